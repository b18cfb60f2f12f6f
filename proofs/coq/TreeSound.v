(* Theorem 14: an accepted tree proves that nothing with fewer than N particles satisfies the conditions.

   Masses are real numbers. The lower bound of a class is strict where it holds a particle, and only there. *)

From Coq Require Import ZArith QArith Reals Qreals List Bool String Ascii Lia Lra FMapPositive.
From Mdm Require Import Numbers NumbersFacts Certificate Tree Spec Reduction.
Import ListNotations.
Open Scope R_scope.

(* ---- What a tree is about ------------------------------------------------------------------------ *)

(* A class of a sample: count, mass, excess p of a total, and what passes its upper opening. *)
Record state := State { q_of : Z; t_of : R; p_of : R; P_of : R }.

Section Tree.
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

Fixpoint passing_from (P : R) (ss : list state) : Prop :=
  match ss with
  | [] => True
  | s :: ss => P_of s = P + t_of s /\ passing_from (P_of s) ss
  end.

Definition all_mass (ss : list state) : R := Spec.total (map t_of ss).
Definition all_volume (ss : list state) : R :=
  Spec.total (map (fun '(x, s) => t_of s * IZR (per_factor x) / su) (combine (classes_of pr) ss)).

(* A solution of the problem within the tolerance; with at most N - 1 particles where N is claimed. *)
Record satisfies (ss : list state) : Prop := {
  sat_classes : Forall2 (meets (all_mass ss)) (classes_of pr) ss;
  sat_passing : passing_from 0 ss;
  sat_mass : 0 < all_mass ss;
  sat_total : Spec.total (map p_of ss) * su <= IZR (half_total pr) * all_mass ss;
  sat_volume : Q2R (volume pr) <= all_volume ss;
  sat_least : (least_count pr <= sum (map q_of ss))%Z;
  sat_claim : forall N, claim pr = Some N -> (sum (map q_of ss) <= N - 1)%Z }.

(* ---- Linear forms -------------------------------------------------------------------------------- *)

Definition value_one (x : of_one) (s : state) : R :=
  IZR (on_q x) * IZR (q_of s) / mu + IZR (on_t x) * t_of s + IZR (on_P x) * P_of s + IZR (on_p x) * p_of s.

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
  value_from (PositiveMap.add i (add_one k (of_class_j single i) x) single) al j l =
  value_from single al j l + IZR k * value_one x s.
Proof.
  induction l as [|s0 l IH]; intros j s H; simpl in *; [discriminate|]. rewrite of_class_j_add, (Pos.eqb_sym j i).
  destruct (Pos.eqb_spec i j) as [->|N].
  - injection H as <-. rewrite value_add_one, value_other by lia. ring.
  - rewrite (IH _ _ H). ring.
Qed.

Lemma value_all_classes k x single al : forall l j,
  value_from single (add_one k al x) j l = value_from single al j l + IZR k * Spec.total (map (value_one x) l).
Proof.
  induction l as [|s l IH]; intros j; simpl; [ring|]. rewrite value_add_one, IH. ring.
Qed.

(* ---- Conditions hold ----------------------------------------------------------------------------- *)

(* The bounds in force are true of the counts. *)
Definition forced (e : force) : Prop :=
  forall j s, state_at j 1 ss = Some s ->
    (forall v, PositiveMap.find j (at_least_v e) = Some v -> (v <= q_of s)%Z) /\
    (forall v, PositiveMap.find j (at_most_v e) = Some v -> (q_of s <= v)%Z).

Definition holds (strictly : bool) (v : R) : Prop := 0 <= v /\ (strictly = true -> 0 < v).

Lemma least_true e j x s : forced e -> state_at j 1 ss = Some s -> meets M x s -> (least_of e j x <= q_of s)%Z.
Proof.
  intros Fo At Me. destruct (meets_count _ _ _ Me) as (Rs & _). destruct (Fo j s At) as (L & _).
  unfold least_of. destruct (PositiveMap.find j (at_least_v e)) as [v|]; [specialize (L v eq_refl); lia | exact Rs].
Qed.

Lemma scaled_nonneg k v : 0 < k -> 0 <= v * k -> 0 <= v.
Proof. intros K H. apply (Rmult_le_reg_r k); [exact K|]. lra. Qed.
Lemma scaled_positive k v : 0 < k -> 0 < v * k -> 0 < v.
Proof. intros K H. apply (Rmult_lt_reg_r k); [exact K|]. lra. Qed.

(* Shows 0 <= e or 0 < e for an e that is v. *)
Ltac is v :=
  cbn [on_q on_t on_P on_p on_M on_volume constant strict none closed]; rewrite ?opp_IZR, ?minus_IZR;
  match goal with
  | |- _ <= ?e => replace e with v by (field; lra)
  | |- _ < ?e => replace e with v by (field; lra)
  end.
Ltac plain := split; [|cbn [strict closed]; discriminate].

Lemma condition_holds e j x ch one all s :
  forced e -> state_at j 1 ss = Some s -> meets M x s -> condition_on pr e j x ch = Some (one, all) ->
  holds (strict all) (value_one one s + value_sum all).
Proof.
  intros Fo At Me H. pose proof (least_true e j x s Fo At Me) as Le. destruct (Fo j s At) as (_ & Mo).
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
  { destruct (PositiveMap.find j (at_most_v e)) as [v|]; [|discriminate]. injection H as <- <-.
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

Lemma total_lin l x :
  Spec.total (map (value_one x) l) =
  IZR (on_q x) * IZR (sum (map q_of l)) / mu + IZR (on_t x) * Spec.total (map t_of l) +
  IZR (on_P x) * Spec.total (map P_of l) + IZR (on_p x) * Spec.total (map p_of l).
Proof.
  induction l as [|s l IH]; simpl; [field; lra|]. rewrite IH, plus_IZR. unfold value_one. field. lra.
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
  destruct (claim pr) as [N|]; [|discriminate]. specialize (Cl N eq_refl). apply IZR_le in Cl.
  rewrite minus_IZR in Cl. cbn [option_map] in H. remember (1 - N)%Z as k eqn:Ek. injection H as <- <-. subst k. plain. is (IZR N - 1 - IZR (sum (map q_of ss))). lra.
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
  destruct (of_class k) as [|j|j]; [exact (All H)| |exact (All H)].
  destruct (PositiveMap.find j t) as [cj|] eqn:E; [|discriminate].
  destruct (table_state _ _ _ (sat_classes _ solves) _ _ _ _ E) as [(s & At & Me)|E'];
    [|rewrite PositiveMap.gempty in E'; discriminate].
  destruct (condition_on pr e j cj (letter k)) as [(one, all)|] eqn:C; [|discriminate].
  injection H as <-. cbn [single alike sums]. rewrite (value_one_class _ _ _ _ _ _ _ _ At), value_add_sum.
  pose proof (condition_holds _ _ _ _ _ _ _ Fo At Me C) as Ho.
  pose proof (holds_add _ _ _ _ (times_m k) K Fx Ho) as R. cbn [strict add_sum].
  match goal with |- holds _ ?v => replace v with
    (value_from (single x) (alike x) 1 ss + value_sum (sums x) +
     IZR (times_m k) * (value_one one s + value_sum all)) by ring end. exact R.
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
Lemma cancels_value x cs l (ok : limits -> state -> Prop) : Forall2 ok cs l -> forall j P held,
  passing_from P l -> cancels pr x j cs = Some held ->
  value_from (single x) (alike x) j l =
  IZR held * P - IZR (on_M (sums x)) * Spec.total (map t_of l) / su
  - IZR (on_volume (sums x)) * Spec.total (map (fun '(c, s) => t_of s * IZR (per_factor c) / su) (combine cs l)).
Proof.
  induction 1 as [|c s cs l O _ IH]; intros j P held Pa H; cbn [cancels] in H.
  { injection H as <-. simpl. field. lra. }
  destruct (cancels pr x (Pos.succ j) cs) as [held'|] eqn:E; [|discriminate].
  destruct Pa as (Ps & Pa). unfold check in H.
  set (one := of_class_j (single x) j) in *. set (all := alike x) in *.
  destruct ((on_q one + on_q all =? 0)%Z &&
            (((on_t one + on_t all + (held' + on_P one + on_P all)) * share_unit pr + on_M (sums x) +
              on_volume (sums x) * per_factor c =? 0)%Z) && (on_p one + on_p all =? 0)%Z)%bool eqn:B; [|discriminate].
  injection H as <-. rewrite !andb_true_iff, !Z.eqb_eq in B. destruct B as ((Bq & Bt) & Bp).
  cbn [value_from combine map Spec.total fold_right]. fold (Spec.total (map t_of l)).
  rewrite (IH _ _ _ Pa E). fold one. fold all. unfold value_one.
  apply (f_equal IZR) in Bq, Bt, Bp. rewrite !plus_IZR, !mult_IZR in *. rewrite !plus_IZR in *.
  change (fold_right Rplus 0 (map t_of l)) with (Spec.total (map t_of l)).
  change (fold_right Rplus 0 (map (fun '(c, s) => t_of s * IZR (per_factor c) / su) (combine cs l)))
    with (Spec.total (map (fun '(c, s) => t_of s * IZR (per_factor c) / su) (combine cs l))).
  rewrite Ps.
  replace (IZR (on_q one)) with (- IZR (on_q all)) by lra. replace (IZR (on_p one)) with (- IZR (on_p all)) by lra.
  replace (IZR (on_t one)) with (- IZR (on_t all) - (IZR held' + IZR (on_P one) + IZR (on_P all))
     - (IZR (on_M (sums x)) + IZR (on_volume (sums x)) * IZR (per_factor c)) / su).
  - field. lra.
  - apply (Rmult_eq_reg_r su); [|lra]. field_simplify; [|lra]. lra.
Qed.

Lemma cancels_everywhere x held : cancels pr x 1 (classes_of pr) = Some held ->
  value_from (single x) (alike x) 1 ss = - IZR (on_M (sums x)) * M / su - IZR (on_volume (sums x)) * V.
Proof.
  intro Ca. rewrite (cancels_value x _ _ _ (sat_classes _ solves) _ _ _ (sat_passing _ solves) Ca).
  fold (all_mass ss). fold (all_volume ss). field. lra.
Qed.

Lemma says_nothing_value x s : says_nothing x = true -> value_one x s = 0.
Proof.
  unfold says_nothing. rewrite !andb_true_iff, !Z.eqb_eq. intros (((E1 & E2) & E3) & E4).
  unfold value_one. rewrite E1, E2, E3, E4. field. lra.
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

(* ---- The tree ------------------------------------------------------------------------------------ *)

Lemma split_forced e j v : forced e -> forced (below e j v) \/ forced (from e j v).
Proof.
  intro Fo. destruct (state_at j 1 ss) as [s|] eqn:At.
  - destruct (Z_lt_le_dec (q_of s) v) as [L|L]; [left | right]; intros i s' At'; destruct (Fo i s' At') as (A & B).
    + split; [exact A|]. unfold below. cbn [at_most_v]. intros u H. destruct (Pos.eq_dec i j) as [->|N].
      * rewrite PositiveMap.gss in H. rewrite At in At'. injection At' as <-. injection H as <-.
        destruct (PositiveMap.find j (at_most_v e)) as [w|] eqn:W; [specialize (B w eq_refl)|]; lia.
      * rewrite PositiveMap.gso in H by exact N. auto.
    + split; [|exact B]. unfold from. cbn [at_least_v]. intros u H. destruct (Pos.eq_dec i j) as [->|N].
      * rewrite PositiveMap.gss in H. rewrite At in At'. injection At' as <-. injection H as <-.
        destruct (PositiveMap.find j (at_least_v e)) as [w|] eqn:W; [specialize (A w eq_refl)|]; lia.
      * rewrite PositiveMap.gso in H by exact N. auto.
  - left. intros i s' At'. destruct (Fo i s' At') as (A & B). split; [exact A|]. unfold below. cbn [at_most_v].
    intros u H. destruct (Pos.eq_dec i j) as [->|N]; [congruence|]. rewrite PositiveMap.gso in H by exact N. auto.
Qed.

Lemma nodes_sound nodes : forall to_come e,
  check_nodes pr t nodes to_come = Ok tt -> In e to_come -> ~ forced e.
Proof.
  induction nodes as [|n nodes IH]; intros to_come e H I Fo.
  { destruct to_come; [destruct I | discriminate]. }
  simpl in H. destruct n as [j v|ks].
  - destruct j as [|j|j]; try discriminate. destruct to_come as [|e0 to_come]; [discriminate|].
    destruct (PositiveMap.mem j t); [|discriminate]. destruct I as [->|I].
    + destruct (split_forced e j v Fo) as [B|B]; [apply (IH _ _ H (or_introl eq_refl) B)|].
      apply (IH _ (from e j v) H); [right; left; reflexivity | exact B].
    + apply (IH _ e H); [right; right; exact I | exact Fo].
  - destruct to_come as [|e0 to_come]; [discriminate|]. destruct (refutes pr t e0 ks) eqn:R; [|discriminate].
    destruct I as [->|I]; [exact (leaf_sound e ks R Fo) | exact (IH _ _ H I Fo)].
Qed.

Lemma nothing_forced : forced nothing.
Proof.
  intros j s _. unfold nothing. cbn [at_least_v at_most_v]. split; intros v H; rewrite PositiveMap.gempty in H; discriminate.
Qed.

End Point.

(* Theorem 14 (b). *)
Theorem tree_sound nodes : check_tree pr nodes = Ok tt -> forall ss, ~ satisfies ss.
Proof.
  intros H ss S. unfold check_tree in H.
  exact (nodes_sound ss S nodes [nothing] nothing H (or_introl eq_refl) (nothing_forced ss)).
Qed.

End Tree.
