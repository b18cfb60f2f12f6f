(* An accepted leaf bounds the value in its box from below, or leaves no blend in it, and an accepted tree does in the whole box: Theorem
   22 (a) to (c), in rational numbers. *)

From Coq Require Import ZArith QArith Qabs Qminmax List Bool String Lia Lqa.
From Mdm Require Import Numbers NumbersFacts Rows SampleTally Blend BlendCertificate BlendSieves BlendCheck.
Import ListNotations.
Open Scope list_scope.
Open Scope Q_scope.

(* ---- Numbers in lowest terms ------------------------------------------------------------------------ *)

Lemma add_is x y : add x y == x + y. Proof. apply Qred_correct. Qed.
Lemma subtract_is x y : subtract x y == x - y. Proof. apply Qred_correct. Qed.
Lemma times_is x y : times x y == x * y. Proof. apply Qred_correct. Qed.
Lemma over_is x y : over x y == x / y. Proof. apply Qred_correct. Qed.
Lemma integer_is n : of_integer n == inject_Z n. Proof. reflexivity. Qed.

Ltac plain_numbers := repeat (rewrite ?add_is, ?subtract_is, ?times_is, ?over_is).

Lemma inject_positive n : (1 <= n)%Z -> 0 < inject_Z n.
Proof. intro L. change 0 with (inject_Z 0). rewrite <- Zlt_Qlt. lia. Qed.

Lemma inject_le n m : (n <= m)%Z -> inject_Z n <= inject_Z m.
Proof. rewrite <- Zle_Qle. auto. Qed.

(* ---- Sums over a blend ------------------------------------------------------------------------------ *)

Lemma weighted_sum_is ns : forall xs done, weighted_sum ns xs done == done + weighted ns xs.
Proof.
  induction ns as [|n ns IH]; intros [|x xs] done; simpl; try ring. rewrite IH. plain_numbers. rewrite integer_is. ring.
Qed.

Lemma mean_of_is M ns xs : mean_of M ns xs == mean M ns xs.
Proof. unfold mean_of, mean. plain_numbers. rewrite weighted_sum_is, integer_is, Qplus_0_l. reflexivity. Qed.

Lemma weighted_less_times ns : forall e m ps, List.length e = List.length ps ->
  weighted ns (less_times e m ps) == weighted ns e - m * weighted ns ps.
Proof.
  induction ns as [|n ns IH]; intros [|x e] m [|p ps] L; simpl in *; try discriminate L; try ring.
  rewrite IH by congruence. plain_numbers. ring.
Qed.

Lemma less_times_length e : forall m ps, List.length e = List.length ps -> List.length (less_times e m ps) = List.length e.
Proof. induction e as [|x e IH]; intros m [|p ps] L; simpl in *; try discriminate L; [reflexivity|]. rewrite IH; congruence. Qed.

Lemma mean_less_times M ns e m ps : List.length e = List.length ps ->
  mean M ns (less_times e m ps) == mean M ns e - m * mean M ns ps.
Proof. intro L. unfold mean. rewrite weighted_less_times by exact L. unfold Qdiv. ring. Qed.

Lemma weighted_zeros {A} ns (l : list A) : weighted ns (map (fun _ => 0%Q) l) == 0.
Proof. revert l. induction ns as [|n ns IH]; intros [|x l]; simpl; try reflexivity. rewrite IH. ring. Qed.

(* ---- Elements by number ----------------------------------------------------------------------------- *)

Lemma numbered_map {A B} (f : A -> B) l : forall j, numbered j (map f l) = option_map f (numbered j l).
Proof. induction l as [|x l IH]; intro j; simpl; [reflexivity|]. destruct (j =? 1)%Z; [reflexivity | apply IH]. Qed.

Lemma numbered_combine {A B} (l : list A) : forall (l' : list B) j x y,
  numbered j l = Some x -> numbered j l' = Some y -> numbered j (combine l l') = Some (x, y).
Proof.
  induction l as [|a l IH]; intros [|b l'] j x y H H'; simpl in *; try discriminate.
  destruct (j =? 1)%Z; [congruence | apply IH; assumption].
Qed.

Lemma numbered_in {A} (l : list A) : forall j x, numbered j l = Some x -> In x l.
Proof. induction l as [|a l IH]; intros j x; simpl; [discriminate|]. destruct (j =? 1)%Z; [intros [= ->]; auto | eauto]. Qed.

Lemma changed_length {A} j (f : A -> A) l : forall l', changed j f l = Some l' -> List.length l' = List.length l.
Proof.
  revert j. induction l as [|a l IH]; intros j l'; simpl; [discriminate|]. destruct (j =? 1)%Z; [intros [= <-]; reflexivity|].
  destruct (changed (j - 1) f l) as [l1|] eqn:E; [|discriminate]. intros [= <-]. simpl. rewrite (IH _ _ E). reflexivity.
Qed.

Lemma changed_forall {A} (P : A -> Prop) j (f : A -> A) l : (forall x, P x -> P (f x)) -> forall l', changed j f l = Some l' -> Forall P l -> Forall P l'.
Proof.
  intro Pf. revert j. induction l as [|a l IH]; intros j l'; simpl; [discriminate|]. intros E F. inversion F; subst.
  destruct (j =? 1)%Z; [injection E as <-; constructor; auto|].
  destruct (changed (j - 1) f l) as [l1|] eqn:E1; [|discriminate]. injection E as <-. constructor; eauto.
Qed.

(* ---- Boxes ------------------------------------------------------------------------------------------ *)

Definition holds (bounds : Z * Z) (n : Z) : Prop := (fst bounds <= n <= snd bounds)%Z.
Definition in_box (b : box) (ns : blend) : Prop := Forall2 holds b ns.

Lemma box_length b : forall ns, in_box b ns -> List.length b = List.length ns.
Proof. unfold in_box. induction b as [|x b IH]; intros ns F; inversion F; subst; simpl; [reflexivity|]. f_equal. auto. Qed.

Lemma is_in_box_is b : forall ns, is_in_box b ns = true <-> in_box b ns.
Proof.
  unfold in_box. induction b as [|(lo, hi) b IH]; intros [|n ns]; simpl; split; intro H; try discriminate; try constructor;
    try (inversion H; fail).
  - destruct ((lo <=? n) && (n <=? hi))%Z eqn:E; [|discriminate]. apply andb_prop in E as (E1 & E2). unfold holds. simpl. lia.
  - destruct ((lo <=? n) && (n <=? hi))%Z; [apply IH, H | discriminate].
  - inversion H as [|? ? ? ? (A & B) C]; subst. simpl in A, B. apply Z.leb_le in A, B. rewrite A, B. apply IH, C.
Qed.

Lemma changed_keeps b : forall j f b' ns, changed j f b = Some b' -> in_box b ns ->
  exists n, numbered j ns = Some n /\ ((forall x, holds x n -> holds (f x) n) -> in_box b' ns).
Proof.
  unfold in_box. induction b as [|x b IH]; intros j f b' ns E F; simpl in E; [discriminate|].
  inversion F as [|? n ? ms H F']; subst. simpl. destruct (j =? 1)%Z.
  - injection E as <-. exists n. split; [reflexivity|]. intro K. constructor; auto.
  - destruct (changed (j - 1) f b) as [b1|] eqn:E1; [|discriminate]. injection E as <-.
    destruct (IH _ _ _ _ E1 F') as (m & N & K). exists m. split; [exact N|]. intro Kf. constructor; auto.
Qed.

Lemma changed_before b : forall j f b' ns, changed j f b = Some b' -> (forall x n, holds (f x) n -> holds x n) -> in_box b' ns ->
  in_box b ns /\ exists n x, numbered j ns = Some n /\ holds (f x) n.
Proof.
  unfold in_box. induction b as [|x b IH]; intros j f b' ns E S F; simpl in E; [discriminate|].
  simpl. destruct (j =? 1)%Z eqn:Ej.
  - injection E as <-. inversion F as [|? n ? ms H F']; subst. split; [constructor; auto|]. exists n, x. simpl. rewrite Ej. auto.
  - destruct (changed (j - 1) f b) as [b1|] eqn:E1; [|discriminate]. injection E as <-.
    inversion F as [|? n ? ms H F']; subst. destruct (IH _ _ _ _ E1 S F') as (G & m & y & N & K).
    split; [constructor; auto|]. exists m, y. simpl. rewrite Ej. auto.
Qed.

Lemma used_least_le b : forall ns, in_box b ns -> (used_least b <= used ns)%Z /\
  ((used ns <= used_least b)%Z -> Forall (fun n => (0 <= n)%Z) ns -> in_box (map without_others b) ns).
Proof.
  unfold in_box. induction b as [|(lo, hi) b IH]; intros ns F; inversion F as [|? n ? ms (H1 & H2) F']; subst; simpl in *.
  { split; [lia | constructor]. }
  destruct (IH _ F') as (A & B). destruct (Z.ltb_spec 0 lo), (Z.ltb_spec 0 n); try lia; (split; [lia|]); intros U P;
    inversion P as [|? ? P0 P']; subst; try (constructor; [|apply B; [lia | assumption]]); unfold holds, without_others;
    destruct (Z.eqb_spec lo 0); simpl; lia.
Qed.

Lemma sum_in_box b : forall ns, in_box b ns -> (sum (map fst b) <= sum_of_steps ns <= sum (map snd b))%Z.
Proof.
  unfold in_box. induction b as [|x b IH]; intros ns F; inversion F as [|? n ? ms (H1 & H2) F']; subst; simpl; [lia|].
  specialize (IH _ F'). unfold sum in *. lia.
Qed.

Lemma ordered_in_box b : forall ns, in_box b ns -> forallb (fun '(lo, hi) => (lo <=? hi)%Z) b = true.
Proof.
  unfold in_box. induction b as [|(lo, hi) b IH]; intros ns F; inversion F as [|? n ? ms (H1 & H2) F']; subst; simpl; [reflexivity|].
  rewrite (IH _ F'), andb_true_r. simpl in *. apply Z.leb_le. lia.
Qed.

(* No blend with at most K stockpiles is taken out of the box. *)
Lemma restricted_keeps M K b ns : in_box b ns -> Forall (fun n => (0 <= n)%Z) ns -> sum_of_steps ns = M ->
  (forall n, K = Some n -> (used ns <= n)%Z) -> exists b', restricted M K b = Some b' /\ in_box b' ns.
Proof.
  intros F P S U. destruct (used_least_le _ _ F) as (A & B). unfold restricted.
  set (b1 := if match K with Some K => (K =? used_least b)%Z | None => false end then map without_others b else b).
  assert (in_box b1 ns) as F1.
  { unfold b1. destruct K as [K|]; [|exact F]. destruct (Z.eqb_spec K (used_least b)); [|exact F]. apply B; [|exact P].
    specialize (U K eq_refl). lia. }
  assert (match K with Some K => (K <? used_least b)%Z | None => false end = false) as ->.
  { destruct K as [K|]; [|reflexivity]. specialize (U K eq_refl). apply Z.ltb_ge. lia. }
  cbv zeta. rewrite (ordered_in_box _ _ F1). pose proof (sum_in_box _ _ F1) as (L & H).
  rewrite (proj2 (Z.leb_le _ _)), (proj2 (Z.leb_le _ _)) by lia. exists b1. split; [reflexivity | exact F1].
Qed.

(* ---- The least sum (b) ------------------------------------------------------------------------------ *)

(* For each tau: the thresholds of the program are those with which the bound is greatest. *)
Lemma filled_to_below tau e : forall b ns done, List.length e = List.length b -> in_box b ns ->
  filled_to tau e b done <= done + weighted ns e - tau * inject_Z (sum_of_steps ns).
Proof.
  unfold in_box. induction e as [|x e IH]; intros [|(lo, hi) b] ns done L F; simpl in L; try discriminate L;
    inversion F as [|? n ? ms (H1 & H2) F']; subst; simpl in *.
  { change (inject_Z 0) with 0. lra. }
  eapply Qle_trans; [apply IH; [congruence | exact F']|]. rewrite inject_Z_plus.
  assert (inject_Z lo <= inject_Z n /\ inject_Z n <= inject_Z hi) as (N1 & N2) by (split; apply inject_le; assumption).
  destruct (less (subtract x tau) 0) eqn:E; [apply less_spec in E | apply less_false in E]; rewrite subtract_is in E;
    plain_numbers; rewrite integer_is; revert N1 N2; generalize (inject_Z n) (inject_Z lo) (inject_Z hi) (inject_Z (sum_of_steps ms));
    intros c l h r N1 N2.
  - pose proof (Qmult_le_0_compat (tau - x) (h - c) ltac:(lra) ltac:(lra)). lra.
  - pose proof (Qmult_le_0_compat (x - tau) (c - l) ltac:(lra) ltac:(lra)). lra.
Qed.

Lemma least_sum_below M e b ns : List.length e = List.length b -> in_box b ns -> sum_of_steps ns = M -> least_sum M e b <= weighted ns e.
Proof.
  intros L F S. unfold least_sum. eapply Qle_trans; [apply (filled_to_below _ _ _ ns); assumption|].
  plain_numbers. rewrite integer_is, S. lra.
Qed.

(* ---- Values of a blend ------------------------------------------------------------------------------ *)

Definition judged_deviations (M : Z) (js : list judged) (ts : list Q) (ns : blend) : list Q :=
  map (fun '(j, t) => Qabs (mean M ns (passing_judged j) - t)) (combine js ts).

Definition judged_value (M : Z) (a : aim) (js : list judged) (ns : blend) : Q :=
  match a with
  | NoAim => 0
  | Cost cs => mean M ns cs
  | Deviation ts => fold_right Qplus 0 (judged_deviations M js ts ns)
  | MaxDeviation ts => fold_right Qmax 0 (judged_deviations M js ts ns)
  | Squares ts => fold_right (fun d sum => d * d + sum) 0 (judged_deviations M js ts ns)
  end.

Lemma distance_is x y : distance x y == Qabs (x - y).
Proof.
  unfold distance. destruct (less x y) eqn:E; plain_numbers.
  - apply less_spec in E. rewrite Qabs_neg by lra. ring.
  - apply less_false in E. rewrite Qabs_pos by lra. reflexivity.
Qed.

Lemma larger_is x y : larger x y == Qmax x y.
Proof.
  unfold larger. destruct (less x y) eqn:E.
  - apply less_spec in E. rewrite Q.max_r by lra. reflexivity.
  - apply less_false in E. rewrite Q.max_l by lra. reflexivity.
Qed.

Lemma value_of_blend_is M a js ns : value_of_blend M a js ns == judged_value M a js ns.
Proof.
  assert (forall ts, Forall2 Qeq (deviations_of M js ts ns) (judged_deviations M js ts ns)) as D.
  { intro ts. unfold deviations_of, judged_deviations. induction (combine js ts) as [|(j, t) l IH]; simpl; constructor; [|exact IH].
    rewrite distance_is, mean_of_is. reflexivity. }
  destruct a as [|cs|ts|ts|ts]; simpl; [reflexivity | apply mean_of_is|..]; specialize (D ts);
    induction D as [|x y xs ys E D IH]; simpl; try reflexivity.
  - plain_numbers. rewrite E, IH. reflexivity.
  - rewrite larger_is, E, IH. reflexivity.
  - plain_numbers. rewrite E, IH. reflexivity.
Qed.

(* ---- What multipliers are worth (a) ------------------------------------------------------------------ *)

Definition worth_of (a : aim) (w d : Q) : Q := w * d - (if is_squares a then w * w / 4 else 0).

Fixpoint worth (a : aim) (ws ds : list Q) : Q :=
  match ws, ds with
  | w :: ws, d :: ds => worth_of a w d + worth a ws ds
  | _, _ => 0
  end.

Lemma worth_changed a f ws : forall ds j w d ws', numbered j ws = Some w -> numbered j ds = Some d -> changed j f ws = Some ws' ->
  worth a ws' ds == worth a ws ds - worth_of a w d + worth_of a (f w) d.
Proof.
  induction ws as [|x ws IH]; intros [|y ds] j w d ws' W D C; simpl in W, D, C; try discriminate.
  destruct (j =? 1)%Z.
  - injection W as ->. injection D as ->. injection C as <-. simpl. ring.
  - destruct (changed (j - 1) f ws) as [l|] eqn:E; [|discriminate]. injection C as <-. simpl.
    pose proof (IH ds _ w d l W D E) as K. rewrite K. ring.
Qed.

Lemma worth_zeros a {A} (l : list A) ds : worth a (map (fun _ => 0) l) ds == 0.
Proof.
  revert ds. induction l as [|x l IH]; intros [|d ds]; simpl; try reflexivity. rewrite IH. unfold worth_of.
  destruct (is_squares a); field.
Qed.

Lemma worth_of_each ws : forall ds, is_squares NoAim = false -> Forall (fun d => 0 <= d) ds -> Forall (fun w => 0 <= w) ws ->
  forallb (fun w => at_most w (of_integer 1)) ws = true -> forall a, is_squares a = false -> worth a ws ds <= fold_right Qplus 0 ds.
Proof.
  intros ds _. revert ds. induction ws as [|w ws IH]; intros ds D W B a A; simpl in *.
  { induction D as [|d ds P D IHd]; simpl; [apply Qle_refl | lra]. }
  apply andb_prop in B as (B1 & B). apply at_most_spec in B1. change (of_integer 1) with 1 in B1. inversion W; subst.
  destruct D as [|d ds P D]; simpl; [apply Qle_refl|]. specialize (IH ds D ltac:(assumption) B a A). unfold worth_of. rewrite A.
  pose proof (Qmult_le_0_compat (1 - w) d ltac:(lra) P). lra.
Qed.

Lemma greatest_from_0 ds : 0 <= fold_right Qmax 0 ds.
Proof. induction ds as [|d ds IH]; simpl; [apply Qle_refl|]. eapply Qle_trans; [exact IH | apply Q.le_max_r]. Qed.

Lemma worth_to_greatest a ws : is_squares a = false -> forall ds, Forall (fun w => 0 <= w) ws -> forall m, 0 <= m ->
  Forall (fun d => d <= m) ds -> worth a ws ds <= sum_in_lowest_terms ws * m.
Proof.
  intros A. induction ws as [|w ws IH]; intros ds W m P D; simpl; [lra|]. inversion W; subst. rewrite add_is.
  assert (0 <= sum_in_lowest_terms ws) as S.
  { clear -H2. induction H2 as [|x l X F IHs]; simpl; [apply Qle_refl|]. rewrite add_is. lra. }
  pose proof (Qmult_le_0_compat _ _ S P). pose proof (Qmult_le_0_compat w m ltac:(assumption) P).
  destruct D as [|d ds Hd D]; [lra|]. specialize (IH ds ltac:(assumption) m P D). unfold worth_of. rewrite A.
  pose proof (Qmult_le_0_compat w (m - d) ltac:(assumption) ltac:(lra)). lra.
Qed.

Lemma all_to_greatest ds : Forall (fun d => d <= fold_right Qmax 0 ds) ds.
Proof.
  induction ds as [|d ds IH]; simpl; constructor; [apply Q.le_max_l|]. eapply Forall_impl; [|exact IH]. simpl. intros x H.
  eapply Qle_trans; [exact H | apply Q.le_max_r].
Qed.

Lemma square_from_0 x : 0 <= x * x.
Proof.
  destruct (Qlt_le_dec x 0).
  - pose proof (Qmult_le_0_compat (- x) (- x) ltac:(lra) ltac:(lra)). lra.
  - apply Qmult_le_0_compat; assumption.
Qed.

Lemma worth_of_squares a ws : is_squares a = true -> forall ds, worth a ws ds <= fold_right (fun d sum => d * d + sum) 0 ds.
Proof.
  intro A. induction ws as [|w ws IH]; intros ds; simpl.
  { induction ds as [|d ds IHd]; simpl; [apply Qle_refl | pose proof (square_from_0 d); lra]. }
  destruct ds as [|d ds]; simpl; [apply Qle_refl|]. specialize (IH ds). unfold worth_of. rewrite A.
  pose proof (square_from_0 (d - w / 2)) as Sq.
  assert ((d - w / 2) * (d - w / 2) == d * d - w * d + w * w / 4) as E by field. rewrite E in Sq. lra.
Qed.

(* ---- Leaves ----------------------------------------------------------------------------------------- *)

Section Blend.
Variables (M : Z) (js : list judged) (ns : blend).
Hypothesis M_positive : (1 <= M)%Z.

Definition keeps (j : judged) : Prop := least_judged j <= mean M ns (passing_judged j) <= most_judged j.

Hypothesis of_each : Forall (fun j => List.length (passing_judged j) = List.length ns) js.
Hypothesis kept : Forall keeps js.

Definition stands (a : aim) (base : Q) (ts : list Q) (x : below) : Prop :=
  List.length (of_shares x) = List.length ns /\ Forall (fun w => 0 <= w) (weights x) /\
  constant x + mean M ns (of_shares x) <= base + worth a (weights x) (judged_deviations M js ts ns).

Lemma minus_is m : minus m == - m. Proof. reflexivity. Qed.

Lemma add_multiple_stands a base ts x m x' : stands a base ts x -> 0 < multiplier m -> add_multiple a js ts x m = Ok x' ->
  stands a base ts x'.
Proof.
  intros (L & W & B) P H. destruct x as [D e ws]. simpl in *. unfold add_multiple in H. cbv zeta in H.
  destruct (numbered (of_sieve m) js) as [j|] eqn:Ej; [|discriminate].
  pose proof (numbered_in _ _ _ Ej) as Ij. rewrite Forall_forall in of_each, kept.
  specialize (of_each j Ij). destruct (kept j Ij) as (K1 & K2). set (p := mean M ns (passing_judged j)) in *.
  assert (List.length e = List.length (passing_judged j)) as Le by congruence.
  set (m1 := multiplier m) in *.
  assert (forall sign, List.length (less_times e sign (passing_judged j)) = List.length ns) as Ll by
    (intro sign; rewrite less_times_length by exact Le; exact L).
  assert (forall sign, mean M ns (less_times e sign (passing_judged j)) == mean M ns e - sign * p) as Ml by
    (intro sign; apply mean_less_times; exact Le).
  assert (forall (sign : Q) (y : below), sign == m1 \/ sign == - m1 ->
    match numbered (of_sieve m) ts, numbered (of_sieve m) ws, changed (of_sieve m) (add m1) ws with
    | Some t, Some w, Some ws =>
      bind (demand (negb (is_squares a) || equal w 0) "multipliers of one side of a target alone"%string) (fun _ =>
      Ok (Below (if is_squares a then subtract (add D (times sign t)) (over (times m1 m1) (of_integer 4)) else add D (times sign t))
            (less_times e sign (passing_judged j)) ws))
    | _, _, _ => Refused "a multiplier of a target that is there"%string
    end = Ok y -> stands a base ts y) as Target.
  { intros sign y Sg Hy. destruct (numbered (of_sieve m) ts) as [t|] eqn:Et; [|discriminate].
    destruct (numbered (of_sieve m) ws) as [w|] eqn:Ew; [|discriminate].
    destruct (changed (of_sieve m) (add m1) ws) as [ws'|] eqn:Ec; [|discriminate].
    passed Hy. injection Hy as <-. unfold stands. simpl. split; [apply Ll|]. split.
    { apply (changed_forall (fun w => 0 <= w) _ (add m1) ws) with (2 := Ec); [|exact W]. intros v V. rewrite add_is. lra. }
    assert (numbered (of_sieve m) (judged_deviations M js ts ns) = Some (Qabs (p - t))) as Ed.
    { unfold judged_deviations. rewrite numbered_map, (numbered_combine _ _ _ _ _ Ej Et). reflexivity. }
    rewrite (worth_changed a (add m1) ws _ _ w (Qabs (p - t)) ws' Ew Ed Ec), Ml.
    set (d := Qabs (p - t)) in *. assert (sign * t - sign * p <= m1 * d) as Dl.
    { assert (p - t <= d /\ t - p <= d) as (D1 & D2).
      { pose proof (Qle_Qabs (p - t)) as Q1. pose proof (Qle_Qabs (- (p - t))) as Q2. rewrite Qabs_opp in Q2. fold d in Q1, Q2.
        split; lra. }
      destruct Sg as [Sg|Sg]; rewrite Sg.
      - pose proof (Qmult_le_0_compat m1 (d - (t - p)) ltac:(lra) ltac:(lra)). lra.
      - pose proof (Qmult_le_0_compat m1 (d - (p - t)) ltac:(lra) ltac:(lra)). lra. }
    unfold worth_of. destruct (is_squares a) eqn:Sq.
    - simpl in Hy0. apply equal_spec in Hy0. plain_numbers. change (of_integer 4) with 4.
      rewrite Hy0. assert ((m1 + 0) * (m1 + 0) / 4 == m1 * m1 / 4) as -> by field.
      assert (0 * 0 / 4 == 0) as -> by reflexivity. lra.
    - plain_numbers. lra. }
  destruct (side_of m).
  - injection H as <-. unfold stands. simpl. split; [apply Ll|]. split; [exact W|]. plain_numbers. rewrite Ml.
    pose proof (Qmult_le_0_compat m1 (p - least_judged j) ltac:(lra) ltac:(lra)). lra.
  - injection H as <-. unfold stands. simpl. split; [apply Ll|]. split; [exact W|]. plain_numbers. rewrite Ml, minus_is.
    pose proof (Qmult_le_0_compat m1 (most_judged j - p) ltac:(lra) ltac:(lra)). lra.
  - apply (Target m1 x'); [left; reflexivity | exact H].
  - apply (Target (minus m1) x'); [right; reflexivity | exact H].
Qed.

Lemma add_multiples_stands a base ts ms : forall x x', stands a base ts x -> add_multiples a js ts ms x = Ok x' -> stands a base ts x'.
Proof.
  induction ms as [|m ms IH]; intros x x' S H; simpl in H; [injection H as <-; exact S|].
  passed H. passed H. apply less_spec in H0. apply (IH _ _ (add_multiple_stands _ _ _ _ _ _ S H0 H1) H).
Qed.

Lemma deviations_from_0 ts : Forall (fun d => 0 <= d) (judged_deviations M js ts ns).
Proof. unfold judged_deviations. induction (combine js ts) as [|(j, t) l IH]; constructor; [apply Qabs_nonneg | exact IH]. Qed.

(* The bound of a leaf is not above the value of any blend in its box. *)
Lemma bound_below q a curves ms b v : in_box b ns -> List.length b = List.length ns -> List.length curves = List.length ns ->
  sum_of_steps ns = M -> steps q = M -> (forall cs, a = Cost cs -> List.length cs = List.length ns) ->
  bound_in_box q a curves js ms b = Ok v -> v <= judged_value M a js ns.
Proof.
  intros F Lb Lc S Eq Lcost H. unfold bound_in_box in H. cbv zeta in H. passed H. rename x into y. passed H. injection H as <-.
  set (ts := targets_of a) in *. set (base := mean M ns (costs_of a curves)).
  assert (stands a base ts (Below 0 (costs_of a curves) (map (fun _ => 0) ts))) as St.
  { unfold stands. simpl. split; [|split].
    - destruct a; simpl; unfold no_costs; rewrite ?map_length; auto.
    - clear. induction ts; simpl; constructor; [apply Qle_refl | assumption].
    - rewrite worth_zeros. unfold base. lra. }
  apply (add_multiples_stands _ _ _ _ _ _ St) in H0 as (L & W & B). pose proof (inject_positive _ M_positive) as Mp.
  assert (least_sum (steps q) (of_shares y) b <= weighted ns (of_shares y)) as Ls by
    (apply least_sum_below; congruence).
  plain_numbers. rewrite Eq in *. rewrite integer_is.
  assert (least_sum M (of_shares y) b / inject_Z M <= mean M ns (of_shares y)) as Lm.
  { unfold mean. apply Qle_shift_div_l; [exact Mp|]. unfold Qdiv. rewrite <- Qmult_assoc, (Qmult_comm (/ _)), Qmult_inv_r, Qmult_1_r;
      [exact Ls | intro Z; rewrite Z in Mp; discriminate Mp]. }
  assert (base + worth a (weights y) (judged_deviations M js ts ns) <= judged_value M a js ns) as V; [|lra].
  unfold base, ts, judged_value in *. pose proof (deviations_from_0 (targets_of a)) as D0.
  assert (forall zs, zs = no_costs curves -> mean M ns zs == 0) as Zs.
  { intros zs ->. unfold mean, no_costs. rewrite weighted_zeros. unfold Qdiv. ring. }
  destruct a as [|cs|t0|t0|t0]; cbn [costs_of targets_of weights_are_allowed] in *.
  - rewrite Zs by reflexivity. pose proof (worth_of_each _ _ eq_refl D0 W H1 NoAim eq_refl) as K. unfold judged_deviations in *.
    destruct js; simpl in *; exact K || lra.
  - pose proof (worth_of_each _ _ eq_refl D0 W H1 (Cost cs) eq_refl) as K. unfold judged_deviations in *.
    destruct js; simpl in *; lra.
  - rewrite Zs by reflexivity. pose proof (worth_of_each _ _ eq_refl D0 W H1 (Deviation t0) eq_refl). lra.
  - rewrite Zs by reflexivity. apply at_most_spec in H1. change (of_integer 1) with 1 in H1.
    set (ds := judged_deviations M js t0 ns) in *. pose proof (greatest_from_0 ds) as G.
    pose proof (worth_to_greatest (MaxDeviation t0) _ eq_refl ds W _ G (all_to_greatest ds)).
    pose proof (Qmult_le_0_compat (1 - sum_in_lowest_terms (weights y)) _ ltac:(lra) G). lra.
  - rewrite Zs by reflexivity. pose proof (worth_of_squares (Squares t0) (weights y) eq_refl (judged_deviations M js t0 ns)). lra.
Qed.

(* ---- Trees (c) -------------------------------------------------------------------------------------- *)

Lemma tree_below q curves claimed nodes : forall open, List.length curves = List.length ns -> Forall (fun n => (0 <= n)%Z) ns ->
  sum_of_steps ns = M -> steps q = M -> (forall cs, aim_of q = Cost cs -> List.length cs = List.length ns) ->
  (forall K, most_stockpiles q = Some K -> (used ns <= K)%Z) ->
  check_blend_tree q curves js claimed nodes open = Ok tt -> forall b, In b open -> in_box b ns ->
  exists v, claimed = Some v /\ v <= judged_value M (aim_of q) js ns.
Proof.
  induction nodes as [|node nodes IH]; intros open Lc P S Eq Lcost U H b I F; simpl in H.
  { destruct open; [destruct I | discriminate]. }
  destruct open as [|b0 open]; [destruct node; discriminate|].
  assert (forall b', in_box b' ns -> forall ms a v, bound_in_box q a curves js ms b' = Ok v ->
    (forall cs, a = Cost cs -> List.length cs = List.length ns) -> v <= judged_value M a js ns) as Bound.
  { intros b' F' ms a v Hb La. apply (bound_below q a curves ms b' v); trivial. apply box_length, F'. }
  destruct node as [i v|ms|ms].
  - destruct (changed i (lower v) b0) as [b1|] eqn:E1; [|discriminate].
    destruct (changed i (raise (v + 1)) b0) as [b2|] eqn:E2; [|discriminate].
    specialize (IH _ Lc P S Eq Lcost U H). destruct I as [->|I]; [|apply (IH b); [simpl; auto | exact F]].
    destruct (changed_keeps _ _ _ _ _ E1 F) as (n & N & K1). destruct (changed_keeps _ _ _ _ _ E2 F) as (n' & N' & K2).
    assert (n' = n) as -> by congruence. destruct (Z.le_gt_cases n v) as [L|L].
    + apply (IH b1); [simpl; auto|]. apply K1. intros (lo, hi). unfold holds. simpl. lia.
    + apply (IH b2); [simpl; auto|]. apply K2. intros (lo, hi). unfold holds. simpl. lia.
  - destruct I as [->|I].
    + destruct (restricted_keeps (steps q) (most_stockpiles q) b ns F P ltac:(congruence) U) as (b' & E & F'). rewrite E in H.
      passed H. passed H. destruct claimed as [c|]; [|discriminate]. exists c. split; [reflexivity|]. apply at_most_spec in H1.
      eapply Qle_trans; [exact H1|]. apply (Bound b' F' ms (aim_of q)); assumption.
    + destruct (restricted (steps q) (most_stockpiles q) b0); [passed H; passed H|]; apply (IH open) with (b := b); assumption.
  - destruct I as [->|I].
    + destruct (restricted_keeps (steps q) (most_stockpiles q) b ns F P ltac:(congruence) U) as (b' & E & F'). rewrite E in H.
      passed H. passed H. apply less_spec in H1. exfalso.
      pose proof (Bound b' F' ms NoAim _ H0 ltac:(discriminate)) as K. simpl in K. lra.
    + destruct (restricted (steps q) (most_stockpiles q) b0); [passed H; passed H|]; apply (IH open) with (b := b); assumption.
Qed.
End Blend.
