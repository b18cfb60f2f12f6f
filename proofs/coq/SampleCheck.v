(* The check of a certificate of a sample against a gradation and the sample's rows (certificate-format.md, section 12, for
   rows that are no ranges and laws that give them rational masses: nothing is enclosed). *)

From Coq Require Import ZArith QArith List Bool String.
From Mdm Require Import Numbers Gradation Certificate Question Exact Tolerant Document Rows SampleFile SampleTally
  SampleCertificate.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- The question ----------------------------------------------------------------------------------- *)

(* What a certificate with the same question would be that claims nothing: it has the readings of the question and its
   limits. *)
Definition without_claim (C : sample_certificate) : document :=
  Document (Certificate (question_of C) NoMatch [] (Tolerant [])) None (band_is_of_file C).

(* Questions of samples ask for nothing but shares. *)
Definition asks_for_shares (q : question) : bool :=
  (min_per_class q =? 0) && (at_least q =? 0) && match solids_of q with Anything => true | _ => false end.

Definition asked_of_sample (R : reading) (C : sample_certificate) : result gradation :=
  demand (Bool.eqb (band_is_of_file C) (match limits R with Some _ => true | None => false end))
    "band file: an envelope as the gradation file" ;;
  let cert := certificate_of (without_claim C) in
  let G := reduced (gradation_of R) in
  demand_form (well_formed G && sensible cert && asks_for_shares (question_of C)) "no gradation, or no question" ;;
  let* G := apply_question cert G in
  demand_form (well_formed G) "no gradation after the question" ;; Ok G.

(* Without a tolerance each share is to be that of the gradation. *)
Definition exactly : tolerances := Tolerances (Some 0%Q) false None false [] None [].
Definition tolerances_or_exactly (q : question) : tolerances :=
  match tolerances_of q with Some t => t | None => exactly end.

(* ---- What is derived --------------------------------------------------------------------------------- *)

(* With N the power of the sizes: the power of it that is the mass of a particle, where this is one for all sizes. *)
Definition power_of_mass (q : question) (N : Z) : option Z :=
  if (1 <=? N) && (b q =? 1) && (a q mod N =? 0) then Some (a q / N) else None.

Definition irrational_masses : string := "masses by this law need not be rational, and this checker takes no enclosures: use mdm-check".

(* The reader has seen to this; with this test no theorem is about the reader. *)
Definition are_particles (rows : list particles) : bool :=
  forallb (fun r => less 0 (size_of_each r) && (1 <=? how_many r)) rows && match rows with [] => false | _ => true end.

Record derived := Derived {
  particles_in_all : Z;
  particles_below : Z;
  particles_above : Z;
  particles_outside : Z;
  counts : list Z;
  lines_of_shares : list shares_line;
  derived_total : Q;
  derived_conditions : list answer }.

Definition yes_or_no (holds : bool) : answer := if holds then Yes else No.

Definition work_of_rows : Z := 2 ^ 36.

(* Limits 1 and 2 of section 12; what is as long as this is found before a power of it is computed. *)
Definition check_openings (N : Z) (rs : list row) : result unit :=
  let H := N * longest (fun r => bits_of (opening r)) rs 0 in
  demand_form ((H <=? power_bits) && (size rs * H <=? work_of_scales)) too_long.

Definition check_rows (d N e : Z) (rs : list row) (rows : list particles) : result unit :=
  let h := longest (fun r => bits_of (size_of_each r)) rows 0 in
  demand_form ((2 * h * e <=? power_bits) && (h * d <=? power_bits)) too_long ;;
  let* common := include_all (map_all (fun r => Zpos (Qden (mass_of_each e r))) rows) 1 in
  let H := N * longest (fun r => bits_of (opening r)) rs 0 in
  demand_form (size rows * (2 * h * e + h * d + H + bits common) <=? work_of_rows) too_long.

Definition derive_rows (d N e : Z) (rs : list row) (rows : list particles) : result derived :=
  let js := classes rs in
  let ms := map_all (fun j => mass_in d N e j rows) js in
  demand_form (size js * longest bits_of ms 0 <=? work_of_scales) too_long ;;
  let ls := shares_of_sample js ms in
  let outside := number_where (is_outside d N rs) rows in
  let and_inside holds := yes_or_no (if outside =? 0 then holds else false) in
  Ok (Derived (all_particles rows) (number_where (is_below d N rs) rows) (number_where (is_above d N rs) rows) outside
        (map_all (fun j => count_in d N j rows) js) ls (total_error_of ls)
        [Yes; and_inside true; and_inside (forallb (fun j => one_size d N j rows) js);
         and_inside (forallb (fun l => equal (share_of l) (target_of l)) ls)]).

Definition derive_sample (q : question) (G : gradation) (sample : sample_file) : result derived :=
  let N := power_of_sizes sample in
  let rows_of := rows_of_sample sample in
  demand_form (are_particles rows_of) "no particles" ;;
  match power_of_mass q N with
  | Some e =>
    check_openings N (rows G) ;;
    check_rows (root G) N e (rows G) rows_of ;;
    derive_rows (root G) N e (rows G) rows_of
  | None => Malformed irrational_masses
  end.

(* ---- What is verified -------------------------------------------------------------------------------- *)

Definition in_percent (x : Q) : Q := times (of_integer 100) x.
Definition encloses (s : percents_from) (x : Q) : bool :=
  if at_most (fst s) (in_percent x) then at_most (in_percent x) (snd s) else false.

Fixpoint classes_are (j : Z) (cs : list class_claim) (ns : list Z) (ls : list shares_line) : bool :=
  match cs, ns, ls with
  | c :: cs, n :: ns, l :: ls =>
    if (claimed_index c =? j) && (claimed_count c =? n) && encloses (claimed_share c) (share_of l)
    then classes_are (j + 1) cs ns ls else false
  | [], [], [] => true
  | _, _, _ => false
  end.

(* The element of class j, counted from 1. *)
Fixpoint of_class {A} (j : Z) (l : list A) : option A :=
  match l with
  | x :: l => if j =? 1 then Some x else of_class (j - 1) l
  | [] => None
  end.

(* No error is above, and that of the class that is named not below. *)
Definition is_largest (E : largest_error) (errors : list Q) : bool :=
  forallb (fun e => at_most (in_percent e) (snd (error_within E))) errors &&
  match of_class (at_class E) errors with Some e => at_most (fst (error_within E)) (in_percent e) | None => false end.

(* What passes the last class is all. *)
Definition but_last {A} (l : list A) : list A := match rev' l with _ :: l => rev' l | [] => [] end.
Definition passing_errors (ls : list shares_line) : list Q := map_all passing_error_of (but_last ls).

Definition passing_error_is (E : option largest_error) (errors : list Q) : bool :=
  match E, errors with
  | None, [] => true
  | Some E, _ :: _ => is_largest E errors
  | _, _ => false
  end.

Definition same_answer (x y : answer) : bool :=
  match x, y with Yes, Yes | No, No | Undecided, Undecided => true | _, _ => false end.
Fixpoint same_answers (xs ys : list answer) : bool :=
  match xs, ys with
  | x :: xs, y :: ys => if same_answer x y then same_answers xs ys else false
  | [], [] => true
  | _, _ => false
  end.

(* The value that is found is in the percents, and these are below, or above, what is asked for. *)
Definition missed (found : percents_from) (is_least : bool) (v x least most : Q) : bool :=
  encloses found x &&
  if is_least then less (snd found) v && at_most v (in_percent least)
  else at_most (in_percent most) v && less v (fst found).

Definition is_within (s : share) (l : shares_line) : bool :=
  equal (g_j s) (target_of l) &&
  (at_most (lo (retained_in s)) (share_of l) && at_most (share_of l) (hi (retained_in s))) &&
  (at_most (lo (passing_in s)) (passing_of l) && at_most (passing_of l) (hi (passing_in s))).

Fixpoint all_within (ss : list share) (ls : list shares_line) : bool :=
  match ss, ls with
  | s :: ss, l :: ls => if is_within s l then all_within ss ls else false
  | [], [] => true
  | _, _ => false
  end.

Definition finding_is (f : finding) (t : tolerances) (ss : list share) (D : derived) : bool :=
  let ls := lines_of_shares D in
  match f with
  | Matches =>
    (particles_outside D =? 0) && all_within ss ls &&
    match total t with Some E => at_most (in_percent (derived_total D)) E | None => true end
  | HasOutside => 1 <=? particles_outside D
  | Misses (ClassHolds j) found is_least v =>
    match of_class j ss, of_class j ls with
    | Some s, Some l => missed found is_least v (share_of l) (lo (retained_in s)) (hi (retained_in s))
    | _, _ => false
    end
  | Misses (PassesClass j) found is_least v =>
    (j <? size ls) &&
    match of_class j ss, of_class j ls with
    | Some s, Some l => missed found is_least v (passing_of l) (lo (passing_in s)) (hi (passing_in s))
    | _, _ => false
    end
  | Misses AllErrors found is_least v =>
    match total t with Some E => missed found is_least v (derived_total D) 0 (percent E) | None => false end &&
    negb is_least
  end.

Definition number_or_none (n : option Z) : bool := match n with None => true | Some _ => false end.

Definition check_claims (C : sample_certificate) (G : gradation) (D : derived) : result unit :=
  let c := claims C in
  let t := tolerances_or_exactly (question_of C) in
  let ls := lines_of_shares D in
  demand (number_or_none (places c)) "places: there exactly if e > 1" ;;
  let* ss := shares_of (question_of C) t G in
  demand (claimed_particles c =? particles_in_all D) "particles" ;;
  demand (claimed_below c =? particles_below D) "below" ;;
  demand (claimed_above c =? particles_above D) "above" ;;
  demand (claimed_below c + claimed_above c =? particles_outside D) "below and above" ;;
  demand (claimed_unplaced c =? 0) "unplaced" ;;
  demand (classes_are 1 (claimed_classes c) (counts D) ls) "class: its particles and its share" ;;
  demand (is_largest (retained_error c) (map_all retained_error_of ls)) "retained-error" ;;
  demand (passing_error_is (passing_error c) (passing_errors ls)) "passing-error" ;;
  demand (encloses (total_error c) (derived_total D)) "total-error" ;;
  demand (same_answers (conditions c) (derived_conditions D)) "conditions" ;;
  demand (finding_is (found_to_be c) t ss D) "verdict".
