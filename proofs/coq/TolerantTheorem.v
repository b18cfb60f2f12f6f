(* An accepted certificate of a match within a tolerance: none with fewer particles than the bound is within it, and one with
   the witness's number is; or there is none of any number (Theorems 12 and 14). Matches are counts and masses in classes here;
   the samples that have them follow. *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Exact Leaf Tree Tolerant Spec Openings Reduction RealFacts
  Sizes Contents Solids LeafSound TreeSound Shares TolerantSound.
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

Lemma map_first {A B C} (h : A -> C) (l : list A) : forall m : list B, length m = length l ->
  map (fun p => h (fst p)) (combine l m) = map h l.
Proof. induction l as [|x l IH]; intros [|y m] E; try discriminate; simpl; [reflexivity|]. f_equal. apply IH. injection E as E. exact E. Qed.

Lemma map_second {A B C} (h : B -> C) (l : list A) : forall m : list B, length m = length l ->
  map (fun p => h (snd p)) (combine l m) = map h m.
Proof. induction l as [|x l IH]; intros [|y m] E; try discriminate; simpl; [reflexivity|]. f_equal. apply IH. injection E as E. exact E. Qed.

Lemma total_cons x l : total (x :: l) = x + total l.
Proof. reflexivity. Qed.

(* ---- Matches within a tolerance, as counts and masses -------------------------------------------- *)

Definition mass_of_classes (js : list class) : R := total (map (fun j => Q2R (mass j)) js).

Definition realizes_there (d : positive) (law : R -> R) (p : between_rows) (n : Z) (t : R) : Prop :=
  if snd p then realizes d law (fst p) n t else n = 0%Z /\ t = 0.

Lemma there_signs d law p n t : mass_law law -> proper (fst p) -> realizes_there d law p n t -> (0 <= n)%Z /\ 0 <= t.
Proof.
  intros Law P. unfold realizes_there. destruct (snd p); [|intros (-> & ->); split; [lia | lra]].
  intros [(-> & ->)|(N & B)]; [split; [lia | lra]|]. split; [lia|].
  destruct (proper_sizes (d := d) (fst p) P) as (L & U). destruct P as (_ & C & _).
  pose proof (law_nonneg law Law _ L). apply (IZR_le 1) in N.
  assert (0 <= IZR n * (Q2R (c (fst p)) * law (lower_size d (fst p)))) by (apply Rmult_le_pos; [|apply Rmult_le_pos]; lra). lra.
Qed.

(* Each class holds what it may: of the mass M, with the mass P below the first class; floors are R. *)
Fixpoint fits_from (d : positive) (law : R -> R) (R : Z) (M P : Rdefinitions.R) (places : list between_rows) (ss : list share)
  (qts : contents) : Prop :=
  match places, ss, qts with
  | p :: places, s :: ss, (n, t) :: qts =>
    realizes_there d law p n t /\ (0 < Q2R (mass (fst p)) -> (R <= n)%Z) /\
    within_interval (retained_in s) (t / M) /\ within_interval (passing_in s) ((P + t) / M) /\
    fits_from d law R M (P + t) places ss qts
  | [], [], [] => True
  | _, _, _ => False
  end.

Definition mass_of_contents (qts : contents) : R := total (map snd qts).

(* The contents meet the tolerance, which [ss] has but for the total, and what the question demands besides. *)
Record within_at (law : R -> R) (q : question) (d : positive) (tol : tolerances) (places : list between_rows) (ss : list share)
  (qts : contents) : Prop := {
  wt_some : (1 <= sum (map fst qts))%Z;
  wt_mass : 0 < mass_of_contents qts;
  wt_fits : fits_from d law (min_per_class q) (mass_of_contents qts) 0 places ss qts;
  wt_total : forall e, Certificate.total tol = Some e ->
    total (map (fun p => Rabs (snd (snd p) / mass_of_contents qts - Q2R (mass (fst p)) / mass_of_classes (map fst places)))
      (combine (map fst places) qts)) <= Q2R e / 100;
  wt_solids : solids_of q <> Anything ->
    has_cubes (solids_of q) (total (map (fun p => snd (snd p) / Q2R (c (fst p))) (combine (map fst places) qts)));
  wt_least : (at_least q <= sum (map fst qts))%Z }.

(* What the shares are of: each has the class's share of the gradation; and where a row begins no class there is nothing. *)
Definition has_target (js : list class) (j : class) (s : share) : Prop := Q2R (g_j s) = Q2R (mass j) / mass_of_classes js.
Definition nothing_where_none (p : between_rows) (s : share) : Prop :=
  snd p = false -> Q2R (hi (retained_in s)) <= 0.

Section Claim.
Variables (cert : certificate) (d : positive) (rs : list row) (places : list between_rows) (ss : list share).
Variables (tol : tolerances) (nodes : list node).
Notation q := (asked cert).
Notation js := (map fst places).
Notation na := (Z.to_nat (a q)).
Notation nb := (Z.to_nat (b q)).
Notation all := (mass_of_classes js).

Hypothesis places_follow : follow rs places.
Hypothesis openings_nonneg : Forall (fun r => 0 <= Q2R (opening r)) rs.
Hypothesis classes_proper : Forall proper js.
Hypothesis some_mass : exists j, In j js /\ 0 < Q2R (mass j).
Hypothesis targets : Forall2 (has_target js) js ss.
Hypothesis nothing_there : Forall2 nothing_where_none places ss.
Hypothesis a_least : (1 <= a q)%Z.
Hypothesis b_least : (1 <= b q)%Z.
Hypothesis solids_proper : proper_solids (solids_of q).
Variable law : R -> R.
Hypothesis power : power_law na nb law.

Variable pr : problem.
Hypothesis derived : derive cert (Zpos d) rs places ss tol = Ok pr.

Notation mu := (IZR (mass_unit pr)).
Notation su := (IZR (share_unit pr)).
Notation ls := (classes_of pr).
Notation represents := (represents d law (min_per_class q) (solids_of q) mu su).

Lemma classes_ok p : In p places -> proper (fst p).
Proof. intro I. rewrite Forall_forall in classes_proper. apply classes_proper, in_map, I. Qed.

Lemma all_positive : 0 < all.
Proof.
  destruct some_mass as (j & J & M). unfold mass_of_classes. rewrite Forall_forall in classes_proper.
  pose proof (total_member (fun j => Q2R (mass j)) js j (fun i I => proj2 (proj2 (classes_proper i I))) J) as T. cbv beta in T. lra.
Qed.

Lemma same_number_of_shares : length ss = length places.
Proof. symmetry. exact (same_length _ _ _ nothing_there). Qed.

Lemma den_divides ws ss0 : forall places0, ws = map (inverse_factor (solids_of q)) (map fst places0) -> forall (p : between_rows) s,
  In (p, s) (combine places0 ss0) -> forall e,
  In e (denominators (inverse_factor (solids_of q) (fst p)) s) -> In e (flat_map (fun '(w, s) => denominators w s) (combine ws ss0)).
Proof.
  intros places0 -> p s I e D. apply in_flat_map. exists (inverse_factor (solids_of q) (fst p), s). split; [|exact D]. clear -I. revert ss0 I.
  induction places0 as [|i l IH]; intros [|s0 ss0] I; try destruct I as [[= <- <-]|I]; try contradiction.
  - left; reflexivity.
  - right. apply IH, I.
Qed.

(* x^(a/b) = Y^(a/(b d)), with the exponent in lowest terms. *)
Lemma law_of_roots :
  let n := Z.gcd (a q) (b q * Zpos d) in
  opening_law d (Z.to_nat (a q / n)) (Z.to_nat (b q * Zpos d / n)) law /\ (1 <= Z.to_nat (b q * Zpos d / n))%nat /\
  Z.of_nat (Z.to_nat (b q * Zpos d / n)) = (b q * Zpos d / n)%Z /\ Z.of_nat (Z.to_nat (a q / n)) = (a q / n)%Z.
Proof.
  intro n. pose proof (Z.gcd_nonneg (a q) (b q * Zpos d)) as N0.
  destruct (Z.gcd_divide_l (a q) (b q * Zpos d)) as (a' & Ea).
  destruct (Z.gcd_divide_r (a q) (b q * Zpos d)) as (b' & Eb). fold n in N0, Ea, Eb. clearbody n.
  assert (0 < n)%Z as N by (assert (n <> 0)%Z by (intros ->; lia); lia).
  assert (a q / n = a')%Z as -> by (rewrite Ea; apply Z.div_mul; lia).
  assert (b q * Zpos d / n = b')%Z as -> by (rewrite Eb; apply Z.div_mul; lia).
  assert (0 < a' /\ 0 < b')%Z as (Pa & Pb) by nia.
  split; [|lia]. apply (law_in_lowest_terms d _ _ (Z.to_nat n)); [lia|].
  pose proof (law_at_openings d na nb law power) as P.
  replace (Z.to_nat a' * Z.to_nat n)%nat with na by (rewrite Ea, Z2Nat.inj_mul; lia).
  replace (Z.to_nat b' * Z.to_nat n)%nat with (nb * Pos.to_nat d)%nat; [exact P|].
  rewrite <- Z2Nat.inj_mul, <- Eb, Z2Nat.inj_mul by lia. reflexivity.
Qed.

Record derivation : Prop := {
  der_classes : Forall2 (fun ps l => represents (fst ps) (snd ps) l) (combine places ss) ls;
  der_mass : 0 < mu;
  der_share : 0 < su;
  der_half : IZR (half_total pr) = Q2R (half (Certificate.total tol)) * su;
  der_count : least_count pr = Z.max 1 (at_least q);
  der_volume : volume pr = volume_below (solids_of q);
  der_bound : bound pr = bound_of (claimed cert) }.

Lemma der : derivation.
Proof.
  pose proof derived as H. unfold derive in H. cbv zeta in H.
  passed H. rename x into unit. passed H. rename x into roots. passed H. injection H as H.
  assert (forall e, In e (flat_map (fun '(w, s) => denominators w s)
            (combine (map (inverse_factor (solids_of q)) js) ss)) -> (0 < e)%Z) as Dp.
  { intros e I. apply in_flat_map in I as ((w, s) & _ & I). unfold denominators in I.
    apply in_map_iff in I as (z & <- & _). reflexivity. }
  apply include_all_ok in H0 as (Up & Uh & Ud); [|reflexivity | exact Dp].
  set (n := Z.gcd (a q) (b q * Zpos d)) in *. destruct law_of_roots as (Law & B' & Eb & Ea). fold n in Law, B', Eb, Ea.
  rewrite <- Eb in H1. apply rational_roots_real in H1; [|exact B' | exact openings_nonneg].
  destruct (common_denominator_spec roots) as (Sp & Sd).
  destruct (common_denominator_spec (map factor rs)) as (Fp & Fd).
  constructor; rewrite <- ?H; cbn [classes_of mass_unit share_unit half_total least_count volume bound]; trivial.
  - rewrite <- Ea. apply (limits_represent _ _ B' law Law) with (rs := rs); trivial.
    + exact same_number_of_shares.
    + intros r I. apply Fd, in_map, I.
    + intros p s I e D. apply Ud. eapply den_divides; [reflexivity | eassumption | exact D].
  - apply IZR_lt. apply Z.mul_pos_pos; [apply Z.pow_pos_nonneg; lia | exact Fp].
  - apply IZR_lt, Up.
  - apply in_units_real, Uh.
Qed.

Lemma same_number_of_limits : length ls = length places.
Proof.
  pose proof (same_length _ _ _ (der_classes der)) as L. rewrite combine_length in L. pose proof same_number_of_shares. lia.
Qed.

(* ---- What every problem is ------------------------------------------------------------------------ *)

Lemma targets_whole : sum (map g ls) = share_unit pr.
Proof.
  pose proof (der_classes der) as C. pose proof all_positive as Gm. apply eq_IZR.
  assert (forall places0 ss0 ls0, Forall2 (has_target js) (map fst places0) ss0 ->
    Forall2 (fun ps l => represents (fst ps) (snd ps) l) (combine places0 ss0) ls0 ->
    IZR (sum (map g ls0)) = total (map (fun j => Q2R (mass j)) (map fst places0)) / all * su) as S.
  { induction places0 as [|p l IH]; intros ss0 ls0 H R; inversion H as [|? s ? ss1 H1 H2]; subst; cbn [combine] in R;
      inversion R as [|? lj ? ls1 R1 R2]; subst; cbn [map sum fold_right total]; [field; lra|].
    fold (sum (map g ls1)). fold (total (map (fun j => Q2R (mass j)) (map fst l))).
    rewrite plus_IZR, (IH ss1 ls1 H2 R2), (rep_g _ _ _ _ _ _ _ _ R1). cbn [snd]. rewrite H1. field. lra. }
  rewrite (S places ss _ targets C). fold all. field. lra.
Qed.

Lemma bounds_ascend : Forall (fun x => (0 <= f x < F x)%Z) ls.
Proof.
  pose proof (der_classes der) as C. pose proof (der_mass der) as Mu.
  assert (forall p s, In (p, s) (combine places ss) -> In p places) as I by (intros p s; apply in_combine_l).
  revert I C. generalize (combine places ss) as l. generalize ls as ls0. intros ls0 l. revert ls0.
  induction l as [|(p, s) l IH]; intros ls0 I C; inversion C as [|? x ? ls1 R C']; subst; constructor.
  - cbn [fst snd] in R. destruct (snd p) eqn:B; [|destruct (rep_none _ _ _ _ _ _ _ _ R B) as (-> & ->); lia].
    pose proof (classes_ok p (I p s (or_introl eq_refl))) as P.
    destruct (proper_sizes (d := d) (fst p) P) as (L & U). destruct P as (_ & Cj & _).
    pose proof (law_nonneg law (proj1 power) _ L) as N.
    assert (law (lower_size d (fst p)) < law (upper_size d (fst p))) as Lt by (apply power; lra).
    split; [apply le_IZR | apply lt_IZR]; rewrite (rep_f _ _ _ _ _ _ _ _ R B), ?(rep_F _ _ _ _ _ _ _ _ R B).
    + apply Rmult_le_pos; [apply Rmult_le_pos|]; lra.
    + apply Rmult_lt_compat_r; [exact Mu|]. apply Rmult_lt_compat_l; assumption.
  - apply IH; [|exact C']. intros i t It. apply (I i t). right. exact It.
Qed.

Lemma volume_not_negative : 0 <= Q2R (volume pr).
Proof. rewrite (der_volume der). apply volume_enough_nonneg, solids_proper. Qed.

(* ---- Contents as a point ------------------------------------------------------------------------- *)

Fixpoint states_from (M P : R) (N : Z) (D : R) (js0 : list class) (ls0 : list limits) (qts : contents) : list state :=
  match js0, ls0, qts with
  | j :: js0, l :: ls0, (n, t) :: qts =>
    let D := D + (t - IZR (f l) * IZR n / mu) in
    State n t (Rmax 0 (t - Q2R (mass j) / all * M)) (P + t) (N + n) D :: states_from M (P + t) (N + n) D js0 ls0 qts
  | _, _, _ => []
  end.

Lemma sums_of_states M : forall js0 ls0 qts P N D, sums_from pr P N D ls0 (states_from M P N D js0 ls0 qts).
Proof.
  induction js0 as [|j js0 IH]; intros [|l ls0] [|(n, t) qts] P N D; cbn [states_from sums_from]; trivial.
  cbn [P_of N_of D_of q_of t_of]. repeat split. apply IH.
Qed.

Lemma states_are M : forall js0 ls0 qts P N D, length ls0 = length js0 -> length qts = length js0 ->
  let st := states_from M P N D js0 ls0 qts in
  map t_of st = map snd qts /\ map q_of st = map fst qts /\
  map p_of st = map (fun p => Rmax 0 (snd (snd p) - Q2R (mass (fst p)) / all * M)) (combine js0 qts).
Proof.
  induction js0 as [|j js0 IH]; intros [|l ls0] [|(n, t) qts] P N D L Q; try discriminate; [auto|].
  injection L as L. injection Q as Q. cbn [states_from]. cbv zeta. cbn [map combine t_of q_of p_of fst snd].
  destruct (IH ls0 qts (P + t) (N + n)%Z (D + (t - IZR (f l) * IZR n / mu)) L Q) as (-> & -> & ->). auto.
Qed.

Lemma realizes_signs p n t : In p places -> realizes_there d law p n t -> (0 <= n)%Z /\ 0 <= t.
Proof. intro I. exact (there_signs d law p n t (proj1 power) (classes_ok p I)). Qed.

Lemma meets_of M p s l n t P N D : 0 < M -> In p places -> represents p s l -> has_target js (fst p) s ->
  realizes_there d law p n t -> (0 < Q2R (mass (fst p)) -> (min_per_class q <= n)%Z) ->
  within_interval (retained_in s) (t / M) -> within_interval (passing_in s) (P / M) ->
  meets pr M l (State n t (Rmax 0 (t - Q2R (mass (fst p)) / all * M)) P N D).
Proof.
  intros Mp I Rep Gs Rz Fl (R1 & R2) (P1 & P2).
  pose proof (der_mass der) as Mu. pose proof (der_share der) as Su. destruct (realizes_signs p n t I Rz) as (N0 & T0).
  assert (forall b t, b <= t / M -> b * su * M <= t * su) as Lo.
  { intros b t' H. apply (Rmult_le_compat_r (M * su)) in H; [|left; apply Rmult_lt_0_compat; assumption].
    replace (t' / M * (M * su)) with (t' * su) in H by (field; lra). lra. }
  assert (forall b t, t / M <= b -> t * su <= b * su * M) as Hi.
  { intros b t' H. apply (Rmult_le_compat_r (M * su)) in H; [|left; apply Rmult_lt_0_compat; assumption].
    replace (t' / M * (M * su)) with (t' * su) in H by (field; lra). lra. }
  assert (IZR (f l) * IZR n <= t * mu /\ ((1 <= n)%Z -> IZR (f l) * IZR n < t * mu) /\ t * mu <= IZR (F l) * IZR n) as (B1 & B2 & B3).
  { unfold realizes_there in Rz. destruct (snd p) eqn:B.
    - rewrite (rep_f _ _ _ _ _ _ _ _ Rep B), (rep_F _ _ _ _ _ _ _ _ Rep B). destruct Rz as [(-> & ->)|(Q1 & C1 & C2)].
      + split; [lra|]. split; [lia | lra].
      + apply (Rmult_lt_compat_r mu) in C1; [|exact Mu]. apply (Rmult_le_compat_r mu) in C2; [|lra]. split; [lra|]. split; [intros _; lra | lra].
    - destruct Rz as (-> & ->). split; [lra|]. split; [lia | lra]. }
  constructor; cbn [q_of t_of p_of P_of].
  - split; [|exact N0]. rewrite (rep_floor _ _ _ _ _ _ _ _ Rep). destruct (equal (mass (fst p)) 0) eqn:E; [exact N0|].
    apply Fl. destruct (classes_ok p I) as (_ & _ & [Mj|Mj]); [exact Mj|].
    exfalso. apply equal_false in E. apply E. apply eqR_Qeq. rewrite Q2R_0. auto.
  - split; assumption.
  - exact B3.
  - rewrite (rep_retained_lo _ _ _ _ _ _ _ _ Rep), (rep_retained_hi _ _ _ _ _ _ _ _ Rep). split; [apply Lo, R1 | apply Hi, R2].
  - rewrite (rep_passing_lo _ _ _ _ _ _ _ _ Rep), (rep_passing_hi _ _ _ _ _ _ _ _ Rep). split; [apply Lo, P1 | apply Hi, P2].
  - rewrite (rep_g _ _ _ _ _ _ _ _ Rep), Gs. split; [|apply Rmax_l].
    pose proof (Rmax_r 0 (t - Q2R (mass (fst p)) / all * M)) as K. apply (Rmult_le_compat_r su) in K; [|lra]. lra.
Qed.

Lemma meets_all M : 0 < M -> forall places0 ss0 ls0 qts P N D,
  (forall p, In p places0 -> In p places) ->
  Forall2 (fun ps l => represents (fst ps) (snd ps) l) (combine places0 ss0) ls0 ->
  Forall2 (has_target js) (map fst places0) ss0 -> fits_from d law (min_per_class q) M P places0 ss0 qts ->
  Forall2 (meets pr M) ls0 (states_from M P N D (map fst places0) ls0 qts).
Proof.
  intro Mp. induction places0 as [|p places0 IH]; intros [|s ss0] ls0 [|(n, t) qts] P N D I R T Fi; try destruct Fi as [];
    cbn [combine map] in R; inversion R as [|? l ? ls1 R1 R2]; subst; cbn [map states_from]; [constructor|].
  inversion T as [|? ? ? ? T1 T2]; subst. destruct H0 as (Fl & Fr & Fp & Fi). constructor.
  - eapply meets_of; try eassumption. apply I. left; reflexivity.
  - apply (IH ss0); trivial. intros i Ii. apply I. right; exact Ii.
Qed.

Lemma fits_lengths M : forall places0 ss0 qts P, fits_from d law (min_per_class q) M P places0 ss0 qts -> length qts = length places0.
Proof.
  induction places0 as [|p places0 IH]; intros [|s ss0] [|(n, t) qts] P Fi; try destruct Fi as []; [reflexivity|].
  destruct H0 as (_ & _ & _ & Fi). simpl. f_equal. exact (IH _ _ _ Fi).
Qed.

Lemma fits_signs M : forall places0 ss0 qts P, (forall p, In p places0 -> In p places) ->
  fits_from d law (min_per_class q) M P places0 ss0 qts -> Forall (fun qt => 0 <= snd qt) qts.
Proof.
  induction places0 as [|p places0 IH]; intros [|s ss0] [|(n, t) qts] P I Fi; try destruct Fi as []; constructor.
  - apply (realizes_signs p n t); [apply I; left; reflexivity | assumption].
  - destruct H0 as (_ & _ & _ & Fi). eapply IH; [intros i Ii; apply I; right; exact Ii | exact Fi].
Qed.

Lemma volumes : forall places0 ss0 ls0 qts M P N D, length ss0 = length places0 -> length qts = length places0 ->
  Forall2 (fun ps l => represents (fst ps) (snd ps) l) (combine places0 ss0) ls0 ->
  total (map (fun '(c, s) => t_of s * IZR (per_factor c) / su) (combine ls0 (states_from M P N D (map fst places0) ls0 qts))) =
  total (map (fun p => snd (snd p) * Q2R (inverse_factor (solids_of q) (fst p))) (combine (map fst places0) qts)).
Proof.
  pose proof (der_share der) as Su.
  induction places0 as [|p places0 IH]; intros [|s ss0] ls0 [|(n, t) qts] M P N D L Q H; try discriminate; cbn [combine] in H;
    inversion H as [|? l ? ls1 Hj Hr]; subst; [reflexivity|].
  cbn [map combine states_from]. cbv zeta. rewrite !total_cons, (IH ss0); [|injection L as L; exact L | injection Q as Q; exact Q | exact Hr].
  f_equal. cbn [t_of fst snd]. rewrite (rep_per_factor _ _ _ _ _ _ _ _ Hj). cbn [fst snd]. field. lra.
Qed.

Lemma cubes_of_contents (qts : contents) : solids_of q <> Anything ->
  total (map (fun p => snd (snd p) * Q2R (inverse_factor (solids_of q) (fst p))) (combine js qts)) =
  total (map (fun p => snd (snd p) / Q2R (c (fst p))) (combine js qts)).
Proof.
  intro Ne. apply total_ext. intros (j, qt) I. apply in_combine_l in I. rewrite Forall_forall in classes_proper.
  destruct (classes_proper j I) as (_ & C & _). cbn [fst snd].
  assert (Q2R (inverse_factor (solids_of q) j) = 1 / Q2R (c j)) as ->.
  { unfold inverse_factor. destruct (solids_of q); [congruence|..]; rewrite Q2R_over, Q2R_integer by lra; reflexivity. }
  unfold Rdiv. ring.
Qed.

Lemma no_cubes (qts : contents) : solids_of q = Anything ->
  total (map (fun p => snd (snd p) * Q2R (inverse_factor (solids_of q) (fst p))) (combine js qts)) = 0.
Proof.
  intro E. rewrite E. transitivity (total (map (fun p => 0 * snd (snd p)) (combine js qts))).
  - apply total_ext. intros (j, qt) _. cbn [inverse_factor fst snd]. rewrite Q2R_0. ring.
  - rewrite total_scal. ring.
Qed.

(* The excesses p_j = max(0, t_j - g_j M). *)
Section Excesses.
Variable qts : contents.
Hypothesis of_each : length qts = length js.
Notation M := (mass_of_contents qts).
Hypothesis mass_positive : 0 < M.
Notation excess_of := (fun p : class * (Z * R) => snd (snd p) - Q2R (mass (fst p)) / all * M).

Lemma excesses :
  2 * total (map (fun p => Rmax 0 (excess_of p)) (combine js qts)) =
  M * total (map (fun p => Rabs (snd (snd p) / M - Q2R (mass (fst p)) / all)) (combine js qts)).
Proof.
  pose proof all_positive as Gm. rewrite (positive_part excess_of).
  assert (total (map excess_of (combine js qts)) = 0) as ->.
  { rewrite (total_map_minus (fun p : class * (Z * R) => snd (snd p)) (fun p => Q2R (mass (fst p)) / all * M)).
    rewrite (map_second snd js qts of_each), (map_first (fun j => Q2R (mass j) / all * M) js qts of_each).
    replace (total (map (fun j => Q2R (mass j) / all * M) js)) with (M / all * all).
    - fold (mass_of_contents qts). field. lra.
    - unfold mass_of_classes at 2. rewrite <- total_scal. apply total_ext. intros j _. field. lra. }
  rewrite Rplus_0_r, <- total_scal. apply total_ext. intros (j, qt) _. cbn [fst snd].
  replace (snd qt - Q2R (mass j) / all * M) with (M * (snd qt / M - Q2R (mass j) / all)) by (field; lra).
  rewrite Rabs_mult, (Rabs_right M) by lra. reflexivity.
Qed.

Lemma excesses_at_most : Forall (fun qt => 0 <= snd qt) qts -> total (map (fun p => Rmax 0 (excess_of p)) (combine js qts)) <= M.
Proof.
  intro T. pose proof all_positive as Gm. unfold mass_of_contents at 2. rewrite <- (map_second snd js qts of_each). apply total_map_le.
  intros (j, qt) I. cbn [fst snd]. pose proof (in_combine_l _ _ _ _ I) as J. apply in_combine_r in I.
  rewrite Forall_forall in T, classes_proper. specialize (T qt I). destruct (classes_proper j J) as (_ & _ & Mj).
  assert (0 <= Q2R (mass j) / all * M).
  { apply Rmult_le_pos; [apply Rmult_le_pos; [exact Mj | left; apply Rinv_0_lt_compat, Gm] | lra]. }
  unfold Rmax. destruct (Rle_dec _ _); lra.
Qed.
End Excesses.

(* ---- The theorems -------------------------------------------------------------------------------- *)

(* Contents within the tolerance, of fewer particles than the bound where there is one, satisfy the conditions. *)
Lemma within_satisfies qts : within_at law q d tol places ss qts ->
  (forall B, bound_of (claimed cert) = Some B -> (sum (map fst qts) <= B - 1)%Z) -> exists states, satisfies pr states.
Proof.
  intros [One Mp Fi To So Le] Claim. set (M := mass_of_contents qts) in *. pose proof (der_share der) as Su.
  pose proof (fits_lengths _ _ _ _ _ Fi) as Lp. pose proof same_number_of_limits as Ll.
  assert (length js = length places) as Lj by apply map_length. rewrite <- Lj in Ll. assert (length qts = length js) as Lq by congruence.
  exists (states_from M 0 0 0 js ls qts). destruct (states_are M js ls qts 0 0%Z 0 Ll Lq) as (ET & EQ & EP).
  constructor; unfold all_mass; rewrite ?ET, ?EQ, ?EP; fold (mass_of_contents qts); fold M.
  - apply meets_all with (ss0 := ss); [exact Mp | auto | apply (der_classes der) | exact targets | exact Fi].
  - apply sums_of_states.
  - exact Mp.
  - rewrite (der_half der). pose proof (excesses qts Lq Mp) as E. fold M in E. cbv beta in E.
    match goal with |- ?T * su <= _ => assert (T <= Q2R (half (Certificate.total tol)) * M) as H end.
    { unfold half. destruct (Certificate.total tol) as [e|] eqn:Et.
      - rewrite Q2R_over, Q2R_integer by (rewrite Q2R_integer; lra). pose proof (To e eq_refl) as T.
        apply (Rmult_le_compat_l M) in T; [|lra]. lra.
      - rewrite Q2R_integer. pose proof (excesses_at_most qts Lq Mp (fits_signs _ _ _ _ _ (fun p I => I) Fi)) as H. cbv beta in H. fold M in H. lra. }
    apply (Rmult_le_compat_r su) in H; lra.
  - rewrite (der_volume der). unfold all_volume.
    rewrite (volumes places ss ls qts); [|exact same_number_of_shares | exact Lp | apply (der_classes der)].
    assert (solids_of q = Anything \/ solids_of q <> Anything) as [Es|Es]
      by (destruct (solids_of q); [left; reflexivity | right; congruence | right; congruence]).
    + rewrite (no_cubes qts Es), Es. simpl. rewrite Q2R_0. lra.
    + rewrite (cubes_of_contents qts Es). pose proof (below_needed _ _ solids_proper (So Es)) as B.
      destruct (solids_of q); [congruence | exact B | left; exact B].
  - rewrite (der_count der). lia.
  - intros B E. rewrite (der_bound der) in E. exact (Claim B E).
Qed.

Section Bound.
Hypothesis checked : check_tree pr nodes = Ok tt.

Lemma none_satisfies states : ~ satisfies pr states.
Proof.
  exact (tree_sound pr (der_mass der) (der_share der) targets_whole bounds_ascend volume_not_negative nodes checked states).
Qed.

(* None with fewer particles is within the tolerance. *)
Theorem tolerant_lower_bound B qts : bound_of (claimed cert) = Some B -> within_at law q d tol places ss qts -> (B <= sum (map fst qts))%Z.
Proof.
  intros E A. destruct (Z_le_gt_dec B (sum (map fst qts))) as [|L]; [assumption|exfalso].
  destruct (within_satisfies qts A) as (st & St); [intros B' E'; rewrite E in E'; injection E' as <-; lia|].
  exact (none_satisfies st St).
Qed.

(* None of any number is. *)
Theorem tolerant_none qts : claimed cert = NoMatch -> ~ within_at law q d tol places ss qts.
Proof.
  intros E A. destruct (within_satisfies qts A) as (st & St); [rewrite E; discriminate|].
  exact (none_satisfies st St).
Qed.
End Bound.

(* ---- The witness --------------------------------------------------------------------------------- *)

(* A line of the witness, or none. *)
Definition holds_in (unit : Z) (l : limits) (qt : Z * Z) : Prop :=
  (fst qt = 0%Z /\ snd qt = 0%Z) \/
  (f l * fst qt * unit < snd qt * mass_unit pr /\ snd qt * mass_unit pr <= F l * fst qt * unit)%Z.

Lemma contents_hold unit : forall l j ls0 ws qts,
  length ls0 = length l -> Tolerant.contents (a q) (b q) (Zpos d) unit pr j l ls0 ws = Ok qts -> Forall2 (holds_in unit) ls0 qts.
Proof.
  induction l as [|x l IH]; intros j [|c_j ls0] ws qts Le H; try discriminate; cbn [Tolerant.contents] in H.
  { destruct ws; [injection H as <-; constructor | discriminate]. }
  injection Le as Le. destruct ws as [|w ws].
  { passed H. injection H as <-. constructor; [left; auto | exact (IH _ _ _ _ Le H0)]. }
  destruct (index w =? j)%Z.
  - passed H. passed H. passed H. passed H. injection H as <-. apply Z.ltb_lt in H0. apply Z.leb_le in H1.
    constructor; [right; auto | exact (IH _ _ _ _ Le H3)].
  - passed H. injection H as <-. constructor; [left; auto | exact (IH _ _ _ _ Le H0)].
Qed.

Section Witness.
Variables (N unit : Z) (qts : list (Z * Z)).
Hypothesis unit_positive : (0 < unit)%Z.
Notation Mz := (sum (map snd qts)).
Hypothesis lines_hold_in : Forall2 (holds_in unit) ls qts.
Hypothesis ok_within : within (share_unit pr) Mz 0 ls qts = true.
Hypothesis ok_total : (excess (share_unit pr) Mz ls qts <= half_total pr * Mz)%Z.
Hypothesis ok_volume : Q2R (volume_enough (solids_of q)) * (su * IZR unit) <= IZR (over_factors ls qts).
Hypothesis ok_sum : (sum (map fst qts) =? N)%Z = true.
Hypothesis ok_least : (at_least q <= N)%Z.
Hypothesis N_positive : (1 <= N)%Z.

(* The masses as they are. *)
Definition in_mass (qts0 : list (Z * Z)) : contents := map (fun qt => (fst qt, IZR (snd qt) / IZR unit)) qts0.

Lemma holds_signs l qt : (0 <= f l < F l)%Z -> holds_in unit l qt ->
  (0 <= fst qt)%Z /\ (0 <= snd qt)%Z /\ (1 <= fst qt -> 1 <= snd qt)%Z.
Proof.
  intros Fl [(-> & ->)|(Lo & Hi)]; [lia|]. destruct qt as (n, t). cbn [fst snd] in *.
  assert (0 < mass_unit pr)%Z as Mu by (apply lt_IZR, (der_mass der)).
  assert (0 < n)%Z as Np.
  { apply Z.nle_gt. intro N0. assert (n * ((F l - f l) * unit) <= 0)%Z by (apply Z.mul_nonpos_nonneg; [exact N0 | nia]). lia. }
  assert (0 <= f l * n * unit)%Z by nia. nia.
Qed.

Lemma sums_signs : forall ls0 qts0, Forall (fun x => (0 <= f x < F x)%Z) ls0 -> Forall2 (holds_in unit) ls0 qts0 ->
  (0 <= sum (map fst qts0) /\ 0 <= sum (map snd qts0) /\ (1 <= sum (map fst qts0) -> 1 <= sum (map snd qts0)))%Z.
Proof.
  intros ls0 qts0 Fl H. induction H as [|l qt ls0 qts0 H _ IH]; [simpl; lia|]. inversion Fl as [|? ? F1 F2]; subst.
  specialize (IH F2). pose proof (holds_signs l qt F1 H). cbn [map sum fold_right].
  fold (sum (map fst qts0)). fold (sum (map snd qts0)). lia.
Qed.

Lemma mz_positive : 0 < IZR Mz.
Proof.
  apply IZR_lt. apply Z.eqb_eq in ok_sum. pose proof (sums_signs ls qts bounds_ascend lines_hold_in). lia.
Qed.

Lemma found_mass : mass_of_contents (in_mass qts) = IZR Mz / IZR unit.
Proof.
  unfold mass_of_contents, in_mass. rewrite map_map. pose proof (IZR_lt _ _ unit_positive) as U. clear -U.
  induction qts as [|qt l IH]; [simpl; field; lra|]. cbn [map snd] in *. rewrite total_cons, IH.
  change (sum (snd qt :: map snd l)) with (snd qt + sum (map snd l))%Z. rewrite plus_IZR. field. lra.
Qed.

Lemma line_realizes p s l qt : In p places -> represents p s l -> nothing_where_none p s -> holds_in unit l qt ->
  (snd qt * share_unit pr <= retained_hi l * Mz)%Z -> realizes_there d law p (fst qt) (IZR (snd qt) / IZR unit).
Proof.
  intros J Rp No H Hi0. pose proof (der_mass der) as Mu. pose proof (IZR_lt _ _ unit_positive) as Up. unfold realizes_there.
  destruct (snd p) eqn:B.
  - destruct H as [(-> & ->)|(Lo & Hi)]; [left; split; [reflexivity | unfold Rdiv; ring]|]. destruct qt as (n, t). cbn [fst snd] in *.
    destruct (proper_sizes (d := d) (fst p) (classes_ok p J)) as (L & U). destruct (classes_ok p J) as (_ & C & _).
    assert (law (lower_size d (fst p)) < law (upper_size d (fst p))) as Lt by (apply power; lra).
    assert (f l < F l)%Z as FF.
    { apply lt_IZR. rewrite (rep_f _ _ _ _ _ _ _ _ Rp B), (rep_F _ _ _ _ _ _ _ _ Rp B).
      apply Rmult_lt_compat_r; [exact Mu|]. apply Rmult_lt_compat_l; assumption. }
    assert (0 < n)%Z as Np.
    { apply Z.nle_gt. intro N0. assert (n * ((F l - f l) * unit) <= 0)%Z by (apply Z.mul_nonpos_nonneg; [exact N0 | nia]). lia. }
    right. split; [lia|]. apply IZR_lt in Lo. apply IZR_le in Hi. rewrite !mult_IZR in Lo, Hi.
    rewrite (rep_f _ _ _ _ _ _ _ _ Rp B) in Lo. rewrite (rep_F _ _ _ _ _ _ _ _ Rp B) in Hi. split.
    + apply (Rmult_lt_reg_r (IZR unit * mu)); [apply Rmult_lt_0_compat; assumption|].
      replace (IZR t / IZR unit * (IZR unit * mu)) with (IZR t * mu) by (field; lra). lra.
    + apply (Rmult_le_reg_r (IZR unit * mu)); [apply Rmult_lt_0_compat; assumption|].
      replace (IZR t / IZR unit * (IZR unit * mu)) with (IZR t * mu) by (field; lra). lra.
  - pose proof (No B) as Zero. destruct (rep_none _ _ _ _ _ _ _ _ Rp B) as (Ef & EF). pose proof (der_share der) as Sr.
    assert (retained_hi l <= 0)%Z as E.
    { apply le_IZR. rewrite (rep_retained_hi _ _ _ _ _ _ _ _ Rp). rewrite <- (Rmult_0_l su). apply Rmult_le_compat_r; lra. }
    assert (0 < share_unit pr)%Z as Su by (apply lt_IZR, Sr). pose proof (lt_IZR _ _ mz_positive) as Mzp.
    destruct (holds_signs l qt ltac:(lia) H) as (N0 & T0 & NT).
    assert (snd qt = 0)%Z as T by nia. assert (fst qt = 0)%Z as N1 by lia. rewrite T, N1. split; [reflexivity | unfold Rdiv; ring].
Qed.

Lemma within_fits : forall places0 ss0 ls0 qts0 P, (forall p, In p places0 -> In p places) ->
  Forall2 (fun ps l => represents (fst ps) (snd ps) l) (combine places0 ss0) ls0 ->
  Forall2 nothing_where_none places0 ss0 -> Forall2 (holds_in unit) ls0 qts0 ->
  within (share_unit pr) Mz P ls0 qts0 = true ->
  fits_from d law (min_per_class q) (IZR Mz / IZR unit) (IZR P / (su * IZR unit)) places0 ss0 (in_mass qts0).
Proof.
  pose proof (der_share der) as Su. pose proof mz_positive as Mp. pose proof (IZR_lt _ _ unit_positive) as U.
  assert (forall lo t, IZR lo * IZR Mz <= IZR t -> IZR lo / su <= IZR t / (su * IZR Mz)) as Lo.
  { intros lo t H. apply (Rmult_le_reg_r (su * IZR Mz)); [apply Rmult_lt_0_compat; assumption|].
    replace (IZR lo / su * (su * IZR Mz)) with (IZR lo * IZR Mz) by (field; lra).
    replace (IZR t / (su * IZR Mz) * (su * IZR Mz)) with (IZR t) by (field; lra). exact H. }
  assert (forall hi t, IZR t <= IZR hi * IZR Mz -> IZR t / (su * IZR Mz) <= IZR hi / su) as Hi.
  { intros hi t H. apply (Rmult_le_reg_r (su * IZR Mz)); [apply Rmult_lt_0_compat; assumption|].
    replace (IZR hi / su * (su * IZR Mz)) with (IZR hi * IZR Mz) by (field; lra).
    replace (IZR t / (su * IZR Mz) * (su * IZR Mz)) with (IZR t) by (field; lra). exact H. }
  induction places0 as [|p places0 IH]; intros ss0 ls0 qts0 P I R No H W; inversion No as [|? s ? ss1 No1 No2]; subst;
    cbn [combine] in R; inversion R as [|? l ? ls1 R1 R2]; subst; inversion H as [|? (n, t) ? qts1 H1 H2]; subst; [exact Logic.I|].
  cbn [fst snd] in R1. cbn [within] in W. rewrite !andb_true_iff, !Z.leb_le in W.
  destruct W as (((((W1 & W2) & W3) & W4) & W5) & W6).
  pose proof (line_realizes p s l (n, t) (I p (or_introl eq_refl)) R1 No1 H1 W3) as Rz.
  assert (IZR t / IZR unit / (IZR Mz / IZR unit) = IZR (t * share_unit pr) / (su * IZR Mz)) as Ex by (rewrite mult_IZR; field; lra).
  assert (IZR P / (su * IZR unit) + IZR t / IZR unit = IZR (P + t * share_unit pr) / (su * IZR unit)) as Ep.
  { rewrite plus_IZR, mult_IZR. field. lra. }
  assert (IZR (P + t * share_unit pr) / (su * IZR unit) / (IZR Mz / IZR unit) = IZR (P + t * share_unit pr) / (su * IZR Mz)) as Ey
    by (field; lra).
  apply IZR_le in W2, W3, W4, W5. rewrite (mult_IZR _ Mz) in W2. rewrite (mult_IZR _ Mz) in W3.
  rewrite (mult_IZR _ Mz) in W4. rewrite (mult_IZR _ Mz) in W5.
  apply Lo in W2, W4. apply Hi in W3, W5.
  rewrite (rep_retained_lo _ _ _ _ _ _ _ _ R1) in W2. rewrite (rep_retained_hi _ _ _ _ _ _ _ _ R1) in W3.
  rewrite (rep_passing_lo _ _ _ _ _ _ _ _ R1) in W4. rewrite (rep_passing_hi _ _ _ _ _ _ _ _ R1) in W5.
  assert (forall v, v * su / su = v) as Cancel by (intro; field; lra).
  rewrite Cancel in W2. rewrite Cancel in W3. rewrite Cancel in W4. rewrite Cancel in W5.
  cbn [in_mass map fst snd fits_from]. rewrite Ep. split; [exact Rz|]. split; [|split; [|split]].
  - intro Mj. rewrite (rep_floor _ _ _ _ _ _ _ _ R1) in W1. destruct (equal (mass (fst p)) 0) eqn:E; [|exact W1].
    apply equal_real in E. rewrite Q2R_0 in E. lra.
  - unfold within_interval. rewrite Ex. lra.
  - unfold within_interval. rewrite Ey. lra.
  - apply (IH ss1 ls1 qts1); trivial. intros i Ii. apply I. right; exact Ii.
Qed.

Lemma excess_real : forall places0 ss0 ls0 qts0,
  Forall2 (fun ps l => represents (fst ps) (snd ps) l) (combine places0 ss0) ls0 ->
  Forall2 (has_target js) (map fst places0) ss0 -> length qts0 = length places0 ->
  total (map (fun p => Rmax 0 (snd (snd p) - Q2R (mass (fst p)) / all * (IZR Mz / IZR unit)))
    (combine (map fst places0) (in_mass qts0))) * (su * IZR unit) = IZR (excess (share_unit pr) Mz ls0 qts0) /\
  total (map (fun p => snd (snd p) * Q2R (inverse_factor (solids_of q) (fst p))) (combine (map fst places0) (in_mass qts0))) *
    (su * IZR unit) = IZR (over_factors ls0 qts0).
Proof.
  pose proof (der_share der) as Su. pose proof (IZR_lt _ _ unit_positive) as U. pose proof all_positive as Ap.
  unfold excess, over_factors.
  induction places0 as [|p places0 IH]; intros ss0 ls0 qts0 R Gt Le; inversion Gt as [|? s ? ss1 Gs Gt']; subst; cbn [combine] in R;
    inversion R as [|? lj ? ls1 Rj R']; subst; destruct qts0 as [|(n, t) qts1]; try discriminate Le.
  { simpl. split; ring. }
  injection Le as Le. cbn [fst snd] in *. destruct (IH _ _ _ R' Gt' Le) as (I1 & I2).
  cbn [in_mass combine map sum fold_right fst snd]. rewrite !total_cons. fold (in_mass qts1).
  match goal with |- _ = IZR (_ + ?B) /\ _ = IZR (_ + ?D) =>
    change B with (sum (map (fun '(c, (_, t)) => Z.max 0 (t * share_unit pr - g c * Mz)) (combine ls1 qts1)));
    change D with (sum (map (fun '(c, (_, t)) => (t * per_factor c)%Z) (combine ls1 qts1)))
  end.
  rewrite !plus_IZR, <- I1, <- I2, !Rmult_plus_distr_r. split; f_equal.
  - set (v := IZR t / IZR unit - Q2R (mass (fst p)) / all * (IZR Mz / IZR unit)).
    assert (IZR (t * share_unit pr - g lj * Mz) = v * (su * IZR unit)) as E.
    { rewrite minus_IZR, !mult_IZR, (rep_g _ _ _ _ _ _ _ _ Rj), Gs. unfold v. field. lra. }
    assert (0 < su * IZR unit) as K by (apply Rmult_lt_0_compat; assumption).
    unfold Rmax. destruct (Rle_dec 0 v) as [Ge|Gt0].
    + rewrite Z.max_r; [symmetry; exact E|]. apply le_IZR. rewrite E. apply Rmult_le_pos; lra.
    + rewrite Z.max_l; [ring|]. apply le_IZR. rewrite E. apply Rlt_le. apply Rnot_le_lt in Gt0.
      rewrite <- (Rmult_0_l (su * IZR unit)). apply Rmult_lt_compat_r; assumption.
  - rewrite mult_IZR, (rep_per_factor _ _ _ _ _ _ _ _ Rj). field. lra.
Qed.

Lemma counts_in_mass qts0 : map fst (in_mass qts0) = map fst qts0.
Proof. unfold in_mass. rewrite map_map. reflexivity. Qed.

Theorem witness_within : within_at law q d tol places ss (in_mass qts).
Proof.
  pose proof found_mass as Em. pose proof (der_share der) as Su. pose proof (IZR_lt _ _ unit_positive) as U. pose proof mz_positive as Mz0.
  assert (0 < su * IZR unit) as K by (apply Rmult_lt_0_compat; assumption).
  assert (0 < IZR Mz / IZR unit) as Mp by (apply Rdiv_lt_0_compat; assumption).
  assert (length qts = length places) as Lq by (pose proof (same_length _ _ _ lines_hold_in); pose proof same_number_of_limits; lia).
  assert (length (in_mass qts) = length js) as Lm by (unfold in_mass; rewrite !map_length; exact Lq).
  destruct (excess_real places ss ls qts (der_classes der) targets Lq) as (Ex & Vo). pose proof (proj1 (Z.eqb_eq _ _) ok_sum) as Sum.
  constructor; rewrite ?counts_in_mass, ?Em; try lia.
  - exact Mp.
  - pose proof (within_fits places ss ls qts 0 (fun p I => I) (der_classes der) nothing_there lines_hold_in ok_within) as Fi.
    replace (IZR 0 / (su * IZR unit)) with 0 in Fi by (field; lra). exact Fi.
  - intros e Et. apply IZR_le in ok_total. rewrite <- Ex, mult_IZR, (der_half der) in ok_total.
    unfold half in ok_total. rewrite Et, Q2R_over, Q2R_integer in ok_total by (rewrite Q2R_integer; lra).
    pose proof (excesses (in_mass qts) Lm ltac:(rewrite Em; exact Mp)) as E2. cbv beta in E2, ok_total. rewrite Em in E2.
    set (D := total (map (fun p => Rmax _ _) _)) in *. set (M := IZR Mz / IZR unit) in *.
    apply (Rmult_le_reg_l M); [exact Mp|]. rewrite <- E2.
    replace (IZR Mz) with (M * IZR unit) in ok_total by (unfold M; field; lra).
    apply (Rmult_le_reg_r (su * IZR unit)); [exact K|]. lra.
  - intro Es. apply enough_suffices; [exact solids_proper|]. rewrite <- (cubes_of_contents (in_mass qts) Es).
    apply (Rmult_le_reg_r (su * IZR unit)); [exact K|]. rewrite Vo. exact ok_volume.
Qed.

End Witness.

(* The witness's sizes are those of its contents. *)
Lemma tolerant_sizes unit : (0 < unit)%Z -> forall post pre before ls0 ws qts,
  js = pre ++ post -> length before = length pre ->
  Tolerant.contents (a q) (b q) (Zpos d) unit pr (Z.of_nat (length pre) + 1) post ls0 ws = Ok qts ->
  Forall (fun x => (0 <= f x < F x)%Z) ls0 -> length ls0 = length post ->
  (forall w, In w ws -> (Zpos (Qden (together w)) | unit)%Z) ->
  Forall (line_fits na nb js (before ++ in_mass unit qts)) ws.
Proof.
  intro Up. induction post as [|j post IH]; intros pre before ls0 ws qts E Lb C Fl Ll Dv; cbn [Tolerant.contents] in C.
  { destruct ws; [constructor | discriminate]. }
  destruct ls0 as [|l ls0]; [discriminate|]. inversion Fl as [|? ? Fl1 Fl2]; subst. injection Ll as Ll.
  assert (forall n t ws' qts', Tolerant.contents (a q) (b q) (Zpos d) unit pr (Z.of_nat (length pre) + 1 + 1) post ls0 ws' = Ok qts' ->
    (forall w, In w ws' -> (Zpos (Qden (together w)) | unit)%Z) ->
    Forall (line_fits na nb js (before ++ in_mass unit ((n, t) :: qts'))) ws') as Rest.
  { intros n t ws' qts' C' Dv'. change (in_mass unit ((n, t) :: qts')) with ([(n, IZR t / IZR unit)] ++ in_mass unit qts').
    rewrite app_assoc. apply (IH (pre ++ [j]) (before ++ [(n, IZR t / IZR unit)]) ls0 ws' qts'); trivial; [rewrite <- app_assoc; exact E | |].
    - rewrite !app_length, Lb. reflexivity.
    - rewrite app_length. simpl length. replace (Z.of_nat (length pre + 1) + 1)%Z with (Z.of_nat (length pre) + 1 + 1)%Z by lia.
      exact C'. }
  destruct ws as [|w ws]; [constructor|]. destruct (Z.eqb_spec (index w) (Z.of_nat (length pre) + 1)) as [Iw|].
  - passed C. passed C. passed C. passed C. destruct x. injection C as <-. apply Z.ltb_lt in C0. apply Z.leb_le in C1.
    constructor; [|apply Rest; trivial; intros; apply Dv; right; assumption].
    assert (Z.to_nat (index w - 1) = length pre) as Place by (rewrite Iw; lia).
    exists j, (IZR (in_units (together w) unit) / IZR unit). split; [rewrite E; apply nth_behind, Place|].
    split; [apply nth_behind; congruence|]. intros x X Sz.
    assert (In j js) as J by (rewrite E; apply in_or_app; right; left; reflexivity).
    rewrite Forall_forall in classes_proper. destruct (classes_proper j J) as (_ & Cj & _).
    destruct (holds_signs unit Up l (count w, in_units (together w) unit) Fl1 (or_intror (conj C0 C1))) as (N0 & _ & _). cbn [fst] in N0.
    assert (count w <> 0)%Z as Nz.
    { intro Z. rewrite Z in C0, C1. rewrite !Z.mul_0_r, !Z.mul_0_l in *. lia. }
    assert (1 <= count w)%Z as N1 by lia. apply (IZR_le 1) in N1. pose proof (IZR_lt _ _ Up) as Ur.
    set (one := over (together w) (times (of_integer (count w)) (c j))) in *.
    assert (Q2R one = Q2R (together w) / (IZR (count w) * Q2R (c j))) as Eo.
    { unfold one. rewrite Q2R_over; rewrite Q2R_times, Q2R_integer; [reflexivity|].
      apply Rgt_not_eq, Rmult_lt_0_compat; lra. }
    replace (a q) with (Z.of_nat na) in C2 by lia.
    refine (check_size_sound na (Zpos d) j w _ _ x ltac:(lia) eq_refl _ X _ C2).
    + apply Z.pow_pos_nonneg; lia.
    + rewrite pow_mult, Sz, <- pow_mult, in_units_real by (apply Dv; left; reflexivity).
      replace (Q2R (together w) * IZR unit / IZR unit) with (Q2R (together w)) by (field; lra).
      rewrite <- Eo. replace (b q * Zpos d)%Z with (Z.of_nat (nb * Pos.to_nat d)) by lia.
      rewrite <- !pow_IZR. unfold Q2R, Rdiv. rewrite Rpow_mult_distr, pow_inv. reflexivity.
  - passed C. injection C as <-. exact (Rest 0%Z 0%Z (w :: ws) x C0 Dv).
Qed.

(* One with N is within the tolerance, in the witness's bounds. *)
Theorem tolerant_attained N :
  (1 <= N)%Z -> check_witness cert (Zpos d) js pr N = Ok tt ->
  exists qts, within_at law q d tol places ss qts /\ sum (map fst qts) = N /\ Forall (line_fits na nb js qts) (witness cert).
Proof.
  intros Np H. unfold check_witness in H. cbv zeta in H. passed H. rename x into unit. passed H. passed H. rename x into qts.
  passed H. passed H. passed H. passed H. passed H.
  apply include_all_ok in H0 as (Up & _ & Dv); [|reflexivity|].
  2: { intros e I. apply in_map_iff in I as (w & <- & _). reflexivity. }
  apply Z.leb_le in H4, H. apply at_most_real in H5.
  rewrite Q2R_times, !Q2R_integer, mult_IZR in H5.
  assert (length ls = length js) as Ll by (rewrite map_length; exact same_number_of_limits).
  pose proof (contents_hold unit js 1 ls _ qts Ll H2) as Hin.
  exists (in_mass unit qts). split; [eapply witness_within; eassumption|].
  split; [rewrite counts_in_mass; apply Z.eqb_eq; assumption|].
  apply (tolerant_sizes unit Up js [] [] ls _ qts eq_refl eq_refl H2 bounds_ascend Ll).
  intros w I. apply Dv, in_map_iff. exists w. auto.
Qed.

End Claim.

(* ---- Samples of one gradation -------------------------------------------------------------------- *)

Lemma some_positive {A} (w : A -> Z) l : (1 <= sum (map w l))%Z -> exists j, In j l /\ (1 <= w j)%Z.
Proof.
  induction l as [|i l IH]; intro L; [exfalso; compute in L; apply L; reflexivity|].
  change (1 <= w i + sum (map w l))%Z in L.
  destruct (Z_lt_le_dec (w i) 1) as [Lt|Ge]; [|exists i; split; [left; reflexivity | exact Ge]].
  destruct IH as (j & J & H); [lia|]. exists j. split; [right; exact J | exact H].
Qed.

Lemma all_begin_classes js : map fst (all_begin js) = js.
Proof. unfold all_begin. rewrite map_map. apply map_id. Qed.

Lemma openings_not_negative rs : proper_rows rs -> Forall (fun r => 0 <= Q2R (opening r)) rs.
Proof.
  intros (A & L & _ & _). induction rs as [|r l IH]; constructor.
  - exact L.
  - destruct l as [|n l]; [constructor|]. cbn [ascending] in A. apply andb_prop in A as (A1 & A2). apply less_real in A1.
    apply IH; [exact A2|]. simpl in *. lra.
Qed.

Section Samples.
Variables (q : question) (G : gradation) (d : positive) (tol : tolerances) (ss : list share).
Notation rs := (rows G).
Notation js := (classes rs).

Hypothesis tolerant : tolerances_of q = Some tol.
Hypothesis root_proper : root G = Zpos d.
Hypothesis factor_nonneg : forall K, size_factor q = Some K -> 0 <= Q2R K.
Hypothesis band_sizes : forall X l h, In (X, l, h) (band tol) -> 0 <= Q2R X.
Hypothesis rows_proper : proper_rows rs.
Hypothesis some_mass : exists j, In j js /\ 0 < Q2R (mass j).
Hypothesis solids_law : solids_of q = Anything \/ a q = 3%Z /\ b q = 1%Z.
Variable law : R -> R.
Hypothesis power : power_law (Z.to_nat (a q)) (Z.to_nat (b q)) law.
Hypothesis derived_shares : shares_of q tol G = Ok ss.

(* What the question allows, with the root by its name. *)
Lemma allowed_within S :
  allowed law q G S <-> describes_within d law (size_factor q) tol rs S /\ has_enough d q rs S.
Proof. unfold allowed, root_of. rewrite tolerant, root_proper. tauto. Qed.

Lemma class_ok j : In j js -> proper j.
Proof. pose proof (proper_classes rs rows_proper) as P. rewrite Forall_forall in P. apply P. Qed.

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

Lemma shares_have_targets : Forall2 (has_target js) js ss.
Proof.
  pose proof derived_shares as H. unfold shares_of in H. cbv zeta in H. do 4 passed H.
  apply (band_keeps (fun j => Q2R (mass j) / mass_of_classes js) _ _ _ _ H).
  pose proof (gradation_mass_positive rs rows_proper some_mass) as Gm.
  pose proof (shares_target rs 0 (passing_each tol) (fold_left add (map retained rs) 0%Q)) as T.
  rewrite (sum_of_rows rs rows_proper) in T. apply T. lra.
Qed.

Lemma rows_all_begin : Forall2 nothing_where_none (all_begin js) ss.
Proof.
  pose proof shares_have_targets as T. revert T. generalize (has_target js). intros P T. unfold all_begin. clear -T.
  induction T as [|j s l ss0 _ _ IH]; constructor; [discriminate | exact IH].
Qed.

Section Sample.
Variable S : sample.
Hypothesis S_describes : describes d rs S.
Hypothesis S_some : S <> [].
Notation M := (mass_of_all d law rs S).
Notation x := (fun j => share_retained d law rs j S).
Notation y := (fun j => share_passing d law rs (upper_size d j) S).
Notation gx := (fun j => target_retained rs j).
Notation gy := (fun j => target_passing d rs (upper_size d j)).
Notation qts := (contents_of d law js S).

Lemma mass_of_sample : 0 < M.
Proof.
  assert (exists j, In j js /\ (1 <= number d j S)%Z) as (j & J & N).
  { pose proof (describes_number rs S rows_proper S_describes) as E. destruct S as [|z S0]; [congruence|].
    assert (1 <= sum (map (fun j => number d j (z :: S0)) js))%Z as L by (rewrite <- E; simpl length; lia).
    exact (some_positive _ _ L). }
  assert (0 < held d law j S) as H.
  { destruct (sample_realizes (d := d) law (proj1 power) j S (class_ok j J)) as [(E & _)|(_ & B & _)]; [lia|].
    destruct (proper_sizes (d := d) j (class_ok j J)) as (L & U). destruct (class_ok j J) as (_ & C & _).
    apply (IZR_le 1) in N. pose proof (law_nonneg law (proj1 power) _ L).
    assert (0 <= IZR (number d j S) * (Q2R (c j) * law (lower_size d j))) by (apply Rmult_le_pos; [|apply Rmult_le_pos]; lra). lra. }
  pose proof (total_member (fun j => held d law j S) js j (held_nonneg (d := d) law rs S (proj1 power) rows_proper) J) as T.
  cbv beta in T. unfold mass_of_all. lra.
Qed.

Lemma mass_is : mass_of_contents qts = M.
Proof. unfold mass_of_contents, mass_of_all. rewrite masses_of_contents. reflexivity. Qed.

Lemma number_is : sum (map fst qts) = Z.of_nat (length S).
Proof. rewrite counts_of_contents. symmetry. apply describes_number; assumption. Qed.

Lemma fits_are_shares : forall l ss0 P, (forall j, In j l -> In j js) -> Forall2 (has_target js) l ss0 ->
  prefix_of x y (P / M) l ->
  fits_from d law (min_per_class q) M P (all_begin l) ss0 (contents_of d law l S) <->
  Forall2 (fits_share x y gx) l ss0 /\ forall j, In j l -> 0 < Q2R (mass j) -> (min_per_class q <= number d j S)%Z.
Proof.
  pose proof mass_of_sample as Mp.
  induction l as [|j l IH]; intros ss0 P I T Pr; inversion T as [|? s ? ss1 T1 T2]; subst; cbn [all_begin contents_of map fits_from].
  { split; [intros _; split; [constructor | intros ? []] | trivial]. }
  destruct Pr as (Pj & Pr). cbv beta in Pj.
  assert (share_passing d law rs (upper_size d j) S = (P + held d law j S) / M) as Ey.
  { rewrite Pj. unfold share_retained. field. lra. }
  cbv beta in Pr. rewrite Ey in Pr. specialize (IH ss1 (P + held d law j S) (fun i H => I i (or_intror H)) T2 Pr).
  fold (all_begin l). fold (contents_of d law l S). rewrite IH. cbn [realizes_there fst snd]. split.
  - intros (_ & F & A & B & Fi & Fl). split; [|intros i [<-|H]; auto]. constructor; [|exact Fi].
    split; [exact T1|]. split; [exact A|]. rewrite Ey. exact B.
  - intros (Fi & Fl). inversion Fi as [|? ? ? ? (_ & A & B) Fi']; subst. rewrite Ey in B.
    split; [apply sample_realizes; [apply power | apply class_ok, I; left; reflexivity]|].
    split; [apply Fl; left; reflexivity|]. split; [exact A|]. split; [exact B|]. split; [exact Fi'|].
    intros i H. apply Fl. right. exact H.
Qed.

Lemma errors_are : total (map (fun p => Rabs (snd (snd p) / mass_of_contents qts - Q2R (mass (fst p)) / mass_of_classes js)) (combine js qts)) =
  total (map (fun j => Rabs (x j - gx j)) js).
Proof.
  rewrite mass_is. unfold share_retained, target_retained, gradation_mass, mass_of_classes. generalize M as m.
  generalize (total (map (fun j => Q2R (mass j)) js)) as g. intros g m. clear.
  induction js as [|j l IH]; [reflexivity|]. cbn [contents_of combine map]. rewrite !total_cons. f_equal. exact IH.
Qed.

Lemma cubes_are : solids_of q <> Anything ->
  total (map (fun p => snd (snd p) / Q2R (c (fst p))) (combine js qts)) = total (map sphere S).
Proof.
  intro Ne. destruct solids_law as [E|(A3 & B1)]; [congruence|].
  assert (power_law 3 1 law) as P31 by (rewrite A3, B1 in power; exact power).
  rewrite (cubes_by_class law rs S P31 rows_proper S_describes). clear.
  induction js as [|j l IH]; [reflexivity|]. cbn [contents_of combine map]. rewrite !total_cons. f_equal. exact IH.
Qed.

Lemma solids_are : has_solids (solids_of q) S <->
  (solids_of q <> Anything -> has_cubes (solids_of q) (total (map (fun p => snd (snd p) / Q2R (c (fst p))) (combine js qts)))).
Proof.
  assert (solids_of q = Anything \/ solids_of q <> Anything) as [E|E]
    by (destruct (solids_of q); [left; reflexivity | right; congruence | right; congruence]).
  - rewrite E. simpl. split; [congruence | trivial].
  - rewrite (cubes_are E). assert (has_solids (solids_of q) S <-> has_cubes (solids_of q) (total (map sphere S))) as ->
      by (destruct (solids_of q); reflexivity). tauto.
Qed.
End Sample.

(* The contents of a sample that the question allows are within the tolerance. *)
Lemma within_of_sample S : allowed law q G S ->
  within_at law q d tol (all_begin js) ss (contents_of d law js S) /\ Z.of_nat (length S) = sum (map fst (contents_of d law js S)).
Proof.
  intro Al. apply allowed_within in Al as ((D & Ne & (T1 & T2 & T3 & T4 & T5 & T6 & T7)) & Fl & V & Le).
  pose proof (mass_of_sample S D Ne) as Mp.
  destruct (shares_of_fit law rs S (proj1 power) rows_proper some_mass Mp q tol G ss root_proper factor_nonneg band_sizes
              eq_refl derived_shares) as (Ls & _ & _ & Fit).
  assert (Forall2 (fits_share (fun j => share_retained d law rs j S) (fun j => share_passing d law rs (upper_size d j) S)
            (fun j => target_retained rs j)) js ss) as F.
  { apply Fit; [|exact T7]. apply lines_hold_of; trivial. }
  destruct (shares_prefix (d := d) law rs S rows_proper) as (Px & _).
  split; [|symmetry; apply number_is, D]. constructor; rewrite ?number_is, ?mass_is, ?all_begin_classes by exact D.
  - destruct S; [congruence | simpl length; lia].
  - exact Mp.
  - apply (fits_are_shares S D Ne js ss 0 (fun j J => J) shares_have_targets); [replace (0 / mass_of_all d law rs S) with 0 by (field; lra); exact Px|].
    split; [exact F|]. intros j J Mj. apply Fl; [exact J|]. apply Rlt_Qlt. rewrite Q2R_0. exact Mj.
  - intros e Et. rewrite <- (mass_is S), errors_are. exact (T6 e Et).
  - apply solids_are; assumption.
  - exact Le.
Qed.

Hypothesis rows_tolerances : Forall (fun r => 0 <= Q2R (tolerance r)) rs.
Hypothesis each_nonneg : Forall (fun e => 0 <= Q2R e) (passing_each tol).
Hypothesis passing_nonneg : forall e, passing_all tol = Some e -> 0 <= Q2R e.
Hypothesis band_nonneg : forall X l h, In (X, l, h) (band tol) -> 0 <= Q2R h.

Lemma fits_realize M : forall l ss0 P qts, fits_from d law (min_per_class q) M P (all_begin l) ss0 qts ->
  Forall2 (fun j qt => realizes d law j (fst qt) (snd qt)) l qts.
Proof.
  induction l as [|j l IH]; intros [|s ss0] P [|(n, t) qts] F; try destruct F as []; constructor; [assumption|].
  destruct H0 as (_ & _ & _ & F). exact (IH _ _ _ F).
Qed.

(* And there is a sample for all contents that are. *)
Lemma sample_of_within qts : within_at law q d tol (all_begin js) ss qts ->
  exists S, allowed law q G S /\ Z.of_nat (length S) = sum (map fst qts) /\ describes d rs S /\ one_size_a_class d js S /\
    contents_of d law js S = qts.
Proof.
  intros [One Mp Fi To So Le].
  destruct (sample_with_contents (d := d) law rs qts (proj1 power) rows_proper (fits_realize _ _ _ _ _ Fi)) as (S & D & O & C).
  apply contents_are in C. subst qts. rewrite all_begin_classes in *. rewrite (number_is S D) in *.
  assert (S <> []) as Ne by (intros ->; simpl in One; lia).
  exists S. split; [|split; [reflexivity | split; [exact D | split; [exact O | reflexivity]]]].
  rewrite mass_is in Fi, Mp. destruct (shares_prefix (d := d) law rs S rows_proper) as (Px & _).
  apply (fits_are_shares S D Ne js ss 0 (fun j J => J) shares_have_targets) in Fi as (Fit & Floors);
    [|replace (0 / mass_of_all d law rs S) with 0 by (field; lra); exact Px].
  destruct (shares_of_fit law rs S (proj1 power) rows_proper some_mass Mp q tol G ss root_proper factor_nonneg band_sizes
              eq_refl derived_shares) as (Ls & Fl & Fb & _).
  specialize (Fl Fit). specialize (Fb band_nonneg Fit).
  destruct (of_lines_hold tol (fun j => share_retained d law rs j S) (fun j => share_passing d law rs (upper_size d j) S)
    (fun j => target_retained rs j) (fun j => target_passing d rs (upper_size d j)) rs (passing_each tol) Fl) as (T1 & T2 & T3 & T4 & T5); trivial.
  { intros e E j J L. cbv beta. unfold near.
    rewrite (pass_all law rs S rows_proper Mp _ j J L) by lra.
    rewrite (target_all (d := d) rs rows_proper some_mass j J L). rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra. }
  apply allowed_within. split; [|split; [|split]].
  - split; [exact D|]. split; [exact Ne|].
    split; [exact T1|]. split; [exact T2|]. split; [exact T3|]. split; [exact T4|]. split; [exact T5|]. split; [|exact Fb].
    intros e Et. rewrite <- errors_are. exact (To e Et).
  - intros j J Mj. apply Floors; [exact J|]. apply Qlt_Rlt in Mj. rewrite Q2R_0 in Mj. exact Mj.
  - apply solids_are; assumption.
  - exact Le.
Qed.

End Samples.
