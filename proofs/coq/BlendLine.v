(* The line that the verdict on a blend prints, and what is printed of the names and bytes of a specification, stockpiles and a
   certificate. *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Gradation Certificate Text Decimals Rows GradationFile Document VerdictLine Judge SampleFile
  Blend BlendCertificate BlendSieves BlendCheck.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Files ------------------------------------------------------------------------------------------ *)

(* The limits of a specification, its openings in mm. *)
Definition limits_in_mm (R : reading) : option (list (Q * Q * Q)) :=
  option_map (map_all (fun '(s, least, most) => (times s (gradation_in_mm (sizes_in R)), least, most))) (limits R).

(* The openings of a stockpile are to be rational, and it has no limits. *)
Definition curve_in (R : reading) : option curve :=
  match limits R with
  | Some _ => None
  | None =>
    if root (gradation_of R) =? 1 then Some (curve_of (gradation_in_mm (sizes_in R)) (rows (gradation_of R))) else None
  end.

(* ---- What a line says ------------------------------------------------------------------------------- *)

(* Where a stockpile is interpolated: at which sieves of the specification, and whether at sieves of a modulus or of the factor. *)
Record interpolation := Interpolation { at_sieves : list Q; at_modulus : bool; at_factor : bool }.

(* The value is 0 where none is lowest. Of targets that no blend is judged by, the line does not say what of the deviations from
   them would be lowest: they are those of [Deviation]. *)
Record blend_statement := BlendStatement {
  specification_name : string;
  stockpile_names : list string;
  question_said : blend_question;
  claim_said : option blend;
  value_said : Q;
  sieves_said : list Q;
  interpolations_said : list interpolation }.

Definition aim_in_line (claim : option blend) (a : aim) : aim :=
  match claim, a with None, (MaxDeviation ts | Squares ts) => Deviation ts | _, _ => a end.
Definition asked_in_line (C : blend_certificate) : blend_question :=
  let q := asked_blend C in
  BlendQuestion (steps q) (share_limits q) (most_stockpiles q) (modulus_limits q) (coarseness_limits q)
    (aim_in_line (claimed_blend C) (aim_of q)).

Definition sizes_of_sieves (js : list judged) : list Q :=
  flat_map (fun j => match by_what j with BySieve s => [s] | ByModulus | ByFactor => [] end) js.

(* The j that have this stockpile interpolated, stockpiles being counted from 0. *)
Definition interpolated_in (i : nat) (js : list judged) : list judged :=
  filter (fun j => nth i (interpolated_judged j) false) js.

Definition is_by_modulus (j : judged) : bool := match by_what j with ByModulus => true | _ => false end.
Definition is_by_factor (j : judged) : bool := match by_what j with ByFactor => true | _ => false end.

Definition interpolation_of (js : list judged) (i : nat) : interpolation :=
  let js := interpolated_in i js in
  Interpolation (sizes_of_sieves js) (existsb is_by_modulus js) (existsb is_by_factor js).
Fixpoint interpolations_of (js : list judged) (i : nat) (stockpiles : list file) : list interpolation :=
  match stockpiles with
  | [] => []
  | _ :: stockpiles => interpolation_of js i :: interpolations_of js (S i) stockpiles
  end.

Definition statement_of_blend (specification : file) (stockpiles : list file) (C : blend_certificate) (js : list judged) (v : Q)
  : blend_statement :=
  BlendStatement (name specification) (map name stockpiles) (asked_in_line C) (claimed_blend C) v (sizes_of_sieves js)
    (interpolations_of js 0 stockpiles).

(* ---- As a text -------------------------------------------------------------------------------------- *)

Definition listed (xs : list Q) : string := joined ", " (map_all show_rational xs).
Definition from_to (x y : Q) : string := " from " ++ show_rational x ++ " to " ++ show_rational y.

Definition standard_name (st : standard) : string := match st with Astm => "ASTM C125" | En => "EN 12620" end.

Definition aim_phrases (a : aim) : list string :=
  match a with
  | NoAim => []
  | Cost cs => ["costs " ++ listed cs]
  | Deviation ts | MaxDeviation ts | Squares ts => ["targets " ++ listed ts ++ " percent"]
  end.

Definition places_of (at_ : interpolation) : list string :=
  (match at_sieves at_ with [] => [] | sizes => [listed sizes] end ++
   (if at_modulus at_ then ["sieves of the modulus"] else []) ++
   (if at_factor at_ then ["sieves of the factor"] else []))%list.

Definition interpolation_phrases (name : string) (at_ : interpolation) : list string :=
  match places_of at_ with
  | [] => []
  | ws => [in_quotes name ++ " interpolated linear in size at " ++ joined " and at " ws]
  end.

Fixpoint interpolations_phrases (names : list string) (each : list interpolation) : list string :=
  match names, each with
  | name :: names, at_ :: each => (interpolation_phrases name at_ ++ interpolations_phrases names each)%list
  | _, _ => []
  end.

Definition share_phrase (names : list string) (limit : Z * Q * Q) : string :=
  let '(i, x, y) := limit in
  "share of " ++ in_quotes (match numbered i names with Some name => name | None => "" end) ++ from_to x y.

Definition question_phrases (s : blend_statement) : list string :=
  let q := question_said s in
  (["shares in steps of 1/" ++ show_integer (steps q)]%string ++
   map (share_phrase (stockpile_names s)) (share_limits q) ++
   match most_stockpiles q with Some K => ["at most " ++ show_integer K ++ " stockpiles"]%string | None => [] end ++
   map (fun '(st, x, y) => "fineness modulus of " ++ standard_name st ++ from_to x y)%string (modulus_limits q) ++
   match coarseness_limits q with Some (x, y) => ["coarseness factor" ++ from_to x y]%string | None => [] end ++
   aim_phrases (aim_of q) ++
   ["sieves in mm " ++ listed (sieves_said s)]%string ++
   interpolations_phrases (stockpile_names s) (interpolations_said s))%list.

Definition aim_phrase (a : aim) : string :=
  match a with
  | NoAim => ""
  | Cost _ => "cost"
  | Deviation _ => "sum of deviations from the target"
  | MaxDeviation _ => "largest deviation from the target"
  | Squares _ => "sum of squared deviations from the target"
  end.

Definition claim_phrase (s : blend_statement) : string :=
  let names := joined ", " (map_all in_quotes (stockpile_names s)) in
  let kept := " keeps the limits of " ++ in_quotes (specification_name s) in
  match claim_said s with
  | None => "no blend of " ++ names ++ kept
  | Some ns =>
    "the blend of " ++ joined ", " (map_all show_integer ns) ++ " steps of " ++ names ++ kept ++
    if has_aim (aim_of (question_said s)) then
      ", and none has a lower " ++ aim_phrase (aim_of (question_said s)) ++ " than its " ++ show_rational (value_said s)
    else ""
  end.

Definition blend_line (s : blend_statement) : string :=
  "accepted: " ++ claim_phrase s ++ " (" ++ joined "; " (question_phrases s) ++ ")".

(* ---- What a line can say ---------------------------------------------------------------------------- *)

Definition from_0 (x : Q) : bool := 0 <=? Qnum x.
Definition both_from_0 (x y : Q) : bool := from_0 x && from_0 y.

Definition plain_aim (claim : option blend) (a : aim) : bool :=
  forallb from_0 (numbers_of a) &&
  match claim, a with None, (MaxDeviation _ | Squares _) => false | _, _ => true end.

Definition plain_question (stockpiles : list string) (claim : option blend) (q : blend_question) : bool :=
  (0 <=? steps q) &&
  forallb (fun '(i, x, y) => match numbered i stockpiles with Some _ => both_from_0 x y | None => false end) (share_limits q) &&
  match most_stockpiles q with Some K => 0 <=? K | None => true end &&
  forallb (fun '(_, x, y) => both_from_0 x y) (modulus_limits q) &&
  match coarseness_limits q with Some (x, y) => both_from_0 x y | None => true end &&
  plain_aim claim (aim_of q).

(* The first name that is there again behind it. *)
Fixpoint given_twice (names : list string) : option string :=
  match names with
  | [] => None
  | n :: names => if existsb (String.eqb n) names then Some n else given_twice names
  end.

(* Statements of which each has a line of its own. *)
Definition plain_blend_statement (s : blend_statement) : bool :=
  plain_question (stockpile_names s) (claim_said s) (question_said s) &&
  match claim_said s with Some ns => forallb (Z.leb 0) ns | None => true end &&
  (if match claim_said s with Some _ => has_aim (aim_of (question_said s)) | None => false end then from_0 (value_said s)
   else same_number (value_said s) 0) &&
  forallb from_0 (sieves_said s) &&
  (size (interpolations_said s) =? size (stockpile_names s)) &&
  forallb (fun at_ => forallb from_0 (at_sieves at_)) (interpolations_said s) &&
  match given_twice (stockpile_names s) with Some _ => false | None => true end.

(* ---- The judgement ---------------------------------------------------------------------------------- *)

(* What is wrong with a file, and with its name. *)
Definition read_named (f : file) : result reading :=
  match read_gradation (bytes f) with
  | Refused what | Malformed what => Malformed (printable (name f) ++ ":" ++ what)
  | Ok R => Ok R
  end.

Fixpoint read_all_named (fs : list file) : result (list reading) :=
  match fs with
  | [] => Ok []
  | f :: fs => let* R := read_named f in let* Rs := read_all_named fs in Ok (R :: Rs)
  end.

Fixpoint all_curves (Rs : list reading) : option (list curve) :=
  match Rs with
  | [] => Some []
  | R :: Rs =>
    match curve_in R, all_curves Rs with
    | Some c, Some cs => Some (c :: cs)
    | _, _ => None
    end
  end.

Definition check_readings (C : blend_certificate) (R : reading) (Rs : list reading) : result (list judged * Q) :=
  match limits_in_mm R, all_curves Rs with
  | Some limits, Some curves => check_blend C curves limits
  | None, _ => Refused "the specification as the file of a band"
  | _, None => Refused "stockpiles with masses and rational openings"
  end.

Definition judge_blend (specification : file) (stockpiles : list file) (certificate : file) : judgement :=
  let malformed what :=
    Unreadable (printable (name certificate) ++ ": " ++ what ++ ": let mdm blend --proof write it again") in
  match given_twice (map name stockpiles) with
  | Some twice => Unreadable (printable twice ++ ": two stockpiles are this file: give each once")
  | None =>
  match (let* R := read_named specification in let* Rs := read_all_named stockpiles in Ok (R, Rs)) with
  | Refused what | Malformed what => Unreadable what
  | Ok (R, Rs) =>
    match read_blend_certificate (words_of (bytes certificate)) with
    | Refused what | Malformed what => malformed what
    | Ok C =>
      match (let* (js, v) := check_readings C R Rs in
             let s := statement_of_blend specification stockpiles C js v in
             demand_form (plain_blend_statement s) "a number that the verdict cannot say" ;; Ok s) with
      | Ok s => Proved (blend_line s)
      | Refused what =>
        Unproved (refused_line (name specification)) (printable (name certificate) ++ ": " ++ what ++ " fails")
      | Malformed what => malformed what
      end
    end
  end
  end.
