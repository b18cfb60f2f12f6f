(* Theorem 14 (a): nothing that satisfies the conditions, with fewer particles than the bound, is at an accepted leaf.

   Masses are real numbers. The lower bound of a class is strict where it holds a particle, and only there. *)

From Coq Require Import ZArith QArith Reals Qreals List Bool String Ascii Lia Lra FMapPositive.
From Mdm Require Import Numbers NumbersFacts Certificate Leaf Spec Reduction.
Import ListNotations.
Open Scope R_scope.

(* ---- What a tree is about ------------------------------------------------------------------------ *)

(* A class of a sample: count, mass, excess p of a total, and what passes its upper opening; the sums up to this class of
   the counts and of t - f q. *)
Record state := State { q_of : Z; t_of : R; p_of : R; P_of : R; N_of : Z; D_of : R }.

Section Leaf.
Variable pr : problem.
Notation mu := (IZR (mass_unit pr)).
Notation su := (IZR (share_unit pr)).
Hypothesis mass_unit_positive : 0 < mu.
Hypothesis share_unit_positive : 0 < su.

(* The conditions of one class in a sample of mass M (certificate-format.md, section 6). *)
Record meets (M : R) (x : limits) (s : state) : Prop := {
  meets_count : (floor x <= q_of s)%Z /\ (0 <= q_of s)%Z;
  meets_lower : IZR (f x) * IZR (q_of s) <= t_of s * mu /\ ((1 <= q_of s)%Z -> IZR (f x) * IZR (q_of s) < t_of s * mu);
  meets_upper : t_of s * mu <= IZR (F x) * IZR (q_of s);
  meets_retained : IZR (retained_lo x) * M <= t_of s * su <= IZR (retained_hi x) * M;
  meets_passing : IZR (passing_lo x) * M <= P_of s * su <= IZR (passing_hi x) * M;
  meets_excess : t_of s * su - IZR (g x) * M <= p_of s * su /\ 0 <= p_of s }.

(* The sums up to each class, from those below the first one on. *)
Fixpoint sums_from (P : R) (N : Z) (D : R) (cs : list limits) (ss : list state) : Prop :=
  match cs, ss with
  | x :: cs, s :: ss =>
    P_of s = P + t_of s /\ N_of s = (N + q_of s)%Z /\ D_of s = D + (t_of s - IZR (f x) * IZR (q_of s) / mu) /\
    sums_from (P_of s) (N_of s) (D_of s) cs ss
  | _, _ => True
  end.

Definition all_mass (ss : list state) : R := Spec.total (map t_of ss).
Definition all_volume (ss : list state) : R :=
  Spec.total (map (fun '(x, s) => t_of s * IZR (per_factor x) / su) (combine (classes_of pr) ss)).

(* A solution of the problem within the tolerance; with fewer particles than the bound, where there is one. *)
Record satisfies (ss : list state) : Prop := {
  sat_classes : Forall2 (meets (all_mass ss)) (classes_of pr) ss;
  sat_sums : sums_from 0 0 0 (classes_of pr) ss;
  sat_mass : 0 < all_mass ss;
  sat_total : Spec.total (map p_of ss) * su <= IZR (half_total pr) * all_mass ss;
  sat_volume : Q2R (volume pr) <= all_volume ss;
  sat_least : (least_count pr <= sum (map q_of ss))%Z;
  sat_bound : forall B, bound pr = Some B -> (sum (map q_of ss) <= B - 1)%Z }.

(* ---- Linear forms -------------------------------------------------------------------------------- *)

Definition value_one (x : of_one) (s : state) : R :=
  IZR (on_q x) * IZR (q_of s) / mu + IZR (on_t x) * t_of s + IZR (on_P x) * P_of s + IZR (on_p x) * p_of s +
  IZR (on_N x) * IZR (N_of s) / mu + IZR (on_D x) * D_of s.

Section Point.
Variable ss : list state.
Hypothesis solves : satisfies ss.
Notation M := (all_mass ss).
Notation V := (all_volume ss).

Definition value_sum (x : of_sum) : R :=
  IZR (on_M x) * M / su + IZR (on_volume x) * (V - Q2R (volume pr)) - IZR (constant x).

Fixpoint value_from (single : PositiveMap.t of_one) (alike : of_one) (j : positive) (ss : list state) : R :=
  match ss with
  | [] => 0
  | s :: ss => value_one (of_class_j single j) s + value_one alike s + value_from single alike (Pos.succ j) ss
  end.

Definition value (x : combination) : R := value_from (single x) (alike x) 1 ss + value_sum (sums x).

Fixpoint state_at (i j : positive) (ss : list state) : option state :=
  match ss with
  | [] => None
  | s :: ss => if Pos.eqb i j then Some s else state_at i (Pos.succ j) ss
  end.

Lemma state_at_le i : forall l j s, state_at i j l = Some s -> (j <= i)%positive.
Proof.
  induction l as [|s0 l IH]; intros j s H; simpl in H; [discriminate|].
  destruct (Pos.eqb_spec i j) as [->|N]; [lia|]. apply IH in H. lia.
Qed.

Lemma value_add_one k x y s : value_one (add_one k x y) s = value_one x s + IZR k * value_one y s.
Proof. unfold value_one, add_one; simpl. rewrite !plus_IZR, !mult_IZR. field. lra. Qed.

Lemma value_add_sum k x y : value_sum (add_sum k x y) = value_sum x + IZR k * value_sum y.
Proof. unfold value_sum, add_sum; simpl. rewrite !plus_IZR, !mult_IZR. field. lra. Qed.

Lemma of_class_j_add i j v single :
  of_class_j (PositiveMap.add i v single) j = if Pos.eqb j i then v else of_class_j single j.
Proof.
  unfold of_class_j. destruct (Pos.eqb_spec j i) as [->|N].
  - rewrite PositiveMap.gss. reflexivity.
  - rewrite PositiveMap.gso by exact N. reflexivity.
Qed.

Lemma value_other i v single al : forall l j, (i < j)%positive ->
  value_from (PositiveMap.add i v single) al j l = value_from single al j l.
Proof.
  induction l as [|s l IH]; intros j L; simpl; [reflexivity|].
  rewrite of_class_j_add. destruct (Pos.eqb_spec j i); [lia|]. rewrite IH by lia. reflexivity.
Qed.

Lemma value_one_class i k x single al : forall l j s,
  state_at i j l = Some s ->
  value_from (add_at i k x single) al j l =
  value_from single al j l + IZR k * value_one x s.
Proof.
  unfold add_at.
  induction l as [|s0 l IH]; intros j s H; simpl in *; [discriminate|]. rewrite of_class_j_add, (Pos.eqb_sym j i).
  destruct (Pos.eqb_spec i j) as [->|N].
  - injection H as <-. rewrite value_add_one, value_other by lia. ring.
  - rewrite (IH _ _ H). ring.
Qed.

(* What is before the first class. *)
Definition start : state := State 0 0 0 0 0 0.
Definition state_before (i : positive) : option state :=
  if (i =? 1)%positive then Some start else state_at (Pos.pred i) 1 ss.

Lemma value_between i j k x single al s0 s :
  on_q x = 0%Z -> on_t x = 0%Z -> on_P x = 0%Z -> on_p x = 0%Z ->
  state_before i = Some s0 -> state_at j 1 ss = Some s ->
  value_from (add_between i j k x single) al 1 ss =
  value_from single al 1 ss + IZR k * (value_one x s - value_one x s0).
Proof.
  intros Oq Ot OP Op B At. unfold add_between, state_before in *. destruct (i =? 1)%positive.
  - injection B as <-. rewrite (value_one_class _ _ _ _ _ _ _ _ At).
    assert (value_one x start = 0) as ->; [|ring]. unfold value_one, start. cbn. field. lra.
  - rewrite (value_one_class _ _ _ _ _ _ _ _ B), (value_one_class _ _ _ _ _ _ _ _ At), opp_IZR. ring.
Qed.

Lemma value_all_classes k x single al : forall l j,
  value_from single (add_one k al x) j l = value_from single al j l + IZR k * Spec.total (map (value_one x) l).
Proof.
  induction l as [|s l IH]; intros j; simpl; [ring|]. rewrite value_add_one, IH. ring.
Qed.

(* ---- Conditions hold ----------------------------------------------------------------------------- *)

(* The bounds in force are true of the counts. *)
Definition forced (e : force) : Prop :=
  forall i j s0 s, state_before i = Some s0 -> state_at j 1 ss = Some s ->
    (forall v, of_range i j (at_least_v e) = Some v -> (v <= N_of s - N_of s0)%Z) /\
    (forall v, of_range i j (at_most_v e) = Some v -> (N_of s - N_of s0 <= v)%Z).

(* Sums of consecutive classes: none is negative, and t > f q where there are particles. *)
Lemma sums_rise cs l : Forall2 (meets M) cs l -> forall i P N D j s,
  sums_from P N D cs l -> state_at j i l = Some s -> (N <= N_of s)%Z /\ D <= D_of s /\ ((N < N_of s)%Z -> D < D_of s).
Proof.
  induction 1 as [|x s0 cs l Me _ IH]; intros i P N D j s H At; [discriminate|].
  destruct H as (_ & EN & ED & H). cbn [state_at] in At. destruct (meets_count _ _ _ Me) as (_ & Q).
  destruct (meets_lower _ _ _ Me) as (L & Ls).
  assert (D_of s0 = D + (t_of s0 * mu - IZR (f x) * IZR (q_of s0)) / mu) as ED' by (rewrite ED; field; lra).
  assert (forall v, 0 <= v -> 0 <= v / mu) as Le.
  { intros v V. apply Rmult_le_pos; [exact V | left; apply Rinv_0_lt_compat; assumption]. }
  pose proof (Le (t_of s0 * mu - IZR (f x) * IZR (q_of s0)) ltac:(lra)) as D0.
  assert ((1 <= q_of s0)%Z -> D < D_of s0) as Ds.
  { intro Q1. specialize (Ls Q1). rewrite ED'.
    pose proof (Rdiv_lt_0_compat (t_of s0 * mu - IZR (f x) * IZR (q_of s0)) mu ltac:(lra) ltac:(lra)). lra. }
  destruct (j =? i)%positive.
  - injection At as <-. split; [lia|]. split; [lra|]. intro Lt. apply Ds. lia.
  - destruct (IH _ _ _ _ _ _ H At) as (A & B & C). split; [lia|]. split; [lra|]. intro Lt.
    destruct (Z.eq_dec (q_of s0) 0) as [E|E]; [specialize (C ltac:(lia)); lra | specialize (Ds ltac:(lia)); lra].
Qed.

Lemma sums_rise_between cs l : Forall2 (meets M) cs l -> forall first P N D i j s0 s,
  sums_from P N D cs l -> (i < j)%positive -> state_at i first l = Some s0 -> state_at j first l = Some s ->
  (N_of s0 <= N_of s)%Z /\ D_of s0 <= D_of s /\ ((N_of s0 < N_of s)%Z -> D_of s0 < D_of s).
Proof.
  induction 1 as [|x s1 cs l _ Fo IH]; intros first P N D i j s0 s H L A0 At; [discriminate|].
  destruct H as (_ & _ & _ & H). cbn [state_at] in A0, At.
  destruct (Pos.eqb_spec i first) as [->|Ni].
  - injection A0 as <-. destruct (Pos.eqb_spec j first) as [->|Nj]; [lia|].
    exact (sums_rise cs l Fo _ _ _ _ _ _ H At).
  - destruct (Pos.eqb_spec j first) as [->|Nj]; [apply state_at_le in A0; lia|].
    exact (IH _ _ _ _ _ _ _ _ H L A0 At).
Qed.

(* Of the classes i to j of the sample. *)
Lemma sums_between i j s : (i <= j)%positive -> state_at j 1 ss = Some s ->
  exists s0, state_before i = Some s0 /\
    (i = j -> N_of s = (N_of s0 + q_of s)%Z) /\ (N_of s0 <= N_of s)%Z /\ D_of s0 <= D_of s /\ ((1 <= N_of s - N_of s0)%Z -> D_of s0 < D_of s).
Proof.
  destruct solves as [Me Su _ _ _ _ _].
  assert (forall cs l first P N D j s, Forall2 (meets M) cs l -> sums_from P N D cs l -> state_at j first l = Some s ->
    j = first \/ exists s0, state_at (Pos.pred j) first l = Some s0 /\ N_of s = (N_of s0 + q_of s)%Z) as Before.
  { clear. induction cs as [|x cs IH]; intros l first P N D j s F H At; inversion F as [|? s1 ? l' _ F']; subst; [discriminate|].
    cbn [state_at] in *. destruct (Pos.eqb_spec j first) as [->|Nj]; [left; reflexivity|]. right.
    destruct H as (_ & _ & _ & H). pose proof (state_at_le _ _ _ _ At) as Le.
    destruct (Pos.eqb_spec (Pos.pred j) first) as [E|Np].
    - exists s1. split; [reflexivity|]. destruct cs as [|x2 cs], l' as [|s2 l']; try discriminate; inversion F'; subst.
      cbn [state_at] in At. destruct (Pos.eqb_spec j (Pos.succ (Pos.pred j))) as [_|N2]; [|lia]. injection At as <-.
      exact (proj1 (proj2 H)).
    - destruct (IH _ _ _ _ _ _ _ F' H At) as [->|(s0 & A0 & E)]; [lia|]. exists s0. split; [exact A0 | exact E]. }
  intros L At. unfold state_before. destruct (Pos.eqb_spec i 1) as [->|Ni].
  - exists start. split; [reflexivity|]. destruct (sums_rise _ _ Me _ _ _ _ _ _ Su At) as (A & B & C). cbn [start N_of D_of].
    split; [|split; [exact A | split; [exact B | intro; apply C; lia]]]. intros <-.
    destruct (classes_of pr) as [|x cs], ss as [|s1 l]; try discriminate; inversion Me; subst.
    cbn [state_at] in At. injection At as <-. exact (proj1 (proj2 Su)).
  - assert (exists s0, state_at (Pos.pred i) 1 ss = Some s0) as (s0 & A0).
    { clear -L At Ni. assert (forall l first i j s, (first <= i)%positive -> (i <= j)%positive -> state_at j first l = Some s ->
        exists s0, state_at i first l = Some s0) as H.
      { induction l as [|s1 l IH]; intros first i0 j0 s2 Lf Lj A; [discriminate|]. cbn [state_at] in *.
        destruct (Pos.eqb_spec i0 first); [eauto|]. destruct (Pos.eqb_spec j0 first); [lia|].
        apply (IH _ i0 j0 s2); trivial; lia. }
      apply (H ss 1%positive _ j s); trivial; lia. }
    exists s0. split; [exact A0|]. split.
    + intros ->. destruct (Before _ _ _ _ _ _ _ _ Me Su At) as [->|(s0' & A0' & E)]; [congruence|].
      rewrite A0 in A0'. injection A0' as <-. exact E.
    + destruct (sums_rise_between _ _ Me _ _ _ _ (Pos.pred i) j s0 s Su ltac:(lia) A0 At) as (A & B & C).
      split; [exact A | split; [exact B | intro; apply C; lia]].
Qed.

(* The bounds in force on one class are true of its count. *)
Lemma forced_class e j s : forced e -> state_at j 1 ss = Some s ->
  (forall v, of_range j j (at_least_v e) = Some v -> (v <= q_of s)%Z) /\
  (forall v, of_range j j (at_most_v e) = Some v -> (q_of s <= v)%Z).
Proof.
  intros Fo At. destruct (sums_between j j s (Pos.le_refl j) At) as (s0 & B & E & _). specialize (E eq_refl).
  destruct (Fo j j s0 s B At) as (L & U). split; intros v V; [specialize (L v V) | specialize (U v V)]; lia.
Qed.

Definition holds (strictly : bool) (v : R) : Prop := 0 <= v /\ (strictly = true -> 0 < v).

Lemma least_true e j x s : forced e -> state_at j 1 ss = Some s -> meets M x s -> (least_of e j x <= q_of s)%Z.
Proof.
  intros Fo At Me. destruct (meets_count _ _ _ Me) as (Rs & _). destruct (forced_class e j s Fo At) as (L & _).
  unfold least_of. destruct (of_range j j (at_least_v e)) as [v|]; [specialize (L v eq_refl); lia | exact Rs].
Qed.

Lemma scaled_nonneg k v : 0 < k -> 0 <= v * k -> 0 <= v.
Proof. intros K H. apply (Rmult_le_reg_r k); [exact K|]. lra. Qed.
Lemma scaled_positive k v : 0 < k -> 0 < v * k -> 0 < v.
Proof. intros K H. apply (Rmult_lt_reg_r k); [exact K|]. lra. Qed.

(* Shows 0 <= e or 0 < e for an e that is v. *)
Ltac is v :=
  cbn [on_q on_t on_P on_p on_N on_D on_M on_volume constant strict none closed]; rewrite ?opp_IZR, ?minus_IZR;
  match goal with
  | |- _ <= ?e => replace e with v by (field; lra)
  | |- _ < ?e => replace e with v by (field; lra)
  end.
Ltac plain := split; [|cbn [strict closed]; discriminate].

Lemma condition_holds e j x ch one all s :
  forced e -> state_at j 1 ss = Some s -> meets M x s -> condition_on pr e j x ch = Some (one, all) ->
  holds (strict all) (value_one one s + value_sum all).
Proof.
  intros Fo At Me H. pose proof (least_true e j x s Fo At Me) as Le. destruct (forced_class e j s Fo At) as (_ & Mo).
  destruct Me as [_ (L1 & L2) U (R1 & R2) (P1 & P2) (E1 & E2)].
  unfold condition_on in H. unfold holds, value_one, value_sum.
  destruct (ch =? "f")%char.
  { injection H as <- <-. cbn [strict]. split.
    - apply (scaled_nonneg mu); [assumption|]. is (t_of s * mu - IZR (f x) * IZR (q_of s)). lra.
    - intro K. apply Z.leb_le in K. specialize (L2 ltac:(lia)). apply (scaled_positive mu); [assumption|].
      is (t_of s * mu - IZR (f x) * IZR (q_of s)). lra. }
  destruct (ch =? "F")%char.
  { injection H as <- <-. plain. apply (scaled_nonneg mu); [assumption|].
    is (IZR (F x) * IZR (q_of s) - t_of s * mu). lra. }
  destruct (ch =? "q")%char.
  { injection H as <- <-. plain. apply IZR_le in Le. is (IZR (q_of s) - IZR (least_of e j x)). lra. }
  destruct (ch =? "Q")%char.
  { destruct (of_range j j (at_most_v e)) as [v|]; [|discriminate]. injection H as <- <-.
    specialize (Mo v eq_refl). apply IZR_le in Mo. plain. is (IZR v - IZR (q_of s)). lra. }
  destruct (ch =? "r")%char.
  { injection H as <- <-. plain. apply (scaled_nonneg su); [assumption|].
    is (t_of s * su - IZR (retained_lo x) * M). lra. }
  destruct (ch =? "R")%char.
  { injection H as <- <-. plain. apply (scaled_nonneg su); [assumption|].
    is (IZR (retained_hi x) * M - t_of s * su). lra. }
  destruct (ch =? "p")%char.
  { injection H as <- <-. plain. apply (scaled_nonneg su); [assumption|].
    is (P_of s * su - IZR (passing_lo x) * M). lra. }
  destruct (ch =? "P")%char.
  { injection H as <- <-. plain. apply (scaled_nonneg su); [assumption|].
    is (IZR (passing_hi x) * M - P_of s * su). lra. }
  destruct (ch =? "e")%char.
  { injection H as <- <-. plain. apply (scaled_nonneg su); [assumption|].
    is (p_of s * su - (t_of s * su - IZR (g x) * M)). lra. }
  destruct (ch =? "x")%char; [|discriminate].
  injection H as <- <-. plain. is (p_of s). exact E2.
Qed.

Lemma between_holds e i j ch one all s :
  forced e -> (i < j)%positive -> state_at j 1 ss = Some s -> condition_between pr e i j ch = Some (one, all) ->
  exists s0, state_before i = Some s0 /\
    (on_q one = 0 /\ on_t one = 0 /\ on_P one = 0 /\ on_p one = 0)%Z /\
    holds (strict all) (value_one one s - value_one one s0 + value_sum all).
Proof.
  intros Fo L At H. destruct (sums_between i j s ltac:(lia) At) as (s0 & B & _ & Rise & Le & Lt).
  destruct (Fo i j s0 s B At) as (Lo & Up). exists s0. split; [exact B|].
  unfold condition_between in H. unfold holds, value_one, value_sum.
  destruct (ch =? "s")%char.
  { injection H as <- <-. split; [repeat split|]. plain.
    assert (least_between e i j <= N_of s - N_of s0)%Z as Least.
    { unfold least_between. destruct (of_range i j (at_least_v e)) as [v|]; [exact (Lo v eq_refl) | lia]. }
    apply IZR_le in Least. rewrite minus_IZR in Least.
    is (IZR (N_of s) - IZR (N_of s0) - IZR (least_between e i j)). lra. }
  destruct (ch =? "S")%char.
  { destruct (of_range i j (at_most_v e)) as [v|]; [|discriminate]. injection H as <- <-. split; [repeat split|].
    specialize (Up v eq_refl). apply IZR_le in Up. rewrite minus_IZR in Up. plain.
    is (IZR v - (IZR (N_of s) - IZR (N_of s0))). lra. }
  destruct (ch =? "d")%char; [|discriminate].
  injection H as <- <-. split; [repeat split|]. cbn [strict]. split; [is (D_of s - D_of s0); lra|].
  intro K. apply Z.leb_le in K. is (D_of s - D_of s0). apply Rlt_Rminus, Lt. unfold least_between in K.
  destruct (of_range i j (at_least_v e)) as [v|]; [specialize (Lo v eq_refl)|]; lia.
Qed.

Lemma total_lin l x :
  Spec.total (map (value_one x) l) =
  IZR (on_q x) * IZR (sum (map q_of l)) / mu + IZR (on_t x) * Spec.total (map t_of l) +
  IZR (on_P x) * Spec.total (map P_of l) + IZR (on_p x) * Spec.total (map p_of l) +
  IZR (on_N x) * IZR (sum (map N_of l)) / mu + IZR (on_D x) * Spec.total (map D_of l).
Proof.
  induction l as [|s l IH]; simpl; [field; lra|]. rewrite IH, !plus_IZR. unfold value_one. field. lra.
Qed.

Lemma condition_on_all_holds ch one all :
  condition_on_all pr ch = Some (one, all) -> holds (strict all) (Spec.total (map (value_one one) ss) + value_sum all).
Proof.
  intro H. destruct solves as [_ _ Mp To Vo Le Cl]. rewrite total_lin. unfold condition_on_all in H.
  unfold holds, value_sum. fold (all_mass ss).
  destruct (ch =? "m")%char.
  { injection H as <- <-. split; [|intros _]; is (all_mass ss); lra. }
  destruct (ch =? "E")%char.
  { injection H as <- <-. plain. apply (scaled_nonneg su); [assumption|].
    is (IZR (half_total pr) * M - Spec.total (map p_of ss) * su). lra. }
  destruct (ch =? "w")%char.
  { injection H as <- <-. plain. is (V - Q2R (volume pr)). lra. }
  destruct (ch =? "n")%char.
  { injection H as <- <-. plain. apply IZR_le in Le. is (IZR (sum (map q_of ss)) - IZR (least_count pr)). lra. }
  destruct (ch =? "N")%char; [|discriminate].
  destruct (bound pr) as [B|]; [|discriminate]. specialize (Cl B eq_refl). apply IZR_le in Cl.
  rewrite minus_IZR in Cl. cbn [option_map] in H. remember (1 - B)%Z as k eqn:Ek. injection H as <- <-. subst k. plain.
  is (IZR B - 1 - IZR (sum (map q_of ss))). lra.
Qed.

(* ---- A leaf is a contradiction ------------------------------------------------------------------- *)

Lemma table_state (ok : limits -> state -> Prop) cs l : Forall2 ok cs l -> forall j0 t j x,
  PositiveMap.find j (number_from j0 cs t) = Some x ->
  (exists s, state_at j j0 l = Some s /\ ok x s) \/ PositiveMap.find j t = Some x.
Proof.
  induction 1 as [|x0 s0 cs l O _ IH]; intros j0 t j x H; simpl in *; [right; exact H|].
  apply IH in H as [(s & At & Os)|H].
  - left. pose proof (state_at_le _ _ _ _ At). destruct (Pos.eqb_spec j j0); [lia|]. eauto.
  - destruct (Pos.eqb_spec j j0) as [->|N].
    + rewrite PositiveMap.gss in H. injection H as <-. eauto.
    + rewrite PositiveMap.gso in H by exact N. right; exact H.
Qed.

Notation t := (number_from 1 (classes_of pr) (PositiveMap.empty limits)).

Definition fine (x : combination) : Prop := holds (strict (sums x)) (value x).

Lemma holds_add s1 s2 v1 v2 k :
  (0 < k)%Z -> holds s1 v1 -> holds s2 v2 -> holds (s1 || s2) (v1 + IZR k * v2).
Proof.
  intros K (A1 & A2) (B1 & B2). apply IZR_lt in K.
  pose proof (Rmult_le_pos (IZR k) v2 ltac:(lra) B1). split; [lra|].
  intro S. apply orb_prop in S as [S|S]; [specialize (A2 S); lra|].
  specialize (B2 S). pose proof (Rmult_lt_0_compat _ _ K B2). lra.
Qed.

Lemma add_multiple_fine e x k y : forced e -> fine x -> add_multiple pr t e x k = Some y -> fine y.
Proof.
  intros Fo Fx H. unfold add_multiple in H. destruct (Z.leb_spec (times_m k) 0) as [|K]; [discriminate|].
  unfold fine, value in *.
  assert (match condition_on_all pr (letter k) with
          | Some (one, all) =>
            Some (Combination (single x) (add_one (times_m k) (alike x) one) (add_sum (times_m k) (sums x) all))
          | None => None
          end = Some y -> holds (strict (sums y)) (value_from (single y) (alike y) 1 ss + value_sum (sums y))) as All.
  { intro H'. destruct (condition_on_all pr (letter k)) as [(one, all)|] eqn:C; [|discriminate].
    injection H' as <-. cbn [single alike sums]. rewrite value_all_classes, value_add_sum.
    pose proof (condition_on_all_holds _ _ _ C) as Ho.
    pose proof (holds_add _ _ _ _ (times_m k) K Fx Ho) as R. cbn [strict add_sum].
    match goal with |- holds _ ?v => replace v with
      (value_from (single x) (alike x) 1 ss + value_sum (sums x) +
       IZR (times_m k) * (Spec.total (map (value_one one) ss) + value_sum all)) by ring end. exact R. }
  destruct (of_class k) as [|i|i]; [exact (All H)| |exact (All H)].
  destruct (up_to k) as [|j|j]; [exact (All H)| |exact (All H)].
  destruct (PositiveMap.find j t) as [cj|] eqn:E; [|discriminate].
  destruct (table_state _ _ _ (sat_classes _ solves) _ _ _ _ E) as [(s & At & Me)|E'];
    [|rewrite PositiveMap.gempty in E'; discriminate].
  destruct (Pos.ltb_spec j i) as [|Le]; [discriminate|].
  destruct (Pos.eqb_spec i j) as [->|Ne].
  - destruct (condition_on pr e j cj (letter k)) as [(one, all)|] eqn:C; [|discriminate].
    injection H as <-. cbn [single alike sums]. rewrite (value_one_class _ _ _ _ _ _ _ _ At), value_add_sum.
    pose proof (condition_holds _ _ _ _ _ _ _ Fo At Me C) as Ho.
    pose proof (holds_add _ _ _ _ (times_m k) K Fx Ho) as R. cbn [strict add_sum].
    match goal with |- holds _ ?v => replace v with
      (value_from (single x) (alike x) 1 ss + value_sum (sums x) +
       IZR (times_m k) * (value_one one s + value_sum all)) by ring end. exact R.
  - destruct (condition_between pr e i j (letter k)) as [(one, all)|] eqn:C; [|discriminate].
    injection H as <-. cbn [single alike sums].
    assert (i < j)%positive as Lt by lia.
    destruct (between_holds _ _ _ _ _ _ _ Fo Lt At C) as (s0 & B & (Oq & Ot & OP & Op) & Ho).
    rewrite (value_between _ _ _ _ _ _ s0 s Oq Ot OP Op B At), value_add_sum.
    pose proof (holds_add _ _ _ _ (times_m k) K Fx Ho) as R. cbn [strict add_sum].
    match goal with |- holds _ ?v => replace v with
      (value_from (single x) (alike x) 1 ss + value_sum (sums x) +
       IZR (times_m k) * (value_one one s - value_one one s0 + value_sum all)) by ring end. exact R.
Qed.

Lemma empty_fine : fine empty.
Proof.
  unfold fine, value, empty, value_sum. cbn [single alike sums closed strict on_M on_volume constant].
  assert (forall l j, value_from (PositiveMap.empty of_one) none j l = 0) as Z.
  { induction l as [|s l IH]; intro j; simpl; [reflexivity|]. rewrite IH. unfold of_class_j.
    rewrite PositiveMap.gempty. unfold value_one, none; simpl. field. lra. }
  rewrite Z. split; [|discriminate]. right. field. lra.
Qed.

Lemma add_up_fine e ks : forall x y, forced e -> fine x -> add_up pr t e ks x = Some y -> fine y.
Proof.
  induction ks as [|k ks IH]; intros x y Fo Fx H; simpl in H; [injection H as <-; exact Fx|].
  destruct (add_multiple pr t e x k) as [z|] eqn:E; [|discriminate].
  eapply IH; [exact Fo | eapply add_multiple_fine; eassumption | exact H].
Qed.

(* Where variables cancel, only the right sides are left. *)
Lemma cancels_value x cs l (ok : limits -> state -> Prop) : Forall2 ok cs l -> forall j P N D h,
  sums_from P N D cs l -> cancels pr x j cs = Some h ->
  value_from (single x) (alike x) j l =
  IZR (of_P h) * P + IZR (of_N h) * IZR N / mu + IZR (of_D h) * D - IZR (on_M (sums x)) * Spec.total (map t_of l) / su
  - IZR (on_volume (sums x)) * Spec.total (map (fun '(c, s) => t_of s * IZR (per_factor c) / su) (combine cs l)).
Proof.
  induction 1 as [|c s cs l O _ IH]; intros j P N D h Su H; cbn [cancels] in H.
  { injection H as <-. simpl. field. lra. }
  destruct (cancels pr x (Pos.succ j) cs) as [h'|] eqn:E; [|discriminate].
  destruct Su as (Ps & Ns & Ds & Su). unfold check in H.
  set (one := of_class_j (single x) j) in *. set (all := alike x) in *.
  set (here := carry all (carry one h')) in *. cbv zeta in H.
  match type of H with (if ?b then _ else _) = _ => destruct b eqn:B; [|discriminate] end.
  injection H as <-. rewrite !andb_true_iff, !Z.eqb_eq in B. destruct B as ((Bq & Bt) & Bp).
  cbn [value_from combine map Spec.total fold_right]. fold (Spec.total (map t_of l)).
  rewrite (IH _ _ _ _ _ Su E). fold one. fold all. unfold value_one.
  assert (of_P here = of_P h' + on_P one + on_P all /\ of_N here = of_N h' + on_N one + on_N all /\
          of_D here = of_D h' + on_D one + on_D all)%Z as (EP & EN & ED) by (repeat split).
  rewrite EP, EN, ED in *. clear EP EN ED here.
  apply (f_equal IZR) in Bq, Bt, Bp. rewrite ?minus_IZR, ?plus_IZR, ?mult_IZR, ?minus_IZR, ?plus_IZR in *.
  change (fold_right Rplus 0 (map t_of l)) with (Spec.total (map t_of l)).
  change (fold_right Rplus 0 (map (fun '(c, s) => t_of s * IZR (per_factor c) / su) (combine cs l)))
    with (Spec.total (map (fun '(c, s) => t_of s * IZR (per_factor c) / su) (combine cs l))).
  rewrite Ps, Ds, Ns, ?plus_IZR.
  set (n := IZR (of_N h') + IZR (on_N one) + IZR (on_N all)) in *.
  set (e := IZR (of_D h') + IZR (on_D one) + IZR (on_D all)) in *.
  replace (IZR (on_q one)) with (- IZR (on_q all) - n + e * IZR (f c)) by lra.
  replace (IZR (on_p one)) with (- IZR (on_p all)) by lra.
  replace (IZR (on_t one)) with (- IZR (on_t all) - (IZR (of_P h') + IZR (on_P one) + IZR (on_P all)) - e
     - (IZR (on_M (sums x)) + IZR (on_volume (sums x)) * IZR (per_factor c)) / su).
  - subst n e. field. lra.
  - apply (Rmult_eq_reg_r su); [|lra]. field_simplify; [|lra]. lra.
Qed.

Lemma cancels_everywhere x held : cancels pr x 1 (classes_of pr) = Some held ->
  value_from (single x) (alike x) 1 ss = - IZR (on_M (sums x)) * M / su - IZR (on_volume (sums x)) * V.
Proof.
  intro Ca. rewrite (cancels_value x _ _ _ (sat_classes _ solves) _ _ _ _ _ (sat_sums _ solves) Ca).
  fold (all_mass ss). fold (all_volume ss). field. lra.
Qed.

Lemma says_nothing_value x s : says_nothing x = true -> value_one x s = 0.
Proof.
  unfold says_nothing. rewrite !andb_true_iff, !Z.eqb_eq. intros (((((E1 & E2) & E3) & E4) & E5) & E6).
  unfold value_one. rewrite E1, E2, E3, E4, E5, E6. field. lra.
Qed.

Lemma cancels_named x : cancels_where_named x = true ->
  value_from (single x) (alike x) 1 ss = - IZR (on_M (sums x)) * M / su - IZR (on_volume (sums x)) * V.
Proof.
  unfold cancels_where_named. rewrite !andb_true_iff, !Z.eqb_eq, forallb_forall. intros (((Al & Em) & Ev) & Si).
  rewrite Em, Ev. assert (forall l j, value_from (single x) (alike x) j l = 0) as ->; [|field; lra].
  induction l as [|s l IH]; intro j; cbn [value_from]; [reflexivity|].
  rewrite (says_nothing_value _ s Al), IH. unfold of_class_j. destruct (PositiveMap.find j (single x)) as [one|] eqn:E.
  - rewrite says_nothing_value; [ring|]. apply PositiveMap.elements_correct in E. exact (Si _ E).
  - rewrite says_nothing_value by reflexivity. ring.
Qed.

Lemma contradiction_value x :
  value_from (single x) (alike x) 1 ss = - IZR (on_M (sums x)) * M / su - IZR (on_volume (sums x)) * V ->
  contradiction pr (sums x) = true -> ~ fine x.
Proof.
  intros Ca Co (F1 & F2). unfold value in *. rewrite Ca in *. unfold value_sum in *.
  assert (- IZR (on_M (sums x)) * M / su - IZR (on_volume (sums x)) * V +
          (IZR (on_M (sums x)) * M / su + IZR (on_volume (sums x)) * (V - Q2R (volume pr)) - IZR (constant (sums x))) =
          - (IZR (constant (sums x)) + IZR (on_volume (sums x)) * Q2R (volume pr))) as E by (field; lra).
  rewrite E in *. clear E. unfold contradiction in Co.
  pose proof (IZR_lt 0 (Zpos (Qden (volume pr))) ltac:(reflexivity)) as D.
  assert (IZR (constant (sums x) * Zpos (Qden (volume pr)) + on_volume (sums x) * Qnum (volume pr)) =
          (IZR (constant (sums x)) + IZR (on_volume (sums x)) * Q2R (volume pr)) * IZR (Zpos (Qden (volume pr)))) as K.
  { rewrite plus_IZR, !mult_IZR. unfold Q2R. field. lra. }
  apply orb_prop in Co as [Co|Co].
  - apply Z.ltb_lt, IZR_lt in Co. rewrite K in Co. apply scaled_positive in Co; [|exact D]. lra.
  - apply andb_prop in Co as (Z & S). specialize (F2 S). apply Z.eqb_eq in Z. rewrite Z in K.
    assert (IZR (constant (sums x)) + IZR (on_volume (sums x)) * Q2R (volume pr) = 0) as W.
    { apply (Rmult_eq_reg_r (IZR (Zpos (Qden (volume pr))))); lra. }
    lra.
Qed.

Lemma leaf_sound e ks : refutes pr t e ks = true -> ~ forced e.
Proof.
  unfold refutes. destruct (add_up pr t e ks empty) as [x|] eqn:A; [|discriminate].
  intros Co Fo. assert (fine x) as Fx by (eapply add_up_fine; [exact Fo | apply empty_fine | exact A]). revert Fx.
  destruct (cancels_where_named x) eqn:N; [exact (contradiction_value x (cancels_named x N) Co)|].
  destruct (cancels pr x 1 (classes_of pr)) as [held|] eqn:Ca; [|discriminate].
  exact (contradiction_value x (cancels_everywhere x held Ca) Co).
Qed.

End Point.

End Leaf.
