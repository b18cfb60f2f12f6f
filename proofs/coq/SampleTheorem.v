(* What it means that the line of the verdict on a sample begins with "accepted": what it says is true of the sample and the
   gradation in the files (Theorem 23, where nothing is enclosed). *)

From Coq Require Import ZArith QArith Reals Qreals String Ascii List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Text Rows GradationFile Document VerdictLine Judge
  Tolerant SampleFile SampleTally SampleCertificate SampleCheck SampleLine Spec Openings RealFacts Reduction Shares TolerantSound
  Sizes Theorems JudgeTheorem ExactSample.
Import ListNotations.
Open Scope R_scope.

(* ---- What the words of a line mean ------------------------------------------------------------------- *)

Definition percents_enclose (s : percents_from) (x : R) : Prop := Q2R (fst s) / 100 <= x <= Q2R (snd s) / 100.

Section Meaning.
Variables (f : R -> R) (G : gradation) (K : option Q) (unit : size_unit) (limits_of_file : list (Q * Q * Q)) (S : sample).
Let d := root_of G.
Let rs := rows G.

(* The errors of shares. *)
Definition share_error (T : sample) (j : class) : R := Rabs (share_retained d f rs j T - target_retained rs j).
Definition passing_share_error (T : sample) (j : class) : R :=
  Rabs (share_passing d f rs (upper_size d j) T - target_passing d rs (upper_size d j)).
Definition all_errors (T : sample) : R := Spec.total (map (share_error T) (classes rs)).

(* x is the value of a sample that is named. *)
Definition value_is (what : value) (T : sample) (x : R) : Prop :=
  match what with
  | ClassHolds j => exists i, of_class j (classes rs) = Some i /\ x = share_retained d f rs i T
  | PassesClass j => exists i, of_class j (classes rs) = Some i /\ x = share_passing d f rs (upper_size d i) T
  | AllErrors => x = all_errors T
  end.

(* What matches has at least, or at most, so much. *)
Definition is_asked_for (q : statement) (what : value) (is_least : bool) (v : Q) : Prop :=
  forall T x, matches f G K unit limits_of_file T q -> value_is what T x ->
    if is_least then Q2R v / 100 <= x else x <= Q2R v / 100.

Definition finding_holds (s : sample_statement) : Prop :=
  let such := matches f G K unit limits_of_file S (question_in_line s) in
  match finding_said s with
  | Matches => such
  | HasOutside => ~ such /\ number_outside d rs S = outside_said s /\ (1 <= outside_said s)%Z
  | Misses what found is_least v =>
    ~ such /\ (exists x, value_is what S x /\ percents_enclose found x) /\ is_asked_for (question_in_line s) what is_least v
  end.

(* The errors of some classes, counted from 1, are at most so large, and that of the class that is named is as large. *)
Definition largest_is (error : class -> R) (js : list class) (E : largest_error) : Prop :=
  (forall i, In i js -> error i <= Q2R (snd (error_within E)) / 100) /\
  exists i, of_class (at_class E) js = Some i /\ percents_enclose (error_within E) (error i).

Definition errors_hold (e : errors_said) : Prop :=
  largest_is (share_error S) (classes rs) (of_shares e) /\
  match of_passing e with
  | Some E => largest_is (passing_share_error S) (removelast (classes rs)) E
  | None => removelast (classes rs) = []
  end /\
  percents_enclose (of_all_shares e) (all_errors S).

Definition answer_is (a : answer) (holds : Prop) : Prop := match a with Yes => holds | No => ~ holds | Undecided => True end.
Definition conditions_hold (cs : list answer) : Prop :=
  Forall2 answer_is cs
    [complete rs; describes d rs S; describes_articulately d rs S; describes_accurately d f rs S].

Definition says (s : sample_statement) : Prop :=
  Z.of_nat (length S) = particles_said s /\ finding_holds s /\
  match errors_of s with Some e => errors_hold e | None => True end /\ conditions_hold (conditions_said s).
End Meaning.

(* The sizes in a sample file. *)
Definition sizes_in_file (F : sample_file) : sample := sample_of (Z.to_pos (power_of_sizes F)) (rows_of_sample F).

(* The statement is true of these files: of the gradation and of the particles that are read from their bytes. *)
Definition is_true_of_sample (gradation sample : file) (s : sample_statement) : Prop :=
  let q := question_in_line s in
  file_name q = name gradation /\ sample_name s = name sample /\
  exists R G a b F, read_gradation (bytes gradation) = Ok R /\ as_file_says R q /\
    as_line_says (reduced (gradation_of R)) q = Ok G /\ law_in (parts q) = Some (a, b) /\ (1 <= a)%Z /\ (1 <= b)%Z /\
    read_sample (sizes_in R) (bytes sample) = Ok F /\
    forall f, power_law (Z.to_nat a) (Z.to_nat b) f ->
      says f G (factor_in (parts q)) (sizes_in R) (limits_or_none R) (sizes_in_file F) s.

(* A line has one statement at most: sample_line_determines. *)
Definition true_of_sample_line (gradation sample : file) (line : string) : Prop :=
  exists s, plain_sample_statement s = true /\ line = sample_line s /\ is_true_of_sample gradation sample s.

(* ---- Lists of classes -------------------------------------------------------------------------------- *)

Lemma of_class_in {A} (l : list A) : forall j x, of_class j l = Some x -> In x l.
Proof.
  induction l as [|y l IH]; intros j x; simpl; [discriminate|]. destruct (j =? 1)%Z; [intros [= ->]; auto|].
  intro H. right. exact (IH _ _ H).
Qed.

Lemma of_class_both {A B} (P : A -> B -> Prop) xs ys : Forall2 P xs ys -> forall j,
  match of_class j xs, of_class j ys with Some x, Some y => P x y | None, None => True | _, _ => False end.
Proof. induction 1 as [|x y xs ys H F IH]; intro j; simpl; [exact I|]. destruct (j =? 1)%Z; [exact H | apply IH]. Qed.

Lemma but_last_is {A} (l : list A) : but_last l = removelast l.
Proof.
  unfold but_last, rev'. rewrite <- !rev_alt. destruct l as [|x l _] using rev_ind; [reflexivity|].
  rewrite rev_app_distr. cbn [rev app]. rewrite <- rev_alt, rev_involutive, removelast_last. reflexivity.
Qed.

Lemma removelast_both {A B} (P : A -> B -> Prop) xs ys : Forall2 P xs ys -> Forall2 P (removelast xs) (removelast ys).
Proof.
  induction 1 as [|x y xs ys H F IH]; [constructor|]. destruct F as [|x' y' xs ys H' F]; [constructor|].
  change (Forall2 P (x :: removelast (x' :: xs)) (y :: removelast (y' :: ys))). constructor; assumption.
Qed.

Lemma same_answers_ok xs : forall ys, same_answers xs ys = true -> xs = ys.
Proof.
  induction xs as [|x xs IH]; intros [|y ys]; simpl; try discriminate; trivial.
  destruct (same_answer x y) eqn:E; [|discriminate]. intro H. f_equal; [destruct x, y; (reflexivity || discriminate) | auto].
Qed.

Lemma encloses_real s x : encloses s x = true -> percents_enclose s (Q2R x).
Proof.
  unfold encloses, percents_enclose, in_percent. destruct (at_most (fst s) _) eqn:E; [|discriminate]. intro H.
  apply at_most_real in E, H. rewrite Q2R_times, Q2R_integer in *. lra.
Qed.

(* ---- What the question asks -------------------------------------------------------------------------- *)

Section Asked.
Variables (q : question) (G : gradation) (f : R -> R).
Let rs := rows G.
Let js := classes rs.
Let d := root_of G.
Let t := tolerances_or_exactly q.
Hypothesis well : well_formed G = true.
Hypothesis nothing_else : min_per_class q = 0%Z /\ solids_of q = Anything /\ at_least q = 0%Z.
Hypothesis factor_nonneg : forall K, size_factor q = Some K -> 0 <= Q2R K.
Hypothesis band_nonneg : forall X l h, In (X, l, h) (band t) -> 0 <= Q2R X /\ 0 <= Q2R h.
Hypothesis each_nonneg : Forall (fun e => 0 <= Q2R e) (passing_each t).
Hypothesis passing_nonneg : forall e, passing_all t = Some e -> 0 <= Q2R e.
Hypothesis law : mass_law f.
Variable ss : list share.
Hypothesis derived_shares : shares_of q t G = Ok ss.

Let proper_gradation : proper_rows rs := proj1 (well_formed_proper G well).
Let some_mass : exists j, In j js /\ 0 < Q2R (mass j) := proj2 (well_formed_proper G well).

Lemma mass_of_some T : describes d rs T -> T <> [] -> 0 < mass_of_all d f rs T.
Proof.
  intros D Ne. pose proof (proper_classes rs proper_gradation) as Proper. rewrite Forall_forall in Proper.
  destruct T as [|x T]; [congruence|]. destruct (classes_ascend (d := d) rs proper_gradation) as (As & Top).
  assert (exists j, In j js /\ in_class d j x) as (j & J & C).
  { destruct D as (_ & D). specialize (D x (or_introl eq_refl)). rewrite <- Top in D. exact (in_some_class js _ _ As D). }
  assert (1 <= number d j (x :: T))%Z as N.
  { unfold number, inside. cbn [filter]. destruct (in_class_dec d j x); [simpl length; lia | contradiction]. }
  assert (0 < held d f j (x :: T)) as H.
  { destruct (sample_realizes (d := d) f law j (x :: T) (Proper j J)) as [(E & _)|(_ & B & _)]; [lia|].
    destruct (proper_sizes (d := d) j (Proper j J)) as (L & U). destruct (Proper j J) as (_ & Cp & _).
    apply (IZR_le 1) in N. pose proof (law_nonneg f law _ L).
    assert (0 <= IZR (number d j (x :: T)) * (Q2R (c j) * f (lower_size d j))) by (apply Rmult_le_pos; [|apply Rmult_le_pos]; lra). lra. }
  pose proof (total_member (fun j => held d f j (x :: T)) js j (held_nonneg (d := d) f rs (x :: T) law proper_gradation) J) as M.
  cbv beta in M. unfold mass_of_all. fold js. lra.
Qed.

Notation x_of T := (fun j => share_retained d f rs j T).
Notation y_of T := (fun j => share_passing d f rs (upper_size d j) T).
Notation gx := (fun j => target_retained rs j).
Notation gy := (fun j => target_passing d rs (upper_size d j)).

(* What is asked of all errors together. *)
Definition total_asked (T : sample) : Prop :=
  forall e, Certificate.total t = Some e -> all_errors f G T <= Q2R e / 100.

Lemma tolerances_are_bounds T : 0 < mass_of_all d f rs T ->
  (meets_tolerances d f (size_factor q) t rs T <-> Forall2 (fits_share (x_of T) (y_of T) gx) js ss /\ total_asked T).
Proof.
  intro M. pose proof (well_formed_root G well) as Rd.
  destruct (shares_of_fit f rs T law proper_gradation some_mass M q t G ss Rd factor_nonneg (fun X l h I => proj1 (band_nonneg X l h I))
              eq_refl derived_shares) as (_ & Fl & Fb & Fit). split.
  - intros (T1 & T2 & T3 & T4 & T5 & T6 & T7). split; [|exact T6]. apply Fit; [|exact T7]. apply lines_hold_of; assumption.
  - intros (F & T6). specialize (Fl F). specialize (Fb (fun X l h I => proj2 (band_nonneg X l h I)) F).
    destruct (of_lines_hold t (x_of T) (y_of T) gx gy rs (passing_each t) Fl) as (T1 & T2 & T3 & T4 & T5); trivial.
    { intros e E j J L. cbv beta. unfold near. rewrite (pass_all f rs T proper_gradation M _ j J L) by lra.
      rewrite (target_all (d := d) rs proper_gradation some_mass j J L). rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra. }
    { exact (well_formed_tolerances G well). }
    repeat (split; [assumption|]). exact Fb.
Qed.

Lemma near_0 x y : near 0 x y <-> x = y.
Proof.
  unfold near. rewrite Q2R_0. replace (0 / 100) with 0 by field. split; [|intros ->; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; lra].
  intro H. pose proof (Rabs_pos (x - y)). assert (Rabs (x - y) = 0) as E by lra.
  destruct (Req_dec (x - y) 0) as [Z|Z]; [lra | apply Rabs_no_R0 in Z; contradiction].
Qed.

(* A sample is allowed iff all of it is in classes and its shares are as asked. *)
Lemma allowed_is_within T :
  allowed f q G T <-> describes d rs T /\ 0 < mass_of_all d f rs T /\ meets_tolerances d f (size_factor q) t rs T.
Proof.
  destruct nothing_else as (Z1 & Z2 & Z3).
  assert (has_enough d q rs T) as En.
  { unfold has_enough. rewrite Z1, Z2, Z3. split; [|split; [exact I | lia]]. intros j _ _. unfold number. lia. }
  assert (0 < mass_of_all d f rs T -> T <> []) as Ne.
  { intros M ->. assert (mass_of_all d f rs [] = 0) as E; [|lra]. unfold mass_of_all. generalize (classes rs).
    induction l as [|j l IH]; [reflexivity|]. cbn [map Spec.total fold_right]. unfold Spec.total in IH. rewrite IH.
    unfold held, inside. cbn [filter map Spec.total fold_right]. ring. }
  unfold allowed. fold d rs. unfold t, tolerances_or_exactly. destruct (tolerances_of q) as [tol|].
  - unfold describes_within. split.
    + intros ((D & N & M) & _). split; [exact D|]. split; [exact (mass_of_some T D N) | exact M].
    + intros (D & M & Me). auto.
  - unfold meets_tolerances, exactly. cbn [retained_each retained_file passing_all passing_file passing_each Certificate.total band].
    assert (forall j, meets_retained d f rs T j 0 <-> share_retained d f rs j T = target_retained rs j) as Near
      by (intro j; apply near_0).
    split.
    + intros (A & _). assert (describes d rs T) as D by (destruct A as (s & _ & D & _); exact D).
      pose proof (proj1 (accurate_shares d rs proper_gradation f law some_mass T D) A) as E.
      split; [exact D|]. split; [exact (mass_where_accurate d rs proper_gradation f law some_mass T E)|].
      repeat split; try discriminate.
      * intros e [= <-] j J. apply Near, E, J.
      * intros j e I. rewrite combine_nil in I. destruct I.
      * destruct H.
      * destruct H.
    + intros (D & M & (H & _)). split; [|exact En]. apply (accurate_shares d rs proper_gradation f law some_mass T D).
      intros j J. apply Near, (H 0%Q eq_refl j J).
Qed.

(* ---- What is derived of the sample ------------------------------------------------------------------- *)

Variables (N : positive) (e : nat) (rows : list particles).
Hypothesis sizes : Forall proper_particles rows.
Hypothesis not_empty : rows <> [].
Hypothesis power : power_law (e * Pos.to_nat N) 1 f.
Notation S := (sample_of N rows).
Variable ls : list shares_line.
Hypothesis lines_are : Forall2 (shares_are d N rs rows f) js ls.

Lemma sample_not_empty : S <> [].
Proof.
  pose proof sizes as P. destruct rows as [|r l]; [congruence|]. inversion P as [|? ? (_ & Q) _]; subst.
  unfold sample_of. cbn [flat_map]. destruct (Z.to_nat (how_many r)) eqn:E; [lia | discriminate].
Qed.

Lemma all_within_fits : forall js0 ss0 ls0, Forall2 (shares_are d N rs rows f) js0 ls0 -> all_within ss0 ls0 = true ->
  Forall2 (fits_share (x_of S) (y_of S) gx) js0 ss0.
Proof.
  intros js0 ss0 ls0 F. revert ss0. induction F as [|j l js0 ls0 (A & B & C & _) F IH]; intros [|s ss0] H; try discriminate; [constructor|].
  simpl in H. destruct (is_within s l) eqn:E; [|discriminate]. constructor; [|exact (IH _ H)].
  unfold is_within in E. rewrite !andb_true_iff, equal_real, !at_most_real, A, B, C in E.
  unfold fits_share, within_interval. tauto.
Qed.

Lemma match_allowed : describes d rs S -> all_within ss ls = true -> total_asked S -> allowed f q G S.
Proof.
  intros D W T. apply allowed_is_within. pose proof (mass_of_some S D sample_not_empty) as M.
  split; [exact D|]. split; [exact M|]. apply (tolerances_are_bounds S M). split; [|exact T]. exact (all_within_fits _ _ _ lines_are W).
Qed.

Lemma missed_not found least v x lo hi : missed found least v x lo hi = true ->
  percents_enclose found (Q2R x) /\
  if least then Q2R (snd found) < Q2R v /\ Q2R v / 100 <= Q2R lo else Q2R hi <= Q2R v / 100 /\ Q2R v < Q2R (fst found).
Proof.
  unfold missed. intro H. apply andb_prop in H as (E & H). split; [exact (encloses_real _ _ E)|]. unfold in_percent in H.
  destruct least; apply andb_prop in H as (A & B).
  - apply less_real in A. apply at_most_real in B. rewrite Q2R_times, Q2R_integer in B. lra.
  - apply at_most_real in A. apply less_real in B. rewrite Q2R_times, Q2R_integer in A. lra.
Qed.

Lemma total_is : all_errors f G S = Q2R (total_error_of ls).
Proof. apply total_error_is with (1 := lines_are). Qed.

(* A miss: the value of the sample, and what is asked for. *)
Lemma misses_true D what found least v :
  lines_of_shares D = ls -> derived_total D = total_error_of ls ->
  finding_is (Misses what found least v) t ss D = true ->
  (exists x, value_is f G what S x /\ percents_enclose found x /\ (if least then x < Q2R v / 100 else Q2R v / 100 < x)) /\
  forall T x, allowed f q G T -> value_is f G what T x -> if least then Q2R v / 100 <= x else x <= Q2R v / 100.
Proof.
  intros EL ET H. unfold finding_is in H. rewrite EL in H.
  assert (forall T, allowed f q G T -> Forall2 (fits_share (x_of T) (y_of T) gx) js ss /\ total_asked T) as Fit.
  { intros T A. apply allowed_is_within in A as (_ & M & A). exact (proj1 (tolerances_are_bounds T M) A). }
  destruct what as [j|j|].
  - pose proof (of_class_both _ _ _ lines_are j) as L. destruct (of_class j ss) as [s|] eqn:Es; [|discriminate].
    destruct (of_class j ls) as [l|]; [|discriminate]. destruct (of_class j js) as [i|] eqn:Ei; [|destruct L].
    destruct L as (A & _). apply missed_not in H as (E & H). rewrite A in E. unfold percents_enclose in E. split.
    + exists (share_retained d f rs i S). split; [exists i; auto|]. split; [exact E|]. destruct least; lra.
    + intros T x Al (i' & Ei' & ->). fold rs js in Ei'. rewrite Ei in Ei'. injection Ei' as <-. destruct (Fit T Al) as (F & _).
      pose proof (of_class_both _ _ _ F j) as B. rewrite Ei, Es in B. destruct B as (_ & B & _). unfold within_interval in B.
      fold rs d. destruct least; lra.
  - apply andb_prop in H as (_ & H).
    pose proof (of_class_both _ _ _ lines_are j) as L. destruct (of_class j ss) as [s|] eqn:Es; [|discriminate].
    destruct (of_class j ls) as [l|]; [|discriminate]. destruct (of_class j js) as [i|] eqn:Ei; [|destruct L].
    destruct L as (_ & _ & A & _). apply missed_not in H as (E & H). rewrite A in E. unfold percents_enclose in E. split.
    + exists (share_passing d f rs (upper_size d i) S). split; [exists i; auto|]. split; [exact E|]. destruct least; lra.
    + intros T x Al (i' & Ei' & ->). fold rs js in Ei'. rewrite Ei in Ei'. injection Ei' as <-. destruct (Fit T Al) as (F & _).
      pose proof (of_class_both _ _ _ F j) as B. rewrite Ei, Es in B. destruct B as (_ & _ & B). unfold within_interval in B.
      fold rs d. destruct least; lra.
  - apply andb_prop in H as (H & Nl). destruct least; [discriminate|]. destruct (Certificate.total t) as [E|] eqn:Et; [|discriminate].
    apply missed_not in H as (En & H). rewrite ET, <- total_is in En. unfold percents_enclose in En. rewrite percent_real in H. split.
    + exists (all_errors f G S). split; [reflexivity|]. split; [exact En | lra].
    + intros T x Al ->. destruct (Fit T Al) as (_ & B). specialize (B E Et). lra.
Qed.

Lemma largest_true E js0 ls0 (error : class -> R) (error_of : shares_line -> Q) :
  Forall2 (fun j l => error j = Q2R (error_of l)) js0 ls0 -> is_largest E (map_all error_of ls0) = true ->
  largest_is error js0 E.
Proof.
  unfold is_largest, map_all. rewrite map_all_map. intros F H. apply andb_prop in H as (A & B).
  rewrite forallb_forall in A. assert (forall i, In i js0 -> error i <= Q2R (snd (error_within E)) / 100) as Le.
  { clear B. induction F as [|j l js0 ls0 H F IH]; intros i [].
    - subst i. specialize (A (error_of l) (or_introl eq_refl)). apply at_most_real in A. unfold in_percent in A.
      rewrite Q2R_times, Q2R_integer, <- H in A. lra.
    - apply IH; [intros x X; apply A; right; exact X | assumption]. }
  split; [exact Le|]. assert (Forall2 (fun j x => error j = Q2R x) js0 (map error_of ls0)) as F'.
  { clear -F. induction F; constructor; assumption. }
  pose proof (of_class_both _ _ _ F' (at_class E)) as L. destruct (of_class (at_class E) (map error_of ls0)) as [x|]; [|discriminate].
  destruct (of_class (at_class E) js0) as [i|] eqn:Ei; [|destruct L]. exists i. split; [reflexivity|].
  apply at_most_real in B. unfold in_percent in B. rewrite Q2R_times, Q2R_integer, <- L in B.
  split; [lra | exact (Le i (of_class_in _ _ _ Ei))].
Qed.

Lemma errors_true E : is_largest (of_shares E) (map_all retained_error_of ls) = true ->
  passing_error_is (of_passing E) (passing_errors ls) = true -> encloses (of_all_shares E) (total_error_of ls) = true ->
  errors_hold f G S E.
Proof.
  intros A B C. unfold errors_hold. fold rs js. split; [|split].
  - apply (largest_true _ js ls _ retained_error_of); [|exact A]. clear -lines_are. induction lines_are as [|j l js0 ls0 (X & Y & _) F IH];
      [constructor|]. constructor; [|exact (IH F)]. unfold share_error, retained_error_of. rewrite distance_real, X, Y. reflexivity.
  - unfold passing_errors in B. rewrite but_last_is in B. pose proof (removelast_both _ _ _ lines_are) as F.
    destruct (of_passing E) as [E'|].
    + apply (largest_true _ _ (removelast ls) _ passing_error_of).
      * clear -F. induction F as [|j l js0 ls0 (_ & _ & X & Y) F IH]; [constructor|]. constructor; [|exact IH].
        unfold passing_share_error, passing_error_of. rewrite distance_real, X, Y. reflexivity.
      * unfold passing_error_is in B. destruct (map_all passing_error_of (removelast ls)); [discriminate | exact B].
    + destruct F as [|j l js0 ls0 _ F]; [reflexivity|]. unfold map_all in B. rewrite map_all_map in B. discriminate B.
  - rewrite total_is. apply encloses_real, C.
Qed.

Lemma yes_or_no_is (holds : bool) (P : Prop) : (holds = true <-> P) -> answer_is (yes_or_no holds) P.
Proof. destruct holds; simpl; intros (A & B); [auto | intro H; discriminate (B H)]. Qed.
End Asked.

(* ---- The theorem ------------------------------------------------------------------------------------- *)

Lemma judged_accepted gradation sample certificate line :
  printed (judge_sample gradation sample certificate) = Some line -> begins_with "accepted" line ->
  exists R C G F D, read_gradation (bytes gradation) = Ok R /\ agrees (without_claim C) (limits_or_none R) = true /\
    asked_of_sample R C = Ok G /\ read_sample (sizes_in R) (bytes sample) = Ok F /\ derive_sample (question_of C) G F = Ok D /\
    check_claims C G D = Ok tt /\ gives_openings R (question_of C) = true /\
    let s := sample_statement_of (name gradation) (name sample) R C in
    plain_sample_statement s = true /\ line = sample_line s.
Proof.
  unfold judge_sample. destruct (read_gradation (bytes gradation)) as [R| |]; try discriminate.
  destruct (read_asked R (bytes certificate)) as [(C, G)| |] eqn:EA; try discriminate; [|intros [= <-] (rest & H); discriminate H].
  destruct (read_derived R C G (bytes sample)) as [D| |] eqn:ED; try discriminate. cbv zeta.
  destruct (check_claims C G D ;; demand_form _ _) as [u| |] eqn:EC; try discriminate;
    [|intros [= <-] (rest & H); discriminate H].
  intros [= <-] _. unfold read_asked in EA. cbv zeta in EA. passed EA. rename x into C0. passed EA. passed EA. rename x into G0.
  injection EA as -> ->. unfold read_derived in ED. passed ED. rename x into F.
  destruct (derive_sample (question_of C) G F) as [D0| |] eqn:Der; try discriminate. injection ED as ->.
  passed EC. destruct x, u. apply demand_form_ok in EC. apply andb_prop in EC as (Gv & Plain).
  exists R, C, G, F, D. split; [reflexivity|]. split; [|repeat split; assumption].
  pose proof EA2 as As. unfold asked_of_sample in As. passed As. apply eqb_prop in As0. unfold agrees in *.
  apply andb_prop in EA1 as (A & B). rewrite A. cbn [without_claim band_of_file box_of certificate_of] in *. rewrite As0 in *.
  unfold limits_or_none. destruct (limits R); exact B.
Qed.

Lemma asked_of_sample_ok R C G : asked_of_sample R C = Ok G ->
  asked_gradation (gradation_of R) (certificate_of (without_claim C)) = Ok G /\ well_formed G = true /\
  sensible (certificate_of (without_claim C)) = true /\ asks_for_shares (question_of C) = true.
Proof.
  unfold asked_of_sample. cbv zeta. intro H. passed H. passed H. passed H. passed H. injection H as ->.
  rewrite !andb_true_iff in H1. unfold asked_gradation. tauto.
Qed.

Lemma proper_tolerances cert : sensible cert = true -> let t := tolerances_or_exactly (asked cert) in
  Forall (fun e => 0 <= Q2R e) (passing_each t) /\ (forall e, passing_all t = Some e -> 0 <= Q2R e) /\
  (forall X l h, In (X, l, h) (band t) -> 0 <= Q2R X /\ 0 <= Q2R h).
Proof.
  intro Sen. cbv zeta. unfold tolerances_or_exactly. destruct (tolerances_of (asked cert)) as [tol|] eqn:E.
  - destruct (sensible_tolerances cert tol Sen E) as (_ & A & B & C & _). auto.
  - repeat split; try discriminate; [constructor | destruct H..].
Qed.

(* If the line that is printed begins with "accepted", it is true of the sample and of the gradation in the files. *)
Theorem accepted_sample_line_true gradation sample certificate line :
  printed (judge_sample gradation sample certificate) = Some line -> begins_with "accepted" line ->
  true_of_sample_line gradation sample line.
Proof.
  intros P B. destruct (judged_accepted _ _ _ _ P B) as (R & C & G & F & D & ER & Ag & EA & ES & ED & EC & Gv & Plain & ->).
  set (q := question_of C) in *. set (s := sample_statement_of (name gradation) (name sample) R C) in *.
  exists s. split; [exact Plain|]. split; [reflexivity|]. split; [reflexivity|]. split; [reflexivity|].
  destruct (asked_of_sample_ok _ _ _ EA) as (As & W & Sen & Only).
  destruct (JudgeTheorem.question_said (name gradation) R (without_claim C)) as (La & _ & _ & Fa).
  exists R, G, (a q), (b q), F. split; [exact ER|]. split; [apply file_said|]. split; [apply gradation_said, As|].
  split; [exact La|]. pose proof Sen as Sen'. unfold sensible in Sen. cbv zeta in Sen. cbn [without_claim certificate_of asked] in Sen.
  fold q in Sen. rewrite !andb_true_iff, !Z.leb_le in Sen.
  split; [tauto|]. split; [tauto|]. split; [exact ES|]. intros f Power. fold s in Fa.
  change (parts (question_in_line s)) with (parts (statement_of (name gradation) R (without_claim C))). rewrite Fa.
  cbn [without_claim certificate_of asked]. fold q.
  (* The law in terms of the power of sizes. *)
  unfold derive_sample in ED. cbv zeta in ED. passed ED. rename ED0 into Pa.
  destruct (power_of_mass q (power_of_sizes F)) as [e|] eqn:Ee; [|discriminate]. passed ED. passed ED.
  unfold power_of_mass in Ee. destruct ((1 <=? power_of_sizes F)%Z && (b q =? 1)%Z && (a q mod power_of_sizes F =? 0)%Z) eqn:Eb; [|discriminate].
  injection Ee as <-. rewrite !andb_true_iff, Z.leb_le, !Z.eqb_eq in Eb. destruct Eb as ((N1 & B1) & Mo).
  destruct (power_of_sizes F) as [|N|N] eqn:EN; try lia. set (e := (a q / Zpos N)%Z) in *.
  assert (a q = Zpos N * e)%Z as Ea by (unfold e; pose proof (Z.div_mod (a q) (Zpos N) ltac:(lia)); lia).
  assert (0 <= e)%Z as E0 by nia.
  assert (power_law (Z.to_nat e * Pos.to_nat N) 1 f) as Law.
  { rewrite B1 in Power. replace (Z.to_nat e * Pos.to_nat N)%nat with (Z.to_nat (a q)); [exact Power|]. rewrite Ea. nia. }
  unfold are_particles in Pa. apply andb_prop in Pa as (Pa & Ne).
  assert (Forall proper_particles (rows_of_sample F)) as Sizes.
  { apply Forall_forall. rewrite forallb_forall in Pa. intros r I. specialize (Pa r I). apply andb_prop in Pa as (X & Y).
    apply less_real in X. rewrite Q2R_0 in X. apply Z.leb_le in Y. split; assumption. }
  assert (rows_of_sample F <> []) as NotE by (destruct (rows_of_sample F); [discriminate | congruence]).
  unfold sizes_in_file. rewrite EN. cbn [Z.to_pos]. set (rows := rows_of_sample F) in *. set (d := root_of G).
  pose proof (well_formed_root G W) as Rd. fold d in Rd. rewrite Rd in *.
  destruct (well_formed_proper G W) as (Wp & M).
  unfold derive_rows in ED. cbv zeta in ED. passed ED. injection ED as ED.
  assert (map_all (fun j => mass_in (Zpos d) (Zpos N) e j rows) (classes (Gradation.rows G)) =
    masses d N (Gradation.rows G) rows (Z.to_nat e)) as Ms.
  { unfold map_all, masses. rewrite map_all_map, Z2Nat.id by exact E0. reflexivity. }
  rewrite Ms in *. set (ls := shares_of_sample (classes (Gradation.rows G)) (masses d N (Gradation.rows G) rows (Z.to_nat e))) in *.
  pose proof (shares_are_of_sample d N (Gradation.rows G) Wp rows Sizes (Z.to_nat e) f Law M) as Lines. fold ls in Lines.
  (* The claims. *)
  unfold check_claims in EC. cbv zeta in EC. passed EC. passed EC. rename x into ss.
  do 10 passed EC. apply demand_ok in EC.
  rewrite Z.eqb_eq in *. set (t := tolerances_or_exactly q) in *.
  unfold asks_for_shares in Only. fold q in Only. rewrite !andb_true_iff, !Z.eqb_eq in Only. destruct Only as ((O1 & O3) & O2).
  assert (min_per_class q = 0%Z /\ solids_of q = Anything /\ at_least q = 0%Z) as Nothing
    by (destruct (solids_of q); try discriminate; auto).
  destruct (proper_tolerances _ Sen') as (Te & Tp & Tb). cbn [without_claim certificate_of asked] in Te, Tp, Tb. fold q t in Te, Tp, Tb.
  pose proof (factor_of_question _ Sen') as Kn. cbn [without_claim certificate_of asked] in Kn. fold q in Kn.
  fold q t in EC1, EC. rename x1 into ss'. set (S := sample_of N rows).
  assert (forall T, matches f G (size_factor q) (sizes_in R) (limits_or_none R) T (question_in_line s) <-> allowed f q G T) as Al.
  { intro T. apply (matches_allowed f (name gradation) R (without_claim C) G T Ag Gv As); [rewrite Rd; lia | exact Kn]. }
  pose proof (described d N (Gradation.rows G) Wp rows Sizes) as Des. fold S in Des.
  pose proof (number_outside_is d N (Gradation.rows G) Wp rows Sizes) as Out. fold S in Out.
  rewrite <- ED in EC2, EC5, EC8, EC9, EC10, EC11. cbn [particles_in_all particles_outside lines_of_shares derived_total derived_conditions] in EC2, EC5, EC8, EC9, EC10, EC11.
  unfold says. split; [|split; [|split]].
  - change (particles_said s) with (claimed_particles (claims C)). rewrite EC2. apply all_is_length, Sizes.
  - unfold finding_holds. fold d. change (finding_said s) with (found_to_be (claims C)).
    change (outside_said s) with (outside_of (claims C)). unfold outside_of. rewrite EC5.
    destruct (found_to_be (claims C)) as [| |what found_in least v].
    + apply Al. unfold finding_is in EC. rewrite <- ED in EC. cbn [particles_outside lines_of_shares derived_total] in EC.
      rewrite !andb_true_iff, Z.eqb_eq in EC. destruct EC as ((EO & EW) & ET).
      apply (match_allowed q G f W Nothing Kn Tb Te Tp (proj1 Power) ss' EC1 N rows Sizes NotE ls Lines); [apply Des, EO | exact EW|].
      intros E Et. change (Certificate.total t = Some E) in Et. rewrite Et in ET. apply at_most_real in ET.
      unfold in_percent in ET. rewrite Q2R_times, Q2R_integer in ET. fold S.
      pose proof (total_is G f N rows ls Lines) as Tot. fold S in Tot. rewrite Tot. lra.
    + unfold finding_is in EC. rewrite <- ED in EC. cbn [particles_outside] in EC. apply Z.leb_le in EC.
      split; [|split; [exact Out | exact EC]]. intro H. apply Al in H.
      apply (allowed_is_within q G f W Nothing (proj1 Power)) in H as (H & _). apply Des in H. lia.
    + destruct (misses_true q G f W Nothing Kn Tb Te Tp (proj1 Power) ss' EC1 N rows ls Lines D what found_in least v) as ((x & V & En & Cmp) & Asked);
        [rewrite <- ED; reflexivity | rewrite <- ED; reflexivity | exact EC|]. fold S in V. split; [|split].
      * intro H. apply Al in H. specialize (Asked S x H V). destruct least; lra.
      * exists x. auto.
      * intros T y H Vy. apply (Asked T y); [apply Al, H | exact Vy].
  - change (errors_of s) with (if is_match (found_to_be (claims C)) && is_exact (statement_of (name gradation) R (without_claim C)) then None
      else Some (ErrorsSaid (retained_error (claims C)) (passing_error (claims C)) (total_error (claims C)))).
    destruct (is_match _ && is_exact _); [exact I|]. apply (errors_true G f N rows ls Lines); cbn [of_shares of_passing of_all_shares]; assumption.
  - change (conditions_said s) with (conditions (claims C)). apply same_answers_ok in EC11. rewrite EC11. unfold conditions_hold. fold d.
    destruct Wp as (Wp1 & Wp2 & Comp & Wp3). pose proof (conj Wp1 (conj Wp2 (conj Comp Wp3)) : proper_rows (Gradation.rows G)) as Wp.
    destruct (number_where (is_outside (Zpos d) (Zpos N) (Gradation.rows G)) rows =? 0)%Z eqn:EO.
    + apply Z.eqb_eq in EO. apply Des in EO. constructor; [exact Comp|]. constructor; [exact EO|].
      constructor; [apply yes_or_no_is, (described_articulately d N (Gradation.rows G) Wp rows Sizes), EO|].
      constructor; [|constructor].
      apply yes_or_no_is, (described_accurately d N (Gradation.rows G) Wp rows (Z.to_nat e) f Law M ls Lines), EO.
    + assert (~ describes d (Gradation.rows G) S) as No by (intro H; apply Des in H; apply Z.eqb_neq in EO; contradiction).
      constructor; [exact Comp|]. constructor; [exact No|]. constructor; [intros (H & _); contradiction|].
      constructor; [intros (sc & _ & H & _); contradiction | constructor].
Qed.
