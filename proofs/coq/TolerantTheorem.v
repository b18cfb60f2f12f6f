(* An accepted certificate of a match within a tolerance: no sample with fewer than N particles is within it, and one
   with N is; or there is none of any number (Theorems 12 and 14). *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Exact Tree Tolerant Spec Reduction RealFacts
  Solids TreeSound Shares TolerantSound.
From Mdm Require ExactTheorem.
Import ListNotations.
Open Scope R_scope.

Lemma total_map_le {A} (f g : A -> R) l : (forall i, In i l -> f i <= g i) -> total (map f l) <= total (map g l).
Proof.
  induction l as [|i l IH]; intro H; simpl; [lra|]. pose proof (H i (or_introl eq_refl)).
  specialize (IH ltac:(intros; apply H; right; assumption)). lra.
Qed.

Lemma total_map_minus {A} (f g : A -> R) l : total (map (fun i => f i - g i) l) = total (map f l) - total (map g l).
Proof. induction l as [|i l IH]; simpl; [ring | rewrite IH; ring]. Qed.

(* Deviations add up to 0: the positive ones to half of all (Theorem 12 (d)). *)
Lemma positive_part {A} (d : A -> R) l :
  2 * total (map (fun i => Rmax 0 (d i)) l) = total (map (fun i => Rabs (d i)) l) + total (map d l).
Proof.
  induction l as [|i l IH]; simpl; [ring|]. rewrite !Rmult_plus_distr_l, IH.
  assert (2 * Rmax 0 (d i) = Rabs (d i) + d i); [|lra].
  unfold Rmax, Rabs. destruct (Rle_dec 0 (d i)), (Rcase_abs (d i)); lra.
Qed.

Lemma below_at_most s S :
  proper_solids s -> has_solids s S -> s <> Anything -> Q2R (volume_below s) <= total (map sphere S).
Proof.
  intros P V Ne. assert (has_cubes s (total (map sphere S))) as H by (destruct s; exact V).
  pose proof (below_needed s _ P H) as B. destruct s; [congruence | exact B | left; exact B].
Qed.

Lemma some_positive {A} (w : A -> Z) l : (1 <= sum (map w l))%Z -> exists j, In j l /\ (1 <= w j)%Z.
Proof.
  induction l as [|i l IH]; intro L; [exfalso; compute in L; apply L; reflexivity|].
  change (1 <= w i + sum (map w l))%Z in L.
  destruct (Z_lt_le_dec (w i) 1) as [Lt|Ge]; [|exists i; split; [left; reflexivity | exact Ge]].
  destruct IH as (j & J & H); [lia|]. exists j. split; [right; exact J | exact H].
Qed.

Section Claim.
Variables (cert : certificate) (G : gradation) (tol : tolerances) (nodes : list node).
Notation q := (asked cert).
Notation rs := (rows G).
Notation js := (classes rs).
Notation na := (Z.to_nat (a q)).
Notation nb := (Z.to_nat (b q)).

Hypothesis tolerant : tolerances_of q = Some tol.
Hypothesis rows_proper : proper_rows rs.
Hypothesis some_mass : exists j, In j js /\ 0 < Q2R (mass j).
Hypothesis a_least : (1 <= a q)%Z.
Hypothesis b_least : (1 <= b q)%Z.
Hypothesis solids_proper : proper_solids (solids_of q).
Hypothesis solids_law : solids_of q = Anything \/ a q = 3%Z /\ b q = 1%Z.
Variable law : R -> R.
Hypothesis power : power_law na nb law.

Variable pr : problem.
Hypothesis derived : derive cert G tol = Ok pr.

Lemma nb_pos : (1 <= nb)%nat.
Proof. lia. Qed.

Notation mu := (IZR (mass_unit pr)).
Notation su := (IZR (share_unit pr)).

Lemma classes_ok j : In j js -> proper j.
Proof. pose proof (proper_classes rs rows_proper) as P. rewrite Forall_forall in P. apply P. Qed.

Lemma openings_nonneg : Forall (fun r => 0 <= Q2R (opening r)) rs.
Proof.
  destruct rows_proper as (A & L & _ & _). clear -A L. unfold least_opening in L. induction rs as [|r l IH]; constructor.
  - exact L.
  - destruct l as [|n l]; [constructor|]. cbn [ascending] in A. apply andb_prop in A as (A1 & A2). apply less_real in A1.
    apply IH; [exact A2|]. simpl in *. lra.
Qed.

Lemma den_divides (w : class -> Q) ss js0 j s :
  In (j, s) (combine js0 ss) -> forall d,
  In d (denominators (w j) s) -> In d (flat_map (fun '(w, s) => denominators w s) (combine (map w js0) ss)).
Proof.
  intros I d D. apply in_flat_map. exists (w j, s). split; [|exact D]. clear -I. revert ss I.
  induction js0 as [|i l IH]; intros [|s0 ss] I; try destruct I as [[= <- <-]|I]; try contradiction.
  - left; reflexivity.
  - right. apply IH, I.
Qed.

Record derivation (ss : list share) : Prop := {
  der_shares : shares_of q tol G = Ok ss;
  der_classes : Forall2 (fun js l => represents law (min_per_class q) (solids_of q) mu su (fst js) (snd js) l)
                  (combine js ss) (classes_of pr);
  der_mass : 0 < mu;
  der_share : 0 < su;
  der_half : IZR (half_total pr) = Q2R (half (Certificate.total tol)) * su;
  der_count : least_count pr = Z.max 1 (at_least q);
  der_volume : volume pr = volume_below (solids_of q);
  der_claim : claim pr = particles cert }.

Lemma derive_ok : exists ss, derivation ss.
Proof.
  pose proof derived as H. unfold derive in H. cbv zeta in H.
  passed H. rename x into ss. passed H. rename x into unit. passed H. rename x into roots. passed H. injection H as H.
  exists ss.
  assert (forall d, In d (flat_map (fun '(w, s) => denominators w s)
            (combine (map (inverse_factor (solids_of q)) js) ss)) -> (0 < d)%Z) as Dp.
  { intros d I. apply in_flat_map in I as ((w, s) & _ & I). unfold denominators in I.
    apply in_map_iff in I as (z & <- & _). reflexivity. }
  apply include_all_ok in H1 as (Up & Uh & Ud); [|reflexivity | exact Dp].
  replace (b q) with (Z.of_nat nb) in H2 by lia.
  apply rational_roots_real in H2; [|exact nb_pos | exact openings_nonneg].
  destruct (common_denominator_spec roots) as (Sp & Sd).
  destruct (common_denominator_spec (map factor rs)) as (Fp & Fd).
  assert (length ss = length js) as Le.
  { unfold shares_of in H0. cbv zeta in H0. passed H0. passed H0. passed H0.
    eapply apply_band_length; [|exact H0]. apply shares_length. }
  constructor; rewrite <- ?H; cbn [classes_of mass_unit share_unit half_total least_count volume claim]; trivial.
  - replace (a q) with (Z.of_nat na) by lia.
    apply (limits_represent na nb nb_pos law power); trivial.
    + intros r I. apply Fd, in_map, I.
    + intros j s I d D. apply Ud. eapply den_divides; eassumption.
  - apply IZR_lt. apply Z.mul_pos_pos; [apply Z.pow_pos_nonneg; lia | exact Fp].
  - apply IZR_lt, Up.
  - apply in_units_real, Uh.
Qed.

(* ---- A sample as a point ------------------------------------------------------------------------- *)

Section Sample.
Variable S : sample.
Variable ss : list share.
Hypothesis der : derivation ss.
Notation M := (mass_of_all law rs S).
Notation x := (fun j => share_retained law rs j S).
Notation y := (fun j => share_passing law rs (Q2R (upper j)) S).
Notation gx := (fun j => target_retained rs j).
Notation pass := (fun X => share_passing law rs X S).

Definition state_of (j : class) : state :=
  State (number j S) (held law j S) (Rmax 0 (held law j S - gx j * M)) (mass_passing law rs (Q2R (upper j)) S).

Hypothesis mass_positive : 0 < M.

Lemma meets_of j s l :
  In j js -> represents law (min_per_class q) (solids_of q) mu su j s l -> fits_share x y gx j s ->
  ((0 < mass j)%Q -> (min_per_class q <= number j S)%Z) -> meets pr M l (state_of j).
Proof.
  intros J [Ef EF Efl Erl Erh Epl Eph Eg _] (Gs & (R1 & R2) & (P1 & P2)) Fl.
  pose proof (der_mass _ der) as Mu. pose proof (der_share _ der) as Su.
  pose proof (sample_realizes law (proj1 power) j S (classes_ok j J)) as Rz.
  unfold share_retained in R1, R2. unfold share_passing in P1, P2.
  assert (forall b t, b <= t / M -> b * su * M <= t * su) as Lo.
  { intros b t H. apply (Rmult_le_compat_r (M * su)) in H; [|left; apply Rmult_lt_0_compat; assumption].
    replace (t / M * (M * su)) with (t * su) in H by (field; lra). lra. }
  assert (forall b t, t / M <= b -> t * su <= b * su * M) as Hi.
  { intros b t H. apply (Rmult_le_compat_r (M * su)) in H; [|left; apply Rmult_lt_0_compat; assumption].
    replace (t / M * (M * su)) with (t * su) in H by (field; lra). lra. }
  constructor; unfold state_of; cbn [q_of t_of p_of P_of].
  - split; [|unfold number; lia]. rewrite Efl. destruct (equal (mass j) 0) eqn:E; [unfold number; lia|].
    apply Fl. apply Rlt_Qlt. rewrite Q2R_0. destruct (classes_ok j J) as (_ & _ & [Mj|Mj]); [exact Mj|].
    exfalso. apply equal_false in E. apply E. apply eqR_Qeq. rewrite Q2R_0. auto.
  - rewrite Ef. destruct Rz as [(-> & ->)|(Q1 & B1 & B2)]; [split; [lra | lia]|].
    apply (Rmult_lt_compat_r mu) in B1; [|exact Mu]. split; [lra | intros _; lra].
  - rewrite EF. destruct Rz as [(-> & ->)|(Q1 & B1 & B2)]; [lra|].
    apply (Rmult_le_compat_r mu) in B2; lra.
  - rewrite Erl, Erh. split; [apply Lo, R1 | apply Hi, R2].
  - rewrite Epl, Eph. split; [apply Lo, P1 | apply Hi, P2].
  - rewrite Eg, Gs. split; [|apply Rmax_l].
    pose proof (Rmax_r 0 (held law j S - gx j * M)) as K. cbv beta in K. apply (Rmult_le_compat_r su) in K; [|lra]. lra.
Qed.

Lemma meets_all : forall l ss0 ls,
  (forall j, In j l -> In j js) ->
  Forall2 (fits_share x y gx) l ss0 ->
  Forall2 (fun js l => represents law (min_per_class q) (solids_of q) mu su (fst js) (snd js) l) (combine l ss0) ls ->
  (forall j, In j js -> (0 < mass j)%Q -> (min_per_class q <= number j S)%Z) ->
  Forall2 (meets pr M) ls (map state_of l).
Proof.
  intros l ss0 ls I F. revert ls. induction F as [|j s l ss0 Fj _ IH]; intros ls H Fl; cbn [combine] in H; inversion H; subst;
    cbn [map]; constructor.
  - eapply meets_of; [apply I; left; reflexivity | eassumption | exact Fj | apply Fl, I; left; reflexivity].
  - apply IH; trivial. intros i Ii. apply I. right; exact Ii.
Qed.

Lemma volumes : forall l ss0 ls,
  (forall j, In j l -> In j js) -> length ss0 = length l ->
  Forall2 (fun js l => represents law (min_per_class q) (solids_of q) mu su (fst js) (snd js) l) (combine l ss0) ls ->
  total (map (fun '(c, s) => t_of s * IZR (per_factor c) / su) (combine ls (map state_of l))) =
  total (map (fun j => held law j S * Q2R (inverse_factor (solids_of q) j)) l).
Proof.
  pose proof (der_share _ der) as Su.
  induction l as [|j l IH]; intros [|s ss0] ls I Le H; try discriminate; cbn [combine] in H; inversion H as [|? lj ? ls' Hj Hr]; subst;
    [reflexivity|].
  cbn [combine map total fold_right]. f_equal.
  - cbn [state_of t_of]. rewrite (rep_per_factor _ _ _ _ _ _ _ _ Hj). cbn [fst snd]. field. lra.
  - apply (IH ss0 ls'); [intros i Ii; apply I; right; exact Ii | injection Le as Le; exact Le | exact Hr].
Qed.

Lemma cubes_of_sample :
  describes rs S -> solids_of q <> Anything ->
  total (map (fun j => held law j S * Q2R (inverse_factor (solids_of q) j)) js) = total (map sphere S).
Proof.
  intros D Ne. destruct solids_law as [E|(A3 & B1)]; [congruence|].
  assert (power_law 3 1 law) as P31 by (rewrite A3, B1 in power; exact power).
  rewrite (cubes_by_class law rs S P31 rows_proper D). apply total_ext. intros j J.
  destruct (classes_ok j J) as (_ & C & _).
  assert (Q2R (inverse_factor (solids_of q) j) = 1 / Q2R (c j)) as ->.
  { unfold inverse_factor. destruct (solids_of q); [congruence|..]; rewrite Q2R_over, Q2R_integer by lra; reflexivity. }
  unfold Rdiv. ring.
Qed.

Lemma no_volumes : solids_of q = Anything ->
  total (map (fun j => held law j S * Q2R (inverse_factor (solids_of q) j)) js) = 0.
Proof.
  intro E. rewrite E. transitivity (total (map (fun j => 0 * held law j S) js)).
  - apply total_ext. intros j _. cbn [inverse_factor]. rewrite Q2R_0. ring.
  - rewrite total_scal. ring.
Qed.

(* The excesses p_j = max(0, t_j - g_j M). *)
Lemma excesses :
  2 * total (map (fun j => Rmax 0 (held law j S - gx j * M)) js) =
  M * total (map (fun j => Rabs (x j - gx j)) js).
Proof.
  pose proof (gradation_mass_positive rs rows_proper some_mass) as Gm.
  rewrite positive_part.
  assert (total (map (fun j => held law j S - gx j * M) js) = 0) as ->.
  { rewrite total_map_minus. unfold target_retained.
    replace (total (map (fun i => Q2R (mass i) / gradation_mass rs * M) js))
      with (M / gradation_mass rs * gradation_mass rs).
    - unfold mass_of_all at 1. unfold mass_of_all in *. field. lra.
    - unfold gradation_mass at 2. rewrite <- total_scal. apply total_ext. intros j _. field. lra. }
  rewrite Rplus_0_r, <- total_scal. apply total_ext. intros j _. unfold share_retained.
  replace (held law j S - target_retained rs j * M) with (M * (held law j S / M - target_retained rs j)) by (field; lra).
  rewrite Rabs_mult, (Rabs_right M) by lra. reflexivity.
Qed.

Lemma excesses_at_most : total (map (fun j => Rmax 0 (held law j S - gx j * M)) js) <= M.
Proof.
  unfold mass_of_all at 2. apply total_map_le. intros j J. pose proof (held_nonneg law rs S (proj1 power) rows_proper j J).
  pose proof (gradation_mass_positive rs rows_proper some_mass) as Gm. pose proof (mass_nonneg rs rows_proper j J) as Mj.
  assert (0 <= target_retained rs j * M).
  { unfold target_retained. apply Rmult_le_pos; [apply Rmult_le_pos; [exact Mj | left; apply Rinv_0_lt_compat, Gm] | lra]. }
  unfold Rmax. destruct (Rle_dec _ _); lra.
Qed.

Lemma passing_states : forall l P,
  prefix_of (fun j => held law j S) (fun j => mass_passing law rs (Q2R (upper j)) S) P l ->
  passing_from P (map state_of l).
Proof.
  induction l as [|j l IH]; intros P H; [exact I|]. destruct H as (H & T). split; [exact H | apply IH, T].
Qed.

End Sample.

(* ---- The theorems -------------------------------------------------------------------------------- *)

Lemma mass_of_sample S : describes rs S -> S <> [] -> 0 < mass_of_all law rs S.
Proof.
  intros D Ne. assert (exists j, In j js /\ (1 <= number j S)%Z) as (j & J & N).
  { pose proof (describes_number rs S rows_proper D) as E. destruct S as [|z S0]; [congruence|].
    assert (1 <= sum (map (fun j => number j (z :: S0)) js))%Z as L by (rewrite <- E; simpl length; lia).
    exact (some_positive _ _ L). }
  assert (0 < held law j S) as H.
  { destruct (sample_realizes law (proj1 power) j S (classes_ok j J)) as [(E & _)|(_ & B & _)]; [lia|].
    destruct (classes_ok j J) as ((L & U) & C & _). apply (IZR_le 1) in N. pose proof (law_nonneg law (proj1 power) _ L).
    assert (0 <= IZR (number j S) * (Q2R (c j) * law (Q2R (lower j)))) by (apply Rmult_le_pos; [|apply Rmult_le_pos]; lra). lra. }
  pose proof (total_member (fun j => held law j S) js j (held_nonneg law rs S (proj1 power) rows_proper) J) as T.
  cbv beta in T. unfold mass_of_all. lra.
Qed.

(* A sample that the question allows, of at most N - 1 particles where N is claimed, satisfies the conditions. *)
Lemma allowed_satisfies S :
  allowed law q rs S -> (forall N, particles cert = Some N -> (Z.of_nat (length S) <= N - 1)%Z) ->
  exists states, satisfies pr states.
Proof.
  intros (Al & Fl & V & Le) Claim. rewrite tolerant in Al. destruct Al as (D & Ne & (T1 & T2 & T3 & T4 & T5 & T6 & T7)).
  destruct derive_ok as (ss & der). pose proof (der_share _ der) as Su.
  pose proof (mass_of_sample S D Ne) as Mp.
  destruct (shares_of_fit law rs S (proj1 power) rows_proper some_mass Mp q tol G ss eq_refl (der_shares _ der))
    as (Ls & _ & _ & Fit).
  assert (Forall2 (fits_share (fun j => share_retained law rs j S) (fun j => share_passing law rs (Q2R (upper j)) S)
            (fun j => target_retained rs j)) js ss) as F.
  { apply Fit; [|exact T7]. apply lines_hold_of; trivial. }
  exists (map (state_of S) js).
  assert (all_mass (map (state_of S) js) = mass_of_all law rs S) as EM.
  { unfold all_mass, mass_of_all. rewrite map_map. reflexivity. }
  assert (map q_of (map (state_of S) js) = map (fun j => number j S) js) as EQ by (rewrite map_map; reflexivity).
  pose proof (describes_number rs S rows_proper D) as EN.
  constructor; rewrite ?EM, ?EQ, <- ?EN.
  - eapply meets_all; [exact der | exact Mp | intros; assumption | exact F | apply der | exact Fl].
  - apply passing_states.
    pose proof (up_to_prefix (fun j => held law j S) js _ 0 (js_ascend rs rows_proper)) as P.
    refine (prefix_ext _ _ _ _ _ _ eq_refl _ P). intros j _. rewrite Rplus_0_l. reflexivity.
  - exact Mp.
  - rewrite (der_half _ der). replace (map p_of (map (state_of S) js)) with
      (map (fun j => Rmax 0 (held law j S - target_retained rs j * mass_of_all law rs S)) js) by (rewrite map_map; reflexivity).
    assert (total (map (fun j => Rmax 0 (held law j S - target_retained rs j * mass_of_all law rs S)) js) <=
            Q2R (half (Certificate.total tol)) * mass_of_all law rs S) as H.
    { unfold half. destruct (Certificate.total tol) as [e|] eqn:Et.
      - rewrite Q2R_over, Q2R_integer by (rewrite Q2R_integer; lra).
        pose proof (excesses S Mp) as E. cbv beta in E. pose proof (T6 e eq_refl) as T.
        apply (Rmult_le_compat_l (mass_of_all law rs S)) in T; [|lra]. lra.
      - rewrite Q2R_integer. pose proof (excesses_at_most S Mp). cbv beta in H. lra. }
    apply (Rmult_le_compat_r su) in H; lra.
  - rewrite (der_volume _ der). unfold all_volume. rewrite (volumes S ss der js ss (classes_of pr)); [|auto | exact Ls | apply der].
    assert (solids_of q = Anything \/ solids_of q <> Anything) as [Es|Es]
      by (destruct (solids_of q); [left; reflexivity | right; congruence | right; congruence]).
    + rewrite (no_volumes S Es), Es. simpl. rewrite Q2R_0. lra.
    + rewrite (cubes_of_sample S D Es). exact (below_at_most _ _ solids_proper V Es).
  - rewrite (der_count _ der). apply Z.max_lub; [|exact Le]. destruct S; [congruence | simpl length; lia].
  - intros N E. rewrite (der_claim _ der) in E. exact (Claim N E).
Qed.

Hypothesis checked : check_tree pr nodes = Ok tt.

(* None with fewer particles is within the tolerance. *)
Theorem tolerant_lower_bound N S : particles cert = Some N -> allowed law q rs S -> (N <= Z.of_nat (length S))%Z.
Proof.
  intros E A. destruct (Z_le_gt_dec N (Z.of_nat (length S))) as [|L]; [assumption|exfalso].
  destruct (allowed_satisfies S A) as (st & St); [intros N' E'; rewrite E in E'; injection E' as <-; lia|].
  destruct derive_ok as (ss & der).
  exact (tree_sound pr (der_mass _ der) (der_share _ der) nodes checked st St).
Qed.

(* None of any number is. *)
Theorem tolerant_none S : particles cert = None -> ~ allowed law q rs S.
Proof.
  intros E A. destruct (allowed_satisfies S A) as (st & St); [congruence|].
  destruct derive_ok as (ss & der).
  exact (tree_sound pr (der_mass _ der) (der_share _ der) nodes checked st St).
Qed.

End Claim.
