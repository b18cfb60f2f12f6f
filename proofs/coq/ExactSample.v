(* What is counted and added up of a sample whose sizes have rational powers, by a law that gives them rational masses, is its
   particles, masses, shares and errors, and Conditions 2 to 4 (Theorem 23, where nothing is enclosed). *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Rows SampleFile SampleTally Spec Openings RealFacts Reduction Sizes
  Shares TolerantSound JudgeTheorem.
Import ListNotations.
Open Scope R_scope.

(* ---- Lists ------------------------------------------------------------------------------------------ *)

Lemma sum_of_real xs : Q2R (sum_of xs) = total (map Q2R xs).
Proof.
  unfold sum_of. assert (forall x, Q2R (fold_left add xs x) = Q2R x + total (map Q2R xs)) as G.
  { induction xs as [|y xs IH]; intro x; cbn [fold_left map total fold_right]; [ring|].
    rewrite IH, Q2R_add. unfold total. ring. }
  rewrite G, Q2R_0. ring.
Qed.

Lemma total_ext {A} (g h : A -> R) l : (forall x, In x l -> g x = h x) -> total (map g l) = total (map h l).
Proof.
  induction l as [|x l IH]; intro H; [reflexivity|]. cbn [map total fold_right]. rewrite (H x) by (left; reflexivity).
  f_equal. apply IH. intros y Y. apply H. right. exact Y.
Qed.

Lemma number_where_sum such rows : number_where such rows = sum (map how_many (filter such rows)).
Proof.
  unfold number_where. assert (forall n, fold_left (fun n r => if such r then n + how_many r else n)%Z rows n =
    (n + sum (map how_many (filter such rows)))%Z) as G.
  { induction rows as [|r rows IH]; intro n; cbn [fold_left filter map sum fold_right]; [lia|].
    rewrite IH. destruct (such r); cbn [map sum fold_right]; unfold sum; lia. }
  rewrite G. lia.
Qed.

Lemma filter_all_true {A} (l : list A) : filter (fun _ => true) l = l.
Proof. induction l as [|x l IH]; [reflexivity | cbn [filter]; rewrite IH; reflexivity]. Qed.

(* ---- Rows as particles ------------------------------------------------------------------------------ *)

Definition proper_particles (r : particles) : Prop := 0 < Q2R (size_of_each r) /\ (1 <= how_many r)%Z.

Section Sample.
Variables d N : positive.

Definition real_size (r : particles) : R := nth_root N (Q2R (size_of_each r)).
Definition sample_of (rows : list particles) : sample :=
  flat_map (fun r => repeat (real_size r) (Z.to_nat (how_many r))) rows.

(* The particles that are outside all classes. *)
Definition lies_outside (rs : list row) (x : R) : Prop := ~ (least_opening d rs < x <= largest_opening d rs).
Definition lies_outside_dec (rs : list row) (x : R) : {lies_outside rs x} + {~ lies_outside rs x}.
Proof.
  unfold lies_outside. destruct (Rlt_dec (least_opening d rs) x), (Rle_dec x (largest_opening d rs)); [right|left..]; tauto.
Defined.
Definition number_outside (rs : list row) (S : sample) : Z :=
  Z.of_nat (length (filter (fun x => if lies_outside_dec rs x then true else false) S)).

Lemma above_is y r : 0 <= Q2R y -> proper_particles r ->
  (above_opening (Zpos d) (Zpos N) y r = true <-> size_of d y < real_size r).
Proof.
  intros Y (P & _). unfold above_opening, size_of, real_size. rewrite less_real, !Q2R_power_pos.
  pose proof (nth_root_nonneg (d := d) (Q2R y)). pose proof (nth_root_nonneg (d := N) (Q2R (size_of_each r))).
  rewrite (pow_lt_iff (nth_root d (Q2R y)) (nth_root N (Q2R (size_of_each r))) (Pos.to_nat d * Pos.to_nat N)) by (lra || lia).
  rewrite pow_mult, (Nat.mul_comm (Pos.to_nat d)), pow_mult, !nth_root_power by lra. reflexivity.
Qed.

Lemma above_not y r : 0 <= Q2R y -> proper_particles r ->
  (above_opening (Zpos d) (Zpos N) y r = false <-> real_size r <= size_of d y).
Proof.
  intros Y P. pose proof (above_is y r Y P) as A. destruct (above_opening _ _ y r).
  - assert (size_of d y < real_size r) by (apply A; reflexivity). split; [discriminate | lra].
  - split; [|reflexivity]. intros _. destruct (Rle_lt_dec (real_size r) (size_of d y)); [assumption|].
    assert (false = true) by (apply A; assumption). discriminate.
Qed.

Lemma is_in_class j r : 0 <= Q2R (lower j) -> 0 <= Q2R (upper j) -> proper_particles r ->
  (is_in (Zpos d) (Zpos N) j r = true <-> in_class d j (real_size r)).
Proof.
  intros L U P. unfold is_in, in_class, lower_size, upper_size.
  pose proof (above_is _ r L P) as A. pose proof (above_not _ r U P) as B.
  destruct (above_opening _ _ (lower j) r).
  - rewrite negb_true_iff, B. split; [intro H; split; [apply A; reflexivity | exact H] | tauto].
  - split; [discriminate|]. intros (H & _). apply A in H. discriminate H.
Qed.

Lemma filter_rows (such : particles -> bool) (is : R -> bool) rows :
  (forall r, In r rows -> is (real_size r) = such r) -> filter is (sample_of rows) = sample_of (filter such rows).
Proof.
  induction rows as [|r rows IH]; intro H; [reflexivity|]. unfold sample_of in *. cbn [flat_map filter].
  rewrite filter_app, IH by (intros; apply H; right; assumption).
  assert (forall n, filter is (repeat (real_size r) n) = if such r then repeat (real_size r) n else []) as E.
  { rewrite <- (H r (or_introl eq_refl)). intro n. induction n as [|n I]; cbn [repeat filter].
    - destruct (is (real_size r)); reflexivity.
    - rewrite I. destruct (is (real_size r)); reflexivity. }
  rewrite E. destruct (such r); reflexivity.
Qed.

Lemma inside_rows j rows : 0 <= Q2R (lower j) -> 0 <= Q2R (upper j) -> Forall proper_particles rows ->
  inside d j (sample_of rows) = sample_of (filter (is_in (Zpos d) (Zpos N) j) rows).
Proof.
  intros L U P. rewrite Forall_forall in P. apply filter_rows. intros r I. pose proof (is_in_class j r L U (P r I)) as E.
  destruct (in_class_dec d j (real_size r)) as [Y|No], (is_in _ _ j r); try reflexivity.
  - symmetry. apply E, Y.
  - contradiction No. apply E. reflexivity.
Qed.

Lemma filtered_proper such rows : Forall proper_particles rows -> Forall proper_particles (filter such rows).
Proof. rewrite !Forall_forall. intros P r I. apply filter_In in I as (I & _). apply P, I. Qed.

Lemma length_rows rows : Forall proper_particles rows -> Z.of_nat (length (sample_of rows)) = sum (map how_many rows).
Proof.
  intro P. induction P as [|r rows (_ & Pr) P IH]; [reflexivity|]. unfold sample_of in *. cbn [flat_map map sum fold_right].
  rewrite app_length, repeat_length, Nat2Z.inj_add, IH, Z2Nat.id by lia. reflexivity.
Qed.

Theorem all_is_length rows : Forall proper_particles rows -> Z.of_nat (length (sample_of rows)) = all_particles rows.
Proof. intro P. unfold all_particles. rewrite number_where_sum, filter_all_true. apply length_rows, P. Qed.

(* The particles of a class, and their mass. *)
Theorem count_is_number j rows : proper j -> Forall proper_particles rows ->
  number d j (sample_of rows) = count_in (Zpos d) (Zpos N) j rows.
Proof.
  intros ((L & U) & _) P. unfold number, count_in. rewrite inside_rows, number_where_sum by (lra || assumption).
  apply length_rows, filtered_proper, P.
Qed.

Lemma sample_rows rows x : Forall proper_particles rows -> In x (sample_of rows) <-> exists r, In r rows /\ real_size r = x.
Proof.
  intro sizes. unfold sample_of. rewrite in_flat_map. split.
  - intros (r & I & X). apply repeat_spec in X. eauto.
  - intros (r & I & <-). exists r. split; [exact I|]. rewrite Forall_forall in sizes. destruct (sizes r I) as (_ & P).
    destruct (Z.to_nat (how_many r)) eqn:E; [lia | left; reflexivity].
Qed.

Lemma same_real_size r s : proper_particles r -> proper_particles s ->
  (equal (size_of_each r) (size_of_each s) = true <-> real_size r = real_size s).
Proof.
  intros (P & _) (P' & _). rewrite equal_real. unfold real_size. split; [intros ->; reflexivity|]. intro E.
  rewrite <- (nth_root_power (d := N) (Q2R (size_of_each r))), E, nth_root_power by lra. reflexivity.
Qed.

Section Gradation.
Variable rs : list row.
Hypothesis proper_gradation : proper_rows rs.
Notation js := (classes rs).

(* Condition 4 of any sample, in shares. *)
Section Accurate.
Variable f : R -> R.
Hypothesis law : mass_law f.
Hypothesis some_mass : exists j, In j js /\ 0 < Q2R (mass j).
Variable S : sample.

Lemma held_of_none j : In j js -> mass_of_all d f rs S = 0 -> held d f j S = 0.
Proof.
  intros J Z. pose proof (fun j J => held_nonneg (d := d) f rs S law proper_gradation j J) as Nn.
  pose proof (total_member (fun j => held d f j S) js j Nn J) as M. pose proof (Nn j J). unfold mass_of_all in Z. cbv beta in M. lra.
Qed.

Lemma mass_where_accurate : (forall j, In j js -> share_retained d f rs j S = target_retained rs j) -> 0 < mass_of_all d f rs S.
Proof.
  intro H. pose proof (gradation_mass_positive rs proper_gradation some_mass) as Gm. destruct some_mass as (j0 & J0 & M0).
  pose proof (fun j J => held_nonneg (d := d) f rs S law proper_gradation j J) as Nn.
  pose proof (total_nonneg (fun j => held d f j S) js Nn) as T. fold (mass_of_all d f rs S) in T.
  destruct (Req_dec (mass_of_all d f rs S) 0) as [Z|Z]; [|lra]. specialize (H j0 J0).
  unfold share_retained, target_retained in H. rewrite (held_of_none j0 J0 Z) in H.
  assert (0 < Q2R (mass j0) / gradation_mass rs) by (apply Rdiv_lt_0_compat; assumption). unfold Rdiv in H at 1. lra.
Qed.

Lemma accurate_shares : describes d rs S ->
  (describes_accurately d f rs S <-> forall j, In j js -> share_retained d f rs j S = target_retained rs j).
Proof.
  intro D. pose proof (gradation_mass_positive rs proper_gradation some_mass) as Gm. split.
  - intros (s & Sp & _ & H) j J. assert (mass_of_all d f rs S = s * gradation_mass rs) as E.
    { unfold mass_of_all, gradation_mass. revert H. generalize js. induction l as [|i l IH]; intro H; cbn [map total fold_right]; [ring|].
      unfold total in IH. rewrite IH by (intros; apply H; right; assumption). rewrite H by (left; reflexivity). ring. }
    unfold share_retained, target_retained. rewrite E, H by exact J. field. lra.
  - intro H. pose proof (mass_where_accurate H) as M.
    exists (mass_of_all d f rs S / gradation_mass rs). split; [apply Rdiv_lt_0_compat; assumption|]. split; [exact D|].
    intros j J. specialize (H j J). unfold share_retained, target_retained in H.
    apply (Rmult_eq_reg_r (/ mass_of_all d f rs S)); [|apply Rinv_neq_0_compat; lra].
    unfold Rdiv in H. rewrite H. field. lra.
Qed.
End Accurate.

Variable rows : list particles.
Hypothesis sizes : Forall proper_particles rows.
Notation S := (sample_of rows).

Lemma proper_class j : In j js -> proper j.
Proof. intro J. pose proof (proper_classes rs proper_gradation) as P. rewrite Forall_forall in P. apply P, J. Qed.

Lemma first_is_least r l s : ascending (r :: l) = true -> In s (r :: l) -> Q2R (opening r) <= Q2R (opening s).
Proof.
  revert r. induction l as [|t l IH]; intros r A [<-|I]; try lra; [destruct I|]. cbn [ascending] in A.
  apply andb_prop in A as (A & B). apply less_real in A. specialize (IH t B I). lra.
Qed.

Lemma openings_nonneg : 0 <= Q2R (finest rs) /\ 0 <= Q2R (opening (last_row rs)).
Proof.
  destruct proper_gradation as (A & L & _). split; [exact L|]. unfold last_row.
  destruct rs as [|r l]; [simpl; rewrite Q2R_0; lra|]. simpl in L.
  assert (In (last (r :: l) (Row 0 0 1 0)) (r :: l)) as I.
  { clear. revert r. induction l as [|s l IH]; intro r; [left; reflexivity | right; apply IH]. }
  pose proof (first_is_least r l _ A I). lra.
Qed.

(* Condition 2, and the particles that are outside all classes. *)
Lemma outside_is r : In r rows -> (is_outside (Zpos d) (Zpos N) rs r = true <-> lies_outside rs (real_size r)).
Proof.
  intro I. rewrite Forall_forall in sizes. destruct openings_nonneg as (F & L). pose proof (sizes r I) as P.
  unfold is_outside, is_below, is_above, lies_outside, least_opening, largest_opening, finest in *.
  pose proof (above_not _ r F P) as A. pose proof (above_not _ r L P) as B. pose proof (above_is _ r L P) as C.
  rewrite orb_true_iff, negb_true_iff, A, C. destruct (Rle_lt_dec (real_size r) (size_of d (opening (hd (Row 0 0 1 0) rs)))),
    (Rle_lt_dec (real_size r) (size_of d (opening (last_row rs)))); lra.
Qed.

Theorem number_outside_is : number_outside rs S = number_where (is_outside (Zpos d) (Zpos N) rs) rows.
Proof.
  unfold number_outside. rewrite number_where_sum, (filter_rows (is_outside (Zpos d) (Zpos N) rs)).
  - apply length_rows, filtered_proper, sizes.
  - intros r I. pose proof (outside_is r I) as O. destruct (lies_outside_dec rs (real_size r)), (is_outside _ _ rs r); try reflexivity.
    + symmetry. apply O. assumption.
    + exfalso. apply n, O. reflexivity.
Qed.

Lemma sum_zero l : Forall proper_particles l -> (sum (map how_many l) = 0)%Z -> l = [].
Proof.
  destruct l as [|r l]; [reflexivity|]. intros P E. exfalso. inversion P as [|? ? (_ & Q) P']; subst.
  assert (0 <= sum (map how_many l))%Z.
  { clear -P'. induction P' as [|s l (_ & Q) P IH]; cbn [map sum fold_right]; unfold sum in *; lia. }
  cbn [map sum fold_right] in E. unfold sum in *. lia.
Qed.

Theorem described : number_where (is_outside (Zpos d) (Zpos N) rs) rows = 0%Z <-> describes d rs S.
Proof.
  rewrite number_where_sum. split.
  - intro E. apply sum_zero in E; [|apply filtered_proper, sizes]. split; [apply proper_gradation|]. intros x X.
    apply sample_rows in X as (r & I & <-); [|exact sizes]. pose proof (outside_is r I) as O.
    pose proof (filter_In (is_outside (Zpos d) (Zpos N) rs) r rows) as F. rewrite E in F.
    destruct (is_outside _ _ rs r); [destruct F as (_ & F); destruct (F (conj I eq_refl))|].
    unfold lies_outside in O. destruct (Rlt_dec (least_opening d rs) (real_size r)), (Rle_dec (real_size r) (largest_opening d rs));
      try (split; assumption); exfalso; assert (false = true) by (apply O; lra); discriminate.
  - intros (_ & H).
    assert (filter (is_outside (Zpos d) (Zpos N) rs) rows = []) as ->; [|reflexivity].
    destruct (filter (is_outside (Zpos d) (Zpos N) rs) rows) as [|r l] eqn:E; [reflexivity|].
    assert (In r rows /\ is_outside (Zpos d) (Zpos N) rs r = true) as (I & O) by (apply filter_In; rewrite E; left; reflexivity).
    apply (outside_is r I) in O. contradiction O. apply H, sample_rows; [exact sizes | eauto].
Qed.

(* Condition 3: one size a class. *)
Lemma no_opening_inside l : forall j s, ascending l = true -> In j (classes l) -> In s l ->
  lower_size d j < size_of d (opening s) < upper_size d j -> False.
Proof.
  induction l as [|x [|y l] IH]; intros j s A J I (L & U); try (destruct J; fail).
  pose proof A as A'. cbn [ascending] in A. apply andb_prop in A as (A & B). apply less_real in A. destruct J as [<-|J].
  - unfold lower_size, upper_size in *. cbn [lower upper] in *. destruct I as [<-|I]; [lra|].
    pose proof (nth_root_le (d := d) _ _ (first_is_least y l s B I)). unfold size_of in *. lra.
  - destruct I as [<-|I]; [|exact (IH j s B J I (conj L U))].
    destruct (class_of_rows _ _ J) as (K & _). apply in_map_iff in K as (t & E & K).
    pose proof (first_is_least y l t B K) as F. rewrite E in F. unfold lower_size, size_of in L.
    pose proof (nth_root_le (d := d) (Q2R (opening x)) (Q2R (lower j)) ltac:(lra)). unfold size_of in *. lra.
Qed.

Lemma row_in r j : In r rows -> In j js -> (is_in (Zpos d) (Zpos N) j r = true <-> in_class d j (real_size r)).
Proof.
  intros I J. destruct (proper_class j J) as ((L & U) & _). rewrite Forall_forall in sizes. apply is_in_class; [lra | lra | apply sizes, I].
Qed.

Lemma one_size_iff j : (one_size (Zpos d) (Zpos N) j rows = true <->
  forall r s, In r rows -> In s rows -> is_in (Zpos d) (Zpos N) j r = true -> is_in (Zpos d) (Zpos N) j s = true ->
    real_size r = real_size s).
Proof.
  pose proof sizes as P. rewrite Forall_forall in P. unfold one_size.
  destruct (find (is_in (Zpos d) (Zpos N) j) rows) as [t|] eqn:F.
  - apply find_some in F as (T & Ht). rewrite forallb_forall. split.
    + intros H. assert (forall r, In r rows -> is_in (Zpos d) (Zpos N) j r = true -> real_size t = real_size r) as All.
      { intros r I Hr. specialize (H r I). rewrite Hr in H. apply same_real_size in H; auto. }
      intros r s I I' Hr Hs. rewrite <- (All r I Hr). exact (All s I' Hs).
    + intros H s I. destruct (is_in _ _ j s) eqn:E; [|reflexivity]. apply same_real_size; auto.
  - split; [|reflexivity]. intros _ r s I _ H _. pose proof (find_none _ _ F r I). congruence.
Qed.

Theorem described_articulately :
  describes d rs S -> (forallb (fun j => one_size (Zpos d) (Zpos N) j rows) js = true <-> describes_articulately d rs S).
Proof.
  intro D. rewrite forallb_forall. split.
  - intro H. apply one_size_articulate; [exact proper_gradation | exact D|]. intros j x y J X Y Cx Cy.
    apply sample_rows in X as (r & I & <-); [|exact sizes]. apply sample_rows in Y as (s & I' & <-); [|exact sizes].
    apply (proj1 (one_size_iff j) (H j J)); trivial; apply row_in; assumption.
  - intros (_ & H) j J. apply one_size_iff. intros r s I I' Hr Hs.
    apply row_in in Hr, Hs; trivial. destruct proper_gradation as (A & _).
    assert (forall x y, In x S -> In y S -> in_class d j x -> in_class d j y -> x < y -> False) as No.
    { intros x y X Y (Lx & Ux) (Ly & Uy) L. destruct (H x y X Y L) as (t & It & Lt & Ut).
      apply (no_opening_inside rs j t A J It). lra. }
    pose proof (proj2 (sample_rows rows _ sizes) (ex_intro _ r (conj I eq_refl))) as X.
    pose proof (proj2 (sample_rows rows _ sizes) (ex_intro _ s (conj I' eq_refl))) as Y.
    destruct (Rtotal_order (real_size r) (real_size s)) as [L|[E|L]]; [|exact E|]; exfalso; eauto.
Qed.

(* ---- Masses and shares ------------------------------------------------------------------------------ *)

Variables (e : nat) (f : R -> R).
Hypothesis law : power_law (e * Pos.to_nat N) 1 f.

Lemma law_value r : proper_particles r -> f (real_size r) = Q2R (mass_of_each (Z.of_nat e) r).
Proof.
  intros (P & _). unfold real_size, mass_of_each. pose proof (nth_root_nonneg (d := N) (Q2R (size_of_each r))) as X.
  destruct (proj2 law _ X) as (_ & E). rewrite pow_1 in E.
  rewrite E, Nat.mul_comm, pow_mult, nth_root_power, Q2R_power by lra. reflexivity.
Qed.

Lemma total_rows l : Forall proper_particles l -> total (map f (sample_of l)) =
  total (map (fun r => IZR (how_many r) * Q2R (mass_of_each (Z.of_nat e) r)) l).
Proof.
  intro P. induction P as [|r l Pr P IH]; [reflexivity|]. unfold sample_of in *.
  cbn [flat_map map]. rewrite map_app, total_app, IH, total_repeat, law_value by exact Pr. cbn [total fold_right].
  destruct Pr as (_ & Pr). rewrite INR_IZR_INZ, Z2Nat.id by lia. reflexivity.
Qed.

Theorem mass_is_held j : In j js -> held d f j S = Q2R (mass_in (Zpos d) (Zpos N) (Z.of_nat e) j rows).
Proof.
  intro J. destruct (proper_class j J) as ((L & U) & _). unfold held, mass_in. rewrite inside_rows by (lra || assumption).
  rewrite Q2R_times, total_rows by apply filtered_proper, sizes. f_equal. clear sizes.
  assert (forall l m, Q2R (fold_left (fun m r => if is_in (Zpos d) (Zpos N) j r
      then add m (times (of_integer (how_many r)) (mass_of_each (Z.of_nat e) r)) else m) l m) =
    Q2R m + total (map (fun r => IZR (how_many r) * Q2R (mass_of_each (Z.of_nat e) r)) (filter (is_in (Zpos d) (Zpos N) j) l))) as G.
  { induction l as [|r l IH]; intro m; cbn [fold_left filter map total fold_right]; [ring|]. rewrite IH.
    destruct (is_in _ _ j r); [|reflexivity]. rewrite Q2R_add, Q2R_times, Q2R_integer. cbn [map total fold_right]. unfold total. ring. }
  rewrite G, Q2R_0. ring.
Qed.

Definition masses : list Q := map (fun j => mass_in (Zpos d) (Zpos N) (Z.of_nat e) j rows) js.

Lemma whole_is_mass_of_all : mass_of_all d f rs S = Q2R (sum_of masses).
Proof.
  unfold mass_of_all, masses. rewrite sum_of_real, map_map. apply total_ext. intros j J. apply mass_is_held, J.
Qed.

Lemma mass_of_gradation : gradation_mass rs = Q2R (sum_of (map_all mass js)).
Proof. unfold gradation_mass, map_all. rewrite map_all_map, sum_of_real, map_map. reflexivity. Qed.

Hypothesis some_mass : exists j, In j js /\ 0 < Q2R (mass j).

(* A line's shares are those of its class. *)
Definition shares_are (j : class) (l : shares_line) : Prop :=
  Q2R (share_of l) = share_retained d f rs j S /\ Q2R (target_of l) = target_retained rs j /\
  Q2R (passing_of l) = share_passing d f rs (upper_size d j) S /\
  Q2R (target_passing_of l) = target_passing d rs (upper_size d j).

Lemma share_is j : In j js ->
  Q2R (over (mass_in (Zpos d) (Zpos N) (Z.of_nat e) j rows) (sum_of masses)) = share_retained d f rs j S.
Proof.
  intro J. unfold share_retained. destruct (Req_dec (mass_of_all d f rs S) 0) as [Z|Z].
  - rewrite (held_of_none f (proj1 law) S j J Z). pose proof (mass_is_held j J) as E. rewrite (held_of_none f (proj1 law) S j J Z) in E.
    unfold over. rewrite Q2R_red. unfold Qdiv. rewrite Q2R_mult, <- E. unfold Rdiv. ring.
  - rewrite whole_is_mass_of_all, (mass_is_held j J) in *. apply Q2R_over, Z.
Qed.

Theorem shares_are_of_sample : Forall2 shares_are js (shares_of_sample js masses).
Proof.
  destruct (shares_prefix (d := d) f rs S proper_gradation) as (Py & PG).
  pose proof (gradation_mass_positive rs proper_gradation some_mass) as Gm.
  unfold shares_of_sample, masses.
  set (whole := sum_of (map (fun j => mass_in (Zpos d) (Zpos N) (Z.of_nat e) j rows) js)).
  set (all := sum_of (map_all mass js)).
  assert (forall l P G done, (forall j, In j l -> In j js) ->
    prefix_of (fun j => share_retained d f rs j S) (fun j => share_passing d f rs (upper_size d j) S) (Q2R P) l ->
    prefix_of (fun j => target_retained rs j) (fun j => target_passing d rs (upper_size d j)) (Q2R G) l ->
    exists ls, shares_lines whole all P G (combine l (map (fun j => mass_in (Zpos d) (Zpos N) (Z.of_nat e) j rows) l)) done =
      rev done ++ ls /\ Forall2 shares_are l ls) as A.
  { induction l as [|j l IH]; intros P G done Sub HP HG; cbn [map combine shares_lines].
    - exists []. rewrite app_nil_r. unfold rev'. rewrite <- rev_alt. split; [reflexivity | constructor].
    - destruct HP as (Ep & HP), HG as (Eg & HG). pose proof (share_is j (Sub j (or_introl eq_refl))) as Sh. fold masses in whole.
      fold whole in Sh. set (y := over (mass_in (Zpos d) (Zpos N) (Z.of_nat e) j rows) whole) in *.
      assert (Q2R (over (mass j) all) = target_retained rs j) as Ta.
      { unfold target_retained, all. rewrite mass_of_gradation in *. apply Q2R_over. lra. }
      destruct (IH (add P y) (add G (over (mass j) all)) (SharesLine y (add P y) (over (mass j) all) (add G (over (mass j) all)) :: done))
        as (ls & E & F).
      + intros i I. apply Sub. right. exact I.
      + rewrite Q2R_add, Sh, <- Ep. exact HP.
      + rewrite Q2R_add, Ta, <- Eg. exact HG.
      + exists (SharesLine y (add P y) (over (mass j) all) (add G (over (mass j) all)) :: ls). split.
        * rewrite E. cbn [rev]. rewrite <- app_assoc. reflexivity.
        * constructor; [|exact F]. unfold shares_are. cbn [share_of target_of passing_of target_passing_of].
          rewrite !Q2R_add, Sh, Ta, Ep, Eg. auto. }
  destruct (A js 0%Q 0%Q []) as (ls & -> & F); trivial; rewrite Q2R_0; assumption.
Qed.

(* Condition 4: the classes hold the shares that the gradation says. *)
Theorem described_accurately ls : Forall2 shares_are js ls -> describes d rs S ->
  (forallb (fun l => equal (share_of l) (target_of l)) ls = true <-> describes_accurately d f rs S).
Proof.
  intros F D. rewrite (accurate_shares f (proj1 law) some_mass S D).
  clear -F. induction F as [|j l js0 ls0 (A & B & _) F IH]; cbn [forallb].
  - split; [intros _ j [] | reflexivity].
  - rewrite andb_true_iff, equal_real, IH, A, B. split.
    + intros (H & T) i [<-|I]; [exact H | exact (T i I)].
    + intro H. split; [apply H; left; reflexivity | intros i I; apply H; right; exact I].
Qed.

(* Errors. *)
Lemma distance_real x y : Q2R (distance x y) = Rabs (Q2R x - Q2R y).
Proof.
  unfold distance. destruct (less x y) eqn:L; rewrite Q2R_subtract.
  - apply less_real in L. rewrite Rabs_left by lra. ring.
  - apply less_real_false in L. rewrite Rabs_right by lra. reflexivity.
Qed.

Theorem total_error_is ls : Forall2 shares_are js ls ->
  total (map (fun j => Rabs (share_retained d f rs j S - target_retained rs j)) js) = Q2R (total_error_of ls).
Proof.
  intro F. unfold total_error_of, map_all. rewrite map_all_map, sum_of_real, map_map. clear some_mass.
  induction F as [|j l js0 ls0 (A & B & _) F IH]; [reflexivity|]. cbn [map total fold_right]. unfold total in IH. rewrite IH.
  unfold retained_error_of. rewrite distance_real, A, B. reflexivity.
Qed.

End Gradation.
End Sample.
