(* An accepted certificate of an exact match proves its claim: samples to integers and back (Theorems 1, 5-7). *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Chain ChainSound Exact Spec Openings
  Reduction RealFacts.
Import ListNotations.
Open Scope R_scope.

Local Arguments Chain.above : simpl never.

(* ---- Real scales and rational ones --------------------------------------------------------------- *)

(* q particles of class j at the scale S, to the power b. *)
Definition holds_real (b : Z) (S : R) (j : bounds) (q : Z) : Prop :=
  (m j = 0%Z /\ q = 0%Z) \/
  ((0 < m j)%Z /\ (r j <= q)%Z /\ IZR (q ^ b * f j) < S * IZR (m j) <= IZR (q ^ b * F j)).

(* The greatest scale of the counts q, min q^b F/m, is rational. *)
Lemma greatest_scale b S js qs :
  0 < S -> Forall2 (holds_real b S) js qs ->
  exists n d, (0 < n)%Z /\ (0 < d)%Z /\ S * IZR d <= IZR n /\
    Forall2 (fun j q => 0 < m j -> n * m j <= q ^ b * F j * d)%Z js qs.
Proof.
  intros P H. induction H as [|j q js qs H _ (n & d & N & D & U & A)].
  { exists (up S), 1%Z. destruct (archimed S) as (L & _). repeat split; try lia; [|lra|constructor].
    apply lt_IZR. lra. }
  destruct H as [(M & _)|(M & _ & Lo & Hi)].
  { exists n, d. repeat split; trivial. constructor; [lia | exact A]. }
  destruct (Z_le_gt_dec (n * m j) (q ^ b * F j * d)) as [C|C].
  { exists n, d. repeat split; trivial. constructor; [intros _; exact C | exact A]. }
  exists (q ^ b * F j)%Z, (m j). split; [|split; [exact M|split; [exact Hi|]]].
  - apply lt_IZR. apply IZR_lt in M. pose proof (Rmult_lt_0_compat _ _ P M). lra.
  - constructor; [lia|]. clear -A C M D. induction A as [|x y js' qs' X _ IH]; constructor; [|exact IH].
    intro Mx. specialize (X Mx). apply (Z.mul_le_mono_pos_r _ _ d); [exact D|].
    assert (q ^ b * F j * d * m x <= n * m j * m x)%Z by (apply Z.mul_le_mono_nonneg_r; lia).
    assert (n * m x * m j <= y ^ b * F x * d * m j)%Z by (apply Z.mul_le_mono_nonneg_r; lia). lia.
Qed.

Lemma rational_scale b S js qs :
  0 < S -> Forall2 (holds_real b S) js qs ->
  exists scale, solution b js qs scale /\ S * IZR (snd scale) <= IZR (fst scale).
Proof.
  intros P H. destruct (greatest_scale b S js qs P H) as (n & d & N & D & U & A).
  exists (n, d). split; [|exact U]. repeat split; simpl; trivial.
  induction H as [|j q js qs H _ IH]; inversion A; subst; constructor; auto. clear IH.
  destruct H as [H|(M & R & Lo & Hi)]; [left; exact H | right]. repeat split; trivial; [|auto].
  apply lt_IZR. rewrite !mult_IZR in *. apply IZR_lt in D, M.
  apply (Rmult_lt_compat_r (IZR d)) in Lo; [|exact D].
  apply (Rmult_le_compat_r (IZR (m j))) in U; [|lra]. lra.
Qed.

Lemma real_scale b n d j q : (0 < d)%Z -> holds b (n, d) j q -> holds_real b (IZR n / IZR d) j q.
Proof.
  intros D [H|(M & R & Lo & Hi)]; [left; exact H | right]. repeat split; trivial; apply IZR_lt in D.
  - apply IZR_lt in Lo. rewrite !mult_IZR in *. apply (Rmult_lt_reg_r (IZR d)); [exact D|].
    replace (IZR n / IZR d * IZR (m j) * IZR d) with (IZR n * IZR (m j)) by (field; lra). exact Lo.
  - apply IZR_le in Hi. rewrite !mult_IZR in *. apply (Rmult_le_reg_r (IZR d)); [exact D|].
    replace (IZR n / IZR d * IZR (m j) * IZR d) with (IZR n * IZR (m j)) by (field; lra). exact Hi.
Qed.

(* ---- Classes in integers ------------------------------------------------------------------------- *)

(* b is the degree of the law times the root. *)
Section Units.
Context {d : positive}.
Variables (na nb : nat).

Hypothesis b_positive : (1 <= nb)%nat.
Variable law : R -> R.
Hypothesis power : opening_law d na nb law.
Variable u : units.
Hypothesis x_unit : (0 < of_openings u)%Z.
Hypothesis m_unit : (0 < of_masses u)%Z.
Hypothesis c_unit : (0 < of_factors u)%Z.

Notation a := (Z.of_nat na).
Notation b := (Z.of_nat nb).

Definition integral (j : class) : Prop :=
  (Zpos (Qden (lower j)) | of_openings u)%Z /\ (Zpos (Qden (upper j)) | of_openings u)%Z /\
  (Zpos (Qden (mass j)) | of_masses u)%Z /\ (Zpos (Qden (c j)) | of_factors u)%Z.

(* The integers' scale is that of Spec.v to the power b, times this. *)
Definition per_scale : R := IZR (of_factors u) ^ nb * IZR (of_openings u) ^ na / IZR (of_masses u) ^ nb.

Lemma unit_powers :
  0 < IZR (of_factors u) ^ nb * IZR (of_openings u) ^ na /\ 0 < IZR (of_masses u) ^ nb.
Proof.
  split; [apply Rmult_lt_0_compat|]; apply pow_lt, IZR_lt; assumption.
Qed.

Lemma per_scale_positive : 0 < per_scale.
Proof. destruct unit_powers. unfold per_scale. apply Rdiv_lt_0_compat; assumption. Qed.

Lemma law_of_lower j :
  0 <= Q2R (lower j) -> 0 <= law (lower_size d j) /\ law (lower_size d j) ^ nb = Q2R (lower j) ^ na.
Proof. apply power. Qed.
Lemma law_of_upper j :
  0 <= Q2R (upper j) -> 0 <= law (upper_size d j) /\ law (upper_size d j) ^ nb = Q2R (upper j) ^ na.
Proof. apply power. Qed.

Lemma integer_powers j : integral j -> proper j ->
  IZR (f (in_integers u a b j)) = (Q2R (c j) * law (lower_size d j)) ^ nb * (IZR (of_factors u) ^ nb * IZR (of_openings u) ^ na) /\
  IZR (F (in_integers u a b j)) = (Q2R (c j) * law (upper_size d j)) ^ nb * (IZR (of_factors u) ^ nb * IZR (of_openings u) ^ na) /\
  IZR (m (in_integers u a b j)) = Q2R (mass j) ^ nb * IZR (of_masses u) ^ nb.
Proof.
  intros (Dl & Du & Dm & Dc) ((L & U) & C & M). simpl.
  rewrite !mult_IZR, <- !pow_IZR, !in_units_real by assumption. rewrite !Rpow_mult_distr.
  destruct (law_of_lower j L) as (_ & ->). destruct (law_of_upper j ltac:(lra)) as (_ & ->).
  repeat split; ring.
Qed.

Lemma in_integers_sound j floor :
  integral j -> proper j -> (1 <= floor)%Z -> sound (set_floor (in_integers u a b j) floor).
Proof.
  intros I P H. destruct (integer_powers j I P) as (Ef & EF & Em). destruct unit_powers as (U1 & U2).
  destruct (proper_sizes (d := d) j P) as (Sl & Su). destruct P as ((L & U) & C & M). destruct power as (Law & _).
  destruct (law_of_lower j L) as (Fl & _). destruct (law_of_upper j ltac:(lra)) as (Fu & _).
  assert (law (lower_size d j) < law (upper_size d j)) as Lt by (apply Law; lra).
  unfold sound. simpl r. repeat split.
  - apply le_IZR. change (m (set_floor (in_integers u a b j) floor)) with (m (in_integers u a b j)). rewrite Em.
    apply Rmult_le_pos; [apply pow_le; exact M | lra].
  - exact H.
  - apply le_IZR. change (f (set_floor (in_integers u a b j) floor)) with (f (in_integers u a b j)). rewrite Ef.
    apply Rmult_le_pos; [apply pow_le, Rmult_le_pos; lra | lra].
  - apply lt_IZR. change (f (set_floor (in_integers u a b j) floor)) with (f (in_integers u a b j)).
    change (F (set_floor (in_integers u a b j) floor)) with (F (in_integers u a b j)). rewrite Ef, EF.
    apply Rmult_lt_compat_r; [exact U1|]. apply pow_lt_compat; [|exact b_positive]. split.
    + apply Rmult_le_pos; lra.
    + apply Rmult_lt_compat_l; assumption.
Qed.

(* The class inequalities of Theorem 1 (c). *)
Lemma class_iff j s q :
  integral j -> proper j -> 0 < s -> (1 <= q)%Z ->
  (IZR q * (Q2R (c j) * law (lower_size d j)) < s * Q2R (mass j) <-> 
   IZR (q ^ b * f (in_integers u a b j)) < s ^ nb * per_scale * IZR (m (in_integers u a b j))) /\
  (s * Q2R (mass j) <= IZR q * (Q2R (c j) * law (upper_size d j)) <-> 
   s ^ nb * per_scale * IZR (m (in_integers u a b j)) <= IZR (q ^ b * F (in_integers u a b j))).
Proof.
  intros I P Sp Q. destruct (integer_powers j I P) as (Ef & EF & Em). destruct unit_powers as (U1 & U2).
  destruct P as ((L & U) & C & M).
  destruct (law_of_lower j L) as (Fl & _). destruct (law_of_upper j ltac:(lra)) as (Fu & _).
  assert (1 <= IZR q) as Q1 by (apply (IZR_le 1); exact Q).
  rewrite !mult_IZR, Ef, EF, Em, <- pow_IZR. unfold per_scale.
  set (E := IZR (of_factors u) ^ nb * IZR (of_openings u) ^ na) in *. set (mu := IZR (of_masses u) ^ nb) in *.
  replace (s ^ nb * (E / mu) * (Q2R (mass j) ^ nb * mu)) with ((s * Q2R (mass j)) ^ nb * E)
    by (rewrite Rpow_mult_distr; field; lra).
  assert (forall y, 0 <= y -> 0 <= IZR q * (Q2R (c j) * y)) as K by (intros; apply Rmult_le_pos; [|apply Rmult_le_pos]; lra).
  assert (forall y, IZR q ^ nb * ((Q2R (c j) * y) ^ nb * E) = (IZR q * (Q2R (c j) * y)) ^ nb * E) as D
    by (intro; rewrite !Rpow_mult_distr; ring).
  rewrite !D. assert (0 <= s * Q2R (mass j)) as Sm by (apply Rmult_le_pos; lra).
  split.
  - rewrite (pow_lt_iff _ _ nb (K _ Fl) Sm b_positive).
    split; intro H; [apply Rmult_lt_compat_r; assumption | apply Rmult_lt_reg_r in H; assumption].
  - rewrite (pow_le_iff _ _ nb Sm (K _ Fu) b_positive).
    split; intro H; [apply Rmult_le_compat_r; lra | apply Rmult_le_reg_r in H; assumption].
Qed.

Lemma mass_zero j : integral j -> proper j -> Q2R (mass j) = 0 <-> m (in_integers u a b j) = 0%Z.
Proof.
  intros I P. destruct (integer_powers j I P) as (_ & _ & Em). destruct unit_powers as (_ & U2).
  destruct P as (_ & _ & M). split; intro H.
  - apply eq_IZR. rewrite Em, H, pow_i by lia. ring.
  - rewrite H in Em. destruct M as [M| <-]; [|reflexivity].
    pose proof (pow_lt _ nb M) as K. pose proof (Rmult_lt_0_compat _ _ K U2). lra.
Qed.

Lemma realizes_holds j s q floor :
  integral j -> proper j -> 0 < s -> realizes d law j q (s * Q2R (mass j)) -> (0 < Q2R (mass j) -> (floor <= q)%Z) ->
  holds_real b (s ^ nb * per_scale) (set_floor (in_integers u a b j) floor) q.
Proof.
  intros I P Sp H Fl. pose proof (mass_zero j I P) as Z.
  assert (0 <= m (in_integers u a b j))%Z as Mn.
  { destruct (in_integers_sound j 1 I P) as (Mn & _); [lia | exact Mn]. }
  unfold holds_real. cbn [set_floor m r f F].
  destruct H as [(-> & E)|(Q & B)].
  - left. split; [|reflexivity]. apply Z. apply Rmult_integral in E as [E|E]; [lra | exact E].
  - right. destruct (class_iff j s q I P Sp Q) as (A1 & A2).
    assert (0 < Q2R (mass j)) as M.
    { destruct P as ((L & U) & C & [M|M]); [exact M|]. rewrite <- M, Rmult_0_r in B.
      destruct (law_of_lower j L) as (F0 & _). apply (IZR_le 1) in Q.
      assert (0 <= IZR q * (Q2R (c j) * law (lower_size d j))) by (apply Rmult_le_pos; [|apply Rmult_le_pos]; lra). lra. }
    assert (m (in_integers u a b j) <> 0)%Z by (intro E; apply Z in E; lra).
    split; [lia|]. split; [apply Fl; exact M|]. split; [apply A1, B | apply A2, B].
Qed.

Lemma holds_realizes j s q floor :
  integral j -> proper j -> 0 < s -> (1 <= floor)%Z ->
  holds_real b (s ^ nb * per_scale) (set_floor (in_integers u a b j) floor) q ->
  realizes d law j q (s * Q2R (mass j)).
Proof.
  intros I P Sp Fl H. pose proof (mass_zero j I P) as Z. unfold holds_real in H. cbn [set_floor m r f F] in H.
  destruct H as [(E & ->)|(M & Q & Lo & Hi)].
  - left. apply Z in E. rewrite E. split; [reflexivity | ring].
  - right. destruct (class_iff j s q I P Sp ltac:(lia)) as (A1 & A2).
    split; [lia|]. split; [apply A1, Lo | apply A2, Hi].
Qed.

End Units.
