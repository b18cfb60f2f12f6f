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

(* Of the stockpiles it says where they are interpolated, of [interpolations_of]. *)
Record blend_statement := BlendStatement {
  specification_name : string;
  stockpile_names : list string;
  question_said : blend_question;
  claim_said : option blend;
  value_said : Q;
  judged_said : list judged }.

Definition sizes_of_sieves (js : list judged) : list Q :=
  flat_map (fun j => match by_what j with BySieve s => [s] | ByModulus | ByFactor => [] end) js.

(* The j that have this stockpile interpolated, stockpiles being counted from 0. *)
Definition interpolated_in (i : nat) (js : list judged) : list judged :=
  filter (fun j => nth i (interpolated_judged j) false) js.

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

Definition is_by_modulus (j : judged) : bool := match by_what j with ByModulus => true | _ => false end.
Definition is_by_factor (j : judged) : bool := match by_what j with ByFactor => true | _ => false end.

Definition interpolation_phrases (js : list judged) (i : nat) (name : string) : list string :=
  let js := interpolated_in i js in
  let sizes := sizes_of_sieves js in
  let places :=
    (match sizes with [] => [] | _ => [listed sizes] end ++
     (if existsb is_by_modulus js then ["sieves of the modulus"] else []) ++
     (if existsb is_by_factor js then ["sieves of the factor"] else []))%list in
  match places with
  | [] => []
  | _ => [in_quotes name ++ " interpolated linear in size at " ++ joined " and at " places]
  end.

Fixpoint interpolations (js : list judged) (i : nat) (names : list string) : list string :=
  match names with
  | [] => []
  | name :: names => (interpolation_phrases js i name ++ interpolations js (S i) names)%list
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
   ["sieves in mm " ++ listed (sizes_of_sieves (judged_said s))]%string ++
   interpolations (judged_said s) 0 (stockpile_names s))%list.

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

Definition statement_of_blend (specification : file) (stockpiles : list file) (C : blend_certificate) (js : list judged) (v : Q)
  : blend_statement :=
  BlendStatement (name specification) (map name stockpiles) (asked_blend C) (claimed_blend C) v js.

Definition check_readings (C : blend_certificate) (R : reading) (Rs : list reading) : result (list judged * Q) :=
  match limits_in_mm R, all_curves Rs with
  | Some limits, Some curves => check_blend C curves limits
  | None, _ => Refused "the specification as the file of a band"
  | _, None => Refused "stockpiles with masses and rational openings"
  end.

Definition judge_blend (specification : file) (stockpiles : list file) (certificate : file) : judgement :=
  let malformed what :=
    Unreadable (printable (name certificate) ++ ": " ++ what ++ ": let mdm blend --proof write it again") in
  match (let* R := read_named specification in let* Rs := read_all_named stockpiles in Ok (R, Rs)) with
  | Refused what | Malformed what => Unreadable what
  | Ok (R, Rs) =>
    match read_blend_certificate (words_of (bytes certificate)) with
    | Refused what | Malformed what => malformed what
    | Ok C =>
      match check_readings C R Rs with
      | Ok (js, v) => Proved (blend_line (statement_of_blend specification stockpiles C js v))
      | Refused what =>
        Unproved (refused_line (name specification)) (printable (name certificate) ++ ": " ++ what ++ " fails")
      | Malformed what => malformed what
      end
    end
  end.
