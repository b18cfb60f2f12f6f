(* A gradation of several materials, and the check of a certificate against it (certificate-format.md, section 14; Theorem
   28): to the classes of all materials it is what Checker.v is to those of one. *)

From Coq Require Import ZArith QArith List Bool String OrderedTypeEx.
From Mdm Require Import Numbers Gradation Certificate Question Exact Tolerant.
Import ListNotations.
Open Scope string_scope.

(* The rows of each material, by its name: a gradation of its own. Openings are to the power root, as those of one gradation,
   and masses of all materials are in one unit. *)
Record mixture := Mixture { materials : list (string * list row); mixture_root : Z }.

Definition of_one (d : Z) (rs : list row) : gradation := Gradation rs d false.
Definition all_rows (ms : list (string * list row)) : list row := flat_map snd ms.

Definition before (x y : string) : bool := match String_as_OT.cmp x y with Lt => true | _ => false end.
Fixpoint names_ascend (names : list string) : bool :=
  match names with
  | x :: ((y :: _) as rest) => before x y && names_ascend rest
  | _ => true
  end.

Definition well_formed_mixture (M : mixture) : bool :=
  forallb (fun '(_, rs) => well_formed (of_one (mixture_root M) rs)) (materials M) && names_ascend (map fst (materials M)) &&
  match materials M with [] => false | _ => true end.

Definition reduced_mixture (M : mixture) : mixture :=
  Mixture (map (fun '(name, rs) => (name, rows (reduced (of_one (mixture_root M) rs)))) (materials M)) (mixture_root M).

(* ---- Classes ------------------------------------------------------------------------------------- *)

(* The last row of a material begins no class: it has no mass. *)
Definition nothing_behind (r : row) : between_rows := (Class 0 (of_integer 1) 0 (factor r), false).

(* What belongs to each, with something between one and the next. *)
Fixpoint interleaved {A B} (each : B -> list A) (between : B -> A) (ms : list B) : list A :=
  match ms with
  | [] => []
  | [m] => each m
  | m :: ms => (each m ++ between m :: interleaved each between ms)%list
  end.

Definition places_of (ms : list (string * list row)) : list between_rows :=
  interleaved (fun m => all_begin (classes (snd m))) (fun m => nothing_behind (last_row (snd m))) ms.

(* ---- The question -------------------------------------------------------------------------------- *)

(* With all openings times K. *)
Definition with_size_factor (K : option Q) (M : mixture) : result mixture :=
  match K with
  | Some K =>
    let* factor := to_power (mixture_root M) K in
    let multiplied := map (fun r => with_opening (times (opening r) factor) r) in
    Ok (Mixture (map (fun '(name, rs) => (name, multiplied rs)) (materials M)) (mixture_root M))
  | None => Ok M
  end.

Definition asked_mixture (cert : certificate) (M : mixture) : result mixture :=
  let q := asked cert in
  demand match pan_size q, cut_below q with None, None => true | _, _ => false end "materials: without pan-size and cut-below" ;;
  let* M := with_size_factor (size_factor q) M in
  demand_small cert (mixture_root M) (all_rows (materials M)) ;; Ok M.

(* ---- Shares -------------------------------------------------------------------------------------- *)

(* What is retained where a row begins no class is nothing. *)
Definition share_there (tol : tolerances) (all : Q) (p : between_rows) : share :=
  let g := over (mass (fst p)) all in
  let near := around g (retained_each tol) any_share in
  Share g (if snd p then near else narrow near 0 0) any_share.

Definition mixture_shares (tol : tolerances) (ms : list (string * list row)) : result (list share) :=
  demand (negb (retained_file tol || passing_file tol)) "a column tolerance_percent" ;;
  demand match passing_all tol, passing_each tol, band tol with None, [], [] => true | _, _, _ => false end
    "materials: tolerances on what is retained and on the total alone" ;;
  Ok (map (share_there tol (fold_left add (map retained (all_rows ms)) 0%Q)) (places_of ms)).

(* ---- The check ----------------------------------------------------------------------------------- *)

Definition check_mixture (M : mixture) (cert : certificate) : result unit :=
  let M := reduced_mixture M in
  demand_form (well_formed_mixture M && sensible cert) "no gradation, or no question" ;;
  let* M := asked_mixture cert M in
  demand_form (well_formed_mixture M) "no gradation after the question" ;;
  let ms := materials M in
  match tolerances_of (asked cert), proof_of cert with
  | None, Exact scale z chain =>
    check_exact cert (mixture_root M) (all_rows ms) (map fst (places_of ms)) scale z chain
  | Some tol, Tolerant nodes =>
    let* ss := mixture_shares tol ms in
    check_tolerant cert (mixture_root M) (all_rows ms) (places_of ms) ss tol nodes
  | _, _ => Malformed "a chain for an exact match, a tree for a tolerance"
  end.
