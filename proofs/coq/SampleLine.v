(* The line that the verdict on a sample prints, and what is printed of the names and bytes of a gradation, a sample and its
   certificate. *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Gradation Certificate Text Decimals Rows GradationFile Document VerdictLine Judge SampleFile
  SampleCertificate SampleCheck.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- What a line says -------------------------------------------------------------------------------- *)

Record errors_said := ErrorsSaid { of_shares : largest_error; of_passing : option largest_error; of_all_shares : percents_from }.

(* [question_in_line] has the gradation's file, the tolerance and the parts; its claim is none. [outside_said] is 0 but where
   particles outside are what is found. An exact match has no errors. *)
Record sample_statement := SampleStatement {
  question_in_line : statement;
  sample_name : string;
  particles_said : Z;
  finding_said : finding;
  outside_said : Z;
  errors_of : option errors_said;
  conditions_said : list answer }.

Definition is_match (f : finding) : bool := match f with Matches => true | _ => false end.
Definition outside_of (c : sample_claims) : Z :=
  match found_to_be c with HasOutside => claimed_below c + claimed_above c | _ => 0 end.

Definition sample_statement_of (gradation sample : string) (R : reading) (C : sample_certificate) : sample_statement :=
  let c := claims C in
  let s := statement_of gradation R (without_claim C) in
  SampleStatement s sample (claimed_particles c) (found_to_be c) (outside_of c)
    (if is_match (found_to_be c) && is_exact s then None
     else Some (ErrorsSaid (retained_error c) (passing_error c) (total_error c)))
    (conditions c).

(* ---- As a text --------------------------------------------------------------------------------------- *)

Definition percents_phrase (s : percents_from) : string :=
  let lo := show_decimal (fst s) in
  let hi := show_decimal (snd s) in
  (if String.eqb lo hi then lo else lo ++ " to " ++ hi) ++ " %".

Definition value_phrase (what : value) (found : string) : string :=
  match what with
  | ClassHolds j => "class " ++ show_integer j ++ " holds " ++ found
  | PassesClass j => found ++ " pass the upper opening of class " ++ show_integer j
  | AllErrors => "all errors together are " ++ found
  end.

Definition reason_phrase (f : finding) (outside : Z) : string :=
  match f with
  | Matches => ""
  | HasOutside => ": " ++ show_integer outside ++ " outside all classes"
  | Misses what found is_least v =>
    ": " ++ value_phrase what (percents_phrase found) ++ ", and at " ++ (if is_least then "least " else "most ") ++
    show_decimal v ++ " % are asked for"
  end.

Definition errors_phrase (e : errors_said) : string :=
  "; the largest error of a share is " ++ percents_phrase (error_within (of_shares e)) ++ ", in class " ++
  show_integer (at_class (of_shares e)) ++
  match of_passing e with
  | Some p =>
    "; of what passes " ++ percents_phrase (error_within p) ++ ", at the upper opening of class " ++ show_integer (at_class p)
  | None => ""
  end ++ "; all together " ++ percents_phrase (of_all_shares e).

Definition answer_phrase (a : answer) : string := match a with Yes => "yes" | No => "no" | Undecided => "open" end.
Fixpoint conditions_phrases (i : Z) (cs : list answer) : list string :=
  match cs with
  | c :: cs => (show_integer i ++ " " ++ answer_phrase c) :: conditions_phrases (i + 1) cs
  | [] => []
  end.

Definition sample_line (s : sample_statement) : string :=
  let q := question_in_line s in
  let one := particles_said s =? 1 in
  "accepted: the " ++ show_integer (particles_said s) ++ (if one then " particle of " else " particles of ") ++
  in_quotes (sample_name s) ++
  (if is_match (finding_said s) then if one then " matches " else " match "
   else if one then " does not match " else " do not match ") ++
  in_quotes (file_name q) ++ (if is_exact q then " exactly" else " within a tolerance") ++
  reason_phrase (finding_said s) (outside_said s) ++
  match errors_of s with Some e => errors_phrase e | None => "" end ++
  "; conditions " ++ joined ", " (conditions_phrases 1 (conditions_said s)) ++ " (" ++
  joined "; " (map_all (phrase (unit_of q)) (parts q)) ++ ")".

Definition refused_sample_line (gradation sample : string) : string :=
  "refused: the certificate does not prove its claim about " ++ in_quotes sample ++ " and " ++ in_quotes gradation.

(* ---- What a line can say ----------------------------------------------------------------------------- *)

Definition claims_nothing (q : statement) : bool := match claim_of q with NoMatch => or_more q =? 0 | _ => false end.

Definition plain_percents (s : percents_from) : bool := plain (fst s) && plain (snd s).

Definition plain_value (what : value) : bool :=
  match what with ClassHolds j | PassesClass j => plain_integer j | AllErrors => true end.

Definition plain_finding (f : finding) (outside : Z) : bool :=
  match f with
  | Matches => outside =? 0
  | HasOutside => plain_integer outside
  | Misses what found _ v => (outside =? 0) && plain_value what && plain_percents found && plain v
  end.

Definition plain_error (E : largest_error) : bool := plain_percents (error_within E) && plain_integer (at_class E).
Definition plain_errors (e : errors_said) : bool :=
  plain_error (of_shares e) && match of_passing e with Some E => plain_error E | None => true end &&
  plain_percents (of_all_shares e).

(* Statements of which each has a line of its own. *)
Definition plain_sample_statement (s : sample_statement) : bool :=
  plain_statement (question_in_line s) && claims_nothing (question_in_line s) && plain_integer (particles_said s) &&
  plain_finding (finding_said s) (outside_said s) && match errors_of s with Some e => plain_errors e | None => true end.

(* ---- The judgement ----------------------------------------------------------------------------------- *)

(* The certificate, and the gradation as it asks about it. *)
Definition read_asked (R : reading) (w : string) : result (sample_certificate * gradation) :=
  let here := match limits R with Some ls => ls | None => [(of_integer 1, 0%Q, of_integer 100)] end in
  let* C := read_sample_certificate here (words_of w) in
  demand_form (agrees (without_claim C) here) "the line band file" ;;
  let* G := asked_of_sample R C in Ok (C, G).

(* What is wrong with no line in particular. *)
Definition in_no_line {A} (r : result A) : result A :=
  match r with Malformed what => Malformed (" " ++ what) | _ => r end.

(* The rows of the sample, and all that is derived of them. *)
Definition read_derived (R : reading) (C : sample_certificate) (G : gradation) (w : string) : result derived :=
  let* sample := read_sample (sizes_in R) w in
  in_no_line (derive_sample (question_of C) G sample).

Definition judge_sample (gradation sample certificate : file) : judgement :=
  let refused what :=
    Unproved (refused_sample_line (name gradation) (name sample)) (printable (name certificate) ++ ": " ++ what ++ " fails") in
  let malformed what :=
    Unreadable (printable (name certificate) ++ ": " ++ unreadable_text (bytes certificate) what "mdm verify") in
  match read_gradation (bytes gradation) with
  | Refused what | Malformed what => Unreadable (printable (name gradation) ++ ":" ++ what)
  | Ok R =>
    match read_asked R (bytes certificate) with
    | Refused what => refused what
    | Malformed what => malformed what
    | Ok (C, G) =>
      match read_derived R C G (bytes sample) with
      | Refused what | Malformed what => Unreadable (printable (name sample) ++ ":" ++ what)
      | Ok D =>
        let s := sample_statement_of (name gradation) (name sample) R C in
        match (check_claims C G D ;;
               demand_form (gives_openings R (question_of C) && plain_sample_statement s) "a number that the verdict cannot say") with
        | Refused what => refused what
        | Malformed what => malformed what
        | Ok _ => Proved (sample_line s)
        end
      end
    end
  end.
