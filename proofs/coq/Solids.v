(* The volume of the solids as a bound on scales (Theorem 6). *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Chain ChainSound Exact Spec Openings
  Reduction RealFacts ExactSound.
Import ListNotations.
Open Scope R_scope.

Section Root.
Context {d : positive}.

(* ---- Sums over a sample, class by class ---------------------------------------------------------- *)

Lemma total_parts g js : forall x1 S,
  ascend_from d x1 js -> (forall x, In x S -> x1 < x <= top d x1 js) ->
  total (map g S) = total (map (fun j => total (map g (inside d j S))) js).
Proof.
  intros x1 S A. induction S as [|x S IH]; intro H.
  { simpl. clear A H. induction js; simpl; [reflexivity|]. rewrite <- IHjs. ring. }
  assert (total (map (fun j => total (map g (inside d j (x :: S)))) js) =
          g x + total (map (fun j => total (map g (inside d j S))) js)) as E.
  2: { rewrite E, <- IH by (intros; apply H; right; assumption). reflexivity. }
  specialize (H x (or_introl eq_refl)). clear IH. revert x1 A H.
  induction js as [|j js IH]; intros x1 A H; simpl in *; [unfold top in H; simpl in H; lra|].
  destruct A as (E & L & A). destruct (in_class_dec d j x) as [Y|N].
  - assert (map (fun j => total (map g (inside d j (x :: S)))) js = map (fun j => total (map g (inside d j S))) js) as E'.
    { apply map_ext_in. intros i I. unfold inside. simpl. destruct (in_class_dec d i x) as [Yi|]; [|reflexivity].
      pose proof (above_lower _ _ _ _ A I Yi). unfold in_class in Y. lra. }
    unfold inside in E' |- *. simpl in E' |- *. rewrite E'. simpl. ring.
  - assert (upper_size d j < x) as U
      by (unfold in_class in N; destruct (Rle_dec x (upper_size d j)); [exfalso; apply N; lra | lra]).
    specialize (IH (upper_size d j) A). unfold inside in IH |- *. simpl in IH |- *. rewrite IH; [ring|].
    split; [exact U|]. apply H.
Qed.

Lemma total_ext {A} (g h : A -> R) xs : (forall x, In x xs -> g x = h x) -> total (map g xs) = total (map h xs).
Proof. intro H. f_equal. apply map_ext_in, H. Qed.

Lemma total_scal {A} k (g : A -> R) xs : total (map (fun x => k * g x) xs) = k * total (map g xs).
Proof. induction xs as [|x xs IH]; simpl; [ring | rewrite IH; ring]. Qed.

(* The sum of x^3, by the masses of the classes. *)
Lemma cubes_by_class law rs S :
  power_law 3 1 law -> proper_rows rs -> describes d rs S ->
  total (map sphere S) = total (map (fun j => held d law j S / Q2R (c j)) (classes rs)).
Proof.
  intros (_ & P) W (_ & D). pose proof (proper_classes rs W) as Pj. 
  destruct (classes_ascend (d := d) rs W) as (As & T).
  rewrite (total_parts sphere _ _ S As) by (intros x X; rewrite T; apply D, X).
  apply total_ext. intros j J. rewrite Forall_forall in Pj. destruct (proper_sizes (d := d) j (Pj j J)) as (Lj & Uj). destruct (Pj j J) as (_ & C & _).
  unfold held. replace (Q2R (c j) * total (map law (inside d j S)) / Q2R (c j)) with (total (map law (inside d j S)))
    by (field; lra).
  apply total_ext. intros x X. apply inside_in in X as (_ & X1 & X2).
  destruct (P x ltac:(lra)) as (_ & E). rewrite pow_1 in E. rewrite E. reflexivity.
Qed.

(* The sum of x^3 in a match at scale 1. *)
Definition unit_cubes (js : list class) : R := total (map (fun j => Q2R (mass j) / Q2R (c j)) js).

Lemma volume_of_match law rs S s :
  power_law 3 1 law -> proper_rows rs -> describes_accurately_at d s law rs S ->
  solid_volume S = PI / 6 * (s * unit_cubes (classes rs)).
Proof.
  intros P W (D & H). unfold solid_volume, unit_cubes. rewrite (cubes_by_class law rs S P W D).
  rewrite <- (total_scal s). f_equal. apply total_ext. intros j J. rewrite (H j J). unfold Rdiv. ring.
Qed.

End Root.

(* ---- The demanded volume ------------------------------------------------------------------------- *)

Definition has_cubes (s : solids) (cubes : R) : Prop :=
  match s with
  | Anything => True
  | Cylinder d h e => PI / 4 * Q2R d ^ 2 * Q2R h <= PI / 6 * cubes * (1 + Q2R e)
  | Volume v _ _ => Q2R v <= PI / 6 * cubes
  end.

Definition proper_solids (s : solids) : Prop :=
  match s with
  | Anything => True
  | Cylinder d h e => 0 < Q2R d /\ 0 < Q2R h /\ 0 <= Q2R e
  | Volume v p r => 0 < Q2R v /\ 0 < Q2R p < PI /\ PI < Q2R r
  end.

Lemma below_needed s cubes :
  proper_solids s -> has_cubes s cubes ->
  match s with
  | Anything => True
  | Cylinder _ _ _ => Q2R (volume_below s) <= cubes
  | Volume _ _ _ => Q2R (volume_below s) < cubes
  end.
Proof.
  pose proof PI_RGT_0 as P. destruct s as [|d h e|v p r]; simpl; [trivial| |].
  - intros (D & H & E) V.
    rewrite Q2R_over, !Q2R_times, Q2R_add, !Q2R_integer by (rewrite Q2R_times, Q2R_add, !Q2R_integer; lra).
    apply (Rmult_le_reg_l (PI / 6 * (1 + Q2R e))); [apply Rmult_lt_0_compat; lra|].
    replace (PI / 6 * (1 + Q2R e) * (3 * (Q2R d * (Q2R d * Q2R h)) / (2 * (1 + Q2R e))))
      with (PI / 4 * Q2R d ^ 2 * Q2R h) by (field; lra). lra.
  - intros (V & (Pp & Pi) & R) H. rewrite Q2R_over, Q2R_times, Q2R_integer by lra.
    apply (Rmult_lt_reg_l (PI / 6)); [lra|]. apply Rlt_le_trans with (Q2R v); [|exact H].
    apply (Rmult_lt_reg_r (Q2R r)); [lra|].
    replace (PI / 6 * (6 * Q2R v / Q2R r) * Q2R r) with (PI * Q2R v) by (field; lra).
    rewrite (Rmult_comm (Q2R v)). apply Rmult_lt_compat_r; assumption.
Qed.

Lemma enough_suffices s cubes : proper_solids s -> Q2R (volume_enough s) <= cubes -> has_cubes s cubes.
Proof.
  pose proof PI_RGT_0 as P. destruct s as [|d h e|v p r]; simpl; [trivial| |].
  - intros (D & H & E).
    rewrite Q2R_over, !Q2R_times, Q2R_add, !Q2R_integer by (rewrite Q2R_times, Q2R_add, !Q2R_integer; lra).
    intro V. apply (Rmult_le_compat_l (PI / 6 * (1 + Q2R e))) in V; [|left; apply Rmult_lt_0_compat; lra].
    replace (PI / 6 * (1 + Q2R e) * (3 * (Q2R d * (Q2R d * Q2R h)) / (2 * (1 + Q2R e))))
      with (PI / 4 * Q2R d ^ 2 * Q2R h) in V by (field; lra). lra.
  - intros (V & (Pp & Pi) & R) H. rewrite Q2R_over, Q2R_times, Q2R_integer in H by lra.
    apply Rle_trans with (PI / 6 * (6 * Q2R v / Q2R p)); [|apply Rmult_le_compat_l; lra].
    apply (Rmult_le_reg_r (Q2R p)); [lra|].
    replace (PI / 6 * (6 * Q2R v / Q2R p) * Q2R p) with (PI * Q2R v) by (field; lra).
    rewrite (Rmult_comm (Q2R v)). apply Rmult_le_compat_r; lra.
Qed.

Lemma volume_enough_nonneg s : proper_solids s -> 0 <= Q2R (volume_enough s) /\ 0 <= Q2R (volume_below s).
Proof.
  assert (forall x y, 0 <= x -> 0 < y -> 0 <= x / y) as D.
  { intros x y X Y. apply Rmult_le_pos; [exact X | left; apply Rinv_0_lt_compat, Y]. }
  destruct s as [|d h e|v p r]; simpl; [rewrite Q2R_0; lra| |].
  - intros (Dp & H & E).
    rewrite Q2R_over, !Q2R_times, Q2R_add, !Q2R_integer by (rewrite Q2R_times, Q2R_add, !Q2R_integer; lra).
    assert (0 <= 3 * (Q2R d * (Q2R d * Q2R h)) / (2 * (1 + Q2R e))); [|lra].
    apply D; [|lra]. apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [|apply Rmult_le_pos]; lra.
  - intros (V & (Pp & Pi) & R). rewrite !Q2R_over, !Q2R_times, !Q2R_integer by lra. split; apply D; lra.
Qed.

(* ---- In the integers' unit of scales ------------------------------------------------------------- *)

Section Units.
Variable u : units.
Hypothesis x_unit : (0 < of_openings u)%Z.
Hypothesis m_unit : (0 < of_masses u)%Z.
Hypothesis c_unit : (0 < of_factors u)%Z.

Lemma integer_factor_real j : integral u j -> IZR (integer_factor u j) = Q2R (c j) * IZR (of_factors u).
Proof. intros (_ & _ & _ & D). apply in_units_real, D. Qed.

Lemma integer_factor_positive j : integral u j -> proper j -> (0 < integer_factor u j)%Z.
Proof.
  intros I (_ & C & _). apply lt_IZR. rewrite integer_factor_real by exact I.
  apply Rmult_lt_0_compat; [exact C | apply IZR_lt, c_unit].
Qed.

Lemma unit_scale_real js common :
  Forall (integral u) js -> Forall proper js -> (0 < common)%Z ->
  (forall j, In j js -> (integer_factor u j | common)%Z) ->
  IZR (solids_of_unit_scale u js common) = IZR (of_masses u) * IZR common / IZR (of_factors u) * unit_cubes js.
Proof.
  intros I P C D. pose proof (IZR_lt _ _ m_unit) as Mu. pose proof (IZR_lt _ _ c_unit) as Cu. unfold solids_of_unit_scale, unit_cubes.
  induction js as [|j js IH]; simpl; [ring|].
  inversion I as [|? ? Ij Ijs]; inversion P as [|? ? Pj Pjs]; subst.
  rewrite plus_IZR, IH by (trivial; intros; apply D; right; assumption).
  destruct (D j (or_introl eq_refl)) as (k & E).
  assert (0 < integer_factor u j)%Z as Fp by (apply integer_factor_positive; assumption).
  rewrite E, Z.div_mul by lia. rewrite !mult_IZR, in_units_real, integer_factor_real by (assumption || apply Ij).
  destruct Pj as (_ & Cp & _). field. lra.
Qed.

Lemma unit_cubes_with_mass js : unit_cubes (with_mass js) = unit_cubes js.
Proof.
  unfold unit_cubes, with_mass. induction js as [|j js IH]; simpl; [reflexivity|].
  destruct (equal (mass j) 0) eqn:E; simpl; rewrite IH; [|reflexivity].
  apply equal_real in E. rewrite E, Q2R_0. unfold Rdiv. ring.
Qed.

Lemma unit_cubes_positive js :
  Forall proper js -> (exists j, In j js /\ 0 < Q2R (mass j)) -> 0 < unit_cubes js.
Proof.
  intros P (j & J & M). unfold unit_cubes. induction P as [|i js Pi P IH]; [destruct J|].
  assert (forall i, proper i -> 0 <= Q2R (mass i) / Q2R (c i)) as N.
  { intros x (_ & C & Mx). apply Rmult_le_pos; [exact Mx | left; apply Rinv_0_lt_compat, C]. }
  assert (0 <= total (map (fun j => Q2R (mass j) / Q2R (c j)) js)) as T.
  { clear -P N. induction P; simpl; [lra|]. specialize (N _ H). lra. }
  simpl. destruct J as [->|J].
  - destruct Pi as (_ & C & _). assert (0 < Q2R (mass j) / Q2R (c j)) by (apply Rdiv_lt_0_compat; assumption). lra.
  - specialize (IH J). specialize (N i Pi). lra.
Qed.

Lemma scale_of_volume_real nb k js common volume s :
  Forall (integral u) js -> Forall proper js -> (0 < common)%Z ->
  (forall j, In j js -> (integer_factor u j | common)%Z) -> 0 < unit_cubes js -> 0 <= Q2R volume ->
  scale_of_volume u (Z.of_nat nb) k (solids_of_unit_scale u js common) common volume = Ok s ->
  bound s /\ IZR (fst s) / IZR (snd s) = (Q2R volume / unit_cubes js) ^ nb * per_scale 3 nb u.
Proof.
  intros I P C D W V H. unfold scale_of_volume in H. cbv zeta in H. passed H.
  assert (forall x y : ratio, Ok x = Ok y -> y = x) as Inj by congruence. apply Inj in H. subst s. clear Inj.
  pose proof (unit_scale_real js common I P C D) as E. set (Wi := solids_of_unit_scale u js common) in *.
  pose proof (IZR_lt _ _ x_unit) as X. pose proof (IZR_lt _ _ m_unit) as M. pose proof (IZR_lt _ _ c_unit) as Cu.
  pose proof (IZR_lt _ _ C) as Cc.
  assert (0 < IZR Wi) as Wp.
  { rewrite E. apply Rmult_lt_0_compat; [|exact W]. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; assumption. }
  assert (0 < Wi)%Z as Wz by (apply lt_IZR; exact Wp).
  set (s := fraction (Qnum volume * common) (Zpos (Qden volume) * Wi)) in *.
  assert (Q2R s = Q2R volume / unit_cubes js * (IZR (of_factors u) / IZR (of_masses u))) as Es.
  { unfold s. rewrite Q2R_fraction by lia. rewrite !mult_IZR, Q2R_num, E. pose proof (den_positive volume). field. lra. }
  pose proof (den_positive s) as Ds. cbn [fst snd]. split.
  - split; cbn [fst snd]; [|apply Z.pow_pos_nonneg; lia].
    assert (0 <= Qnum s)%Z as Sn.
    { apply le_IZR. rewrite Q2R_num, Es. apply Rmult_le_pos; [|lra].
      apply Rmult_le_pos; [apply Rmult_le_pos; [exact V | left; apply Rinv_0_lt_compat, W]|].
      left. apply Rdiv_lt_0_compat; assumption. }
    apply Z.mul_nonneg_nonneg; apply Z.pow_nonneg; lia.
  - rewrite mult_IZR. change 3%Z with (Z.of_nat 3). rewrite <- !pow_IZR.
    replace (IZR (Qnum s)) with (Q2R s * IZR (Zpos (Qden s))) by (symmetry; apply Q2R_num).
    rewrite Rpow_mult_distr, Es, Rpow_mult_distr. unfold per_scale. pose proof (pow_lt _ nb Ds). pose proof (pow_lt _ nb M).
    replace ((IZR (of_factors u) / IZR (of_masses u)) ^ nb) with (IZR (of_factors u) ^ nb / IZR (of_masses u) ^ nb)
      by (unfold Rdiv; rewrite Rpow_mult_distr, pow_inv; reflexivity).
    field. repeat split; lra.
Qed.

(* What [scales_of] demands of a scale S = s^b * per_scale. *)
Theorem scales_ok na nb js sol ss :
  (1 <= nb)%nat ->
  Forall (integral u) js -> Forall proper js -> (exists j, In j js /\ 0 < Q2R (mass j)) ->
  proper_solids sol -> (sol = Anything \/ na = 3%nat) -> scales_of u (Z.of_nat nb) js sol = Ok ss ->
  bound (start ss) /\ bound (excluded ss) /\ bound (enough ss) /\
  forall s, 0 < s ->
    (has_cubes sol (s * unit_cubes js) ->
       IZR (fst (start ss)) / IZR (snd (start ss)) <= s ^ nb * per_scale na nb u /\
       IZR (fst (excluded ss)) / IZR (snd (excluded ss)) < s ^ nb * per_scale na nb u) /\
    (IZR (fst (enough ss)) / IZR (snd (enough ss)) <= s ^ nb * per_scale na nb u ->
       has_cubes sol (s * unit_cubes js)).
Proof.
  intros B I P Mp Ps Law H.
  assert (forall s, 0 < s -> 0 < s ^ nb * per_scale na nb u) as Pos.
  { intros s Sp. apply Rmult_lt_0_compat; [apply pow_lt, Sp | apply per_scale_positive; assumption]. }
  assert (bound (0, 1)%Z) as B0 by (split; simpl; lia).
  assert (IZR 0 / IZR 1 = 0) as Z0 by field.
  destruct sol as [|d h e|v p r] eqn:Es; rewrite <- Es in *.
  { rewrite Es in *. injection H as <-. cbn [start excluded enough fst snd]. rewrite Z0.
    repeat (split; [tauto|]). intros s Sp. specialize (Pos s Sp). repeat split; simpl; trivial; lra. }
  all: destruct Law as [Law| ->]; [congruence|].
  all: rewrite Es in H; cbn [scales_of] in H; rewrite <- Es in H; passed H.
  all: rename x into common; apply include_all_ok in H0 as (Cp & _ & Cd);
    [|lia|intros w Iw; apply in_map_iff in Iw as (j & <- & J); unfold with_mass in J; apply filter_In in J as (J & _);
          apply integer_factor_positive; [rewrite Forall_forall in I | rewrite Forall_forall in P]; auto].
  all: assert (Forall (integral u) (with_mass js)) as Iw
    by (rewrite Forall_forall in *; intros j J; apply filter_In in J as (J & _); auto).
  all: assert (Forall proper (with_mass js)) as Pw
    by (rewrite Forall_forall in *; intros j J; apply filter_In in J as (J & _); auto).
  all: assert (forall j, In j (with_mass js) -> (integer_factor u j | common)%Z) as Dw
    by (intros j J; apply Cd, in_map, J).
  all: pose proof (unit_cubes_positive js P Mp) as W; rewrite <- unit_cubes_with_mass in W.
  all: destruct (volume_enough_nonneg sol Ps) as (Ve & Vb).
  all: pose proof (fun v s => scale_of_volume_real nb (size js) (with_mass js) common v s Iw Pw Cp Dw W) as Real.
  all: rewrite unit_cubes_with_mass in *.
  all: pose proof (per_scale_positive 3 nb u x_unit m_unit c_unit) as K.
  all: assert (forall v s, 0 <= v -> 0 < s ->
         ((v / unit_cubes js) ^ nb * per_scale 3 nb u <= s ^ nb * per_scale 3 nb u <-> v <= s * unit_cubes js)) as Le.
  1, 3: intros v' s Vn Sp;
    assert (0 <= v' / unit_cubes js) as Vw by (apply Rmult_le_pos; [exact Vn | left; apply Rinv_0_lt_compat, W]);
    transitivity ((v' / unit_cubes js) ^ nb <= s ^ nb);
    [split; intro Hl; [apply Rmult_le_reg_r in Hl; [exact Hl | exact K] | apply Rmult_le_compat_r; [lra | exact Hl]]|];
    rewrite <- pow_le_iff by (trivial; lra); split; intro Hl;
    [apply (Rmult_le_compat_r (unit_cubes js)) in Hl; [|lra];
     replace (v' / unit_cubes js * unit_cubes js) with v' in Hl by (field; lra); exact Hl
    |apply (Rmult_le_reg_r (unit_cubes js)); [exact W|];
     replace (v' / unit_cubes js * unit_cubes js) with v' by (field; lra); exact Hl].
  all: passed H.
  - injection H as <-; cbn [start excluded enough]. apply Real in H0 as (Be & Re); [|exact Ve].
    split; [exact Be|]. split; [exact B0|]. split; [exact Be|].
    intros s Sp. rewrite Re. cbn [fst snd]. rewrite Z0. split; [intro Hs; split; [|apply Pos, Sp] | intro Hs].
    + apply Le; trivial. pose proof (below_needed sol _ Ps Hs) as N. rewrite Es in N |- *. exact N.
    + apply enough_suffices; [exact Ps|]. apply Le; trivial.
  - passed H. injection H as <-; cbn [start excluded enough].
    apply Real in H0 as (Be & Re); [|exact Ve]. apply Real in H1 as (Bb & Rb); [|exact Vb].
    split; [exact B0|]. split; [exact Bb|]. split; [exact Be|].
    intros s Sp. rewrite Re, Rb. cbn [fst snd]. rewrite Z0. split; [intro Hs; split; [left; apply Pos, Sp|] | intro Hs].
    + pose proof (below_needed sol _ Ps Hs) as N. rewrite Es in N. rewrite <- Es in N.
      apply Rmult_lt_compat_r; [exact K|]. apply pow_lt_compat; [|exact B]. split.
      * apply Rmult_le_pos; [exact Vb | left; apply Rinv_0_lt_compat, W].
      * apply (Rmult_lt_reg_r (unit_cubes js)); [exact W|].
        replace (Q2R (volume_below sol) / unit_cubes js * unit_cubes js) with (Q2R (volume_below sol)) by (field; lra).
        exact N.
    + apply enough_suffices; [exact Ps|]. apply Le; trivial.
Qed.

End Units.
