(* An accepted certificate of a match within a tolerance: no sample with fewer particles than the bound is within it, and
   one with the witness's number is; or there is none of any number (Theorems 12 and 14). *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Exact Leaf Tree Tolerant Spec Openings Reduction RealFacts
  Sizes Solids LeafSound TreeSound Shares TolerantSound.
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

Lemma same_length {A B} (P : A -> B -> Prop) xs ys : Forall2 P xs ys -> length xs = length ys.
Proof. induction 1; simpl; congruence. Qed.

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
Variables (cert : certificate) (G : gradation) (d : positive) (tol : tolerances) (nodes : list node).
Notation q := (asked cert).
Notation rs := (rows G).
Notation js := (classes rs).
Notation na := (Z.to_nat (a q)).
Notation nb := (Z.to_nat (b q)).

Hypothesis tolerant : tolerances_of q = Some tol.
Hypothesis root_proper : root G = Zpos d.
Hypothesis factor_nonneg : forall K, size_factor q = Some K -> 0 <= Q2R K.
Hypothesis band_sizes : forall X l h, In (X, l, h) (band tol) -> 0 <= Q2R X.
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

(* What the question allows, with the root by its name. *)
Lemma allowed_within S :
  allowed law q G S <-> describes_within d law (size_factor q) tol rs S /\ has_enough d q rs S.
Proof. unfold allowed, root_of. rewrite tolerant, root_proper. tauto. Qed.

Lemma classes_ok j : In j js -> proper j.
Proof. pose proof (proper_classes rs rows_proper) as P. rewrite Forall_forall in P. apply P. Qed.

Lemma openings_nonneg : Forall (fun r => 0 <= Q2R (opening r)) rs.
Proof.
  destruct rows_proper as (A & L & _ & _). clear -A L. induction rs as [|r l IH]; constructor.
  - exact L.
  - destruct l as [|n l]; [constructor|]. cbn [ascending] in A. apply andb_prop in A as (A1 & A2). apply less_real in A1.
    apply IH; [exact A2|]. simpl in *. lra.
Qed.

Lemma den_divides (w : class -> Q) ss js0 j s :
  In (j, s) (combine js0 ss) -> forall e,
  In e (denominators (w j) s) -> In e (flat_map (fun '(w, s) => denominators w s) (combine (map w js0) ss)).
Proof.
  intros I e D. apply in_flat_map. exists (w j, s). split; [|exact D]. clear -I. revert ss I.
  induction js0 as [|i l IH]; intros [|s0 ss] I; try destruct I as [[= <- <-]|I]; try contradiction.
  - left; reflexivity.
  - right. apply IH, I.
Qed.

(* x^(a/b) = Y^(a/(b d)), with the exponent in lowest terms. *)
Lemma law_of_roots :
  let n := Z.gcd (a q) (b q * root G) in
  opening_law d (Z.to_nat (a q / n)) (Z.to_nat (b q * root G / n)) law /\ (1 <= Z.to_nat (b q * root G / n))%nat /\
  Z.of_nat (Z.to_nat (b q * root G / n)) = (b q * root G / n)%Z /\ Z.of_nat (Z.to_nat (a q / n)) = (a q / n)%Z.
Proof.
  intro n. pose proof (Z.gcd_nonneg (a q) (b q * root G)) as N0.
  destruct (Z.gcd_divide_l (a q) (b q * root G)) as (a' & Ea).
  destruct (Z.gcd_divide_r (a q) (b q * root G)) as (b' & Eb). fold n in N0, Ea, Eb. clearbody n.
  rewrite root_proper in *. assert (0 < n)%Z as N by (assert (n <> 0)%Z by (intros ->; lia); lia).
  assert (a q / n = a')%Z as -> by (rewrite Ea; apply Z.div_mul; lia).
  assert (b q * Zpos d / n = b')%Z as -> by (rewrite Eb; apply Z.div_mul; lia).
  assert (0 < a' /\ 0 < b')%Z as (Pa & Pb) by nia.
  split; [|lia]. apply (law_in_lowest_terms d _ _ (Z.to_nat n)); [lia|].
  pose proof (law_at_openings d na nb law power) as P.
  replace (Z.to_nat a' * Z.to_nat n)%nat with na by (rewrite Ea, Z2Nat.inj_mul; lia).
  replace (Z.to_nat b' * Z.to_nat n)%nat with (nb * Pos.to_nat d)%nat; [exact P|].
  rewrite <- Z2Nat.inj_mul, <- Eb, Z2Nat.inj_mul by lia. reflexivity.
Qed.

Record derivation (ss : list share) : Prop := {
  der_shares : shares_of q tol G = Ok ss;
  der_classes : Forall2 (fun js l => represents d law (min_per_class q) (solids_of q) mu su (fst js) (snd js) l)
                  (combine js ss) (classes_of pr);
  der_mass : 0 < mu;
  der_share : 0 < su;
  der_half : IZR (half_total pr) = Q2R (half (Certificate.total tol)) * su;
  der_count : least_count pr = Z.max 1 (at_least q);
  der_volume : volume pr = volume_below (solids_of q);
  der_bound : bound pr = bound_of (claimed cert) }.

Lemma derive_ok : exists ss, derivation ss.
Proof.
  pose proof derived as H. unfold derive in H. cbv zeta in H.
  passed H. rename x into ss. passed H. rename x into unit. passed H. rename x into roots. passed H. injection H as H.
  exists ss.
  assert (forall e, In e (flat_map (fun '(w, s) => denominators w s)
            (combine (map (inverse_factor (solids_of q)) js) ss)) -> (0 < e)%Z) as Dp.
  { intros e I. apply in_flat_map in I as ((w, s) & _ & I). unfold denominators in I.
    apply in_map_iff in I as (z & <- & _). reflexivity. }
  apply include_all_ok in H1 as (Up & Uh & Ud); [|reflexivity | exact Dp].
  set (n := Z.gcd (a q) (b q * root G)) in *. destruct law_of_roots as (Law & B' & Eb & Ea). fold n in Law, B', Eb, Ea.
  rewrite <- Eb in H2. apply rational_roots_real in H2; [|exact B' | exact openings_nonneg].
  destruct (common_denominator_spec roots) as (Sp & Sd).
  destruct (common_denominator_spec (map factor rs)) as (Fp & Fd).
  assert (length ss = length js) as Le.
  { unfold shares_of in H0. cbv zeta in H0. do 4 passed H0.
    eapply apply_band_length; [|exact H0]. apply shares_length. }
  constructor; rewrite <- ?H; cbn [classes_of mass_unit share_unit half_total least_count volume bound]; trivial.
  - rewrite <- Ea. apply (limits_represent _ _ B' law Law); trivial.
    + intros r I. apply Fd, in_map, I.
    + intros j s I e D. apply Ud. eapply den_divides; eassumption.
  - apply IZR_lt. apply Z.mul_pos_pos; [apply Z.pow_pos_nonneg; lia | exact Fp].
  - apply IZR_lt, Up.
  - apply in_units_real, Uh.
Qed.

(* ---- What every problem is ------------------------------------------------------------------------ *)

Lemma shares_target : forall rs0 G0 each (all : Q),
  Q2R all <> 0 -> Forall2 (fun j s => Q2R (g_j s) = Q2R (mass j) / Q2R all) (classes rs0) (shares tol all G0 rs0 each).
Proof.
  induction rs0 as [|r0 l IH]; intros G0 each all Al; [constructor|]. destruct l as [|n l]; [constructor|].
  change (classes (r0 :: n :: l)) with (Class (opening r0) (opening n) (retained r0) (factor r0) :: classes (n :: l)).
  cbn [shares]. constructor; [cbn [g_j mass]; apply Q2R_over, Al | apply IH, Al].
Qed.

Lemma band_keeps (target : class -> R) : forall l ss0 lines result,
  apply_band l ss0 lines = Ok result -> Forall2 (fun j s => Q2R (g_j s) = target j) l ss0 ->
  Forall2 (fun j s => Q2R (g_j s) = target j) l result.
Proof.
  assert (forall lines s, g_j (narrow_by s lines) = g_j s) as N.
  { unfold narrow_by. induction lines as [|((X, l0), h0) lines IH]; intro s; [reflexivity|]. cbn [fold_left]. rewrite IH. reflexivity. }
  induction l as [|j l IH]; intros ss0 lines result H F; inversion F as [|? s ? ss1 F1 F2]; subst; cbn [apply_band] in H;
    [injection H as <-; constructor|].
  destruct l as [|j2 l].
  - passed H. injection H as <-. inversion F2; subst. constructor; [rewrite N; exact F1 | constructor].
  - destruct lines as [|((X, l0), h0) rest]; [injection H as <-; constructor; assumption|].
    passed H. passed H. injection H as <-. constructor; [destruct (equal X (upper j)); exact F1 | exact (IH _ _ _ H1 F2)].
Qed.

Lemma shares_of_target ss : shares_of q tol G = Ok ss -> Forall2 (fun j s => Q2R (g_j s) = target_retained rs j) js ss.
Proof.
  intro H. unfold shares_of in H. cbv zeta in H. do 4 passed H.
  eapply band_keeps; [exact H|]. pose proof (gradation_mass_positive rs rows_proper some_mass) as Gm.
  pose proof (shares_target rs 0 (passing_each tol) (fold_left add (map retained rs) 0%Q)) as T.
  rewrite (sum_of_rows rs rows_proper) in T. apply T. lra.
Qed.

Lemma targets_whole ss : derivation ss -> sum (map g (classes_of pr)) = share_unit pr.
Proof.
  intro der. pose proof (shares_of_target ss (der_shares _ der)) as T. pose proof (der_classes _ der) as C.
  pose proof (gradation_mass_positive rs rows_proper some_mass) as Gm. apply eq_IZR.
  assert (forall l ss0 ls, Forall2 (fun j s => Q2R (g_j s) = target_retained rs j) l ss0 ->
    Forall2 (fun js l => represents d law (min_per_class q) (solids_of q) mu su (fst js) (snd js) l) (combine l ss0) ls ->
    IZR (sum (map g ls)) = total (map (fun j => Q2R (mass j)) l) / gradation_mass rs * su) as S.
  { induction l as [|j l IH]; intros ss0 ls H R; inversion H as [|? s ? ss1 H1 H2]; subst; cbn [combine] in R;
      inversion R as [|? lj ? ls1 R1 R2]; subst; cbn [map sum fold_right total]; [field; lra|].
    fold (sum (map g ls1)). fold (total (map (fun j => Q2R (mass j)) l)).
    rewrite plus_IZR, (IH ss1 ls1 H2 R2), (rep_g _ _ _ _ _ _ _ _ R1). cbn [snd]. rewrite H1. unfold target_retained. field. lra. }
  rewrite (S js ss _ T C). fold (gradation_mass rs). field. lra.
Qed.

Lemma bounds_ascend ss : derivation ss -> Forall (fun x => (0 <= f x < F x)%Z) (classes_of pr).
Proof.
  intro der. pose proof (der_classes _ der) as C. pose proof (der_mass _ der) as Mu.
  assert (forall j s, In (j, s) (combine js ss) -> In j js) as I by (intros j s; apply in_combine_l).
  revert I C. generalize (combine js ss) as l. generalize (classes_of pr) as ls. intros ls l. revert ls.
  induction l as [|(j, s) l IH]; intros ls I C; inversion C as [|? x ? ls1 R C']; subst; constructor.
  - cbn [fst snd] in R. pose proof (classes_ok j (I j s (or_introl eq_refl))) as P.
    destruct (proper_sizes (d := d) j P) as (L & U). destruct P as (_ & Cj & _).
    pose proof (law_nonneg law (proj1 power) _ L) as N. assert (law (lower_size d j) < law (upper_size d j)) as Lt by (apply power; lra).
    split; [apply le_IZR | apply lt_IZR]; rewrite (rep_f _ _ _ _ _ _ _ _ R), ?(rep_F _ _ _ _ _ _ _ _ R).
    + apply Rmult_le_pos; [apply Rmult_le_pos|]; lra.
    + apply Rmult_lt_compat_r; [exact Mu|]. apply Rmult_lt_compat_l; assumption.
  - apply IH; [|exact C']. intros i t It. apply (I i t). right. exact It.
Qed.

Lemma volume_not_negative ss : derivation ss -> 0 <= Q2R (volume pr).
Proof. intro der. rewrite (der_volume _ der). apply volume_enough_nonneg, solids_proper. Qed.

(* ---- A sample as a point ------------------------------------------------------------------------- *)

Section Sample.
Variable S : sample.
Variable ss : list share.
Hypothesis der : derivation ss.
Notation M := (mass_of_all d law rs S).
Notation x := (fun j => share_retained d law rs j S).
Notation y := (fun j => share_passing d law rs (upper_size d j) S).
Notation gx := (fun j => target_retained rs j).
Notation pass := (fun X => share_passing d law rs X S).

(* The sums up to a class: the number of particles, and how much more their masses are than those at the lower bounds. *)
Definition number_up_to (j : class) : Z :=
  sum (map (fun i => if Rle_dec (upper_size d i) (upper_size d j) then number d i S else 0%Z) js).
Definition above_least (i : class) : R := held d law i S - Q2R (c i) * law (lower_size d i) * IZR (number d i S).
Definition above_least_up_to (j : class) : R := up_to d above_least (upper_size d j) js.

Definition state_of (j : class) : state :=
  State (number d j S) (held d law j S) (Rmax 0 (held d law j S - gx j * M)) (mass_passing d law rs (upper_size d j) S)
    (number_up_to j) (above_least_up_to j).

Hypothesis mass_positive : 0 < M.

Lemma meets_of j s l :
  In j js -> represents d law (min_per_class q) (solids_of q) mu su j s l -> fits_share x y gx j s ->
  ((0 < mass j)%Q -> (min_per_class q <= number d j S)%Z) -> meets pr M l (state_of j).
Proof.
  intros J [Ef EF Efl Erl Erh Epl Eph Eg _] (Gs & (R1 & R2) & (P1 & P2)) Fl.
  pose proof (der_mass _ der) as Mu. pose proof (der_share _ der) as Su.
  pose proof (sample_realizes (d := d) law (proj1 power) j S (classes_ok j J)) as Rz.
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
    pose proof (Rmax_r 0 (held d law j S - gx j * M)) as K. cbv beta in K. apply (Rmult_le_compat_r su) in K; [|lra]. lra.
Qed.

Lemma meets_all : forall l ss0 ls,
  (forall j, In j l -> In j js) ->
  Forall2 (fits_share x y gx) l ss0 ->
  Forall2 (fun js l => represents d law (min_per_class q) (solids_of q) mu su (fst js) (snd js) l) (combine l ss0) ls ->
  (forall j, In j js -> (0 < mass j)%Q -> (min_per_class q <= number d j S)%Z) ->
  Forall2 (meets pr M) ls (map state_of l).
Proof.
  intros l ss0 ls I F. revert ls. induction F as [|j s l ss0 Fj _ IH]; intros ls H Fl; cbn [combine] in H; inversion H; subst;
    cbn [map]; constructor.
  - eapply meets_of; [apply I; left; reflexivity | eassumption | exact Fj | apply Fl, I; left; reflexivity].
  - apply IH; trivial. intros i Ii. apply I. right; exact Ii.
Qed.

Lemma volumes : forall l ss0 ls,
  (forall j, In j l -> In j js) -> length ss0 = length l ->
  Forall2 (fun js l => represents d law (min_per_class q) (solids_of q) mu su (fst js) (snd js) l) (combine l ss0) ls ->
  total (map (fun '(c, s) => t_of s * IZR (per_factor c) / su) (combine ls (map state_of l))) =
  total (map (fun j => held d law j S * Q2R (inverse_factor (solids_of q) j)) l).
Proof.
  pose proof (der_share _ der) as Su.
  induction l as [|j l IH]; intros [|s ss0] ls I Le H; try discriminate; cbn [combine] in H; inversion H as [|? lj ? ls' Hj Hr]; subst;
    [reflexivity|].
  cbn [combine map total fold_right]. f_equal.
  - cbn [state_of t_of]. rewrite (rep_per_factor _ _ _ _ _ _ _ _ Hj). cbn [fst snd]. field. lra.
  - apply (IH ss0 ls'); [intros i Ii; apply I; right; exact Ii | injection Le as Le; exact Le | exact Hr].
Qed.

Lemma cubes_of_sample :
  describes d rs S -> solids_of q <> Anything ->
  total (map (fun j => held d law j S * Q2R (inverse_factor (solids_of q) j)) js) = total (map sphere S).
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
  total (map (fun j => held d law j S * Q2R (inverse_factor (solids_of q) j)) js) = 0.
Proof.
  intro E. rewrite E. transitivity (total (map (fun j => 0 * held d law j S) js)).
  - apply total_ext. intros j _. cbn [inverse_factor]. rewrite Q2R_0. ring.
  - rewrite total_scal. ring.
Qed.

(* The excesses p_j = max(0, t_j - g_j M). *)
Lemma excesses :
  2 * total (map (fun j => Rmax 0 (held d law j S - gx j * M)) js) =
  M * total (map (fun j => Rabs (x j - gx j)) js).
Proof.
  pose proof (gradation_mass_positive rs rows_proper some_mass) as Gm.
  rewrite positive_part.
  assert (total (map (fun j => held d law j S - gx j * M) js) = 0) as ->.
  { rewrite total_map_minus. unfold target_retained.
    replace (total (map (fun i => Q2R (mass i) / gradation_mass rs * M) js))
      with (M / gradation_mass rs * gradation_mass rs).
    - unfold mass_of_all at 1. unfold mass_of_all in *. field. lra.
    - unfold gradation_mass at 2. rewrite <- total_scal. apply total_ext. intros j _. field. lra. }
  rewrite Rplus_0_r, <- total_scal. apply total_ext. intros j _. unfold share_retained.
  replace (held d law j S - target_retained rs j * M) with (M * (held d law j S / M - target_retained rs j)) by (field; lra).
  rewrite Rabs_mult, (Rabs_right M) by lra. reflexivity.
Qed.

Lemma excesses_at_most : total (map (fun j => Rmax 0 (held d law j S - gx j * M)) js) <= M.
Proof.
  unfold mass_of_all at 2. apply total_map_le. intros j J. pose proof (held_nonneg (d := d) law rs S (proj1 power) rows_proper j J).
  pose proof (gradation_mass_positive rs rows_proper some_mass) as Gm. pose proof (mass_nonneg rs rows_proper j J) as Mj.
  assert (0 <= target_retained rs j * M).
  { unfold target_retained. apply Rmult_le_pos; [apply Rmult_le_pos; [exact Mj | left; apply Rinv_0_lt_compat, Gm] | lra]. }
  unfold Rmax. destruct (Rle_dec _ _); lra.
Qed.

Lemma number_up_to_real j : IZR (number_up_to j) = up_to d (fun i => IZR (number d i S)) (upper_size d j) js.
Proof.
  unfold number_up_to, up_to, sum. generalize js as l. induction l as [|i l IH]; [reflexivity|].
  cbn [map fold_right total]. rewrite plus_IZR, IH. destruct (Rle_dec _ _); reflexivity.
Qed.

Lemma sums_of_states : forall l ss0 ls P N D,
  length ss0 = length l ->
  Forall2 (fun js l => represents d law (min_per_class q) (solids_of q) mu su (fst js) (snd js) l) (combine l ss0) ls ->
  prefix_of (fun j => held d law j S) (fun j => mass_passing d law rs (upper_size d j) S) P l ->
  prefix_of (fun j => IZR (number d j S)) (fun j => IZR (number_up_to j)) (IZR N) l ->
  prefix_of above_least above_least_up_to D l ->
  sums_from pr P N D ls (map state_of l).
Proof.
  pose proof (der_mass _ der) as Mu.
  induction l as [|j l IH]; intros [|s ss0] ls P N D Le R Hp Hn Hd; try discriminate; cbn [combine] in R;
    inversion R as [|? lj ? ls1 Rj R']; subst; [exact I|].
  destruct Hp as (Hp & Tp), Hn as (Hn & Tn), Hd as (Hd & Td). cbn [map sums_from state_of q_of t_of P_of N_of D_of].
  split; [exact Hp|]. split; [apply eq_IZR; rewrite plus_IZR; exact Hn|]. split.
  - rewrite Hd. unfold above_least. cbn [fst] in Rj. rewrite (rep_f _ _ _ _ _ _ _ _ Rj). field. lra.
  - apply (IH ss0); trivial. injection Le as Le. exact Le.
Qed.

Lemma prefixes w : prefix_of w (fun j => up_to d w (upper_size d j) js) 0 js.
Proof.
  pose proof (up_to_prefix w js _ 0 (js_ascend (d := d) rs rows_proper)) as P.
  refine (prefix_ext _ _ _ _ _ _ eq_refl _ P). intros j _. rewrite Rplus_0_l. reflexivity.
Qed.

End Sample.

(* ---- The theorems -------------------------------------------------------------------------------- *)

Lemma mass_of_sample S : describes d rs S -> S <> [] -> 0 < mass_of_all d law rs S.
Proof.
  intros D Ne. assert (exists j, In j js /\ (1 <= number d j S)%Z) as (j & J & N).
  { pose proof (describes_number rs S rows_proper D) as E. destruct S as [|z S0]; [congruence|].
    assert (1 <= sum (map (fun j => number d j (z :: S0)) js))%Z as L by (rewrite <- E; simpl length; lia).
    exact (some_positive _ _ L). }
  assert (0 < held d law j S) as H.
  { destruct (sample_realizes (d := d) law (proj1 power) j S (classes_ok j J)) as [(E & _)|(_ & B & _)]; [lia|].
    destruct (proper_sizes (d := d) j (classes_ok j J)) as (L & U). destruct (classes_ok j J) as (_ & C & _).
    apply (IZR_le 1) in N. pose proof (law_nonneg law (proj1 power) _ L).
    assert (0 <= IZR (number d j S) * (Q2R (c j) * law (lower_size d j))) by (apply Rmult_le_pos; [|apply Rmult_le_pos]; lra). lra. }
  pose proof (total_member (fun j => held d law j S) js j (held_nonneg (d := d) law rs S (proj1 power) rows_proper) J) as T.
  cbv beta in T. unfold mass_of_all. lra.
Qed.

(* A sample that the question allows, of fewer particles than the bound where there is one, satisfies the conditions. *)
Lemma allowed_satisfies S :
  allowed law q G S -> (forall B, bound_of (claimed cert) = Some B -> (Z.of_nat (length S) <= B - 1)%Z) ->
  exists states, satisfies pr states.
Proof.
  intros Al Claim. apply allowed_within in Al as ((D & Ne & (T1 & T2 & T3 & T4 & T5 & T6 & T7)) & Fl & V & Le).
  destruct derive_ok as (ss & der). pose proof (der_share _ der) as Su.
  pose proof (mass_of_sample S D Ne) as Mp.
  destruct (shares_of_fit law rs S (proj1 power) rows_proper some_mass Mp q tol G ss root_proper factor_nonneg band_sizes
              eq_refl (der_shares _ der))
    as (Ls & _ & _ & Fit).
  assert (Forall2 (fits_share (fun j => share_retained d law rs j S) (fun j => share_passing d law rs (upper_size d j) S)
            (fun j => target_retained rs j)) js ss) as F.
  { apply Fit; [|exact T7]. apply lines_hold_of; trivial. }
  exists (map (state_of S) js).
  assert (all_mass (map (state_of S) js) = mass_of_all d law rs S) as EM.
  { unfold all_mass, mass_of_all. rewrite map_map. reflexivity. }
  assert (map q_of (map (state_of S) js) = map (fun j => number d j S) js) as EQ by (rewrite map_map; reflexivity).
  pose proof (describes_number rs S rows_proper D) as EN.
  constructor; rewrite ?EM, ?EQ, <- ?EN.
  - eapply meets_all; [exact der | exact Mp | intros; assumption | exact F | apply der | exact Fl].
  - apply (sums_of_states S ss der js ss); [exact Ls | apply der | | | apply prefixes].
    + exact (prefixes (fun j => held d law j S)).
    + refine (prefix_ext _ _ _ _ _ _ eq_refl _ (prefixes (fun j => IZR (number d j S)))).
      intros j _. symmetry. apply number_up_to_real.
  - exact Mp.
  - rewrite (der_half _ der). replace (map p_of (map (state_of S) js)) with
      (map (fun j => Rmax 0 (held d law j S - target_retained rs j * mass_of_all d law rs S)) js) by (rewrite map_map; reflexivity).
    assert (total (map (fun j => Rmax 0 (held d law j S - target_retained rs j * mass_of_all d law rs S)) js) <=
            Q2R (half (Certificate.total tol)) * mass_of_all d law rs S) as H.
    { unfold half. destruct (Certificate.total tol) as [e|] eqn:Et.
      - rewrite Q2R_over, Q2R_integer by (rewrite Q2R_integer; lra).
        pose proof (excesses S Mp) as E. cbv beta in E. pose proof (T6 e eq_refl) as T.
        apply (Rmult_le_compat_l (mass_of_all d law rs S)) in T; [|lra]. lra.
      - rewrite Q2R_integer. pose proof (excesses_at_most S Mp). cbv beta in H. lra. }
    apply (Rmult_le_compat_r su) in H; lra.
  - rewrite (der_volume _ der). unfold all_volume. rewrite (volumes S ss der js ss (classes_of pr)); [|auto | exact Ls | apply der].
    assert (solids_of q = Anything \/ solids_of q <> Anything) as [Es|Es]
      by (destruct (solids_of q); [left; reflexivity | right; congruence | right; congruence]).
    + rewrite (no_volumes S Es), Es. simpl. rewrite Q2R_0. lra.
    + rewrite (cubes_of_sample S D Es). exact (below_at_most _ _ solids_proper V Es).
  - rewrite (der_count _ der). apply Z.max_lub; [|exact Le]. destruct S; [congruence | simpl length; lia].
  - intros B E. rewrite (der_bound _ der) in E. exact (Claim B E).
Qed.

Hypothesis checked : check_tree pr nodes = Ok tt.

Lemma none_satisfies states : ~ satisfies pr states.
Proof.
  destruct derive_ok as (ss & der). exact (tree_sound pr (der_mass _ der) (der_share _ der) (targets_whole ss der)
    (bounds_ascend ss der) (volume_not_negative ss der) nodes checked states).
Qed.

(* None with fewer particles is within the tolerance. *)
Theorem tolerant_lower_bound B S : bound_of (claimed cert) = Some B -> allowed law q G S -> (B <= Z.of_nat (length S))%Z.
Proof.
  intros E A. destruct (Z_le_gt_dec B (Z.of_nat (length S))) as [|L]; [assumption|exfalso].
  destruct (allowed_satisfies S A) as (st & St); [intros B' E'; rewrite E in E'; injection E' as <-; lia|].
  exact (none_satisfies st St).
Qed.

(* None of any number is. *)
Theorem tolerant_none S : claimed cert = NoMatch -> ~ allowed law q G S.
Proof.
  intros E A. destruct (allowed_satisfies S A) as (st & St); [rewrite E; discriminate|].
  exact (none_satisfies st St).
Qed.

(* ---- The witness --------------------------------------------------------------------------------- *)

(* A line of the witness, or none. *)
Definition holds_in (unit : Z) (l : limits) (qt : Z * Z) : Prop :=
  (fst qt = 0%Z /\ snd qt = 0%Z) \/
  (f l * fst qt * unit < snd qt * mass_unit pr /\ snd qt * mass_unit pr <= F l * fst qt * unit)%Z.

Lemma contents_hold unit : forall l j ls ws qts,
  length ls = length l -> contents (a q) (b q) (root G) unit pr j l ls ws = Ok qts -> Forall2 (holds_in unit) ls qts.
Proof.
  induction l as [|x l IH]; intros j [|c_j ls] ws qts Le H; try discriminate; cbn [contents] in H.
  { destruct ws; [injection H as <-; constructor | discriminate]. }
  injection Le as Le. destruct ws as [|w ws].
  { passed H. injection H as <-. constructor; [left; auto | exact (IH _ _ _ _ Le H0)]. }
  destruct (index w =? j)%Z.
  - passed H. passed H. passed H. passed H. injection H as <-. apply Z.ltb_lt in H0. apply Z.leb_le in H1.
    constructor; [right; auto | exact (IH _ _ _ _ Le H3)].
  - passed H. injection H as <-. constructor; [left; auto | exact (IH _ _ _ _ Le H0)].
Qed.

Section Witness.
Variables (N : Z) (ss : list share) (unit : Z) (qts : list (Z * Z)).
Hypothesis der : derivation ss.
Hypothesis unit_positive : (0 < unit)%Z.
Notation ls := (classes_of pr).
Notation Mz := (sum (map snd qts)).
Hypothesis lines_hold_in : Forall2 (holds_in unit) ls qts.
Hypothesis ok_within : within (share_unit pr) Mz 0 ls qts = true.
Hypothesis ok_total : (excess (share_unit pr) Mz ls qts <= half_total pr * Mz)%Z.
Hypothesis ok_volume : Q2R (volume_enough (solids_of q)) * (su * IZR unit) <= IZR (over_factors ls qts).
Hypothesis ok_sum : (sum (map fst qts) =? N)%Z = true.
Hypothesis ok_least : (at_least q <= N)%Z.
Hypothesis N_positive : (1 <= N)%Z.
Hypothesis rows_tolerances : Forall (fun r => 0 <= Q2R (tolerance r)) rs.
Hypothesis each_nonneg : Forall (fun e => 0 <= Q2R e) (passing_each tol).
Hypothesis passing_nonneg : forall e, passing_all tol = Some e -> 0 <= Q2R e.
Hypothesis band_nonneg : forall X l h, In (X, l, h) (band tol) -> 0 <= Q2R h.

Lemma line_realizes j s l qt :
  In j js -> represents d law (min_per_class q) (solids_of q) mu su j s l -> holds_in unit l qt ->
  realizes d law j (fst qt) (IZR (snd qt) / IZR unit).
Proof.
  intros J Rp [(-> & ->)|(Lo & Hi)]; [left; split; [reflexivity | unfold Rdiv; ring]|].
  destruct qt as (n, t). cbn [fst snd] in *.
  pose proof (der_mass _ der) as Mu. pose proof (IZR_lt _ _ unit_positive) as Up.
  destruct (proper_sizes (d := d) j (classes_ok j J)) as (L & U). destruct (classes_ok j J) as (_ & C & _).
  assert (law (lower_size d j) < law (upper_size d j)) as Lt by (apply power; lra).
  assert (f l < F l)%Z as FF.
  { apply lt_IZR. rewrite (rep_f _ _ _ _ _ _ _ _ Rp), (rep_F _ _ _ _ _ _ _ _ Rp).
    apply Rmult_lt_compat_r; [exact Mu|]. apply Rmult_lt_compat_l; assumption. }
  assert (0 < n)%Z as Np.
  { apply Z.nle_gt. intro N0. assert (n * ((F l - f l) * unit) <= 0)%Z by (apply Z.mul_nonpos_nonneg; [exact N0 | nia]). lia. }
  right. split; [lia|]. apply IZR_lt in Lo. apply IZR_le in Hi. rewrite !mult_IZR in Lo, Hi.
  rewrite (rep_f _ _ _ _ _ _ _ _ Rp) in Lo. rewrite (rep_F _ _ _ _ _ _ _ _ Rp) in Hi. split.
  - apply (Rmult_lt_reg_r (IZR unit * mu)); [apply Rmult_lt_0_compat; assumption|].
    replace (IZR t / IZR unit * (IZR unit * mu)) with (IZR t * mu) by (field; lra). lra.
  - apply (Rmult_le_reg_r (IZR unit * mu)); [apply Rmult_lt_0_compat; assumption|].
    replace (IZR t / IZR unit * (IZR unit * mu)) with (IZR t * mu) by (field; lra). lra.
Qed.

Lemma lines_realize : forall l ss0 ls0 qts0,
  (forall j, In j l -> In j js) -> length ss0 = length l ->
  Forall2 (fun js l => represents d law (min_per_class q) (solids_of q) mu su (fst js) (snd js) l) (combine l ss0) ls0 ->
  Forall2 (holds_in unit) ls0 qts0 ->
  Forall2 (fun j qt => realizes d law j (fst qt) (snd qt)) l (map (fun qt => (fst qt, IZR (snd qt) / IZR unit)) qts0).
Proof.
  induction l as [|j l IH]; intros [|s ss0] ls0 qts0 I Le R H; try discriminate; cbn [combine] in R; inversion R; subst; inversion H; subst;
    cbn [map]; constructor.
  - cbn [fst snd] in *. eapply line_realizes; [apply I; left; reflexivity | eassumption | assumption].
  - eapply IH; [intros i Ii; apply I; right; exact Ii | injection Le as Le; exact Le | eassumption | assumption].
Qed.

Section Found.
Variable S : sample.
Hypothesis S_describes : describes d rs S.
Hypothesis S_counts : Forall2 (fun j qt => number d j S = fst qt /\ held d law j S = IZR (snd qt) / IZR unit) js qts.
Notation M := (mass_of_all d law rs S).
Notation x := (fun j => share_retained d law rs j S).
Notation y := (fun j => share_passing d law rs (upper_size d j) S).
Notation gx := (fun j => target_retained rs j).
Notation gy := (fun j => target_passing d rs (upper_size d j)).

Lemma found_length : Z.of_nat (length S) = N.
Proof.
  rewrite (describes_number rs S rows_proper S_describes), <- (proj1 (Z.eqb_eq _ _) ok_sum). f_equal. clear -S_counts.
  induction S_counts as [|j qt l qts0 (E & _) T IH]; [reflexivity|]. cbn [map]. rewrite E. f_equal. exact (IH T).
Qed.

Lemma found_not_empty : S <> [].
Proof. pose proof found_length. destruct S; [simpl in *; lia | congruence]. Qed.

Lemma found_mass : M = IZR Mz / IZR unit /\ 0 < M.
Proof.
  split; [|exact (mass_of_sample S S_describes found_not_empty)].
  unfold mass_of_all. clear -S_counts unit_positive. induction S_counts as [|j qt l qts0 (_ & E) T IH]; cbn [map total fold_right sum].
  - unfold Rdiv. simpl. ring.
  - change (fold_right Rplus 0 (map (fun j => held d law j S) l)) with (total (map (fun j => held d law j S) l)).
    change (fold_right Z.add 0%Z (map snd qts0)) with (sum (map snd qts0)). rewrite (IH T), E, plus_IZR. unfold Rdiv. ring.
Qed.

Lemma mz_positive : 0 < IZR Mz.
Proof.
  destruct found_mass as (E & P). pose proof (IZR_lt _ _ unit_positive) as U.
  replace (IZR Mz) with (M * IZR unit) by (rewrite E; field; lra). apply Rmult_lt_0_compat; assumption.
Qed.

Lemma share_of_line j t : held d law j S = IZR t / IZR unit -> x j = IZR t / IZR Mz.
Proof.
  intro E. destruct found_mass as (Em & P). pose proof mz_positive as Mp. pose proof (IZR_lt _ _ unit_positive) as U.
  unfold share_retained. rewrite E, Em. field. lra.
Qed.

Lemma within_fits : forall l ss0 ls0 qts0 P,
  Forall2 (fun js l => represents d law (min_per_class q) (solids_of q) mu su (fst js) (snd js) l) (combine l ss0) ls0 ->
  Forall2 (fun j s => Q2R (g_j s) = target_retained rs j) l ss0 ->
  Forall2 (fun j qt => number d j S = fst qt /\ held d law j S = IZR (snd qt) / IZR unit) l qts0 ->
  prefix_of x y (IZR P / (su * IZR Mz)) l -> within (share_unit pr) Mz P ls0 qts0 = true ->
  Forall2 (fits_share x y gx) l ss0 /\ forall j, In j l -> (0 < mass j)%Q -> (min_per_class q <= number d j S)%Z.
Proof.
  pose proof (der_share _ der) as Su. pose proof mz_positive as Mp.
  assert (forall lo t, IZR lo * IZR Mz <= IZR t -> IZR lo / su <= IZR t / (su * IZR Mz)) as Lo.
  { intros lo t H. apply (Rmult_le_reg_r (su * IZR Mz)); [apply Rmult_lt_0_compat; assumption|].
    replace (IZR lo / su * (su * IZR Mz)) with (IZR lo * IZR Mz) by (field; lra).
    replace (IZR t / (su * IZR Mz) * (su * IZR Mz)) with (IZR t) by (field; lra). exact H. }
  assert (forall hi t, IZR t <= IZR hi * IZR Mz -> IZR t / (su * IZR Mz) <= IZR hi / su) as Hi.
  { intros hi t H. apply (Rmult_le_reg_r (su * IZR Mz)); [apply Rmult_lt_0_compat; assumption|].
    replace (IZR hi / su * (su * IZR Mz)) with (IZR hi * IZR Mz) by (field; lra).
    replace (IZR t / (su * IZR Mz) * (su * IZR Mz)) with (IZR t) by (field; lra). exact H. }
  induction l as [|j l IH]; intros ss0 ls0 qts0 P R Gt C Pr W; inversion Gt as [|? s ? ss1 Gs Gt']; subst.
  { split; [constructor | intros ? []]. }
  cbn [combine] in R. inversion R as [|? lj ? ls1 Rj R']; subst. cbn [fst snd] in Rj.
  inversion C as [|? (n, t) ? qts1 (Cn & Ct) C']; subst. cbn [fst snd] in Cn, Ct.
  destruct Pr as (Pj & Pr). cbn [within] in W. rewrite !andb_true_iff, !Z.leb_le in W.
  destruct W as (((((W1 & W2) & W3) & W4) & W5) & W6).
  pose proof (share_of_line j t Ct) as Ex. cbv beta in Ex, Pj.
  assert (x j = IZR (t * share_unit pr) / (su * IZR Mz)) as Ex' by (cbv beta; rewrite Ex, mult_IZR; field; lra).
  assert (y j = IZR (P + t * share_unit pr) / (su * IZR Mz)) as Ey.
  { cbv beta in Ex' |- *. rewrite Pj, Ex', plus_IZR. field. lra. }
  cbv beta in Ex', Ey. rewrite Ey in Pr.
  destruct (IH _ _ _ (P + t * share_unit pr)%Z R' Gt' C' Pr W6) as (I1 & I2).
  apply IZR_le in W2, W3, W4, W5. rewrite (mult_IZR _ Mz) in W2. rewrite (mult_IZR _ Mz) in W3.
  rewrite (mult_IZR _ Mz) in W4. rewrite (mult_IZR _ Mz) in W5.
  apply Lo in W2, W4. apply Hi in W3, W5.
  rewrite (rep_retained_lo _ _ _ _ _ _ _ _ Rj) in W2. rewrite (rep_retained_hi _ _ _ _ _ _ _ _ Rj) in W3.
  rewrite (rep_passing_lo _ _ _ _ _ _ _ _ Rj) in W4. rewrite (rep_passing_hi _ _ _ _ _ _ _ _ Rj) in W5.
  assert (forall v, v * su / su = v) as Cancel by (intro; field; lra).
  rewrite Cancel in W2. rewrite Cancel in W3. rewrite Cancel in W4. rewrite Cancel in W5.
  split.
  - constructor; [|exact I1]. split; [exact Gs|]. unfold within_interval. cbv beta. rewrite Ex', Ey. lra.
  - intros i [<-|Ii] Mi; [|exact (I2 i Ii Mi)]. rewrite Cn. rewrite (rep_floor _ _ _ _ _ _ _ _ Rj) in W1.
    destruct (equal (mass j) 0) eqn:E; [|exact W1]. apply equal_spec in E. rewrite E in Mi. discriminate.
Qed.

Lemma excess_real : forall l ss0 ls0 qts0,
  Forall2 (fun js l => represents d law (min_per_class q) (solids_of q) mu su (fst js) (snd js) l) (combine l ss0) ls0 ->
  Forall2 (fun j s => Q2R (g_j s) = target_retained rs j) l ss0 ->
  Forall2 (fun j qt => number d j S = fst qt /\ held d law j S = IZR (snd qt) / IZR unit) l qts0 ->
  total (map (fun j => Rmax 0 (held d law j S - gx j * M)) l) * (su * IZR unit) =
  IZR (excess (share_unit pr) Mz ls0 qts0) /\
  total (map (fun j => held d law j S * Q2R (inverse_factor (solids_of q) j)) l) * (su * IZR unit) =
  IZR (over_factors ls0 qts0).
Proof.
  pose proof (der_share _ der) as Su. pose proof (IZR_lt _ _ unit_positive) as U. destruct found_mass as (Em & Mp).
  unfold excess, over_factors.
  induction l as [|j l IH]; intros ss0 ls0 qts0 R Gt C; inversion Gt as [|? s ? ss1 Gs Gt']; subst; cbn [combine] in R;
    inversion R as [|? lj ? ls1 Rj R']; subst; inversion C as [|? (n, t) ? qts1 (Cn & Ct) C']; subst.
  { simpl. split; ring. }
  cbn [fst snd] in *. destruct (IH _ _ _ R' Gt' C') as (I1 & I2). cbn [combine map total fold_right sum].
  match goal with |- (_ + ?A) * _ = IZR (_ + ?B) /\ (_ + ?C) * _ = IZR (_ + ?D) =>
    change A with (total (map (fun j => Rmax 0 (held d law j S - gx j * M)) l));
    change B with (sum (map (fun '(c, (_, t)) => Z.max 0 (t * share_unit pr - g c * Mz)) (combine ls1 qts1)));
    change C with (total (map (fun j => held d law j S * Q2R (inverse_factor (solids_of q) j)) l));
    change D with (sum (map (fun '(c, (_, t)) => (t * per_factor c)%Z) (combine ls1 qts1)))
  end.
  rewrite !plus_IZR, <- I1, <- I2, !Rmult_plus_distr_r. split; f_equal.
  - assert (IZR (t * share_unit pr - g lj * Mz) = (held d law j S - target_retained rs j * M) * (su * IZR unit)) as E.
    { rewrite minus_IZR, !mult_IZR, (rep_g _ _ _ _ _ _ _ _ Rj), Gs, Ct, Em. field. lra. }
    assert (0 < su * IZR unit) as K by (apply Rmult_lt_0_compat; assumption).
    unfold Rmax. destruct (Rle_dec 0 (held d law j S - target_retained rs j * M)) as [Le|Gt0].
    + rewrite Z.max_r; [symmetry; exact E|]. apply le_IZR. rewrite E. apply Rmult_le_pos; lra.
    + rewrite Z.max_l; [ring|]. apply le_IZR. rewrite E. apply Rlt_le. apply Rnot_le_lt in Gt0.
      rewrite <- (Rmult_0_l (su * IZR unit)). apply Rmult_lt_compat_r; assumption.
  - rewrite mult_IZR, (rep_per_factor _ _ _ _ _ _ _ _ Rj), Ct. field. lra.
Qed.

Theorem found_allowed : allowed law q G S.
Proof.
  destruct found_mass as (Em & Mp). pose proof (der_share _ der) as Su. pose proof (IZR_lt _ _ unit_positive) as U.
  assert (0 < su * IZR unit) as K by (apply Rmult_lt_0_compat; assumption).
  pose proof (shares_of_target ss (der_shares _ der)) as Gt.
  destruct (shares_of_fit law rs S (proj1 power) rows_proper some_mass Mp q tol G ss root_proper factor_nonneg band_sizes
              eq_refl (der_shares _ der))
    as (Ls & Fl & Fb & _).
  destruct (shares_prefix (d := d) law rs S rows_proper) as (Px & _).
  destruct (within_fits js ss ls qts 0 (der_classes _ der) Gt S_counts) as (Fit & Floors); [|exact ok_within|].
  { replace (IZR 0 / (su * IZR Mz)) with 0 by (pose proof mz_positive; field; lra). exact Px. }
  specialize (Fl Fit). specialize (Fb band_nonneg Fit).
  destruct (excess_real js ss ls qts (der_classes _ der) Gt S_counts) as (Ex & Vo).
  destruct (of_lines_hold tol x y gx gy rs (passing_each tol) Fl) as (T1 & T2 & T3 & T4 & T5); trivial.
  { intros e E j J L. cbv beta. unfold near.
    rewrite (pass_all law rs S rows_proper Mp _ j J L) by lra.
    rewrite (target_all (d := d) rs rows_proper some_mass j J L). rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra. }
  apply allowed_within. split; [|split; [|split]].
  - split; [exact S_describes|]. split; [exact found_not_empty|].
    split; [exact T1|]. split; [exact T2|]. split; [exact T3|]. split; [exact T4|]. split; [exact T5|]. split; [|exact Fb].
    intros e Et. apply IZR_le in ok_total. rewrite <- Ex, mult_IZR, (der_half _ der) in ok_total.
    unfold half in ok_total. rewrite Et, Q2R_over, Q2R_integer in ok_total by (rewrite Q2R_integer; lra).
    pose proof (excesses S Mp) as E2. cbv beta in E2, ok_total. set (D := total _) in *.
    apply (Rmult_le_reg_l M); [exact Mp|]. rewrite <- E2.
    replace (IZR Mz) with (M * IZR unit) in ok_total by (rewrite Em; field; lra).
    apply (Rmult_le_reg_r (su * IZR unit)); [exact K|]. lra.
  - exact Floors.
  - assert (solids_of q = Anything \/ solids_of q <> Anything) as [Es|Es]
      by (destruct (solids_of q); [left; reflexivity | right; congruence | right; congruence]).
    + rewrite Es. exact I.
    + assert (has_cubes (solids_of q) (total (map sphere S))) as H.
      { apply enough_suffices; [exact solids_proper|]. rewrite <- (cubes_of_sample S S_describes Es).
        apply (Rmult_le_reg_r (su * IZR unit)); [exact K|]. rewrite Vo. exact ok_volume. }
      destruct (solids_of q); exact H.
  - rewrite found_length. exact ok_least.
Qed.

End Found.

Theorem found_sample : exists S, allowed law q G S /\ Z.of_nat (length S) = N /\ describes d rs S /\
  one_size_a_class d js S /\ Forall2 (fun j qt => number d j S = fst qt /\ held d law j S = IZR (snd qt) / IZR unit) js qts.
Proof.
  assert (length ss = length js) as Le.
  { pose proof (shares_of_target ss (der_shares _ der)) as Gt. symmetry. exact (same_length _ _ _ Gt). }
  pose proof (lines_realize js ss ls qts ltac:(auto) Le (der_classes _ der) lines_hold_in) as Rz.
  destruct (classes_ascend (d := d) rs rows_proper) as (As & T).
  destruct (counts_sample (d := d) law (proj1 power) js _ _ As (proper_classes rs rows_proper) Rz) as (S & B & O & C).
  assert (describes d rs S) as D by (split; [apply rows_proper | intros z Z; rewrite <- T; apply B, Z]).
  assert (Forall2 (fun j qt => number d j S = fst qt /\ held d law j S = IZR (snd qt) / IZR unit) js qts) as C'.
  { clear -C. revert C. generalize js as l. generalize qts as qs. induction qs as [|qt qs IH]; intros l C; inversion C; subst; constructor; auto. }
  exists S. split; [exact (found_allowed S D C')|]. split; [exact (found_length S D C')|].
  split; [exact D | split; [exact O | exact C']].
Qed.

End Witness.

(* The witness's sizes are those of this sample. *)
Lemma tolerant_sizes unit S : (0 < unit)%Z -> describes d rs S -> one_size_a_class d js S -> forall post pre ls ws qts,
  js = pre ++ post -> contents (a q) (b q) (root G) unit pr (Z.of_nat (length pre) + 1) post ls ws = Ok qts ->
  (forall w, In w ws -> (Zpos (Qden (together w)) | unit)%Z) ->
  Forall2 (fun j qt => number d j S = fst qt /\ held d law j S = IZR (snd qt) / IZR unit) post qts ->
  Forall (line_true d js S) ws.
Proof.
  intros Up D O. induction post as [|j post IH]; intros pre ls ws qts E C Dv Q; cbn [contents] in C.
  { destruct ws; [constructor | discriminate]. }
  destruct ls as [|l ls]; [discriminate|].
  assert (forall ws' qts', contents (a q) (b q) (root G) unit pr (Z.of_nat (length pre) + 1 + 1) post ls ws' = Ok qts' ->
    (forall w, In w ws' -> (Zpos (Qden (together w)) | unit)%Z) ->
    Forall2 (fun j qt => number d j S = fst qt /\ held d law j S = IZR (snd qt) / IZR unit) post qts' ->
    Forall (line_true d js S) ws') as Rest.
  { intros ws' qts' C' Dv' Q'. apply (IH (pre ++ [j]) ls ws' qts'); trivial; [rewrite <- app_assoc; exact E|].
    rewrite app_length. simpl length. replace (Z.of_nat (length pre + 1) + 1)%Z with (Z.of_nat (length pre) + 1 + 1)%Z by lia.
    exact C'. }
  destruct ws as [|w ws]; [constructor|]. destruct (Z.eqb_spec (index w) (Z.of_nat (length pre) + 1)) as [Iw|].
  - passed C. passed C. passed C. passed C. destruct x. injection C as <-. inversion Q as [|? ? ? ? (Qj & Hj) Q']; subst.
    cbn [fst snd] in Qj, Hj. constructor; [|apply (Rest ws _ C3); trivial; intros; apply Dv; right; assumption].
    exists j. split; [|split; [exact Qj|]].
    + rewrite Iw, E. replace (Z.to_nat (Z.of_nat (length pre) + 1 - 1)) with (length pre) by lia.
      rewrite nth_error_app2, Nat.sub_diag by lia. reflexivity.
    + assert (In j js) as J by (rewrite E; apply in_or_app; right; left; reflexivity).
      intros x X Jx. destruct (size_of_class na nb law rs S j x power rows_proper D O J X Jx) as (Sz & N1).
      destruct (proper_sizes (d := d) j (classes_ok j J)) as (L & U). destruct (classes_ok j J) as (_ & Cj & _). rewrite Qj in Sz, N1. apply (IZR_le 1) in N1.
      pose proof (IZR_lt _ _ Up) as Ur.
      set (one := over (together w) (times (of_integer (count w)) (c j))) in *.
      assert (Q2R one = Q2R (together w) / (IZR (count w) * Q2R (c j))) as Eo.
      { unfold one. rewrite Q2R_over; rewrite Q2R_times, Q2R_integer; [reflexivity|].
        apply Rgt_not_eq, Rmult_lt_0_compat; lra. }
      replace (a q) with (Z.of_nat na) in C2 by lia.
      refine (check_size_sound na (root G) j w _ _ x ltac:(lia) root_proper _ _ _ C2).
      * apply Z.pow_pos_nonneg; lia.
      * unfold in_class in Jx. lra.
      * rewrite pow_mult, Sz, <- pow_mult, Hj, in_units_real by (apply Dv; left; reflexivity).
        replace (Q2R (together w) * IZR unit / IZR unit) with (Q2R (together w)) by (field; lra).
        rewrite <- Eo. rewrite root_proper. replace (b q * Zpos d)%Z with (Z.of_nat (nb * Pos.to_nat d)) by lia.
        rewrite <- !pow_IZR.
        unfold Q2R, Rdiv. rewrite Rpow_mult_distr, pow_inv. reflexivity.
  - passed C. injection C as <-. inversion Q as [|? ? ? ? _ Q']; subst. exact (Rest (w :: ws) _ C0 Dv Q').
Qed.

Hypothesis rows_tolerances : Forall (fun r => 0 <= Q2R (tolerance r)) rs.
Hypothesis each_nonneg : Forall (fun e => 0 <= Q2R e) (passing_each tol).
Hypothesis passing_nonneg : forall e, passing_all tol = Some e -> 0 <= Q2R e.
Hypothesis band_nonneg : forall X l h, In (X, l, h) (band tol) -> 0 <= Q2R h.

(* One with N is within the tolerance, with one size a class, in the witness's bounds. *)
Theorem tolerant_attained N :
  (1 <= N)%Z -> check_witness cert G pr N = Ok tt ->
  exists S, allowed law q G S /\ Z.of_nat (length S) = N /\ describes d rs S /\ one_size_a_class d js S /\
    Forall (line_true d js S) (witness cert).
Proof.
  intros Np H. unfold check_witness in H. cbv zeta in H. passed H. rename x into unit. passed H. passed H. rename x into qts.
  passed H. passed H. passed H. passed H. passed H.
  destruct derive_ok as (ss & der).
  apply include_all_ok in H0 as (Up & _ & Dv); [|reflexivity|].
  2: { intros e I. apply in_map_iff in I as (w & <- & _). reflexivity. }
  apply Z.leb_le in H4, H. apply at_most_real in H5.
  rewrite Q2R_times, !Q2R_integer, mult_IZR in H5.
  assert (Forall2 (holds_in unit) (classes_of pr) qts) as Hin.
  { eapply contents_hold; [|exact H2].
    pose proof (same_length _ _ _ (der_classes _ der)) as L. rewrite combine_length in L.
    pose proof (same_length _ _ _ (shares_of_target ss (der_shares _ der))). lia. }
  assert (exists S, allowed law q G S /\ Z.of_nat (length S) = N /\ describes d rs S /\ one_size_a_class d js S /\
    Forall2 (fun j qt => number d j S = fst qt /\ held d law j S = IZR (snd qt) / IZR unit) js qts) as (S & A & L & D & O & C)
    by (eapply found_sample; eassumption).
  exists S. split; [exact A|]. split; [exact L|]. split; [exact D|]. split; [exact O|].
  refine (tolerant_sizes unit S Up D O js [] _ _ qts eq_refl H2 _ C).
  intros w I. apply Dv, in_map_iff. exists w. auto.
Qed.

End Claim.
