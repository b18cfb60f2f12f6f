(* Theorem 5: an accepted chain proves a lower bound, and a whole one the least match. Integers only, no axioms. *)

From Coq Require Import ZArith List Bool Lia FMapPositive.
From Mdm Require Import Numbers NumbersFacts Chain.
Import ListNotations.
Open Scope Z_scope.

(* ---- The problem in integers ----------------------------------------------------------------------------- *)

Definition sound (j : bounds) : Prop := 0 <= m j /\ 1 <= r j /\ 0 <= f j < F j.

(* q particles of class j at the scale n/d, to the power b: q^b f/m < n/d <= q^b F/m. *)
Definition holds (b : Z) (scale : ratio) (j : bounds) (q : Z) : Prop :=
  let (n, d) := scale in
  (m j = 0 /\ q = 0) \/
  (0 < m j /\ r j <= q /\ q ^ b * f j * d < n * m j /\ n * m j <= q ^ b * F j * d).

Definition solution (b : Z) (js : list bounds) (qs : list Z) (scale : ratio) : Prop :=
  0 < fst scale /\ 0 < snd scale /\ Forall2 (holds b scale) js qs.

Definition feasible (b : Z) (js : list bounds) (qs : list Z) : Prop := exists scale, solution b js qs scale.

(* n is the least sum of counts. *)
Definition least_total (b : Z) (js : list bounds) (n : Z) : Prop :=
  (exists qs, feasible b js qs /\ sum qs = n) /\ forall qs, feasible b js qs -> n <= sum qs.

(* ---- One step ------------------------------------------------------------------------------------ *)

(* L < S, for fractions. *)
Definition under (L scale : ratio) : Prop := fst L * snd scale < fst scale * snd L.
Definition bound (L : ratio) : Prop := 0 <= fst L /\ 0 < snd L.

Local Arguments above : simpl never.

Section Steps.
Variable b : Z.
Hypothesis b_positive : 1 <= b.

Lemma above_floor L j : r j <= above b L j.
Proof. unfold above. destruct L. lia. Qed.

Lemma above_above L j :
  sound j -> bound L -> fst L * m j < above b L j ^ b * F j * snd L.
Proof.
  destruct L as (n, d). intros (M & R & Lo & Hi) (N & D). unfold above. simpl in *.
  set (y := n * m j / (d * F j)). assert (0 < d * F j) as P by nia.
  assert (0 <= y) as Y by (apply Z.div_pos; nia).
  assert (y < Z.max (r j) (root b y + 1) ^ b) as G by (apply root_lt; lia).
  pose proof (Z.div_mod (n * m j) (d * F j) ltac:(lia)) as E. fold y in E.
  pose proof (Z.mod_pos_bound (n * m j) (d * F j) P). nia.
Qed.

Lemma above_least L j q :
  sound j -> bound L -> r j <= q -> fst L * m j < q ^ b * F j * snd L -> above b L j <= q.
Proof.
  destruct L as (n, d). intros (M & R & Lo & Hi) (N & D) Q H. unfold above. simpl in *.
  set (y := n * m j / (d * F j)). assert (0 < d * F j) as P by nia.
  assert (0 <= y) as Y by (apply Z.div_pos; nia).
  assert (y < q ^ b) as G by (apply Z.div_lt_upper_bound; nia).
  apply root_lt in G; lia.
Qed.

(* Every solution above L has the count above(j, L) at least, and its scale is above that count's level. *)
Lemma forced L scale j q :
  sound j -> 0 < m j -> bound L -> 0 < snd scale -> under L scale -> holds b scale j q ->
  above b L j <= q /\ under (above b L j ^ b * f j, m j) scale.
Proof.
  destruct L as (n, d), scale as (s, e). unfold under, bound; simpl. intros W M (N & D) E U [(Z & _)|(_ & R & Lo & Hi)]; [lia|].
  assert (above b (n, d) j <= q) as A.
  { apply above_least; simpl; try assumption; [split; assumption|].
    apply (Z.mul_lt_mono_pos_r e); [exact E|].
    assert (n * e * m j < s * d * m j) by (apply Z.mul_lt_mono_pos_r; assumption).
    assert (s * m j * d <= q ^ b * F j * e * d) by (apply Z.mul_le_mono_nonneg_r; lia). lia. }
  split; [exact A|].
  assert (above b (n, d) j ^ b <= q ^ b) as B.
  { apply Z.pow_le_mono_l. pose proof (above_floor (n, d) j). destruct W as (_ & ? & _). lia. }
  destruct W as (_ & _ & F0 & _).
  assert (above b (n, d) j ^ b * (f j * e) <= q ^ b * (f j * e)) by (apply Z.mul_le_mono_nonneg_r; nia).
  lia.
Qed.

Lemma level_bound L j : sound j -> 0 < m j -> bound (above b L j ^ b * f j, m j).
Proof.
  intros (_ & R & Lo & _) M. split; simpl; [|exact M].
  pose proof (above_floor L j). apply Z.mul_nonneg_nonneg; [apply Z.pow_nonneg|]; lia.
Qed.

(* ---- The replay ---------------------------------------------------------------------------------- *)

Lemma find_in js : forall j0 t j c,
  find j (number_from j0 js t) = Some c -> In c js \/ find j t = Some c.
Proof.
  induction js as [|x js IH]; intros j0 t j c H; simpl in *; [right; exact H|].
  apply IH in H as [H|H]; [left; right; exact H|].
  destruct j as [|p|p]; try discriminate. simpl in *.
  destruct (Pos.eq_dec p j0) as [->|N].
  - rewrite PositiveMap.gss in H. injection H as <-. left; left; reflexivity.
  - rewrite PositiveMap.gso in H by exact N. right; exact H.
Qed.

Lemma find_numbered js j c : find j (number_from 1 js (PositiveMap.empty bounds)) = Some c -> In c js.
Proof.
  intro H. apply find_in in H as [H|H]; [exact H|].
  destruct j as [|p|p]; try discriminate. simpl in H. rewrite PositiveMap.gempty in H. discriminate.
Qed.

Lemma Forall2_In {A B} (P : A -> B -> Prop) xs ys x : Forall2 P xs ys -> In x xs -> exists y, P x y.
Proof. induction 1; intros []; subst; eauto. Qed.

Lemma replay_bound t js B chain : forall L L',
  Forall sound js -> (forall j c, find j t = Some c -> In c js) -> bound L ->
  replay b B t L chain = Ok L' -> bound L'.
Proof.
  induction chain as [|j chain IH]; intros L L' W T Bd H; simpl in H; [injection H as <-; exact Bd|].
  destruct (find j t) as [c|] eqn:E; [|discriminate]. destruct (Z.eqb_spec (m c) 0); [discriminate|].
  destruct (above b L c <=? B); [|discriminate].
  assert (sound c) as Wc by (rewrite Forall_forall in W; apply W; eauto).
  apply IH in H; trivial. apply level_bound; [exact Wc|]. destruct Wc. lia.
Qed.

Lemma replay_under t js B scale qs chain : forall L L',
  Forall sound js -> (forall j c, find j t = Some c -> In c js) -> bound L -> solution b js qs scale ->
  under L scale -> replay b B t L chain = Ok L' -> under L' scale.
Proof.
  induction chain as [|j chain IH]; intros L L' W T Bd S U H; simpl in H; [injection H as <-; exact U|].
  destruct (find j t) as [c|] eqn:E; [|discriminate]. destruct (Z.eqb_spec (m c) 0); [discriminate|].
  destruct (above b L c <=? B); [|discriminate].
  assert (sound c) as Wc by (rewrite Forall_forall in W; apply W; eauto).
  assert (0 < m c) as M by (destruct Wc; lia).
  apply IH in H; trivial; [apply level_bound; assumption|].
  destruct S as (_ & D & S). destruct (Forall2_In _ _ _ _ S (T _ _ E)) as (q & Q).
  eapply forced; eassumption.
Qed.

(* ---- Soundness ----------------------------------------------------------------------------------- *)

Lemma solution_counts js qs scale L :
  Forall sound js -> bound L -> solution b js qs scale -> under L scale -> Forall2 Z.le (map (least b L) js) qs.
Proof.
  intros W B (_ & D & S) U. induction S as [|j q js qs H _ IH]; inversion W; subst; simpl; constructor; auto.
  unfold least. destruct (Z.eqb_spec (m j) 0) as [E|E].
  - destruct scale. simpl in H. destruct H as [(_ & ->)|(? & _)]; lia.
  - eapply forced; try eassumption. destruct H2. lia.
Qed.

(* A scale above L that none of the counts above(j, L) forbids. *)
Lemma some_scale js L :
  Forall sound js -> bound L ->
  exists scale, 0 < fst scale /\ 0 < snd scale /\ under L scale /\
    Forall (fun j => 0 < m j -> fst scale * m j <= above b L j ^ b * F j * snd scale) js.
Proof.
  intros W B. induction W as [|j js Wj W (s & P & D & U & A)].
  { exists (fst L + snd L, snd L). destruct L as (n, d). unfold under, bound in *; simpl in *.
    repeat split; [nia | nia | nia | constructor]. }
  destruct (Z_le_gt_dec (m j) 0) as [M|M].
  { exists s. repeat split; trivial. constructor; [lia | exact A]. }
  pose proof (above_above L j Wj B) as G. destruct s as (n, d). destruct L as (ln, ld).
  unfold under, bound in *; simpl in *.
  destruct (Z_le_gt_dec (n * m j) (above b (ln, ld) j ^ b * F j * d)) as [C|C].
  - exists (n, d). simpl. repeat split; try assumption. constructor; [intros _; exact C | exact A].
  - exists (above b (ln, ld) j ^ b * F j, m j). simpl. repeat split.
    + nia.
    + lia.
    + lia.
    + constructor; [lia|]. eapply Forall_impl; [|exact A]. intros x X Mx. specialize (X Mx). simpl in X.
      apply (Z.mul_le_mono_pos_r _ _ d); [exact D|].
      assert (above b (ln, ld) j ^ b * F j * d * m x <= n * m j * m x) by (apply Z.mul_le_mono_nonneg_r; lia).
      assert (n * m x * m j <= above b (ln, ld) x ^ b * F x * d * m j) by (apply Z.mul_le_mono_nonneg_r; lia).
      lia.
Qed.

Lemma closed_feasible js L :
  Forall sound js -> bound L -> forallb (closed b L) js = true -> feasible b js (map (least b L) js).
Proof.
  intros W B C. destruct (some_scale js L W B) as (s & P & D & U & A).
  exists s. repeat split; trivial. rewrite forallb_forall in C.
  assert (forall j, In j js -> holds b s j (least b L j)) as H.
  { intros j I. rewrite Forall_forall in W, A. specialize (W j I). specialize (A j I). specialize (C j I).
    destruct s as (n, d), L as (ln, ld). unfold least, holds, under in *; simpl in *.
    destruct (Z.eqb_spec (m j) 0) as [E|E]; [left; auto|right].
    destruct W as (M & R & Lo & Hi). simpl in C. apply Z.leb_le in C.
    pose proof (above_floor (ln, ld) j) as G. destruct B; simpl in *.
    assert (0 < m j) as Mp by lia. repeat split; try lia; try (apply A; lia).
    assert (0 < ld) by lia. nia. }
  clear -H. induction js as [|j js IH]; simpl; constructor; [apply H; left; reflexivity|].
  apply IH. intros; apply H; right; assumption.
Qed.

(* No match has fewer than the counts of an accepted chain in any class; those of a whole chain are a match. *)
Theorem chain_counts B whole js chain :
  Forall sound js -> check_chain b B whole js chain = Ok tt ->
  exists qs, sum qs = B /\ (whole = true -> feasible b js qs) /\ forall qs', feasible b js qs' -> Forall2 Z.le qs qs'.
Proof.
  intros W H. unfold check_chain in H. passed H. passed H. passed H. apply Z.eqb_eq in H. rename x into L.
  assert (bound (0, 1)) as B0 by (split; simpl; lia).
  assert (bound L) as Bd by (eapply replay_bound; [exact W | apply find_numbered | exact B0 | exact H0]).
  exists (map (least b L) js). split; [exact H|]. split; [intros ->; apply closed_feasible; assumption|].
  intros qs (s & S). eapply solution_counts; trivial; [exact S|].
  eapply replay_under; [exact W | apply find_numbered | exact B0 | exact S | | exact H0].
  destruct S as (P & _). unfold under. simpl. lia.
Qed.

(* Theorem 5 (a): no match has fewer particles than the bound of an accepted chain, also of one that is cut off. *)
Theorem chain_bound B whole js chain :
  Forall sound js -> check_chain b B whole js chain = Ok tt -> forall qs, feasible b js qs -> B <= sum qs.
Proof.
  intros W H qs Q. destruct (chain_counts B whole js chain W H) as (ms & <- & _ & A). apply sum_le. auto.
Qed.

(* The counts of an accepted whole chain are a match, and the least in every class. *)
Theorem chain_least N js chain :
  Forall sound js -> check_chain b N true js chain = Ok tt ->
  exists qs, sum qs = N /\ feasible b js qs /\ forall qs', feasible b js qs' -> Forall2 Z.le qs qs'.
Proof.
  intros W H. destruct (chain_counts N true js chain W H) as (qs & E & Q & A). exists qs. auto.
Qed.

(* Theorem 5 (b): an accepted whole chain's N is the least number of particles. *)
Theorem chain_sound N js chain :
  Forall sound js -> check_chain b N true js chain = Ok tt -> least_total b js N.
Proof.
  intros W H. destruct (chain_least N js chain W H) as (qs & E & Q & A).
  split; [exists qs; auto|]. intros qs' Q'. subst N. apply sum_le. auto.
Qed.

Lemma sum_eq xs ys : Forall2 Z.le xs ys -> sum ys = sum xs -> ys = xs.
Proof.
  induction 1 as [|x y xs ys H T IH]; simpl; intro E; [reflexivity|].
  pose proof (sum_le _ _ T). assert (x = y) by lia. subst. f_equal. apply IH. lia.
Qed.

(* Theorem 2 (b): the match with the least number is unique. *)
Theorem chain_unique N js chain :
  Forall sound js -> check_chain b N true js chain = Ok tt ->
  exists qs, feasible b js qs /\ sum qs = N /\ forall qs', feasible b js qs' -> sum qs' = N -> qs' = qs.
Proof.
  intros W H. destruct (chain_least N js chain W H) as (qs & E & Q & A).
  exists qs. repeat split; trivial. intros qs' Q' E'. apply sum_eq; [auto | congruence].
Qed.

(* ---- Starts are floors (Theorem 6) and at least M particles (Theorem 7) -------------------------- *)

Definition set_floor (j : bounds) (floor : Z) : bounds := Bounds (f j) (F j) (m j) floor.

(* A solution above z has the counts above(j, z). *)
Theorem open_start z scale j q :
  sound j -> bound z -> 0 < snd scale -> under z scale -> holds b scale j q ->
  holds b scale (set_floor j (above b z j)) q.
Proof.
  intros W B D U H. pose proof H as H'. destruct scale as (n, d). simpl in *.
  destruct H as [(M & Q)|(M & R & Lo & Hi)]; [left; auto|right].
  repeat split; trivial. eapply (forced z (n, d)); eassumption.
Qed.

(* No class holds more than h_j at scales up to z: with a sum of at least M the scale is above z. *)
Theorem above_sound M z js qs scale :
  Forall sound js -> 0 < fst z -> 0 < snd z -> check_above b M z js = Ok tt -> solution b js qs scale -> M <= sum qs ->
  under z scale.
Proof.
  intros W Zn Zd H (P & D & S) Q. unfold check_above in H. passed H. passed H. apply Z.ltb_lt in H.
  destruct (Z_lt_le_dec (fst z * snd scale) (fst scale * snd z)) as [U|U]; [exact U|exfalso].
  assert (sum qs <= sum (map (most_below b z) js)) as L; [|lia].
  apply sum_le. clear -W Zn Zd D U H0 S b_positive.
  induction S as [|j q js qs H T IH]; simpl in *; constructor; inversion W; subst;
    apply andb_prop in H0 as (Hj & H0); auto.
  destruct z as (zn, zd), scale as (n, d). unfold most_below; simpl in *.
  destruct (Z.eqb_spec (m j) 0) as [E|E]; [destruct H as [(_ & ->)|(? & _)]; lia|].
  destruct H as [(? & _)|(Mj & R & Lo & Hi)]; [lia|].
  simpl in Hj. apply Z.ltb_lt in Hj. destruct H3 as (_ & R1 & _).
  assert (q ^ b * f j * zd < zn * m j) as K by nia.
  set (y := (zn * m j - 1) / (zd * f j)).
  assert (0 <= y) as Y by (apply Z.div_pos; nia).
  destruct (Z_le_gt_dec q (root b y)) as [|G]; [assumption|exfalso].
  assert (y < q ^ b) as X by (apply root_lt; lia).
  pose proof (Z.div_mod (zn * m j - 1) (zd * f j) ltac:(nia)) as V. fold y in V.
  pose proof (Z.mod_pos_bound (zn * m j - 1) (zd * f j) ltac:(nia)). nia.
Qed.

End Steps.
