(* Theorem 20 (a) and (b): nothing that satisfies the conditions has its mass in a window that is ruled out. *)

From Coq Require Import ZArith QArith Reals Qreals List Bool String Ascii Lia Lra FMapPositive.
From Mdm Require Import Numbers NumbersFacts Certificate Leaf Windows Spec Reduction RealFacts LeafSound WindowClass.
Import ListNotations.
Open Scope R_scope.

Section Windows.
Variable pr : problem.
Notation mu := (IZR (mass_unit pr)).
Notation su := (IZR (share_unit pr)).
Notation half := (IZR (half_total pr)).
Hypothesis mass_unit_positive : 0 < mu.
Hypothesis share_unit_positive : 0 < su.
(* A gradation's shares are all of it, the bounds of a class ascend, and a volume is one. *)
Hypothesis targets_whole : sum (map g (classes_of pr)) = share_unit pr.
Hypothesis classes_ascend : Forall (fun x => (0 <= f x < F x)%Z) (classes_of pr).
Hypothesis volume_nonneg : 0 <= Q2R (volume pr).

Variable ss : list state.
Hypothesis solves : satisfies pr ss.
Notation M := (all_mass ss).

Lemma mass_positive : 0 < M.
Proof. apply (sat_mass _ _ solves). Qed.

(* Shares of the mass, and what passes, in units of shares. *)
Definition share (s : state) : R := t_of s * su / M.
Definition passes (s : state) : R := P_of s * su / M.

(* ---- Bounds on shares ---------------------------------------------------------------------------- *)

Definition within (b : bounds) (x : R) : Prop := IZR (lowest b) <= x <= IZR (highest b).

Lemma narrowed_within b lo hi x : within b x -> IZR lo <= x <= IZR hi -> within (narrowed b lo hi) x.
Proof.
  unfold within, narrowed. cbn [lowest highest]. intros (A & B) (C & D). split.
  - destruct (Z.max_spec (lowest b) lo) as [(_ & ->)|(_ & ->)]; assumption.
  - destruct (Z.min_spec (highest b) hi) as [(_ & ->)|(_ & ->)]; assumption.
Qed.

Definition known (b : bounds * bounds) (s : state) : Prop := within (fst b) (share s) /\ within (snd b) (passes s).

Definition excess_of (cs : list (limits * state)) : R := Spec.total (map (fun '(c, s) => Rmax 0 (share s - IZR (g c))) cs).
Definition deviation_of (cs : list (limits * state)) : R := Spec.total (map (fun '(c, s) => share s - IZR (g c)) cs).

Lemma deviation_excess cs : deviation_of cs <= excess_of cs /\ 0 <= excess_of cs.
Proof.
  unfold deviation_of, excess_of. induction cs as [|(c, s) cs (A & B)]; cbn [map Spec.total fold_right]; [lra|].
  pose proof (Rmax_r 0 (share s - IZR (g c))). pose proof (Rmax_l 0 (share s - IZR (g c))).
  fold (Spec.total (map (fun '(c, s) => share s - IZR (g c)) cs)).
  fold (Spec.total (map (fun '(c, s) => Rmax 0 (share s - IZR (g c))) cs)). lra.
Qed.

Lemma deviation_cons c s cs : deviation_of ((c, s) :: cs) = share s - IZR (g c) + deviation_of cs.
Proof. reflexivity. Qed.
Lemma excess_cons c s cs : excess_of ((c, s) :: cs) = Rmax 0 (share s - IZR (g c)) + excess_of cs.
Proof. reflexivity. Qed.

(* In units of shares what the tolerance's lines say, which [meets] has of masses. *)
Lemma in_shares lo hi t : IZR lo * M <= t * su <= IZR hi * M -> IZR lo <= t * su / M <= IZR hi.
Proof.
  intros (A & B). pose proof mass_positive as Mp. split; apply (Rmult_le_reg_r M); trivial;
    replace (t * su / M * M) with (t * su) by (field; lra); assumption.
Qed.

(* The deviations before a class, [before], and their positive part, [more]; the total of all is 0. *)
Lemma upwards_known : forall cs l G b P N D before more,
  Forall2 (meets pr M) cs l -> sums_from pr P N D cs l ->
  within b (P * su / M) -> before = P * su / M - IZR G -> before <= more -> 0 <= more ->
  before + deviation_of (combine cs l) = 0 -> more + excess_of (combine cs l) <= half ->
  P * su / M + Spec.total (map share l) = su ->
  Forall2 known (upwards pr G b cs) l.
Proof.
  pose proof mass_positive as Mp.
  induction cs as [|c cs IH]; intros l G b P N D before more Me Su Wb Eb Lb Pm T E W;
    inversion Me as [|? s ? l' Ms Me']; subst;
    [constructor|].
  destruct Su as (EP & _ & _ & Su). cbn [combine] in T, E. rewrite deviation_cons in T. rewrite excess_cons in E.
  cbn [map Spec.total fold_right] in W. fold (Spec.total (map share l')) in W.
  destruct (deviation_excess (combine cs l')) as (De & Ep).
  pose proof (Rmax_r 0 (share s - IZR (g c))) as X1. pose proof (Rmax_l 0 (share s - IZR (g c))) as X0.
  assert (passes s = P * su / M + share s) as Ep'.
  { unfold passes, share. rewrite EP. field. lra. }
  pose proof (in_shares _ _ _ (meets_retained _ _ _ _ Ms)) as R. fold (share s) in R.
  pose proof (in_shares _ _ _ (meets_passing _ _ _ _ Ms)) as Pa. fold (passes s) in Pa.
  cbn [upwards]. set (own := narrowed (Bounds (retained_lo c) (retained_hi c)) _ _).
  assert (within own (share s)) as Ow by (apply narrowed_within; [exact R | rewrite minus_IZR, plus_IZR; lra]).
  set (lines := match cs with [] => _ | _ => _ end).
  assert (within lines (passes s)) as Li.
  { subst lines. destruct cs as [|c2 cs].
    - inversion Me'; subst. cbn in W. unfold within. cbn [lowest highest]. rewrite Ep'. lra.
    - apply narrowed_within; [exact Pa|]. rewrite minus_IZR, !plus_IZR, Ep'. lra. }
  set (passing := narrowed lines _ _).
  assert (within passing (passes s)) as Wp.
  { apply narrowed_within; [exact Li|]. rewrite !plus_IZR, Ep'. unfold within in Wb, Ow. lra. }
  constructor; [split; assumption|].
  apply (IH l' _ passing _ _ _ (passes s - IZR (G + g c)) (more + Rmax 0 (share s - IZR (g c))) Me' Su); trivial;
    fold (passes s); rewrite ?plus_IZR, ?Ep'; lra.
Qed.

(* What passes adds up. *)
Fixpoint chained (P : R) (l : list state) : Prop :=
  match l with
  | [] => True
  | s :: l => passes s = P + share s /\ chained (passes s) l
  end.

Lemma sums_chained : forall cs l P N D, List.length cs = List.length l -> sums_from pr P N D cs l -> chained (P * su / M) l.
Proof.
  pose proof mass_positive as Mp.
  induction cs as [|c cs IH]; intros [|s l] P N D Le H; try discriminate; [exact I|].
  destruct H as (E & _ & _ & H). split; [unfold passes, share; rewrite E; field; lra|].
  apply (IH l _ _ _ ltac:(injection Le; trivial) H).
Qed.

Lemma downwards_known : forall js l P, Forall2 known js l -> chained P l -> Forall2 known (downwards js) l.
Proof.
  induction js as [|(own, passing) js IH]; intros l P K C; inversion K as [|? s ? l' Ks K']; subst; [constructor|].
  destruct C as (_ & C). specialize (IH _ _ K' C). cbn [downwards].
  destruct (downwards js) as [|(next, above) js']; inversion IH as [|? s2 ? l2 K2 IH']; subst; constructor; trivial.
  destruct Ks as (K1 & K2'), K2 as (N1 & N2), C as (E & _). unfold fst, snd in *. split; [exact K1|]. cbn [snd].
  apply narrowed_within; [exact K2'|]. rewrite !minus_IZR. unfold within in *. lra.
Qed.

Lemma differences_known : forall js l b P, Forall2 known js l -> chained P l -> within b P ->
  Forall2 (fun b s => within b (share s)) (differences b js) l.
Proof.
  induction js as [|(own, passing) js IH]; intros l b P K C W; inversion K as [|? s ? l' Ks K']; subst; constructor.
  - destruct Ks as (K1 & K2), C as (E & _). unfold fst, snd in *. apply narrowed_within; [exact K1|].
    rewrite !minus_IZR. unfold within in *. lra.
  - destruct C as (_ & C). destruct Ks as (_ & K2). exact (IH l' passing _ K' C K2).
Qed.

Lemma states_length : List.length (classes_of pr) = List.length ss.
Proof. destruct solves as [Me _ _ _ _ _ _]. clear -Me. induction Me; cbn; congruence. Qed.

Lemma shares_total l : Spec.total (map share l) = Spec.total (map t_of l) * (su / M).
Proof.
  pose proof mass_positive as Mp. induction l as [|s l IH]; cbn [map Spec.total fold_right]; [ring|].
  fold (Spec.total (map share l)). fold (Spec.total (map t_of l)). rewrite IH. unfold share. field. lra.
Qed.

Lemma shares_whole : Spec.total (map share ss) = su.
Proof. rewrite shares_total. fold M. pose proof mass_positive. field. lra. Qed.

Lemma excess_at_most : excess_of (combine (classes_of pr) ss) <= half.
Proof.
  pose proof mass_positive as Mp. destruct solves as [Me _ _ To _ _ _].
  assert (forall cs l, Forall2 (meets pr M) cs l -> excess_of (combine cs l) * M <= Spec.total (map p_of l) * su) as K.
  { induction 1 as [|c s cs l Ms _ IH]; [cbn; lra|]. cbn [combine]. rewrite excess_cons.
    cbn [map Spec.total fold_right]. fold (Spec.total (map p_of l)). rewrite !Rmult_plus_distr_r.
    apply Rplus_le_compat; [|exact IH]. destruct (meets_excess _ _ _ _ Ms) as (E1 & E2).
    unfold Rmax. destruct (Rle_dec 0 (share s - IZR (g c))).
    - replace ((share s - IZR (g c)) * M) with (t_of s * su - IZR (g c) * M) by (unfold share; field; lra). exact E1.
    - rewrite Rmult_0_l. apply Rmult_le_pos; lra. }
  specialize (K _ _ Me). apply (Rmult_le_reg_r M); [exact Mp|]. lra.
Qed.

Lemma deviations_zero : deviation_of (combine (classes_of pr) ss) = 0.
Proof.
  pose proof shares_whole as W. rewrite <- targets_whole in W.
  pose proof states_length as Le. revert Le W. generalize (classes_of pr) as cs. generalize ss as l.
  assert (forall l cs, List.length cs = List.length l ->
    deviation_of (combine cs l) = Spec.total (map share l) - IZR (sum (map g cs))) as E.
  { induction l as [|s l IH]; intros [|c cs] Le; try discriminate; [cbn; lra|]. cbn [combine].
    rewrite deviation_cons, IH by (injection Le; trivial).
    cbn [map Spec.total fold_right sum]. rewrite plus_IZR. unfold Spec.total, sum. lra. }
  intros l cs Le W. rewrite E by exact Le. lra.
Qed.

Lemma shares_bounded : Forall2 (fun b s => within b (share s)) (bounds_of_shares pr) ss.
Proof.
  pose proof mass_positive as Mp. pose proof (sums_chained _ _ _ _ _ states_length (sat_sums _ _ solves)) as C.
  assert (0 * su / M = 0) as Z by (field; lra).
  apply (differences_known _ _ _ (0 * su / M)); [|exact C | unfold within; cbn [lowest highest]; lra].
  apply (downwards_known _ _ (0 * su / M)); [|exact C].
  apply (upwards_known _ _ _ _ 0 0%Z 0 0 0 (sat_classes _ _ solves) (sat_sums _ _ solves)); try lra.
  - unfold within. cbn [lowest highest]. lra.
  - rewrite deviations_zero. lra.
  - pose proof excess_at_most. lra.
  - rewrite shares_whole. lra.
Qed.

(* ---- A class of the sample in a window ----------------------------------------------------------- *)

Variable e : force.
Hypothesis counts_in_force : forced ss e.
Hypothesis more_than : Q2R (above e) < M.
Hypothesis at_most_mass : forall u, up_to_mass e = Some u -> M <= Q2R u.
Notation w := (ends_of pr e).
Notation s' := (Z.max 1 (s_num w)).
Notation u' := (Z.max 1 (S_num w)).
Notation K := (IZR (s' * u')).

Lemma scale_positive : (0 < s' * u')%Z.
Proof. apply Z.mul_pos_pos; lia. Qed.

(* s = s_num / s_den, in units of mass. *)
Lemma lower_end : IZR (s_num w) < M * mu * IZR (s_den w) /\ (0 < s_den w)%Z.
Proof.
  unfold ends_of. cbn [s_num s_den]. split; [|reflexivity]. rewrite Q2R_num, Q2R_times, Q2R_integer.
  apply Rmult_lt_compat_r; [apply den_positive|]. apply Rmult_lt_compat_r; assumption.
Qed.

Lemma upper_end : (0 < S_num w)%Z -> M * mu * IZR (S_den w) <= IZR (S_num w) /\ (0 < S_den w)%Z.
Proof.
  unfold ends_of. cbn [S_num S_den]. destruct (up_to_mass e) as [u|] eqn:E; [|cbn; lia]. intros _. split; [|reflexivity].
  rewrite Q2R_num, Q2R_times, Q2R_integer. apply Rmult_le_compat_r; [left; apply den_positive|].
  apply Rmult_le_compat_r; [lra | exact (at_most_mass u eq_refl)].
Qed.

Lemma least_count_fair lowest_y one forced_v :
  (0 <= one)%Z ->
  let m := least_count_of lowest_y one forced_v in
  (0 <= m /\ forced_v <= m /\ (0 < lowest_y -> 1 <= m /\ (0 < one -> lowest_y < one * m)))%Z.
Proof.
  intro O. unfold least_count_of. cbv zeta. split; [lia|]. split; [lia|]. intro L. rewrite (proj2 (Z.ltb_lt _ _) L).
  destruct (Z.ltb_spec 0 one) as [P|P]; [|split; lia].
  pose proof (Z.mul_succ_div_gt lowest_y one P) as D. pose proof (Z.div_pos lowest_y one ltac:(lia) P) as D0.
  set (u := (lowest_y / one)%Z) in *. split; [lia|]. intros _. nia.
Qed.

Lemma greatest_count_fair highest_y one forced_v :
  (0 <= one)%Z ->
  match greatest_count_of highest_y one forced_v with
  | Some n => (highest_y <= 0 -> n <= 0)%Z /\ (0 < highest_y -> 0 < one -> one * n < highest_y)%Z
  | None => (0 < highest_y /\ one = 0)%Z
  end.
Proof.
  intro O. unfold greatest_count_of. destruct (Z.leb_spec highest_y 0) as [L|L].
  - destruct forced_v; split; lia.
  - destruct (Z.ltb_spec 0 one) as [P|P]; [|destruct forced_v; [split; lia | split; lia]].
    pose proof (Z.mul_div_le (highest_y - 1) one P) as D. set (u := ((highest_y - 1) / one)%Z) in *.
    destruct forced_v; (split; [lia | intros _ _; nia]).
Qed.

Lemma view_fair x b s j :
  (0 <= f x < F x)%Z -> meets pr M x s -> within b (share s) -> state_at j 1 ss = Some s ->
  let v := view_of pr w e j x b in
  fair v /\ has_point v (q_of s) (share s * K) /\ has_count v (q_of s) = true.
Proof.
  intros (F0 & FF) Me (W1 & W2) At v. pose proof mass_positive as Mp. pose proof scale_positive as Kp.
  assert (0 < share_unit pr)%Z as Sz by (apply lt_IZR, share_unit_positive).
  pose proof (IZR_lt _ _ Kp) as Kr. destruct lower_end as (Ls & Ld). pose proof (IZR_lt _ _ Ld) as Ldr.
  assert (0 <= low_one v /\ 0 <= high_one v)%Z as (A & B).
  { subst v. unfold view_of. cbn [low_one high_one]. split.
    - destruct (Z.ltb_spec 0 (S_num w)) as [P|P]; [|lia]. destruct (upper_end P) as (_ & D).
      repeat apply Z.mul_nonneg_nonneg; lia.
    - destruct (Z.ltb_spec 0 (s_num w)) as [P|P]; [|lia]. repeat apply Z.mul_nonneg_nonneg; lia. }
  pose proof (least_count_fair (l v) (high_one v) (least_of e j x) B) as (L1 & L2 & L3).
  pose proof (greatest_count_fair (h v) (low_one v) (of_range j j (at_most_v e)) A) as G.
  change (least_count_of (l v) (high_one v) (least_of e j x)) with (fewest v) in *.
  change (greatest_count_of (h v) (low_one v) (of_range j j (at_most_v e))) with (greatest v) in *.
  assert (fair v) as Fv by (constructor; [split; assumption | split; [exact L1 | exact L3] | exact G]).
  destruct (meets_count _ _ _ _ Me) as (_ & Q0). destruct (meets_lower _ _ _ _ Me) as (Lo & Lo').
  pose proof (meets_upper _ _ _ _ Me) as Up.
  assert (IZR (l v) <= share s * K <= IZR (h v)) as Lh.
  { subst v. unfold view_of. cbn [l h]. rewrite !(mult_IZR _ (s' * u')). split; apply Rmult_le_compat_r; lra. }
  assert (has_point v (q_of s) (share s * K)) as Pt.
  { destruct (Z.eq_dec (q_of s) 0) as [E|E].
    - left. split; [exact E|]. rewrite E in *. assert (t_of s = 0) as T by (apply (Rmult_eq_reg_r mu); lra).
      unfold share. rewrite T. field. lra.
    - right. split; [lia|]. split; [exact Lh|]. specialize (Lo' ltac:(lia)).
      assert (0 < IZR (q_of s)) as Qp by (apply IZR_lt; lia).
      assert (share s * K = t_of s * mu * (su * K / (M * mu))) as Es by (unfold share; field; lra).
      assert (0 < su * K / (M * mu)) as Cp.
      { apply Rdiv_lt_0_compat; apply Rmult_lt_0_compat; assumption. }
      split.
      + subst v. unfold view_of. cbn [low_one]. destruct (Z.ltb_spec 0 (S_num w)) as [P|P].
        * destruct (upper_end P) as (Us & Ud). pose proof (IZR_lt _ _ Ud) as Udr. pose proof (IZR_lt _ _ P) as Pr.
          rewrite Es. apply (Rle_lt_trans _ (IZR (f x) * IZR (q_of s) * (su * K / (M * mu)))).
          2: { apply Rmult_lt_compat_r; assumption. }
          assert (u' = S_num w) as Eu by lia. rewrite !mult_IZR, Eu.
          assert (0 <= IZR (f x) * IZR (q_of s) * su * IZR s') as N.
          { repeat apply Rmult_le_pos; try lra; apply IZR_le; lia. }
          replace (IZR (f x) * IZR (S_den w) * su * IZR s' * IZR (q_of s))
            with (IZR (f x) * IZR (q_of s) * su * IZR s' * IZR (S_den w)) by ring.
          replace (IZR (f x) * IZR (q_of s) * (su * (IZR s' * IZR (S_num w)) / (M * mu)))
            with (IZR (f x) * IZR (q_of s) * su * IZR s' * (IZR (S_num w) / (M * mu))) by (field; lra).
          apply Rmult_le_compat_l; [exact N|]. apply (Rmult_le_reg_r (M * mu)); [apply Rmult_lt_0_compat; assumption|].
          replace (IZR (S_num w) / (M * mu) * (M * mu)) with (IZR (S_num w)) by (field; lra). lra.
        * rewrite Rmult_0_l, Es. apply Rmult_lt_0_compat; [|exact Cp].
          apply (IZR_le 0) in F0. pose proof (Rmult_le_pos _ _ F0 (Rlt_le _ _ Qp)). lra.
      + subst v. unfold view_of. cbn [high_one]. destruct (Z.ltb_spec 0 (s_num w)) as [P|P]; [intros _ | intro K0; lra].
        pose proof (IZR_lt _ _ P) as Pr. rewrite Es.
        apply (Rle_lt_trans _ (IZR (F x) * IZR (q_of s) * (su * K / (M * mu)))); [apply Rmult_le_compat_r; lra|].
        assert (s' = s_num w) as E' by lia. rewrite !mult_IZR, E'.
        assert (0 < IZR (F x) * IZR (q_of s) * su * IZR u') as N.
        { repeat apply Rmult_lt_0_compat; trivial; apply IZR_lt; lia. }
        replace (IZR (F x) * IZR (s_den w) * su * IZR u' * IZR (q_of s))
          with (IZR (F x) * IZR (q_of s) * su * IZR u' * IZR (s_den w)) by ring.
        replace (IZR (F x) * IZR (q_of s) * (su * (IZR (s_num w) * IZR u') / (M * mu)))
          with (IZR (F x) * IZR (q_of s) * su * IZR u' * (IZR (s_num w) / (M * mu))) by (field; lra).
        apply Rmult_lt_compat_l; [exact N|]. apply (Rmult_lt_reg_r (M * mu)); [apply Rmult_lt_0_compat; assumption|].
        replace (IZR (s_num w) / (M * mu) * (M * mu)) with (IZR (s_num w)) by (field; lra). lra. }
  split; [exact Fv|]. split; [exact Pt|].
  pose proof (least_true pr mass_unit_positive ss solves e j x s counts_in_force At Me) as Lt.
  destruct (forced_class pr mass_unit_positive ss solves e j s counts_in_force At) as (_ & Mo).
  apply has_count_spec. split.
  - change (fewest v) with (least_count_of (l v) (high_one v) (least_of e j x)). unfold least_count_of.
    apply Z.max_lub; [lia|]. destruct (Z.ltb_spec 0 (l v)) as [P|P]; [|exact Q0].
    pose proof (IZR_lt _ _ P) as Pr. destruct Pt as [(_ & E)|(Q1 & _ & _ & Hi)]; [lra|].
    destruct (Z.ltb_spec 0 (high_one v)) as [H1|H1]; [|exact Q1].
    specialize (Hi (IZR_lt _ _ H1)). assert (l v < high_one v * q_of s)%Z as Lq by (apply lt_IZR; rewrite mult_IZR; lra).
    pose proof (Z.div_lt_upper_bound (l v) (high_one v) (q_of s) H1 Lq). lia.
  - change (greatest v) with (greatest_count_of (h v) (low_one v) (of_range j j (at_most_v e))). unfold greatest_count_of.
    assert (forall n, of_range j j (at_most_v e) = Some n -> (q_of s <= n)%Z) as Mo' by (intros n E; exact (Mo n E)).
    assert (match (if (h v <=? 0)%Z then Some 0%Z else if (0 <? low_one v)%Z then Some ((h v - 1) / low_one v)%Z else None)
      with
            | Some n => (q_of s <= n)%Z | None => True end) as Own.
    { destruct (Z.leb_spec (h v) 0) as [P|P].
      - destruct Pt as [(-> & _)|(Q1 & (_ & H2) & H3 & _)]; [lia|]. exfalso. apply IZR_le in P.
        pose proof (Rmult_le_pos _ _ (IZR_le _ _ A) (IZR_le _ _ Q0)). lra.
      - destruct (Z.ltb_spec 0 (low_one v)) as [L|L]; [|exact I]. apply Z.div_le_lower_bound; [exact L|].
        destruct Pt as [(-> & _)|(Q1 & (_ & H2) & H3 & _)]; [lia|].
        assert (low_one v * q_of s < h v)%Z by (apply lt_IZR; rewrite mult_IZR; lra). lia. }
    destruct (if (h v <=? 0)%Z then _ else _) as [n|], (of_range j j (at_most_v e)) as [m|]; auto.
    apply Z.min_glb; auto.
Qed.

(* ---- Conditions hold ----------------------------------------------------------------------------- *)

(* 1 / S, or 0. *)
Definition inverse_end : R := if (0 <? S_num w)%Z then mu * IZR (S_den w) / IZR (S_num w) else 0.

(* Per mass: what a class has, what passes it, all excesses, and by how much all volumes are more than w / S. *)
Definition part (s : state) : R := t_of s / M.
Definition part_passing (s : state) : R := P_of s / M.
Definition excesses : R := excess_of (combine (classes_of pr) ss) / su.
Definition volumes : R := all_volume pr ss / M - Q2R (volume pr) * inverse_end.

Definition value_of (x : terms) (y n : R) : R :=
  IZR (on_shares x) * y + IZR (on_counts x) * n - IZR (on_excess x) * excesses + IZR (on_volume x) * volumes
  - IZR (right_of_shares x) / su - IZR (right_of_counts x).

Lemma volumes_nonneg : 0 <= volumes.
Proof.
  unfold volumes, inverse_end. pose proof mass_positive as Mp. pose proof (sat_volume _ _ solves) as Vo.
  destruct (Z.ltb_spec 0 (S_num w)) as [P|P].
  - destruct (upper_end P) as (U & D). pose proof (IZR_lt _ _ P) as Pr. pose proof (IZR_lt _ _ D) as Dr.
    assert (mu * IZR (S_den w) / IZR (S_num w) <= / M) as I.
    { apply (Rmult_le_reg_r (M * IZR (S_num w))); [apply Rmult_lt_0_compat; assumption|].
      replace (mu * IZR (S_den w) / IZR (S_num w) * (M * IZR (S_num w))) with (M * mu * IZR (S_den w)) by (field; lra).
      replace (/ M * (M * IZR (S_num w))) with (IZR (S_num w)) by (field; lra). exact U. }
    pose proof (Rmult_le_compat_l _ _ _ volume_nonneg I).
    assert (0 <= / M) as Im by (left; apply Rinv_0_lt_compat, Mp). pose proof (Rmult_le_compat_r _ _ _ Im Vo).
    unfold Rdiv in *. lra.
  - rewrite Rmult_0_r, Rminus_0_r. apply Rmult_le_pos; [lra | left; apply Rinv_0_lt_compat, Mp].
Qed.

Lemma parts_total l : Spec.total (map part l) = Spec.total (map t_of l) / M.
Proof.
  induction l as [|s l IH]; cbn [map Spec.total fold_right]; [unfold Rdiv; ring|].
  fold (Spec.total (map part l)). fold (Spec.total (map t_of l)). rewrite IH. unfold part, Rdiv. ring.
Qed.

(* Shows 0 <= v for the value of one of the conditions. *)
Ltac says v :=
  unfold value_of; cbn [on_shares on_counts on_excess on_volume right_of_shares right_of_counts];
  rewrite ?opp_IZR, ?minus_IZR; match goal with |- 0 <= ?e => replace e with v by (field; lra) end.

Lemma condition_of_all_holds ch x :
  condition_of_all pr ch = Some x -> 0 <= value_of x 1 (IZR (sum (map q_of ss))).
Proof.
  intro H. pose proof mass_positive as Mp. unfold condition_of_all in H.
  destruct (ch =? "t")%char. { injection H as <-. says 0. lra. }
  destruct (ch =? "T")%char. { injection H as <-. says 0. lra. }
  destruct (ch =? "E")%char.
  { injection H as <-. says (half / su - excesses). unfold excesses. pose proof excess_at_most as X.
    apply (Rmult_le_compat_r (/ su)) in X; [unfold Rdiv; lra | left; apply Rinv_0_lt_compat; assumption]. }
  destruct (ch =? "w")%char. { injection H as <-. says volumes. apply volumes_nonneg. }
  destruct (ch =? "n")%char.
  { injection H as <-. pose proof (sat_least _ _ solves) as Le. apply IZR_le in Le.
    says (IZR (sum (map q_of ss)) - IZR (least_count pr)). lra. }
  destruct (ch =? "N")%char; [|discriminate]. destruct (bound pr) as [B|] eqn:E; [|discriminate]. cbn [option_map] in H.
  pose proof (sat_bound _ _ solves B E) as Le. apply IZR_le in Le. rewrite minus_IZR in Le.
  remember (1 - B)%Z as k eqn:Ek. injection H as <-. subst k. says (IZR B - 1 - IZR (sum (map q_of ss))). lra.
Qed.

Lemma condition_of_passing_holds c ch x s n :
  meets pr M c s -> condition_of_passing c ch = Some x ->
  on_counts x = 0%Z /\ 0 <= value_of (right_alone x) 0 0 + IZR (on_shares x) * part_passing s + IZR (on_counts x) * n.
Proof.
  intros Me H. pose proof mass_positive as Mp. destruct (in_shares _ _ _ (meets_passing _ _ _ _ Me)) as (A & B).
  assert (P_of s * su / M = part_passing s * su) as E by (unfold part_passing; field; lra). rewrite E in *.
  unfold condition_of_passing in H. destruct (ch =? "p")%char.
  - injection H as <-. split; [reflexivity|]. unfold right_alone. says (part_passing s - IZR (passing_lo c) / su).
    apply (Rmult_le_compat_r (/ su)) in A; [|left; apply Rinv_0_lt_compat; assumption].
    replace (part_passing s * su * / su) with (part_passing s) in A by (field; lra). unfold Rdiv. lra.
  - destruct (ch =? "P")%char; [|discriminate]. injection H as <-. split; [reflexivity|]. unfold right_alone.
    says (IZR (passing_hi c) / su - part_passing s).
    apply (Rmult_le_compat_r (/ su)) in B; [|left; apply Rinv_0_lt_compat; assumption].
    replace (part_passing s * su * / su) with (part_passing s) in B by (field; lra). unfold Rdiv. lra.
Qed.

Lemma condition_of_counts_holds i j ch x s :
  (i < j)%positive -> state_at j 1 ss = Some s -> condition_of_counts e i j ch = Some x ->
  exists s0, state_before ss i = Some s0 /\ on_shares x = 0%Z /\
    0 <= value_of (right_alone x) 0 0 + IZR (on_counts x) * (IZR (N_of s) - IZR (N_of s0)).
Proof.
  intros L At H. destruct (sums_between pr mass_unit_positive ss solves i j s ltac:(lia) At) as (s0 & B & _ & Rise & _).
  destruct (counts_in_force i j s0 s B At) as (Lo & Up). exists s0. split; [exact B|]. unfold condition_of_counts in H.
  destruct (ch =? "s")%char.
  - injection H as <-. split; [reflexivity|].
    assert (least_between e i j <= N_of s - N_of s0)%Z as Least.
    { unfold least_between. destruct (of_range i j (at_least_v e)) as [v|]; [exact (Lo v eq_refl) | lia]. }
    apply IZR_le in Least. rewrite minus_IZR in Least. unfold right_alone.
    says (IZR (N_of s) - IZR (N_of s0) - IZR (least_between e i j)). lra.
  - destruct (ch =? "S")%char; [|discriminate]. destruct (of_range i j (at_most_v e)) as [u|]; [|discriminate].
    injection H as <-. split; [reflexivity|]. specialize (Up u eq_refl). apply IZR_le in Up. rewrite minus_IZR in Up.
    unfold right_alone. says (IZR u - (IZR (N_of s) - IZR (N_of s0))). lra.
Qed.

(* ---- Sums of conditions -------------------------------------------------------------------------- *)

Fixpoint pairs_from (m : PositiveMap.t (Z * Z)) (j : positive) (l : list state) : R :=
  match l with
  | [] => 0
  | s :: l => IZR (fst (pair_at m j)) * part_passing s + IZR (snd (pair_at m j)) * IZR (N_of s) + pairs_from m (Pos.succ j)
    l
  end.

Definition tally_value (x : tally) : R :=
  pairs_from (up_to_class x) 1 ss + value_of (of_sample x) 1 (IZR (sum (map q_of ss))).

Lemma pair_at_add i j k x m :
  pair_at (add_pair i k x m) j =
  if Pos.eqb j i then (fst (pair_at m i) + k * on_shares x, snd (pair_at m i) + k * on_counts x)%Z else pair_at m j.
Proof.
  unfold add_pair. destruct (pair_at m i) as (p, n) eqn:E. cbn [fst snd]. unfold pair_at.
  destruct (Pos.eqb_spec j i) as [->|N].
  - rewrite PositiveMap.gss. reflexivity.
  - rewrite PositiveMap.gso by exact N. reflexivity.
Qed.

Lemma pairs_other i k x m : forall l j, (i < j)%positive -> pairs_from (add_pair i k x m) j l = pairs_from m j l.
Proof.
  induction l as [|s l IH]; intros j L; [reflexivity|]. cbn [pairs_from]. rewrite pair_at_add.
  destruct (Pos.eqb_spec j i); [lia|]. rewrite IH by lia. reflexivity.
Qed.

Lemma pairs_add i k x m : forall l j s, state_at i j l = Some s ->
  pairs_from (add_pair i k x m) j l =
  pairs_from m j l + IZR k * (IZR (on_shares x) * part_passing s + IZR (on_counts x) * IZR (N_of s)).
Proof.
  induction l as [|s0 l IH]; intros j s At; [discriminate|]. cbn [pairs_from state_at] in *.
  rewrite pair_at_add, (Pos.eqb_sym j i).
  destruct (Pos.eqb_spec i j) as [->|N].
  - injection At as <-. rewrite pairs_other by lia. cbn [fst snd]. rewrite !plus_IZR, !mult_IZR. ring.
  - rewrite (IH _ _ At). ring.
Qed.

Lemma value_add k x y p n : value_of (add_terms k x y) p n = value_of x p n + IZR k * value_of y p n.
Proof.
  unfold value_of, add_terms. cbn [on_shares on_counts on_excess on_volume right_of_shares right_of_counts].
  rewrite !plus_IZR, !mult_IZR. field. lra.
Qed.

Lemma value_alone x p n : value_of (right_alone x) p n = value_of (right_alone x) 0 0.
Proof. unfold value_of, right_alone. cbn [on_shares on_counts on_excess on_volume right_of_shares right_of_counts]. lra.
Qed.

Notation t := (number_from 1 (classes_of pr) (PositiveMap.empty limits)).

Lemma add_condition_fine x k y : 0 <= tally_value x -> add_condition pr t e x k = Some y -> 0 <= tally_value y.
Proof.
  intros Fx H. unfold add_condition in H. destruct (Z.leb_spec (times_m k) 0) as [|Kp]; [discriminate|].
  apply IZR_lt in Kp. unfold tally_value in *.
  assert (option_map (fun y => Tally (up_to_class x) (add_terms (times_m k) (of_sample x) y))
      (condition_of_all pr (letter k)) = Some y ->
          0 <= pairs_from (up_to_class y) 1 ss + value_of (of_sample y) 1 (IZR (sum (map q_of ss)))) as All.
  { intro H'. destruct (condition_of_all pr (letter k)) as [z|] eqn:C; [|discriminate]. injection H' as <-.
    cbn [up_to_class of_sample].
    rewrite value_add. pose proof (Rmult_le_pos _ _ (Rlt_le _ _ Kp) (condition_of_all_holds _ _ C)). lra. }
  destruct (of_class k) as [|i|i]; [exact (All H)| |exact (All H)].
  destruct (up_to k) as [|j|j]; [exact (All H)| |exact (All H)]. clear All.
  destruct (PositiveMap.find j t) as [cj|] eqn:E; [|discriminate].
  destruct (table_state _ _ _ (sat_classes _ _ solves) _ _ _ _ E) as [(s & At & Me)|E'];
    [|rewrite PositiveMap.gempty in E'; discriminate].
  destruct (Pos.ltb_spec j i) as [|Le]; [discriminate|]. destruct (Pos.eqb_spec i j) as [->|Ne].
  - destruct (condition_of_passing cj (letter k)) as [z|] eqn:C; [|discriminate]. injection H as <-.
    cbn [up_to_class of_sample].
    destruct (condition_of_passing_holds _ _ _ s (IZR (N_of s)) Me C) as (_ & P).
    rewrite (pairs_add _ _ _ _ _ _ _ At), value_add, (value_alone z 1).
    pose proof (Rmult_le_pos _ _ (Rlt_le _ _ Kp) P). lra.
  - destruct (condition_of_counts e i j (letter k)) as [z|] eqn:C; [|discriminate].
    assert (i < j)%positive as Lt by lia.
    destruct (condition_of_counts_holds _ _ _ _ s Lt At C) as (s0 & B & Z & P).
    pose proof (Rmult_le_pos _ _ (Rlt_le _ _ Kp) P) as P'. unfold state_before in B.
    destruct (i =? 1)%positive; injection H as <-; cbn [up_to_class of_sample]; rewrite value_add, (value_alone z 1).
    + injection B as <-. rewrite (pairs_add _ _ _ _ _ _ _ At), Z. cbn [start N_of] in P'. lra.
    + rewrite (pairs_add _ _ _ _ _ _ _ B), (pairs_add _ _ _ _ _ _ _ At), Z, opp_IZR. lra.
Qed.

Lemma add_conditions_fine ks : forall x y, 0 <= tally_value x -> add_conditions pr t e ks x = Some y -> 0 <= tally_value y.
Proof.
  induction ks as [|k ks IH]; intros x y Fx H; cbn [add_conditions] in H; [injection H as <-; exact Fx|].
  destruct (add_condition pr t e x k) as [z|] eqn:E; [|discriminate]. exact (IH z y (add_condition_fine x k z Fx E) H).
Qed.

Lemma nothing_fine : 0 <= tally_value nothing_said.
Proof.
  unfold tally_value, nothing_said, value_of. cbn [up_to_class of_sample on_shares on_counts on_excess on_volume
    right_of_shares right_of_counts].
  assert (forall l j, pairs_from (PositiveMap.empty (Z * Z)) j l = 0) as ->.
  { induction l as [|s l IH]; intro j; cbn [pairs_from]; [reflexivity|]. rewrite IH. unfold pair_at.
    rewrite PositiveMap.gempty. cbn. ring. }
  right. field. lra.
Qed.

(* ---- The greatest sum ---------------------------------------------------------------------------- *)

(* A class with its view, and the sample's state there. *)
Definition in_view (cv : limits * view) (s : state) : Prop :=
  let (c, v) := cv in
  fair v /\ has_point v (q_of s) (share s * K) /\ has_count v (q_of s) = true /\ IZR (target v) = IZR (g c) * K.

Lemma views_fair : forall cs bs l j,
  Forall (fun x => (0 <= f x < F x)%Z) cs -> Forall2 (meets pr M) cs l -> Forall2 (fun b s => within b (share s)) bs l ->
  (forall i s, state_at i j l = Some s -> state_at i 1 ss = Some s) ->
  Forall2 in_view (views pr w e j cs bs) l.
Proof.
  induction cs as [|c cs IH]; intros bs l j Ca Me Wb At; inversion Me as [|? s ? l' Ms Me']; subst;
    inversion Wb as [|b ? bs' ? W1 W2]; subst;
    [constructor|].
  inversion Ca as [|? ? Cc Cs]; subst. cbn [views]. constructor.
  - destruct (view_fair c b s j Cc Ms W1) as (Vf & Vp & Vc).
    { apply At. cbn [state_at]. rewrite Pos.eqb_refl. reflexivity. }
    split; [exact Vf|]. split; [exact Vp|]. split; [exact Vc|]. apply mult_IZR.
  - apply IH; trivial. intros i s0 A. apply At. cbn [state_at]. pose proof (state_at_le _ _ _ _ A).
    destruct (Pos.eqb_spec i j); [lia | exact A].
Qed.

(* What a tally has in some classes, but for the right sides. *)
Definition left_side (x : tally) (j : positive) (vs : list (limits * view)) (l : list state) : R :=
  pairs_from (up_to_class x) j l + IZR (on_shares (of_sample x)) * Spec.total (map part l) +
  IZR (on_counts (of_sample x)) * IZR (sum (map q_of l)) +
  IZR (on_volume (of_sample x)) *
    Spec.total (map (fun '(cv, s) => part s * IZR (per_factor (fst cv)) / su) (combine vs l)) -
  IZR (on_excess (of_sample x)) *
    Spec.total (map (fun '(cv, s) => Rmax 0 (share s - IZR (g (fst cv))) / su) (combine vs l)).

Notation D := (IZR (units pr w)).

Lemma greatest_of_all_sound x : (0 <= on_excess (of_sample x))%Z -> forall vs l j P N E cs r,
  map fst vs = cs -> Forall2 in_view vs l -> sums_from pr P N E cs l -> greatest_of_all pr (units pr w) x j vs = Some r ->
  let before :=
    (IZR (at_shares r) - IZR (on_shares (of_sample x))) * (P / M) +
    (IZR (at_counts r) - IZR (on_counts (of_sample x))) * IZR N in
  left_side x j vs l * (D * su) <= IZR (sum_of_all r) + before * (D * su) /\
  (left_side x j vs l * (D * su) = IZR (sum_of_all r) + before * (D * su) -> all_have r = true).
Proof.
  intro Ex. pose proof mass_positive as Mp. pose proof (IZR_lt _ _ scale_positive) as Kp.
  assert (D = su * K) as ED by (unfold units; rewrite mult_IZR; reflexivity).
  assert (0 <= on_excess (of_sample x) * share_unit pr)%Z as Ex' by (apply Z.mul_nonneg_nonneg; [exact Ex | apply le_IZR;
    lra]).
  induction vs as [|(c, v) vs IH]; intros l j P N E cs r Ec Iv Su G; inversion Iv as [|? s ? l' Vs Iv']; subst.
  { cbn [greatest_of_all] in G. injection G as <-. cbn [at_shares at_counts sum_of_all all_have]. unfold left_side. cbn.
    split; [right; ring | trivial]. }
  cbn [map fst] in Su. destruct Su as (EP & EN & _ & Su). cbn [greatest_of_all] in G.
  destruct (greatest_of_all pr (units pr w) x (Pos.succ j) vs) as [r'|] eqn:Gr; [|discriminate].
  destruct (pair_at (up_to_class x) j) as (p, n) eqn:Ep. cbv zeta in G.
  set (A := (at_shares r' + p)%Z) in *. set (B := (at_counts r' + n)%Z) in *.
  destruct (greatest_value v _) as [(value, has)|] eqn:Gv; [|discriminate]. injection G as <-.
  cbn [at_shares at_counts sum_of_all all_have].
  destruct Vs as (Vf & Vp & Vc & Vt).
  destruct (class_sound v (Weights _ _ (on_excess (of_sample x) * share_unit pr)) Vf Ex' value has Gv _ _ Vc Vp)
    as (C1 & C2). unfold psi in C1, C2. cbn [per_share per_count per_excess] in C1, C2.
  rewrite Vt, plus_IZR, (mult_IZR B), (mult_IZR (units pr w)), (mult_IZR (share_unit pr) A), (mult_IZR _ (per_factor c)),
    (mult_IZR (on_excess _)) in C1, C2.
  specialize (IH l' (Pos.succ j) (P_of s) (N_of s) (D_of s) (map fst vs) r' eq_refl Iv' Su Gr). cbv zeta in IH.
  destruct IH as (I1 & I2).
  assert (part_passing s = P / M + part s) as Epp by (unfold part_passing, part; rewrite EP; field; lra).
  assert (share s = part s * su) as Es by (unfold share, part; field; lra).
  assert (Rmax 0 (share s * K - IZR (g c) * K) = Rmax 0 (share s - IZR (g c)) * K) as Er.
  { replace (share s * K - IZR (g c) * K) with ((share s - IZR (g c)) * K) by ring. rewrite <- (Rmult_0_l K) at 1.
    symmetry. rewrite (Rmult_comm _ K), (Rmult_comm 0 K), (Rmult_comm (share s - IZR (g c)) K). rewrite RmaxRmult by lra.
    reflexivity. }
  set (psi_s := IZR B * (D * su) * IZR (q_of s) + (su * IZR A + IZR (on_volume (of_sample x)) * IZR (per_factor c)) *
    (share s * K)
                - IZR (on_excess (of_sample x)) * su * Rmax 0 (share s * K - IZR (g c) * K)) in *.
  assert (left_side x j ((c, v) :: vs) (s :: l') * (D * su) =
          left_side x (Pos.succ j) vs l' * (D * su) -
          ((IZR (at_shares r') - IZR (on_shares (of_sample x))) * (P_of s / M) +
           (IZR (at_counts r') - IZR (on_counts (of_sample x))) * IZR (N_of s)) * (D * su) + psi_s +
          ((IZR A - IZR (on_shares (of_sample x))) * (P / M) + (IZR B - IZR (on_counts (of_sample x))) * IZR N) * (D * su))
            as Step.
  { unfold left_side. cbn [pairs_from combine map Spec.total fold_right fst sum]. rewrite Ep. cbn [fst snd].
    fold (Spec.total (map part l')). fold (sum (map q_of l')).
    fold (Spec.total (map (fun '(cv, s) => part s * IZR (per_factor (fst cv)) / su) (combine vs l'))).
    fold (Spec.total (map (fun '(cv, s) => Rmax 0 (share s - IZR (g (fst cv))) / su) (combine vs l'))).
    fold (part_passing s). change (P_of s / M) with (part_passing s). rewrite Epp, EN. subst psi_s A B.
    rewrite Er, Es, !plus_IZR, ED. field. lra. }
  rewrite Step, plus_IZR. split; [lra|]. intro Eq. rewrite I2, C2 by lra. reflexivity.
Qed.

(* Theorem 20 (b). *)
Theorem window_sound ks : rules_out pr t (bounds_of_shares pr) e ks = true -> False.
Proof.
  intro H. unfold rules_out in H. destruct (add_conditions pr t e ks nothing_said) as [x|] eqn:Ax; [|discriminate].
  pose proof (add_conditions_fine ks _ _ nothing_fine Ax) as Fx.
  assert (0 <= on_excess (of_sample x))%Z as Ex.
  { assert (forall ks x0, (0 <= on_excess (of_sample x0))%Z -> add_conditions pr t e ks x0 = Some x ->
      (0 <= on_excess (of_sample x))%Z) as G.
    { clear. induction ks as [|k ks IH]; intros x0 P H; cbn [add_conditions] in H; [injection H as <-; exact P|].
      destruct (add_condition pr t e x0 k) as [z|] eqn:E; [|discriminate]. apply (IH z); [|exact H]. clear - P E.
      unfold add_condition in E. destruct (Z.leb_spec (times_m k) 0) as [|Kp]; [discriminate|].
      assert (forall y, (condition_of_all pr (letter k) = Some y -> 0 <= on_excess y)%Z) as Of.
      { intros y. unfold condition_of_all. repeat (destruct (_ =? _)%char; [intros [= <-]; cbn; lia|]).
        destruct (_ =? _)%char; [|discriminate]. destruct (bound pr); [intros [= <-]; cbn; lia | discriminate]. }
      assert (option_map (fun y => Tally (up_to_class x0) (add_terms (times_m k) (of_sample x0) y))
        (condition_of_all pr (letter k)) = Some z ->
              (0 <= on_excess (of_sample z))%Z) as All.
      { destruct (condition_of_all pr (letter k)) as [y|]; [|discriminate]. intros [= <-]. specialize (Of y eq_refl). cbn.
        nia. }
      destruct (of_class k) as [|i|i]; [exact (All E)| |exact (All E)].
      destruct (up_to k) as [|j|j]; [exact (All E)| |exact (All E)].
      destruct (PositiveMap.find j t); [|discriminate]. destruct (j <? i)%positive; [discriminate|].
      destruct (i =? j)%positive.
      - destruct (condition_of_passing _ _); [|discriminate]. injection E as <-. cbn. lia.
      - destruct (condition_of_counts _ _ _ _); [|discriminate]. injection E as <-. cbn. lia. }
    apply (G ks nothing_said); [cbn; lia | exact Ax]. }
  pose proof (views_fair (classes_of pr) (bounds_of_shares pr) ss 1 classes_ascend (sat_classes _ _ solves) shares_bounded
    ltac:(trivial)) as Vf.
  set (vs := views pr w e 1 (classes_of pr) (bounds_of_shares pr)) in *.
  assert (map fst vs = classes_of pr) as Ev.
  { subst vs. assert (forall cs bs l j, Forall2 (meets pr M) cs l -> Forall2 (fun b s => within b (share s)) bs l ->
      map fst (views pr w e j cs bs) = cs) as Fst.
    { induction cs as [|c cs IH]; intros bs l j Me Sb; inversion Me; subst; inversion Sb; subst; cbn [views map fst];
        [reflexivity|].
      f_equal. eapply IH; eassumption. }
    exact (Fst _ _ ss _ (sat_classes _ _ solves) shares_bounded). }
  clearbody vs. apply orb_prop in H as [H|H].
  { apply existsb_exists in H as ((c, v) & I & Em). clear - Vf I Em.
    induction Vf as [|(c', v') s vs l V Vf IH]; [destruct I|].
    destruct I as [[= -> ->]|I]; [|exact (IH I)]. destruct V as (_ & _ & V & _). apply has_count_spec in V.
    unfold is_empty in Em.
    destruct (greatest v) as [n|]; [|discriminate]. apply Z.ltb_lt in Em. lia. }
  destruct (greatest_of_all pr (units pr w) x 1 vs) as [r|] eqn:Gr; [|discriminate]. cbv zeta in H.
  destruct (greatest_of_all_sound x Ex vs ss 1 0 0 0 (classes_of pr) r Ev Vf (sat_sums _ _ solves) Gr) as (G1 & G2).
  pose proof mass_positive as Mp. pose proof (IZR_lt _ _ scale_positive) as Kp.
  assert (D = su * K) as ED by (unfold units; rewrite mult_IZR; reflexivity).
  assert (0 < D) as Dp by (rewrite ED; apply Rmult_lt_0_compat; assumption).
  assert (forall z, z + ((IZR (at_shares r) - IZR (on_shares (of_sample x))) * (0 / M) +
    (IZR (at_counts r) - IZR (on_counts (of_sample x))) * IZR 0) * (D * su) = z) as Nothing by (intro; field; lra).
  cbv zeta in G1, G2. rewrite Nothing in G1, G2. clear Nothing.
  pose proof (den_positive (volume pr)) as Wd. set (wd := IZR (Zpos (Qden (volume pr)))) in *.
  set (y := of_sample x) in *.
  assert (IZR (right_side pr w y) = (IZR (on_volume y) * (Q2R (volume pr) * inverse_end) + IZR (right_of_shares y) / su +
    IZR (right_of_counts y)) * (D * su) * wd) as Er.
  { unfold right_side, inverse_end. cbv zeta. rewrite plus_IZR, mult_IZR, plus_IZR, !mult_IZR. fold wd.
    destruct (Z.ltb_spec 0 (S_num w)) as [P|P].
    - assert (u' = S_num w) as Eu by lia. pose proof (IZR_lt _ _ P) as Pr. rewrite !mult_IZR, (Q2R_num (volume pr)).
      fold wd.
      rewrite ED, mult_IZR, Eu. field. lra.
    - field. lra. }
  assert (left_side x 1 vs ss - IZR (on_volume y) * (Q2R (volume pr) * inverse_end) - IZR (right_of_shares y) / su -
    IZR (right_of_counts y) = tally_value x) as El.
  { unfold left_side, tally_value, value_of. fold y. rewrite parts_total. fold M.
    replace (M / M) with 1 by (field; lra). unfold volumes, excesses.
    assert (Spec.total (map (fun '(cv, s) => part s * IZR (per_factor (fst cv)) / su) (combine vs ss)) =
      all_volume pr ss / M) as ->.
    { unfold all_volume. rewrite <- Ev. clear. unfold part. generalize M as m. intro m. revert vs. generalize ss as l.
      induction l as [|s l IH]; intros [|cv vs]; cbn [combine map Spec.total fold_right]; try (unfold Rdiv; ring).
      fold (Spec.total (map (fun '(cv, s) => t_of s / m * IZR (per_factor (fst cv)) / su) (combine vs l))). rewrite IH.
      unfold Spec.total, Rdiv. ring. }
    assert (Spec.total (map (fun '(cv, s) => Rmax 0 (share s - IZR (g (fst cv))) / su) (combine vs ss)) =
            excess_of (combine (classes_of pr) ss) / su) as ->.
    { unfold excess_of. rewrite <- Ev. clear. generalize share as sh. intro sh. revert vs. generalize ss as l.
      induction l as [|s l IH]; intros [|cv vs]; cbn [combine map Spec.total fold_right]; try (unfold Rdiv; ring).
      fold (Spec.total (map (fun '(cv, s) => Rmax 0 (sh s - IZR (g (fst cv))) / su) (combine vs l))). rewrite IH.
      unfold Spec.total, Rdiv. ring. }
    ring. }
  assert (0 <= (left_side x 1 vs ss - IZR (on_volume y) * (Q2R (volume pr) * inverse_end) - IZR (right_of_shares y) / su -
    IZR (right_of_counts y)) * (D * su) * wd) as Le.
  { rewrite El. apply Rmult_le_pos; [apply Rmult_le_pos; [exact Fx|] | lra]. apply Rmult_le_pos; lra. }
  assert (IZR (right_side pr w y) <= left_side x 1 vs ss * (D * su) * wd) as Ge by (rewrite Er; lra).
  pose proof (Rmult_le_compat_r wd _ _ (Rlt_le _ _ Wd) G1) as G1'.
  apply orb_prop in H as [H|H].
  - apply Z.ltb_lt, IZR_lt in H. rewrite mult_IZR in H. fold wd in H. lra.
  - apply andb_prop in H as (Eq & Nh). apply Z.eqb_eq in Eq. apply (f_equal IZR) in Eq. rewrite mult_IZR in Eq.
    fold wd in Eq.
    rewrite G2 in Nh; [discriminate|]. apply (Rmult_eq_reg_r wd); lra.
Qed.

End Windows.
