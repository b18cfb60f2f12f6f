(* A class in a window: nothing that it can have adds more to a sum than the greatest value of the counts and shares that
   are looked at, and as much only if the checker says so (Theorem 20 (c) and (d)). *)

From Coq Require Import ZArith Reals List Bool Lia Lra.
From Mdm Require Import Numbers Leaf Windows.
Import ListNotations.
Open Scope R_scope.

(* ---- Between two counts -------------------------------------------------------------------------- *)

(* A straight line is at most its values at both ends; where it comes up to them it is level. *)
Lemma straight k s q1 q q2 V :
  q1 < q < q2 -> k + s * q1 <= V -> k + s * q2 <= V -> k + s * q <= V /\ (k + s * q = V -> k + s * q1 = V).
Proof.
  intros (L & U) H1 H2. destruct (Rtotal_order s 0) as [S|[->|S]]; [|lra|].
  - pose proof (Rmult_lt_compat_l (- s) q1 q ltac:(lra) L). lra.
  - pose proof (Rmult_lt_compat_l s q q2 S U). lra.
Qed.

(* The shares from low to high that q particles can have, each more than a and at most b of them; 0 for b: any. *)
Definition region (a b low high q y : R) : Prop := low <= y /\ a * q <= y /\ y <= high /\ (0 < b -> y <= b * q).

(* Between two counts the ends are straight. What is linear in both is nowhere above its values at the two counts; where
   it comes up to them, it does so at the first one too, and not at an end that is that of a or b. *)
Lemma region_between a b low high e c k V q1 q q2 y :
  0 <= a -> 0 <= b -> 1 <= q1 -> q1 < q < q2 ->
  low <= a * q1 \/ a * q2 <= low /\ a * q1 < low ->
  (0 < b -> high < b * q1 \/ b * q2 <= high) ->
  a * q2 <= high -> (0 < b -> low < b * q1) ->
  low <= y <= high -> a * q < y -> (0 < b -> y < b * q) ->
  (forall z, region a b low high q1 z -> e * q1 + c * z + k <= V) ->
  (forall z, region a b low high q2 z -> e * q2 + c * z + k <= V) ->
  e * q + c * y + k <= V /\
  (e * q + c * y + k = V ->
   exists z, region a b low high q1 z /\ a * q1 < z /\ (0 < b -> z < b * q1) /\ e * q1 + c * z + k = V).
Proof.
  intros A B Q1 (Q & Q') Lo Hi A2 Lb (Y1 & Y2) Ya Yb H1 H2. unfold region in *.
  assert (a * q1 <= a * q) as Aq by (apply Rmult_le_compat_l; lra).
  assert (0 < b -> a * q1 < b * q1 /\ a * q2 < b * q2 /\ b * q1 < b * q2) as AB.
  { intro B0. specialize (Yb B0). assert (a < b) as L by (apply (Rmult_lt_reg_r q); lra).
    repeat split; [apply Rmult_lt_compat_r | apply Rmult_lt_compat_r | apply Rmult_lt_compat_l]; lra. }
  assert ((0 < b -> high < b * q1) \/ 0 < b /\ b * q2 <= high) as Hi'.
  { destruct (Rle_lt_dec b 0) as [B0|B0]; [left; lra|]. destruct (Hi B0); auto. }
  clear Hi.
  (* The upper end, and the lower one, from q1 to q2. *)
  assert (forall z1 z2 s, (low <= z1 /\ a * q1 <= z1 /\ z1 <= high /\ (0 < b -> z1 <= b * q1)) ->
            (low <= z2 /\ a * q2 <= z2 /\ z2 <= high /\ (0 < b -> z2 <= b * q2)) ->
            (exists z0, z1 = z0 + s * q1 /\ z2 = z0 + s * q2) ->
            let z := z1 + s * (q - q1) in
            e * q + c * z + k <= V /\ (e * q + c * z + k = V -> e * q1 + c * z1 + k = V)) as Along.
  { intros z1 z2 s R1 R2 (z0 & -> & ->). specialize (H1 _ R1). specialize (H2 _ R2). cbv zeta.
    destruct (straight (c * z0 + k) (e + c * s) q1 q q2 V ltac:(lra) ltac:(lra) ltac:(lra)) as (S1 & S2).
    split; [lra|]. intro E. rewrite <- S2; lra. }
  assert (forall z, low <= z <= high -> a * q2 <= z -> (0 < b -> z <= b * q1) ->
            e * q + c * z + k <= V /\ (e * q + c * z + k = V -> e * q1 + c * z + k = V)) as Level.
  { intros z R R2 Rb. assert (a * q <= a * q2) by (apply Rmult_le_compat_l; lra).
    destruct (Along z z 0) as (L1 & L2).
    - lra.
    - lra.
    - exists z. lra.
    - split; [lra|]. intro E. apply L2. lra. }
  assert (0 < b -> b * q2 <= high ->
            e * q + c * (b * q) + k <= V /\ (e * q + c * (b * q) + k = V -> e * q1 + c * (b * q1) + k = V)) as Upper.
  { intros B0 Bh. destruct (AB B0) as (S1 & S2 & S3). specialize (Lb B0).
    destruct (Along (b * q1) (b * q2) b) as (L1 & L2); [lra | lra | exists 0; lra|].
    replace (b * q1 + b * (q - q1)) with (b * q) in * by ring. auto. }
  assert (low <= a * q1 ->
            e * q + c * (a * q) + k <= V /\ (e * q + c * (a * q) + k = V -> e * q1 + c * (a * q1) + k = V)) as Lower.
  { intro La. assert (a * q <= a * q2) by (apply Rmult_le_compat_l; lra).
    destruct (Along (a * q1) (a * q2) a) as (L1 & L2).
    - lra.
    - lra.
    - exists 0. lra.
    - replace (a * q1 + a * (q - q1)) with (a * q) in * by ring. auto. }
  destruct (Rtotal_order c 0) as [C|[->|C]].
  - (* The lower end is the greatest. *)
    destruct Lo as [La|(La & La')].
    + destruct (Lower La) as (L1 & _). pose proof (Rmult_lt_compat_l (- c) (a * q) y ltac:(lra) Ya). lra.
    + destruct (Level low ltac:(lra) La ltac:(lra)) as (L1 & L2).
      destruct (Req_dec y low) as [->|N].
      * split; [exact L1|]. intro E. exists low. lra.
      * pose proof (Rmult_lt_compat_l (- c) low y ltac:(lra) ltac:(lra)). lra.
  - (* All shares have the same value. *)
    destruct Lo as [La|(La & La')].
    + destruct (Lower La) as (L1 & L2). split; [lra|]. intro E. specialize (L2 ltac:(lra)).
      destruct Hi' as [Hc|(B0 & Hb)].
      * exists high. lra.
      * destruct (AB B0) as (S1 & S2 & S3). exists ((a * q1 + b * q1) / 2). lra.
    + destruct (Level low ltac:(lra) La ltac:(lra)) as (L1 & L2).
      split; [lra|]. intro E. specialize (L2 ltac:(lra)). exists low. lra.
  - (* The upper end is the greatest. *)
    destruct Hi' as [Hc|(B0 & Hb)].
    + destruct (Level high ltac:(lra) A2 ltac:(lra)) as (L1 & L2).
      destruct (Req_dec y high) as [->|N].
      * split; [exact L1|]. intro E. exists high. lra.
      * pose proof (Rmult_lt_compat_l c y high C ltac:(lra)). lra.
    + destruct (Upper B0 Hb) as (L1 & _). specialize (Yb B0). pose proof (Rmult_lt_compat_l c y (b * q) C Yb). lra.
Qed.

(* ---- One class ----------------------------------------------------------------------------------- *)

(* The counts of a view leave room for a share: fewer have not the least share, more have too much. *)
Record fair (v : view) : Prop := {
  fair_ends : (0 <= low_one v /\ 0 <= high_one v)%Z;
  fair_fewest : (0 <= fewest v /\ (0 < l v -> 1 <= fewest v /\ (0 < high_one v -> l v < high_one v * fewest v)))%Z;
  fair_greatest :
    match greatest v with
    | Some n => (h v <= 0 -> n <= 0) /\ (0 < h v -> 0 < low_one v -> low_one v * n < h v)
    | None => 0 < h v /\ low_one v = 0
    end%Z }.

(* The class has q particles with the share y. *)
Definition has_point (v : view) (q : Z) (y : R) : Prop :=
  q = 0%Z /\ y = 0 \/
  (1 <= q)%Z /\ IZR (l v) <= y <= IZR (h v) /\ IZR (low_one v) * IZR q < y /\
  (0 < IZR (high_one v) -> y < IZR (high_one v) * IZR q).

Definition psi (v : view) (w : weights) (q : Z) (y : R) : R :=
  IZR (per_count w) * IZR q + IZR (per_share w) * y - IZR (per_excess w) * Rmax 0 (y - IZR (target v)).

Section Class.
Variables (v : view) (w : weights).
Hypothesis v_fair : fair v.
Hypothesis excess_counts : (0 <= per_excess w)%Z.

Notation a := (IZR (low_one v)).
Notation b := (IZR (high_one v)).
Notation g := (IZR (target v)).

Lemma value_real q y : IZR (value_at v w q y) = psi v w q (IZR y).
Proof.
  unfold value_at, psi. rewrite minus_IZR, plus_IZR, !mult_IZR. do 2 f_equal.
  unfold Rmax. rewrite <- minus_IZR. destruct (Rle_dec 0 (IZR (y - target v))) as [L|L].
  - apply le_IZR in L. rewrite Z.max_r by exact L. reflexivity.
  - rewrite Z.max_l; [reflexivity|]. apply Z.nlt_ge. intro G. apply L, IZR_le. lia.
Qed.

Lemma psi_below q y : y <= g -> psi v w q y = IZR (per_count w) * IZR q + IZR (per_share w) * y + 0.
Proof. intro L. unfold psi. rewrite Rmax_left by lra. ring. Qed.
Lemma psi_above q y : g <= y ->
  psi v w q y = IZR (per_count w) * IZR q + (IZR (per_share w) - IZR (per_excess w)) * y + IZR (per_excess w) * g.
Proof. intro L. unfold psi. rewrite Rmax_right by lra. ring. Qed.
Lemma psi_without q y : per_excess w = 0%Z -> psi v w q y = IZR (per_count w) * IZR q + IZR (per_share w) * y + 0.
Proof. intro E. unfold psi. rewrite E. ring. Qed.

(* ---- One count ----------------------------------------------------------------------------------- *)

Notation low q := (Z.max (l v) (q * low_one v)).
Notation high q := (if (0 <? high_one v)%Z then Z.min (h v) (q * high_one v) else h v)%Z.

Lemma low_real q : IZR (l v) <= IZR (low q) /\ a * IZR q <= IZR (low q) /\
  (IZR (low q) = IZR (l v) \/ IZR (low q) = a * IZR q).
Proof.
  rewrite <- mult_IZR, (Z.mul_comm (low_one v)). split; [apply IZR_le; lia|]. split; [apply IZR_le; lia|].
  destruct (Z.max_spec (l v) (q * low_one v)) as [(_ & ->)|(_ & ->)]; auto.
Qed.

Lemma high_real q : IZR (high q) <= IZR (h v) /\ (0 < b -> IZR (high q) <= b * IZR q) /\
  (IZR (high q) = IZR (h v) \/ 0 < b /\ IZR (high q) = b * IZR q).
Proof.
  rewrite <- mult_IZR, (Z.mul_comm (high_one v)). destruct (Z.ltb_spec 0 (high_one v)) as [B|B].
  - apply IZR_lt in B. split; [apply IZR_le; lia|]. split; [intros _; apply IZR_le; lia|].
    destruct (Z.min_spec (h v) (q * high_one v)) as [(_ & ->)|(_ & ->)]; auto.
  - apply IZR_le in B. repeat split; try lra; auto.
Qed.

Lemma points_of q : q <> 0%Z ->
  (exists has, In (value_at v w q (low q), has) (points v w q) /\
     (((q * low_one v < l v) \/ (low q < high q /\
       (per_share w = 0 /\ (per_excess w = 0 \/ high q <= target v) \/
         per_share w = per_excess w /\ target v <= low q)))%Z ->
      has = true)) /\
  (exists has, In (value_at v w q (high q), has) (points v w q) /\
     ((high_one v <= 0 \/ h v < q * high_one v)%Z -> has = true)) /\
  ((low q < target v < high q)%Z -> In (value_at v w q (target v), true) (points v w q)).
Proof.
  intro N. unfold points. rewrite (proj2 (Z.eqb_neq _ _) N). cbv zeta. split; [|split].
  - eexists. split; [left; reflexivity|]. intros [L|(L & F)].
    + rewrite (proj2 (Z.ltb_lt _ _) L). reflexivity.
    + apply orb_true_intro. right. rewrite (proj2 (Z.ltb_lt _ _) L). cbn [andb].
      destruct F as [(-> & [->|F])|(-> & F)].
      * reflexivity.
      * rewrite (proj2 (Z.leb_le _ _) F), orb_true_r. reflexivity.
      * rewrite Z.eqb_refl, (proj2 (Z.leb_le _ _) F). apply orb_true_r.
  - eexists. split; [right; left; reflexivity|]. intros [L|L].
    + rewrite (proj2 (Z.ltb_ge _ _) L). reflexivity.
    + rewrite (proj2 (Z.ltb_lt _ _) L). apply orb_true_r.
  - intros (L & U). rewrite (proj2 (Z.ltb_lt _ _) L), (proj2 (Z.ltb_lt _ _) U). cbn [andb]. right. right. left. reflexivity.
Qed.

Section Count.
Variable V : Z.

(* At a count whose points are at most V, so is every share between the ends. *)
Lemma one_count q y :
  (1 <= q)%Z -> (forall x has, In (x, has) (points v w q) -> (x <= V)%Z) ->
  region a b (IZR (l v)) (IZR (h v)) (IZR q) y -> psi v w q y <= IZR V.
Proof.
  intros Q P (Y1 & Y2 & Y3 & Y4). destruct (points_of q ltac:(lia)) as ((h1 & I1 & _) & (h2 & I2 & _) & I3).
  apply P, IZR_le in I1, I2. rewrite value_real in I1, I2.
  destruct (low_real q) as (_ & _ & L). destruct (high_real q) as (_ & _ & H).
  assert (IZR (low q) <= y) as Ly by (destruct L as [->| ->]; lra).
  assert (y <= IZR (high q)) as Hy by (destruct H as [->|(B & ->)]; auto).
  assert (IZR (low q) < g -> g < IZR (high q) -> psi v w q g <= IZR V) as Between.
  { intros L' H'. apply lt_IZR in L', H'. specialize (I3 (conj L' H')). apply P, IZR_le in I3. rewrite value_real in I3.
    exact I3. }
  apply (IZR_le 0) in excess_counts. clear L H Y1 Y2 Y3 Y4 I3 P.
  set (lo := IZR (low q)) in *. set (hi := IZR (high q)) in *. set (c := IZR (per_share w)) in *.
  set (m := IZR (per_excess w)) in *.
  destruct (Rle_lt_dec y g) as [G|G].
  - rewrite psi_below by exact G. rewrite (psi_below q lo) in I1 by lra.
    destruct (Rle_lt_dec hi g) as [K|K].
    + rewrite (psi_below q hi) in I2 by exact K. fold c in I1, I2 |- *.
      destruct (Rle_lt_dec 0 c); [pose proof (Rmult_le_compat_l c y hi ltac:(lra) Hy); lra|].
      pose proof (Rmult_le_compat_l (- c) lo y ltac:(lra) Ly). lra.
    + destruct (Rle_lt_dec g lo) as [E|E]; [replace y with lo by lra; exact I1|].
      specialize (Between E K). rewrite psi_below in Between by lra. fold c in I1, Between |- *.
      destruct (Rle_lt_dec 0 c); [pose proof (Rmult_le_compat_l c y g ltac:(lra) G); lra|].
      pose proof (Rmult_le_compat_l (- c) lo y ltac:(lra) Ly). lra.
  - rewrite psi_above by lra. rewrite (psi_above q hi) in I2 by lra.
    destruct (Rle_lt_dec g lo) as [K|K].
    + rewrite (psi_above q lo) in I1 by exact K. fold c m in I1, I2 |- *.
      destruct (Rle_lt_dec 0 (c - m)); [pose proof (Rmult_le_compat_l (c - m) y hi ltac:(lra) Hy); lra|].
      pose proof (Rmult_le_compat_l (- (c - m)) lo y ltac:(lra) Ly). lra.
    + specialize (Between K ltac:(lra)). rewrite psi_above in Between by lra. fold c m in I2, Between |- *.
      destruct (Rle_lt_dec 0 (c - m)); [pose proof (Rmult_le_compat_l (c - m) y hi ltac:(lra) Hy); lra|].
      pose proof (Rmult_le_compat_l (- (c - m)) g y ltac:(lra) ltac:(lra)). lra.
Qed.

Lemma nothing_held : psi v w 0 0 <= 0.
Proof.
  unfold psi. apply (IZR_le 0) in excess_counts. pose proof (Rmult_le_pos _ _ excess_counts (Rmax_l 0 (0 - g))). lra.
Qed.

(* If a share that the class has comes up to V, one of the points says so. *)
Lemma one_count_has q y :
  (forall x has, In (x, has) (points v w q) -> (x <= V)%Z) ->
  has_point v q y -> psi v w q y = IZR V -> In (V, true) (points v w q).
Proof.
  intros P [(-> & ->)|(Q & (Y1 & Y3) & Y2 & Y4)] E.
  { left. f_equal. pose proof (P 0%Z true (or_introl eq_refl)). pose proof nothing_held as N. rewrite E in N.
    apply le_IZR in N. lia. }
  destruct (points_of q ltac:(lia)) as ((h1 & I1 & T1) & (h2 & I2 & T2) & I3).
  destruct (low_real q) as (_ & _ & L). destruct (high_real q) as (_ & _ & H).
  assert (IZR (low q) <= y) as Ly by (destruct L as [->| ->]; lra).
  assert (y <= IZR (high q)) as Hy by (destruct H as [->|(B & ->)]; [lra | specialize (Y4 B); lra]).
  (* A point that is known to have y's value. *)
  assert (forall z, In (value_at v w q z, true) (points v w q) -> psi v w q (IZR z) = IZR V ->
    In (V, true) (points v w q)) as Same.
  { intros z I Ez. rewrite <- value_real in Ez. apply eq_IZR in Ez. rewrite <- Ez. exact I. }
  assert (psi v w q (IZR (low q)) <= IZR V /\ psi v w q (IZR (high q)) <= IZR V) as (J1 & J2).
  { split; rewrite <- value_real; apply IZR_le; eapply P; eassumption. }
  assert (IZR (low q) < g -> g < IZR (high q) -> psi v w q g <= IZR V /\ (psi v w q g = IZR V ->
    In (V, true) (points v w q))) as Between.
  { intros L' H'. apply lt_IZR in L', H'. specialize (I3 (conj L' H')). split; [|apply Same, I3].
    rewrite <- value_real. apply IZR_le. eapply P, I3. }
  (* y is an end that is not open. *)
  destruct (Req_dec y (IZR (low q))) as [Yl|Yl].
  { destruct L as [Ll|Ll]; [|lra]. apply (Same (low q)); [|rewrite <- Yl; exact E].
    rewrite T1 in I1; [exact I1|]. left. apply lt_IZR. rewrite mult_IZR. lra. }
  destruct (Req_dec y (IZR (high q))) as [Yh|Yh].
  { apply (Same (high q)); [|rewrite <- Yh; exact E]. rewrite T2 in I2; [exact I2|].
    destruct (Z_le_gt_dec (high_one v) 0) as [B|B]; [left; exact B | right]. apply Z.gt_lt in B.
    apply IZR_lt in B. specialize (Y4 B). apply lt_IZR. rewrite mult_IZR. destruct H as [H|(_ & H)]; lra. }
  assert (IZR (low q) < IZR (high q)) as LH by lra.
  assert (forall f : (per_share w = 0 /\ (per_excess w = 0 \/ high q <= target v) \/
      per_share w = per_excess w /\ target v <= low q)%Z,
            psi v w q (IZR (low q)) = IZR V -> In (V, true) (points v w q)) as Flat.
  { intros f Ez. apply (Same (low q)); [|exact Ez]. rewrite T1 in I1; [exact I1|]. right.
    split; [apply lt_IZR, LH | exact f]. }
  clear I1 I2 I3 T1 T2 L H Same P.
  set (lo := IZR (low q)) in *. set (hi := IZR (high q)) in *.
  destruct (Rle_lt_dec y g) as [G|G].
  - rewrite psi_below in E by exact G. rewrite (psi_below q lo) in J1, Flat by lra.
    assert (IZR (per_share w) = 0 -> In (V, true) (points v w q)) as Level.
    { intro C. destruct (Rle_lt_dec hi g) as [K|K].
      - apply Flat; [left; split; [apply eq_IZR, C | right; apply le_IZR, K]|]. rewrite C in *. lra.
      - apply (Between ltac:(lra) K). rewrite psi_below by lra. rewrite C in *. lra. }
    destruct (Rtotal_order (IZR (per_share w)) 0) as [C|[C|C]]; [|exact (Level C)|].
    + pose proof (Rmult_lt_compat_l (- IZR (per_share w)) lo y ltac:(lra) ltac:(lra)). lra.
    + destruct (Rle_lt_dec hi g) as [K|K].
      * rewrite psi_below in J2 by exact K. pose proof (Rmult_lt_compat_l _ y hi C ltac:(lra)). lra.
      * destruct (Between ltac:(lra) K) as (B1 & B2). rewrite psi_below in B1, B2 by lra.
        destruct (Req_dec y g) as [Yg|Yg]; [apply B2; rewrite Yg in E; exact E|].
        pose proof (Rmult_lt_compat_l _ y g C ltac:(lra)). lra.
  - rewrite psi_above in E by lra. rewrite (psi_above q hi) in J2 by lra.
    set (c := IZR (per_share w) - IZR (per_excess w)) in *.
    assert (c = 0 -> In (V, true) (points v w q)) as Level.
    { intro C. assert (per_share w = per_excess w) as Ce by (apply eq_IZR; subst c; lra).
      destruct (Rle_lt_dec g lo) as [K|K].
      - apply Flat; [right; split; [exact Ce | apply le_IZR, K]|]. rewrite psi_above by exact K. fold c. rewrite C in *.
        lra.
      - apply (Between K ltac:(lra)). rewrite psi_above by lra. fold c. rewrite C in *. lra. }
    destruct (Rtotal_order c 0) as [C|[C|C]]; [|exact (Level C)|].
    + destruct (Rle_lt_dec g lo) as [K|K].
      * rewrite psi_above in J1 by exact K. fold c in J1. pose proof (Rmult_lt_compat_l (- c) lo y ltac:(lra) ltac:(lra)).
        lra.
      * destruct (Between K ltac:(lra)) as (B1 & _). rewrite psi_above in B1 by lra. fold c in B1.
        pose proof (Rmult_lt_compat_l (- c) g y ltac:(lra) ltac:(lra)). lra.
    + pose proof (Rmult_lt_compat_l c y hi C ltac:(lra)). lra.
Qed.

End Count.

(* ---- All counts ---------------------------------------------------------------------------------- *)

Lemma nearest_below (cs : list Z) (q : Z) : forall x, In x cs -> (x < q)%Z ->
  exists q1, In q1 cs /\ (q1 < q)%Z /\ forall z, In z cs -> (z < q)%Z -> (z <= q1)%Z.
Proof.
  induction cs as [|c cs IH]; intros x I L; [destruct I|].
  assert ((exists x', In x' cs /\ (x' < q)%Z) \/ forall z, In z cs -> (z < q)%Z -> False) as [(x' & I' & L')|N].
  { clear. induction cs as [|z cs [(x' & I & L)|N]]; [right; intros ? [] | left; eauto using in_cons|].
    destruct (Z_lt_le_dec z q) as [L|L]; [left; exists z; split; [left; reflexivity | exact L]|].
    right. intros z' [<-|I]; [lia | apply N, I]. }
  - destruct (IH x' I' L') as (q1 & I1 & L1 & M). destruct (Z_lt_le_dec c q) as [Lc|Lc], (Z_lt_le_dec q1 c) as [L1c|L1c].
    + exists c. split; [left; reflexivity|]. split; [exact Lc|]. intros z [<-|Iz] Lz; [lia | specialize (M z Iz Lz); lia].
    + exists q1. split; [right; exact I1|]. split; [exact L1|]. intros z [<-|Iz] Lz; [lia | exact (M z Iz Lz)].
    + exists q1. split; [right; exact I1|]. split; [exact L1|]. intros z [<-|Iz] Lz; [lia | exact (M z Iz Lz)].
    + exists q1. split; [right; exact I1|]. split; [exact L1|]. intros z [<-|Iz] Lz; [lia | exact (M z Iz Lz)].
  - destruct I as [->|I]; [|contradiction (N x I L)]. exists x. split; [left; reflexivity|]. split; [exact L|].
    intros z [<-|Iz] Lz; [lia | contradiction (N z Iz Lz)].
Qed.

Lemma nearest_above (cs : list Z) (q : Z) :
  (forall z, In z cs -> (z <= q)%Z) \/ exists q2, In q2 cs /\ (q < q2)%Z /\ forall z, In z cs -> (q < z)%Z -> (q2 <= z)%Z.
Proof.
  induction cs as [|c cs [N|(q2 & I & L & M)]]; [left; intros ? []| |].
  - destruct (Z_lt_le_dec q c) as [L|L]; [right; exists c | left; intros z [<-|I]; auto].
    split; [left; reflexivity|]. split; [exact L|]. intros z [<-|I] Lz; [lia | specialize (N z I); lia].
  - right. destruct (Z_lt_le_dec q c) as [Lc|Lc], (Z_lt_le_dec c q2) as [L2|L2].
    + exists c. split; [left; reflexivity|]. split; [exact Lc|]. intros z [<-|I'] Lz; [lia | specialize (M z I' Lz); lia].
    + exists q2. split; [right; exact I|]. split; [exact L|]. intros z [<-|I'] Lz; [lia | exact (M z I' Lz)].
    + exists q2. split; [right; exact I|]. split; [exact L|]. intros z [<-|I'] Lz; [lia | exact (M z I' Lz)].
    + exists q2. split; [right; exact I|]. split; [exact L|]. intros z [<-|I'] Lz; [lia | exact (M z I' Lz)].
Qed.

Lemma best_of ps : forall V has, best ps = Some (V, has) ->
  forall x r, In (x, r) ps -> (x <= V)%Z /\ (x = V -> r = true -> has = true).
Proof.
  assert (forall ps p x r, In (x, r) (p :: ps) ->
    (x <= fst (fold_left better ps p))%Z /\ (x = fst (fold_left better ps p) -> r = true ->
      snd (fold_left better ps p) = true)) as B.
  { clear. induction ps as [|p' ps IH]; intros p x r I; cbn [fold_left].
    - destruct I as [->|[]]. cbn. split; [lia | trivial].
    - assert (forall x r, (x, r) = p \/ (x, r) = p' -> exists r', (x < fst (better p p'))%Z \/ x = fst (better p p') /\
        r' = snd (better p p') /\ (r = true -> r' = true)) as K.
      { clear. intros x r H. unfold better. destruct p as (x1, r1), p' as (x2, r2). cbn [fst snd].
        exists (snd (better (x1, r1) (x2, r2))). unfold better. cbn [fst snd].
        destruct (Z.ltb_spec x1 x2), (Z.ltb_spec x2 x1); cbn [fst snd]; destruct H as [[= -> ->]|[= -> ->]];
          try (left; lia); try (right; split; [lia|]; split; [reflexivity|]; intros ->; rewrite ?orb_true_r; reflexivity).
        all: try lia. all: right; split; [lia|]; split; [reflexivity | trivial]. }
      destruct I as [E|[E|I]]; [| |apply IH; right; exact I].
      all: destruct (K x r ltac:(auto)) as (r' & [Lt|(-> & -> & T)]).
      all: destruct (IH (better p p') (fst (better p p')) (snd (better p p'))) as (A1 & A2);
        [left; destruct (better p p'); reflexivity|].
      all: split; [lia|]; intros Ev Er; try lia; auto. }
  intros V has H x r I. destruct ps as [|p ps]; [discriminate|]. cbn [best] in H. injection H as H.
  specialize (B ps p x r I). rewrite H in B. exact B.
Qed.

Notation cs := (candidates v w).

Lemma candidate x : has_count v x = true ->
  (x = fewest v \/ greatest v = Some x \/ x = 1%Z \/ In x (around (h v) (high_one v)) \/ In x (around (l v) (low_one v)) \/
   (0 < per_excess w)%Z /\ (In x (around (target v) (high_one v)) \/ In x (around (target v) (low_one v)))) -> In x cs.
Proof.
  intros H C. unfold candidates. apply filter_In. split; [|exact H]. destruct C as [->|C]; [left; reflexivity|]. right.
  apply in_or_app. destruct C as [->|C]; [left; left; reflexivity|]. right. cbn [app].
  destruct C as [->|C]; [left; reflexivity|]. right. rewrite !in_app_iff. destruct C as [C|[C|(M & C)]]; auto.
  right. right. rewrite (proj2 (Z.ltb_lt _ _) M), in_app_iff. exact C.
Qed.

Lemma candidate_counts x : In x cs -> has_count v x = true.
Proof. intro I. apply filter_In in I. apply I. Qed.

Lemma has_count_spec x : has_count v x = true <->
  (fewest v <= x)%Z /\ match greatest v with Some n => (x <= n)%Z | None => True end.
Proof.
  unfold has_count. destruct (greatest v); rewrite andb_true_iff, Z.leb_le; [rewrite Z.leb_le|]; tauto.
Qed.

Lemma count_between x z q : has_count v x = true -> has_count v z = true -> (x <= q <= z)%Z -> has_count v q = true.
Proof. rewrite !has_count_spec. intros (A & B) (C & D) L. split; [lia|]. destruct (greatest v); [lia | exact I]. Qed.

(* Where the share of one particle is [one], no count between q1 and q2 has the share. *)
Lemma no_break share one q1 q q2 :
  (forall x, In x (around share one) -> has_count v x = true -> In x cs) -> (0 < one)%Z ->
  In q1 cs -> In q2 cs -> (q1 < q < q2)%Z ->
  (forall z, In z cs -> (z < q -> z <= q1)%Z) -> (forall z, In z cs -> (q < z -> q2 <= z)%Z) -> ~ In q cs ->
  (share < one * q1 \/ one * q2 <= share)%Z.
Proof.
  intros A P I1 I2 L B1 B2 N. unfold around in A. rewrite (proj2 (Z.ltb_lt _ _) P) in A.
  pose proof (Z.mul_div_le share one P) as D1. pose proof (Z.mul_succ_div_gt share one P) as D2.
  set (u := (share / one)%Z) in *. rewrite <- Z.add_1_r in D2.
  destruct (Z_lt_le_dec u q1) as [U1|U1]; [left; nia|]. destruct (Z_lt_le_dec u q2) as [U2|U2]; [exfalso | right; nia].
  pose proof (count_between q1 q2 u (candidate_counts _ I1) (candidate_counts _ I2) ltac:(lia)) as H1.
  pose proof (count_between q1 q2 (u + 1) (candidate_counts _ I1) (candidate_counts _ I2) ltac:(lia)) as H2.
  apply A in H1; [|left; reflexivity]. apply A in H2; [|right; left; reflexivity].
  pose proof (B1 _ H1). pose proof (B2 _ H1). pose proof (B1 _ H2). pose proof (B2 _ H2).
  assert (u <> q) by congruence. assert (u + 1 <> q)%Z by congruence. lia.
Qed.

(* The view leaves room. *)
Lemma room q : has_count v q = true -> (1 <= q)%Z -> (0 < h v)%Z ->
  (0 < b -> IZR (l v) < b * IZR q) /\ a * IZR q <= IZR (h v).
Proof.
  intros H Q P. apply has_count_spec in H as (H1 & H2). destruct v_fair as [(A & B) (F0 & F) G].
  rewrite <- !mult_IZR. split.
  - intro B0. apply lt_IZR in B0. apply IZR_lt. destruct (Z_lt_le_dec 0 (l v)) as [L|L]; [|nia].
    destruct (F L) as (_ & F2). specialize (F2 B0). nia.
  - apply IZR_le. destruct (greatest v) as [n|]; [|lia]. destruct G as (_ & G).
    destruct (Z_lt_le_dec 0 (low_one v)) as [A0|A0]; [specialize (G P A0); nia | nia].
Qed.

Variables (V : Z) (has : bool).
Hypothesis found : greatest_value v w = Some (V, has).

Lemma at_candidates q : In q cs -> forall x r, In (x, r) (points v w q) -> (x <= V)%Z /\ (x = V -> r = true -> has = true).
Proof.
  intros I x r P. assert (best (flat_map (points v w) cs) = Some (V, has)) as E.
  { unfold greatest_value in found. destruct (greatest v); [exact found|].
    destruct (0 <? per_count w)%Z; [discriminate | exact found]. }
  apply (best_of _ _ _ E). apply in_flat_map. eauto.
Qed.

Lemma candidate_sound q y : In q cs -> has_point v q y -> psi v w q y <= IZR V /\ (psi v w q y = IZR V -> has = true).
Proof.
  intros I H. pose proof (at_candidates q I) as P.
  assert (forall x r, In (x, r) (points v w q) -> (x <= V)%Z) as P1 by (intros x r Ix; apply (P x r Ix)). split.
  - destruct H as [(-> & ->)|(Q & (Y1 & Y2) & Y3 & Y4)].
    + pose proof nothing_held. pose proof (IZR_le _ _ (P1 0%Z true (or_introl eq_refl))). lra.
    + apply one_count; [exact Q | exact P1|]. unfold region. lra.
  - intro E. apply (P V true); trivial. apply (one_count_has V q y P1 H E).
Qed.

(* Theorem 20 (c) and (d), for one class. *)
Theorem class_sound q y :
  has_count v q = true -> has_point v q y -> psi v w q y <= IZR V /\ (psi v w q y = IZR V -> has = true).
Proof.
  intros H Pt. destruct (in_dec Z.eq_dec q cs) as [I|N]; [exact (candidate_sound q y I Pt)|].
  destruct v_fair as [(A & B) (F0 & F) G].
  pose proof (proj1 (has_count_spec q) H) as (H1 & H2).
  assert (In (fewest v) cs) as If.
  { apply candidate; [|auto]. apply has_count_spec. split; [lia|]. destruct (greatest v); [lia | exact I]. }
  assert (fewest v < q)%Z as Lf by (assert (fewest v <> q) by congruence; lia).
  destruct (nearest_below cs q _ If Lf) as (q1 & I1 & L1 & B1). pose proof (candidate_counts _ I1) as C1.
  pose proof (proj1 (proj1 (has_count_spec q1) C1)) as F1.
  assert (1 <= q1)%Z as Q1.
  { destruct (Z_lt_le_dec (fewest v) 1) as [L|L]; [|specialize (B1 _ If Lf); lia].
    assert (In 1%Z cs) as J by (apply candidate; [apply has_count_spec; split; [lia|]; destruct (greatest v);
      [lia | exact I] | auto]).
    apply B1; [exact J|]. assert (q <> 1%Z) by congruence. lia. }
  destruct Pt as [(E & _)|(Q & (Y1 & Y2) & Y3 & Y4)]; [lia|].
  pose proof (IZR_le _ _ A) as Ar. pose proof (IZR_le _ _ B) as Br. pose proof (IZR_le _ _ Q1) as Q1r.
  pose proof (IZR_lt _ _ L1) as L1r.
  assert (a * IZR q1 <= a * IZR q) as Aq by (apply Rmult_le_compat_l; lra).
  assert (0 <= a * IZR q1) as A0 by (apply Rmult_le_pos; lra).
  assert (0 < h v)%Z as Hp by (apply lt_IZR; lra).
  destruct (room q1 C1 Q1 Hp) as (R1 & R1').
  destruct (nearest_above cs q) as [None_|(q2 & I2 & L2 & B2)].
  - (* Nothing is looked at beyond q1: more particles add nothing. *)
    destruct (greatest v) as [n|] eqn:Eg.
    { exfalso. assert (In n cs) as In_ by (apply candidate; [apply has_count_spec; rewrite Eg; lia | auto]).
      specialize (None_ n In_). assert (n = q) by lia. congruence. }
    destruct G as (_ & Az). rewrite Az in *. assert (per_count w <= 0)%Z as Ec.
    { unfold greatest_value in found. rewrite Eg in found.
      destruct (Z.ltb_spec 0 (per_count w)); [discriminate | assumption]. }
    assert (0 < b -> IZR (h v) < b * IZR q1) as Hb.
    { intro B0. apply lt_IZR in B0. rewrite <- mult_IZR. apply IZR_lt.
      pose proof (Z.mul_succ_div_gt (h v) (high_one v) B0) as D. set (u := (h v / high_one v)%Z) in *.
      destruct (Z_lt_le_dec u q1) as [U|U]; [nia|]. exfalso.
      assert (In (u + 1)%Z cs) as J.
      { apply candidate; [apply has_count_spec; rewrite Eg; split; [lia | exact I]|]. right. right. right. left.
        unfold around. rewrite (proj2 (Z.ltb_lt _ _) B0). right. left. reflexivity. }
      pose proof (None_ _ J). assert (u + 1 <> q)%Z by congruence. specialize (B1 _ J). lia. }
    destruct (candidate_sound q1 y I1) as (S1 & S2).
    { right. rewrite Az. repeat split; lra || lia. }
    assert (psi v w q y = psi v w q1 y + IZR (per_count w) * (IZR q - IZR q1)) as E by (unfold psi; ring).
    apply IZR_le in Ec. pose proof (Rmult_le_compat_l (- IZR (per_count w)) 0 (IZR q - IZR q1) ltac:(lra) ltac:(lra)).
    split; [lra|]. intro Ev. apply S2. lra.
  - pose proof (candidate_counts _ I2) as C2. pose proof (IZR_lt _ _ L2) as L2r.
    destruct (room q2 C2 ltac:(lia) Hp) as (_ & R2).
    assert (forall z, region a b (IZR (l v)) (IZR (h v)) (IZR q1) z -> psi v w q1 z <= IZR V) as V1.
    { intros z Rz. apply (one_count V); trivial. intros x r Ix. apply (at_candidates q1 I1 x r Ix). }
    assert (forall z, region a b (IZR (l v)) (IZR (h v)) (IZR q2) z -> psi v w q2 z <= IZR V) as V2.
    { intros z Rz. apply (one_count V); [lia| |exact Rz]. intros x r Ix. apply (at_candidates q2 I2 x r Ix). }
    assert (forall z, IZR (l v) <= z <= IZR (h v) -> a * IZR q1 < z -> (0 < b -> z < b * IZR q1) -> psi v w q1 z = IZR V ->
      has = true) as Has.
    { intros z Z1 Z2 Z3 Ez. apply (candidate_sound q1 z I1); [|exact Ez]. right. repeat split; trivial; apply Z1. }
    assert (forall share one, (forall x, In x (around share one) -> has_count v x = true -> In x cs) -> (0 <= one)%Z ->
              0 < IZR one -> IZR share < IZR one * IZR q1 \/ IZR one * IZR q2 <= IZR share) as Break.
    { intros share one Ca _ P. apply lt_IZR in P. rewrite <- !mult_IZR.
      destruct (no_break share one q1 q q2 Ca P I1 I2 ltac:(lia) B1 B2 N) as [K|K];
        [left; apply IZR_lt, K | right; apply IZR_le, K]. }
    pose proof (Break (h v) (high_one v) ltac:(intros; apply candidate; tauto) B) as Bh.
    pose proof (Break (l v) (low_one v) ltac:(intros; apply candidate; tauto) A) as Bl.
    (* The kind of a lower end. *)
    assert (forall low, (0 < a -> low < a * IZR q1 \/ a * IZR q2 <= low) -> low <= a * IZR q1 \/ a * IZR q2 <= low /\
      a * IZR q1 < low) as Kind.
    { intros low K. destruct (Req_dec a 0) as [->|Na]; [lra|]. specialize (K ltac:(lra)).
      pose proof (Rmult_lt_compat_l a (IZR q1) (IZR q2) ltac:(lra) ltac:(lra)). lra. }
    destruct (Z.eq_dec (per_excess w) 0) as [M|M].
    + destruct (region_between a b (IZR (l v)) (IZR (h v)) (IZR (per_count w)) (IZR (per_share w)) 0 (IZR V)
        (IZR q1) (IZR q) (IZR q2) y) as (S1 & S2);
        trivial; try lra; auto.
      * intros z Rz. rewrite <- psi_without by exact M. auto.
      * intros z Rz. rewrite <- psi_without by exact M. auto.
      * rewrite psi_without by exact M. split; [exact S1|]. intro E.
        destruct (S2 E) as (z & (Z1 & _ & Z2 & _) & Z3 & Z4 & Ez).
        apply (Has z); auto. rewrite psi_without by exact M. exact Ez.
    + assert (0 < per_excess w)%Z as Mp by lia.
      pose proof (Break (target v) (high_one v) ltac:(intros; apply candidate; tauto) B) as Bgh.
      pose proof (Break (target v) (low_one v) ltac:(intros; apply candidate; tauto) A) as Bgl.
      destruct (Rle_lt_dec y g) as [Yg|Yg].
      * assert (Rmin (IZR (h v)) g = IZR (h v) /\ IZR (h v) <= g \/ Rmin (IZR (h v)) g = g /\ g <= IZR (h v)) as Mn
          by (unfold Rmin; destruct (Rle_dec (IZR (h v)) g); lra).
        assert (a * IZR q2 <= g) as Ag by (destruct (Req_dec a 0) as [Za|Na];
          [rewrite Za in *; lra | specialize (Bgl ltac:(lra)); lra]).
        destruct (region_between a b (IZR (l v)) (Rmin (IZR (h v)) g) (IZR (per_count w)) (IZR (per_share w)) 0 (IZR V)
          (IZR q1) (IZR q) (IZR q2) y) as (S1 & S2);
          trivial; try lra; auto.
        -- clear Bh Bl Bgh Bgl Kind. unfold region. intros z Rz. rewrite <- psi_below by lra. apply V1. unfold region. lra.
        -- clear Bh Bl Bgh Bgl Kind. unfold region. intros z Rz. rewrite <- psi_below by lra. apply V2. unfold region. lra.
        -- clear Bh Bl Bgh Bgl Kind. rewrite psi_below by exact Yg. split; [exact S1|]. intro E.
           destruct (S2 E) as (z & (Z1 & _ & Z2 & _) & Z3 & Z4 & Ez).
           apply (Has z); trivial; [lra|]. rewrite psi_below by lra. exact Ez.
      * assert (Rmax (IZR (l v)) g = IZR (l v) /\ g <= IZR (l v) \/ Rmax (IZR (l v)) g = g /\ IZR (l v) <= g) as Mx
          by (unfold Rmax; destruct (Rle_dec (IZR (l v)) g); lra).
        assert (0 < b -> Rmax (IZR (l v)) g < b * IZR q1) as Gb.
        { intro B0. specialize (R1 B0). specialize (Y4 B0). specialize (Bgh B0).
          pose proof (Rmult_lt_compat_l b (IZR q) (IZR q2) B0 L2r). lra. }
        destruct (region_between a b (Rmax (IZR (l v)) g) (IZR (h v)) (IZR (per_count w)) (IZR (per_share w) - IZR
          (per_excess w))
                    (IZR (per_excess w) * g) (IZR V) (IZR q1) (IZR q) (IZR q2) y) as (S1 & S2);
          trivial; try lra; auto.
        -- apply Kind. intro Ap. specialize (Bl Ap). specialize (Bgl Ap). lra.
        -- clear Bh Bl Bgh Bgl Kind. unfold region. intros z Rz. rewrite <- psi_above by lra. apply V1. unfold region. lra.
        -- clear Bh Bl Bgh Bgl Kind. unfold region. intros z Rz. rewrite <- psi_above by lra. apply V2. unfold region. lra.
        -- clear Bh Bl Bgh Bgl Kind. rewrite psi_above by lra. split; [exact S1|]. intro E.
           destruct (S2 E) as (z & (Z1 & _ & Z2 & _) & Z3 & Z4 & Ez).
           apply (Has z); trivial; [lra|]. rewrite psi_above by lra. exact Ez.
Qed.

End Class.
