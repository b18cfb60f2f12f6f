(* From the rows of a file, in any format, to the gradation (certificate-format.md, section 4).

   A file may have a million rows: functions on them are tail recursive. *)

From Coq Require Import ZArith QArith Qabs List Bool String Ascii.
From Mdm Require Import Numbers Gradation Certificate Text Decimals.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- What a file says ------------------------------------------------------------------------------ *)

Inductive size_unit := Millimetres | Micrometres | Metres | Inches | SieveNames | Phi.
Inductive share_unit := Percents | Fractions.

(* The second column. [Limits] are those of an envelope. *)
Inductive quantity := Masses | Retained (unit : share_unit) | Passing (unit : share_unit) | Cumulative | Limits.

Definition full (unit : share_unit) : Q := of_integer (match unit with Percents => 100 | Fractions => 1 end).

(* A row: its size, none for the pan, of a sieve in mm; the number of its second column; of an envelope the number of its
   third; factor and tolerance; and its line in the file. *)
Record entry := Entry {
  size_of : option Q; value_of : Q; most_of : Q; factor_of : Q; tolerance_of : Q; line_of : Z }.

(* All that a gradation file says. An envelope has limits: size, least and most percent that pass, of each row. *)
Record reading := Reading {
  gradation_of : gradation;
  sizes_in : size_unit;
  has_factors : bool;
  implied_pan : bool;
  sum_to : option (share_unit * Q);
  limits : option (list (Q * Q * Q)) }.

Definition most_phi : Q := of_integer 1000.

(* ---- Lists ---------------------------------------------------------------------------------------- *)

Fixpoint map_onto {A B} (f : A -> B) (l : list A) (done : list B) : list B :=
  match l with x :: l => map_onto f l (f x :: done) | [] => done end.
Definition map_all {A B} (f : A -> B) (l : list A) : list B := rev' (map_onto f l []).

(* Merges two lists that ascend; what is done descends. *)
Fixpoint merge_onto {A} (smaller : A -> A -> bool) (xs : list A) : list A -> list A -> list A :=
  fix inner (ys done : list A) : list A :=
    match xs, ys with
    | [], _ => rev_append ys done
    | _, [] => rev_append xs done
    | x :: xs', y :: ys' =>
      if smaller y x then inner ys' (y :: done) else merge_onto smaller xs' ys (x :: done)
    end.

Fixpoint merge_pairs {A} (smaller : A -> A -> bool) (ls done : list (list A)) : list (list A) :=
  match ls with
  | x :: y :: ls => merge_pairs smaller ls (rev' (merge_onto smaller x y []) :: done)
  | [x] => rev' (x :: done)
  | [] => rev' done
  end.

Fixpoint merge_all {A} (smaller : A -> A -> bool) (rounds : nat) (ls : list (list A)) : list A :=
  match ls, rounds with
  | [], _ => []
  | [l], _ => l
  | l :: _, O => l
  | _, S rounds => merge_all smaller rounds (merge_pairs smaller ls [])
  end.

Fixpoint is_sorted {A} (smaller : A -> A -> bool) (l : list A) : bool :=
  match l with
  | x :: ((y :: _) as rest) => smaller x y && is_sorted smaller rest
  | _ => true
  end.

(* Of at most 2^64 elements. *)
Definition sorted {A} (smaller : A -> A -> bool) (l : list A) : list A :=
  if is_sorted smaller l then l else merge_all smaller 64 (map_all (fun x => [x]) l).

(* ---- Sizes ---------------------------------------------------------------------------------------- *)

Definition power_of_two (n : Z) : Q := if 0 <=? n then of_integer (2 ^ n) else Qmake 1 (Z.to_pos (2 ^ (- n))).

(* 2^-phi to the power d, for a multiple d of the denominator of phi. *)
Definition phi_opening (d : Z) (phi : Q) : Q := power_of_two (- (Qnum phi * (d / Zpos (Qden phi)))).

(* The opening in mm, or um or m, to the power d. *)
Definition opening_of (unit : size_unit) (d : Z) (size : option Q) : Q :=
  match size, unit with
  | None, _ => 0
  | Some phi, Phi => phi_opening d phi
  | Some x, Inches => times x (Qmake 127 5)
  | Some x, _ => x
  end.

(* The least common denominator of all phi, and the greatest magnitude. *)
Fixpoint phi_root (es : list entry) (d : Z) (greatest : Q) : result (Z * Q) :=
  match es with
  | [] => Ok (d, greatest)
  | e :: es =>
    match size_of e with
    | None => phi_root es d greatest
    | Some phi =>
      let magnitude := Qred (Qabs phi) in
      demand_at (line_of e) (at_most magnitude most_phi) "a phi beyond 1000: no grain has this size" ;;
      let d := Z.lcm d (Zpos (Qden phi)) in
      demand_at (line_of e) (d <=? most_root)
        "phi with a common denominator above 1000: let mdm convert write the openings in mm" ;;
      phi_root es d (larger greatest magnitude)
    end
  end.

(* The power of the openings, so that they are rational. Limit 2 of section 2 allows no longer ones. *)
Definition file_root (unit : size_unit) (es : list entry) : result Z :=
  match unit with
  | Phi =>
    let* (d, greatest) := phi_root es 1 0 in
    demand_form (at_most (times (of_integer (size es * d)) greatest) (of_integer (2 ^ 28)))
      "phi with too many digits for so many rows: let mdm convert write the openings in mm" ;;
    Ok d
  | _ => Ok 1
  end.

(* ---- Rows and their lines --------------------------------------------------------------------------- *)

(* A row and where it is from. *)
Definition placed_row : Type := row * entry.

Definition row_of (unit : size_unit) (d : Z) (e : entry) : placed_row :=
  (Row (opening_of unit d (size_of e)) (value_of e) (factor_of e) (tolerance_of e), e).

Definition finer (x y : placed_row) : bool := less (opening (fst x)) (opening (fst y)).

Definition with_retained (m : Q) (r : row) : row := Row (opening r) m (factor r) (tolerance r).

Fixpoint check_rows (before : option Q) (rs : list placed_row) : result unit :=
  match rs with
  | [] => Ok tt
  | (r, e) :: rs =>
    demand_at (line_of e) (at_most 0 (opening r)) "a negative size: give the opening of the sieve" ;;
    demand_at (line_of e) (match before with Some x => less x (opening r) | None => true end)
      "a size that is there twice or out of order: give each sieve once, sorted" ;;
    demand_at (line_of e) (at_most 0 (retained r))
      "a negative mass, or more passes than the next sieve lets through: correct it" ;;
    demand_at (line_of e) (less 0 (factor r) && at_most 0 (tolerance r))
      "a factor or tolerance is too small: give positive factors, tolerances from 0 up" ;;
    check_rows (Some (opening r)) rs
  end.

Fixpoint last_line (rs : list placed_row) (line : Z) : Z :=
  match rs with (_, e) :: rs => last_line rs (line_of e) | [] => line end.

(* ---- What passes --------------------------------------------------------------------------------- *)

(* Turns what passes, ascending by size, into masses, last first; 0 for the largest size. Where it descends a mass becomes
   negative. *)
Fixpoint differences (rs : list placed_row) (done : list placed_row) : list placed_row :=
  match rs with
  | (r, e) :: (((coarser, _) :: _) as rest) =>
    differences rest ((with_retained (subtract (retained coarser) (retained r)) r, e) :: done)
  | [(r, e)] => (with_retained 0 r, e) :: done
  | [] => done
  end.

Definition nothing_retained : string := "the largest sieve retains something: add one that retains nothing".

(* The rows with masses, and whether a pan is implied. *)
Definition from_passing (rs : list placed_row) (most : Q) (may_imply : bool) : result (list placed_row * bool) :=
  match rs with
  | [] => Ok ([], false)
  | (finest, e) :: _ =>
    demand_at (line_of e) (at_most 0 (retained finest)) "less than nothing passes here: correct it" ;;
    demand_at (last_line rs 0) (equal (retained (last_row (map_all fst rs))) most) nothing_retained ;;
    if equal (retained finest) 0 then Ok (rev' (differences rs []), false)
    else
      demand_at (line_of e) (less 0 (opening finest) && may_imply)
        "something passes the finest sieve: add a row of the pan where nothing does" ;;
      Ok (rev' (differences ((Row 0 0 1 0, e) :: rs) []), true)
  end.

(* ---- Envelopes ------------------------------------------------------------------------------------ *)

(* The narrowest bounds of a curve that does not fall: the greatest least percent up to a row, with the row's most;
   coarsest first. *)
Fixpoint least_passing (es : list entry) (least : Q) (done : list (Q * Q)) : list (Q * Q) :=
  match es with
  | e :: es => let least := larger least (value_of e) in least_passing es least ((least, most_of e) :: done)
  | [] => done
  end.
(* The least most percent from a row on; finest first. *)
Fixpoint most_passing (bounds : list (Q * Q)) (most : Q) (done : list (Q * Q)) : list (Q * Q) :=
  match bounds with
  | (least, here) :: bounds => let most := smaller most here in most_passing bounds most ((least, most) :: done)
  | [] => done
  end.

(* What passes in the middle of the limits; the least where they contradict each other. *)
Definition middle (es : list entry) : list Q :=
  let bounds := most_passing (least_passing es 0 []) (of_integer 100) [] in
  let contradict := existsb (fun '(least, most) => less most least) bounds in
  map_all (fun '(least, most) => if contradict then least else over (add least most) (of_integer 2)) bounds.

(* The rows with the middle as what passes: nothing at size 0, all of it at the largest size. *)
Fixpoint with_middle (rs : list placed_row) (passing : list Q) (done : list placed_row) : list placed_row :=
  match rs, passing with
  | (r, e) :: rs, p :: passing =>
    let p := if equal (opening r) 0 then 0%Q else match rs with [] => of_integer 100 | _ => p end in
    with_middle rs passing ((with_retained p r, e) :: done)
  | _, _ => rev' done
  end.

Fixpoint check_limits (rs : list placed_row) : result unit :=
  match rs with
  | [] => Ok tt
  | (r, e) :: rest =>
    let within x := at_most 0 x && at_most x (of_integer 100) in
    demand_at (line_of e) (within (value_of e) && within (most_of e)) "a percent below 0 or above 100: correct it" ;;
    demand_at (line_of e) (negb (equal (opening r) 0) || equal (value_of e) 0)
      "nothing passes size 0: give 0 as its least percent" ;;
    demand_at (line_of e) (match rest with [] => equal (most_of e) (of_integer 100) | _ => true end)
      "the largest sieve must let 100 percent pass: add one that does" ;;
    check_limits rest
  end.

(* ---- The gradation -------------------------------------------------------------------------------- *)

(* The rows of a file in any order; [line] is that of its header. *)
Definition gradation_of_entries (unit : size_unit) (what : quantity) (has_tolerances has_factors : bool) (line : Z)
  (es : list entry) : result reading :=
  let* d := file_root unit es in
  let sieves := sorted finer (map_all (row_of unit d) es) in
  let* (rs, implied) :=
    match what with
    | Masses | Retained _ => Ok (sieves, false)
    | Passing share => from_passing sieves (full share) (negb has_factors)
    | Cumulative =>
      from_passing (map_all (fun '(r, e) => (with_retained (subtract (full Percents) (retained r)) r, e)) sieves)
        (full Percents) (negb has_factors)
    | Limits =>
      demand_at line (d =? 1) "a phi that is no whole number: give the openings of a band in mm" ;;
      check_limits sieves ;; from_passing (with_middle sieves (middle (map_all snd sieves)) []) (full Percents) true
    end in
  check_rows None rs ;;
  let G := Gradation (map_all fst rs) d has_tolerances in
  demand_at (last_line rs line) (equal (retained (last_row (rows G))) 0) nothing_retained ;;
  demand_at line (well_formed G) "nothing is retained anywhere: give the masses of at least two sieves" ;;
  let sum share :=
    let total := fold_left add (map_all value_of es) 0%Q in
    if equal total (full share) then None else Some (share, total) in
  let limits_of placed := let (r, e) := (placed : placed_row) in (opening r, value_of e, most_of e) in
  Ok (Reading G unit has_factors implied
        (match what with Retained share => sum share | _ => None end)
        (match what with Limits => Some (map_all limits_of sieves) | _ => None end)).
