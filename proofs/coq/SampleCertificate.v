(* A certificate of a sample, and how its lines are read (certificate-format.md, section 12). *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Certificate Document.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- What it says ----------------------------------------------------------------------------------- *)

(* From the first to the second, in percent. *)
Definition percents_from : Type := Q * Q.

(* A line "class": a share that is given by one number is this rational. *)
Record class_claim := ClassClaim { claimed_index : Z; claimed_count : Z; claimed_share : percents_from }.

(* The largest error of a measure, and the class where it is. *)
Record largest_error := LargestError { at_class : Z; error_within : percents_from }.

Inductive answer := Yes | No | Undecided.

(* What a sample is that does not match: of a value that is found there is asked for at least, or at most, so much. *)
Inductive value := ClassHolds (j : Z) | PassesClass (j : Z) | AllErrors.
Inductive finding :=
| Matches
| HasOutside
| Misses (what : value) (found : percents_from) (is_least : bool) (asked_for : Q).

Record sample_claims := SampleClaims {
  places : option Z;
  claimed_particles : Z;
  claimed_below : Z;
  claimed_above : Z;
  claimed_unplaced : Z;
  claimed_classes : list class_claim;
  retained_error : largest_error;
  passing_error : option largest_error;
  total_error : percents_from;
  conditions : list answer;
  found_to_be : finding }.

(* With the question in the place of which a match has more lines; whether its band is that of the file. *)
Record sample_certificate := SampleCertificate { question_of : question; band_is_of_file : bool; claims : sample_claims }.

(* ---- Lines ------------------------------------------------------------------------------------------ *)

Definition malformed_line {A} (name : string) : result A := Malformed ("the line " ++ name).

Definition percents_of (lo hi : string) : option percents_from :=
  match number NotNegative lo, number NotNegative hi with
  | Some l, Some h => check (at_most l h) (l, h)
  | _, _ => None
  end.

Definition class_claim_of (l : line) : option class_claim :=
  let claim (j q : string) (share : option percents_from) :=
    match class_index j, number (Integer 0) q, share with
    | Some j, Some q, Some s => Some (ClassClaim j (Qnum q) s)
    | _, _, _ => None
    end in
  match l with
  | [j; q; p] => claim j q (option_map (fun p => (p, p)) (rational p))
  | [j; q; p; r] =>
    claim j q (match percents_of p r with Some s => check (less (fst s) (snd s)) s | None => None end)
  | _ => None
  end.

Fixpoint class_claims (ls : lines) (done : list class_claim) : result (list class_claim * lines) :=
  match ls with
  | (w :: l) :: rest =>
    if negb (String.eqb w "class") then Ok (rev' done, ls) else
    match class_claim_of l with
    | Some c => class_claims rest (c :: done)
    | None => malformed_line "class"
    end
  | _ => Ok (rev' done, ls)
  end.

Definition largest_error_of (name : string) : reader largest_error := fun ls =>
  match ls with
  | [w; j; p; r] :: rest =>
    match String.eqb w name, class_index j, percents_of p r with
    | true, Some j, Some s => Ok (LargestError j s, rest)
    | _, _, _ => malformed_line name
    end
  | _ => malformed_line name
  end.

Definition total_error_line : reader percents_from := fun ls =>
  match ls with
  | [w; p; r] :: rest =>
    match String.eqb w "total-error", percents_of p r with
    | true, Some s => Ok (s, rest)
    | _, _ => malformed_line "total-error"
    end
  | _ => malformed_line "total-error"
  end.

Definition answer_of (w : string) : option answer :=
  if String.eqb w "yes" then Some Yes else if String.eqb w "no" then Some No
  else if String.eqb w "open" then Some Undecided else None.

Definition conditions_line : reader (list answer) := fun ls =>
  match ls with
  | (w :: l) :: rest =>
    match String.eqb w "conditions", all_words answer_of l [] with
    | true, Some cs => demand_form (size cs =? 4) "the line conditions" ;; Ok (cs, rest)
    | _, _ => malformed_line "conditions"
    end
  | _ => malformed_line "conditions"
  end.

Definition misses (what : value) (l : line) : option finding :=
  match l with
  | [p; r; side; v] =>
    match percents_of p r, number NotNegative v with
    | Some s, Some v =>
      if String.eqb side "most" then Some (Misses what s false v)
      else if String.eqb side "least" then match what with AllErrors => None | _ => Some (Misses what s true v) end
      else None
    | _, _ => None
    end
  | _ => None
  end.

Definition finding_of (l : line) : option finding :=
  match l with
  | [w] => if String.eqb w "match" then Some Matches else if String.eqb w "outside" then Some HasOutside else None
  | w :: ((j :: rest) as l) =>
    if String.eqb w "total" then misses AllErrors l else
    match class_index j with
    | Some j =>
      if String.eqb w "class" then misses (ClassHolds j) rest
      else if String.eqb w "passing" then misses (PassesClass j) rest else None
    | None => None
    end
  | [] => None
  end.

Definition verdict_line : reader finding := fun ls =>
  match ls with
  | (w :: l) :: rest =>
    match String.eqb w "verdict", finding_of l with
    | true, Some f => Ok (f, rest)
    | _, _ => malformed_line "verdict"
    end
  | _ => malformed_line "verdict"
  end.

(* ---- The whole -------------------------------------------------------------------------------------- *)

Definition is_sample_certificate (ls : lines) : bool := is_line ["mdm-certificate"; "sample"; "1"] ls.

Definition read_sample_question : reader question := fun ls =>
  let* (law, ls) := required "law" [Rational] ls in
  let* (pan_size, ls) := optional "pan-size" [Positive] ls in
  let* (cut_below, ls) := optional "cut-below" [Positive] ls in
  let* (size_factor, ls) := optional "size-factor" [Positive] ls in
  let* (tolerances, ls) := read_tolerances ls in
  let law := match law with x :: _ => x | [] => 0%Q end in
  demand_form ((Qnum law <=? 1000) && (Zpos (Qden law) <=? 1000)) "a law with numbers above 1000" ;;
  demand_form (match size_factor with x :: _ => negb (equal x (of_integer 1)) | [] => true end)
    "a size-factor of 1" ;;
  Ok (Question (Qnum law) (Zpos (Qden law)) (first pan_size) (first cut_below) (first size_factor)
        0 Anything 0 tolerances, ls).

Definition read_claims : reader sample_claims := fun ls =>
  let* (places, ls) := optional "places" [Integer 0] ls in
  demand_form (integer places <=? 1000) "more than 1000 places" ;;
  let* (n, ls) := required "particles" [Integer 1] ls in
  let* (below, ls) := optional "below" [Integer 1] ls in
  let* (above, ls) := optional "above" [Integer 1] ls in
  let* (unplaced, ls) := optional "unplaced" [Integer 1] ls in
  let* (classes, ls) := class_claims ls [] in
  demand_form (size classes <=? most_rows) "more classes than a gradation can have" ;;
  let* (retained, ls) := largest_error_of "retained-error" ls in
  let* (passing, ls) :=
    if named "passing-error" ls then let* (e, ls) := largest_error_of "passing-error" ls in Ok (Some e, ls)
    else Ok (None, ls) in
  let* (total, ls) := total_error_line ls in
  let* (conditions, ls) := conditions_line ls in
  let* (found, ls) := verdict_line ls in
  Ok (SampleClaims (option_map Qnum (first places)) (integer n) (integer below) (integer above) (integer unplaced) classes
        retained passing total conditions found, ls).

(* [limits] are those of the gradation file, if it is an envelope. *)
Definition read_sample_certificate (limits : list (Q * Q * Q)) (ls : lines) : result sample_certificate :=
  demand_form (forallb (forallb is_word) ls) "a word that is longer than any number" ;;
  let of_file := existsb is_band_file ls in
  demand_form (negb of_file || (size (filter is_band ls) =? 1)) "more lines of a band beside the line band file" ;;
  let ls := if of_file then with_limits limits ls [] else ls in
  demand_form (is_sample_certificate ls) "the line mdm-certificate sample 1 is missing" ;;
  let* (asked, ls) := read_sample_question (tl ls) in
  let* (claims, ls) := read_claims ls in
  demand_form (is_line ["end"] ls && is_line [""] (tl ls) && match tl (tl ls) with [] => true | _ => false end)
    "the line end is missing, or something follows it" ;;
  Ok (SampleCertificate asked of_file claims).
