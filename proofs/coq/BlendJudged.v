(* What a blend is judged by are the limits of its question: a blend is allowed where it keeps them, and its value is that of Blend.v. *)

From Coq Require Import ZArith QArith Qabs List Bool Lia Lqa.
From Mdm Require Import Numbers NumbersFacts Rows Blend BlendCertificate BlendSieves BlendCheck BlendSound.
Import ListNotations.
Open Scope Q_scope.

(* ---- What passes is from 0 to 100 ------------------------------------------------------------------- *)

Definition is_percent (p : Q) : Prop := 0 <= p <= 100.

Lemma between_percents t p q : 0 <= t <= 1 -> is_percent p -> is_percent q -> is_percent (p + t * (q - p)).
Proof.
  intros (T0 & T1) (P0 & P1) (R0 & R1). unfold is_percent.
  pose proof (Qmult_le_0_compat t q T0 R0). pose proof (Qmult_le_0_compat t (100 - q) T0 ltac:(lra)).
  pose proof (Qmult_le_0_compat (1 - t) p ltac:(lra) P0). pose proof (Qmult_le_0_compat (1 - t) (100 - p) ltac:(lra) ltac:(lra)).
  split; lra.
Qed.

Lemma told_is_percent c s : forall before, are_percents c = true ->
  (forall x p, before = Some (x, p) -> is_percent p /\ x < s) -> forall r i, told_from before c s = Known r i -> is_percent r.
Proof.
  induction c as [|(y, q) c IH]; intros before A B r i H; simpl in H.
  { injection H as <- <-. split; discriminate. }
  simpl in A. rewrite !andb_true_iff in A. destruct A as ((A1 & A2) & A). apply at_most_spec in A1, A2.
  assert (is_percent q) as Pq by (split; assumption).
  destruct (less y s) eqn:L.
  { apply less_spec in L. apply (IH (Some (y, q)) A) with (i := i); [|exact H]. intros x p [= <- <-]. auto. }
  destruct (equal y s) eqn:E; [injection H as <- <-; exact Pq|]. apply less_false in L. apply equal_false in E.
  destruct before as [(x, p)|]; [|injection H as <- <-; split; discriminate].
  destruct (B x p eq_refl) as (Pp & Lx). destruct (equal p q); [injection H as <- <-; exact Pq|].
  destruct (equal x 0); [discriminate|]. injection H as <- <-.
  assert (s < y) as Ls by (apply Qle_lt_or_eq in L as [L|L]; [exact L | exfalso; apply E; symmetry; exact L]).
  assert (linear x p y q s == p + (s - x) / (y - x) * (q - p)) as El by (unfold linear; plain_numbers; reflexivity).
  unfold is_percent. rewrite El. apply between_percents; try assumption. split.
  - apply Qle_shift_div_l; lra.
  - apply Qle_shift_div_r; lra.
Qed.

Lemma percent_at_is_percent c s : are_percents c = true -> is_percent (percent_at s c).
Proof.
  intro A. unfold percent_at, told_at. destruct (told_from None c s) as [|r i] eqn:E; [split; discriminate|].
  apply (told_is_percent c s None A) with (i := i); [discriminate | exact E].
Qed.

(* [is_percent] is kept by equality. *)
Lemma weighted_percents ns : forall xs, Forall (fun n => (0 <= n)%Z) ns -> Forall is_percent xs ->
  0 <= weighted ns xs <= 100 * inject_Z (sum_of_steps ns).
Proof.
  induction ns as [|n ns IH]; intros xs P X; simpl; [change (inject_Z 0) with 0; split; lra|].
  inversion P as [|? ? P0 P']; subst. rewrite inject_Z_plus. pose proof (inject_le _ _ P0) as N0. change (inject_Z 0) with 0 in N0.
  revert N0. generalize (inject_Z n). intros c N0. destruct X as [|x xs (X0 & X1) X].
  - destruct (IH [] P' (Forall_nil _)) as (I0 & I1). generalize dependent (inject_Z (sum_of_steps ns)). intros t I1. split; lra.
  - destruct (IH xs P' X) as (I0 & I1). generalize dependent (inject_Z (sum_of_steps ns)). intros t I1.
    pose proof (Qmult_le_0_compat _ _ N0 X0). pose proof (Qmult_le_0_compat c (100 - x) N0 ltac:(lra)). split; lra.
Qed.

Lemma mean_percents M ns xs : (1 <= M)%Z -> Forall (fun n => (0 <= n)%Z) ns -> sum_of_steps ns = M -> Forall is_percent xs ->
  is_percent (mean M ns xs).
Proof.
  intros M1 P S X. destruct (weighted_percents ns xs P X) as (A & B). rewrite S in B. pose proof (inject_positive _ M1) as Mp.
  unfold mean. split; [apply Qle_shift_div_l | apply Qle_shift_div_r]; try exact Mp; lra.
Qed.

Lemma passed_percent M curves ns s : (1 <= M)%Z -> Forall (fun n => (0 <= n)%Z) ns -> sum_of_steps ns = M ->
  forallb are_percents curves = true -> is_percent (passed M curves ns s).
Proof.
  intros M1 P S A. apply mean_percents; trivial. apply Forall_forall. intros p I. apply in_map_iff in I as (c & <- & I).
  rewrite forallb_forall in A. apply percent_at_is_percent, A, I.
Qed.

(* ---- Sums are linear -------------------------------------------------------------------------------- *)

Section Linear.
Context {A : Type}.

Lemma weighted_same ns (f g : A -> Q) l : (forall c, f c == g c) -> weighted ns (map f l) == weighted ns (map g l).
Proof. intro E. revert l. induction ns as [|n ns IH]; intros [|c l]; simpl; try reflexivity. rewrite IH, E. reflexivity. Qed.

Lemma weighted_plus ns (f g : A -> Q) l : weighted ns (map (fun c => f c + g c) l) == weighted ns (map f l) + weighted ns (map g l).
Proof. revert l. induction ns as [|n ns IH]; intros [|c l]; simpl; try ring. rewrite IH. ring. Qed.

Lemma weighted_times ns k (f : A -> Q) l : weighted ns (map (fun c => k * f c) l) == k * weighted ns (map f l).
Proof. revert l. induction ns as [|n ns IH]; intros [|c l]; simpl; try ring. rewrite IH. ring. Qed.
End Linear.

(* ---- Moduli ----------------------------------------------------------------------------------------- *)

Definition sum_of_passed (M : Z) (curves : list curve) (ns : blend) (ss : list Q) : Q :=
  fold_right (fun s sum => passed M curves ns s + sum) 0 ss.

Lemma weighted_of_sum ns ss : forall curves : list curve,
  weighted ns (map (fun c => sum_in_lowest_terms (map (fun s => percent_at s c) ss)) curves) ==
  fold_right (fun s sum => weighted ns (map (percent_at s) curves) + sum) 0 ss.
Proof.
  induction ss as [|s ss IH]; intro curves; simpl; [apply weighted_zeros|].
  rewrite <- IH, <- weighted_plus. apply weighted_same. intro c. apply add_is.
Qed.

Lemma mean_of_modulus_is M curves ns st :
  mean M ns (map (mean_of_modulus st) curves) ==
  sum_of_passed M curves ns (sieves_of_modulus st) / of_integer (size (sieves_of_modulus st)).
Proof.
  set (n := of_integer (size (sieves_of_modulus st))). unfold mean.
  assert (weighted ns (map (mean_of_modulus st) curves) ==
    / n * weighted ns (map (fun c => sum_in_lowest_terms (map (fun s => percent_at s c) (sieves_of_modulus st))) curves)) as ->.
  { rewrite <- weighted_times. apply weighted_same. intro c. unfold mean_of_modulus. fold n. rewrite over_is. unfold Qdiv. ring. }
  rewrite weighted_of_sum. clearbody n. unfold sum_of_passed, passed, mean. generalize (sieves_of_modulus st). intro ss.
  assert (fold_right (fun s sum => weighted ns (map (percent_at s) curves) / inject_Z M + sum) 0 ss ==
    fold_right (fun s sum => weighted ns (map (percent_at s) curves) + sum) 0 ss / inject_Z M) as ->; [|unfold Qdiv; ring].
  induction ss as [|s ss IH]; simpl; [unfold Qdiv; ring|]. rewrite IH. unfold Qdiv. ring.
Qed.

Lemma fineness_is M curves ns st :
  fineness_modulus M curves ns st ==
  of_integer (size (sieves_of_modulus st)) - sum_of_passed M curves ns (sieves_of_modulus st) / 100.
Proof.
  unfold fineness_modulus, sum_of_passed.
  assert (forall ss, fold_right (fun s sum => (100 - passed M curves ns s) / 100 + sum) 0 ss ==
    inject_Z (Z.of_nat (length ss)) - fold_right (fun s sum => passed M curves ns s + sum) 0 ss / 100) as G.
  { induction ss as [|s ss IH]; [reflexivity|]. cbn [fold_right length]. rewrite IH, Nat2Z.inj_succ. unfold Z.succ.
    rewrite inject_Z_plus. change (inject_Z 1) with 1. generalize (inject_Z (Z.of_nat (length ss))). intro k. field. }
  rewrite G. destruct st; reflexivity.
Qed.

Lemma keeps_modulus M curves ns st x y :
  keeps M ns (judged_modulus curves (st, x, y)) <-> x <= fineness_modulus M curves ns st <= y.
Proof.
  unfold keeps. cbn [judged_modulus least_judged most_judged passing_judged]. rewrite mean_of_modulus_is, fineness_is.
  unfold mean_at, hundred. plain_numbers. change (of_integer 100) with 100. change (of_integer 1) with 1.
  generalize (sum_of_passed M curves ns (sieves_of_modulus st)). intro p.
  assert (exists n : Q, n == of_integer (size (sieves_of_modulus st)) /\ 0 < n) as (n & E & N).
  { exists (of_integer (size (sieves_of_modulus st))). split; [reflexivity | destruct st; reflexivity]. }
  rewrite <- E. assert (~ n == 0) as N0 by (intro Z; rewrite Z in N; discriminate N).
  assert (p / n == p / 100 * (100 / n)) as -> by (field; exact N0).
  assert (forall z, 100 * (1 - z / n) == (n - z) * (100 / n)) as R by (intro z; field; exact N0). rewrite !R.
  assert (0 < 100 / n) as H by (apply Qlt_shift_div_l; lra).
  rewrite !Qmult_le_r by exact H. split; intros (A & B); split; lra.
Qed.

(* ---- The factor ------------------------------------------------------------------------------------- *)

Lemma mean_of_factor M curves ns x :
  mean M ns (map (difference_of_factor x) curves) ==
  passed M curves ns coarse_sieve - x / 100 * passed M curves ns fine_sieve.
Proof.
  unfold passed, mean.
  assert (weighted ns (map (difference_of_factor x) curves) ==
    weighted ns (map (percent_at coarse_sieve) curves) + - (x / 100) * weighted ns (map (percent_at fine_sieve) curves)) as ->;
    [|unfold Qdiv; ring].
  rewrite <- weighted_times, <- weighted_plus. apply weighted_same. intro c. unfold difference_of_factor. plain_numbers.
  change hundred with 100. ring.
Qed.

Lemma keeps_factors M curves ns limits : (1 <= M)%Z -> Forall (fun n => (0 <= n)%Z) ns -> sum_of_steps ns = M ->
  forallb are_percents curves = true ->
  (forall x y, limits = Some (x, y) -> 0 <= x /\ x <= y /\ y <= 100) ->
  Forall (keeps M ns) (judged_factors curves limits) <->
  forall x y, limits = Some (x, y) -> keeps_coarseness M curves ns x y.
Proof.
  intros M1 P S A L. destruct limits as [(x, y)|]; simpl; [|split; [discriminate | constructor]].
  destruct (L x y eq_refl) as (L0 & L1 & L2).
  destruct (passed_percent M curves ns coarse_sieve M1 P S A) as (C0 & C1).
  destruct (passed_percent M curves ns fine_sieve M1 P S A) as (F0 & F1).
  assert (forall z least most, keeps M ns (judged_factor curves z least most) <->
    least <= passed M curves ns coarse_sieve - z / 100 * passed M curves ns fine_sieve <= most) as K.
  { intros z least most. unfold keeps. cbn [judged_factor least_judged most_judged passing_judged]. rewrite mean_of_factor. reflexivity. }
  unfold keeps_coarseness.
  set (a := passed M curves ns coarse_sieve) in *. set (b := passed M curves ns fine_sieve) in *. clearbody a b.
  pose proof (Qmult_le_0_compat x b L0 F0) as X0. pose proof (Qmult_le_0_compat x (100 - b) L0 ltac:(lra)) as X1.
  pose proof (Qmult_le_0_compat y b ltac:(lra) F0) as Y0.
  assert (forall z w : Q, z / 100 * w == (1 # 100) * (z * w)) as E by (intros; field).
  transitivity (x / 100 * (100 - b) <= 100 - a /\ (y < 100 -> 100 - a <= y / 100 * (100 - b))).
  2: { split; [intros H z w [= <- <-]; exact H | intro H; exact (H x y eq_refl)]. }
  rewrite Forall_app.
  assert (Forall (keeps M ns) (if less 0 x then [judged_factor curves x (of_integer (-100)) (subtract hundred x)] else []) <->
    x / 100 * (100 - b) <= 100 - a) as ->.
  { destruct (less 0 x) eqn:Ex.
    - rewrite Forall_cons_iff, K. rewrite subtract_is, !E. change hundred with 100. change (of_integer (-100)) with (-100 # 1).
      split; [intros ((_ & H) & _); lra|]. intro H. split; [split; lra | constructor].
    - apply less_false in Ex. assert (x == 0) as Z by lra. split; [|constructor]. intros _. rewrite E, Z. lra. }
  assert (Forall (keeps M ns) (if less y hundred then [judged_factor curves y (subtract hundred y) hundred] else []) <->
    (y < 100 -> 100 - a <= y / 100 * (100 - b))) as ->; [|reflexivity].
  destruct (less y hundred) eqn:Ey.
  - rewrite Forall_cons_iff, K. rewrite subtract_is, !E. apply less_spec in Ey. change hundred with 100 in *.
    split; [intros ((H & _) & _) _; lra|]. intro H. specialize (H Ey). split; [split; lra | constructor].
  - apply less_false in Ey. change hundred with 100 in Ey. split; [intros _ H; lra | constructor].
Qed.

(* ---- Sieves ----------------------------------------------------------------------------------------- *)

Definition told_limits (curves : list curve) (limits : list (Q * Q * Q)) : list (Q * Q * Q) :=
  filter (fun '(s, _, _) => told_by_all curves s) limits.

Lemma judged_sieves_are curves limits : forall done js, judged_sieves curves limits done = Ok js ->
  js = (rev done ++ map (judged_sieve curves) (told_limits curves limits))%list /\
  forall s least most, In (s, least, most) limits -> 0 < s -> 0 < least \/ most < 100 -> told_by_all curves s = true.
Proof.
  induction limits as [|((s, least), most) limits IH]; intros done js H; simpl in H.
  { injection H as <-. unfold rev'. rewrite rev_append_rev. simpl. split; [reflexivity | intros ? ? ? []]. }
  unfold told_limits. cbn [filter]. destruct (told_by_all curves s) eqn:E.
  - destruct (IH _ _ H) as (-> & A). split; [cbn [rev map]; rewrite <- app_assoc; reflexivity|].
    intros s' l m [[= <- <- <-]|I] P L; [exact E | exact (A _ _ _ I P L)].
  - passed H. destruct (IH _ _ H) as (-> & A). split; [reflexivity|].
    intros s' l m [[= <- <- <-]|I] P L; [exfalso | exact (A _ _ _ I P L)].
    apply negb_true_iff, andb_false_iff in H0 as [H0|H0]; [apply less_false in H0; lra|].
    apply orb_false_iff in H0 as (H0 & H1). apply less_false in H0, H1. change hundred with 100 in H1. lra.
Qed.

Lemma sieves_are curves limits : sieves_with_targets limits curves = map (fun '(s, _, _) => s) (told_limits curves limits).
Proof.
  unfold sieves_with_targets, told_limits. induction limits as [|((s, l), m) limits IH]; [reflexivity|].
  cbn [map filter]. destruct (told_by_all curves s); cbn [map]; rewrite IH; reflexivity.
Qed.

(* ---- All of them ------------------------------------------------------------------------------------ *)

Section Judged.
Variables (curves : list curve) (limits : list (Q * Q * Q)) (q : blend_question) (js : list judged).
Hypothesis are_judged : all_judged curves limits q = Ok js.

Lemma all_judged_are :
  forallb are_percents curves = true /\
  (forall x y, coarseness_limits q = Some (x, y) -> 0 <= x /\ x <= y /\ y <= 100) /\
  (forall s least most, In (s, least, most) limits -> 0 < s -> 0 < least \/ most < 100 -> told_by_all curves s = true) /\
  (forall st x y s, In (st, x, y) (modulus_limits q) -> In s (sieves_of_modulus st) -> told_by_all curves s = true) /\
  (coarseness_limits q <> None -> told_by_all curves coarse_sieve = true /\ told_by_all curves fine_sieve = true) /\
  js = (map (judged_sieve curves) (told_limits curves limits) ++ map (judged_modulus curves) (modulus_limits q) ++
        judged_factors curves (coarseness_limits q))%list.
Proof.
  pose proof are_judged as H. unfold all_judged in H. passed H. passed H. passed H. rename x into sieves. passed H. passed H. passed H.
  injection H as <-. destruct (judged_sieves_are _ _ _ _ H2) as (-> & T). split; [exact H0|]. split; [|split; [exact T|split; [|split; [|reflexivity]]]].
  - intros x y E. rewrite E in H1. rewrite !andb_true_iff, !at_most_spec in H1. change hundred with 100 in H1. tauto.
  - intros st x y s I J. rewrite forallb_forall in H4. specialize (H4 _ I). simpl in H4. rewrite forallb_forall in H4. apply H4, J.
  - intro N. destruct (coarseness_limits q); [apply andb_prop, H5 | congruence].
Qed.

Lemma judged_of_each : Forall (fun j => length (passing_judged j) = length curves) js.
Proof.
  destruct all_judged_are as (_ & _ & _ & _ & _ & ->). apply Forall_app. split; [|apply Forall_app; split].
  - apply Forall_forall. intros j I. apply in_map_iff in I as (((s, l), m) & <- & _). apply map_length.
  - apply Forall_forall. intros j I. apply in_map_iff in I as (((st, x), y) & <- & _). apply map_length.
  - unfold judged_factors. destruct (coarseness_limits q) as [(x, y)|]; [|constructor].
    apply Forall_app. split; [destruct (less 0 x) | destruct (less y hundred)]; repeat constructor; apply map_length.
Qed.

(* A blend keeps what it is judged by where it keeps all limits. *)
Lemma judged_kept M ns : (1 <= M)%Z -> Forall (fun n => (0 <= n)%Z) ns -> sum_of_steps ns = M ->
  Forall (keeps M ns) js <->
  (forall s least most, In (s, least, most) limits -> told_by_all curves s = true -> least <= passed M curves ns s <= most) /\
  (forall st x y, In (st, x, y) (modulus_limits q) -> x <= fineness_modulus M curves ns st <= y) /\
  (forall x y, coarseness_limits q = Some (x, y) -> keeps_coarseness M curves ns x y).
Proof.
  intros M1 P S. destruct all_judged_are as (A & L & _ & _ & _ & ->). rewrite !Forall_app, (keeps_factors M curves ns _ M1 P S A L).
  assert (Forall (keeps M ns) (map (judged_sieve curves) (told_limits curves limits)) <->
    forall s least most, In (s, least, most) limits -> told_by_all curves s = true -> least <= passed M curves ns s <= most) as ->.
  { rewrite Forall_map, Forall_forall. split.
    - intros H s l m I T. apply (H (s, l, m)). apply filter_In. auto.
    - intros H ((s, l), m) I. apply filter_In in I as (I & T). exact (H s l m I T). }
  assert (Forall (keeps M ns) (map (judged_modulus curves) (modulus_limits q)) <->
    forall st x y, In (st, x, y) (modulus_limits q) -> x <= fineness_modulus M curves ns st <= y) as ->; [|reflexivity].
  rewrite Forall_map, Forall_forall. split.
  - intros H st x y I. apply keeps_modulus, (H (st, x, y) I).
  - intros H ((st, x), y) I. apply keeps_modulus, H, I.
Qed.

Lemma by_sieve_are : filter is_by_sieve js = map (judged_sieve curves) (told_limits curves limits).
Proof.
  destruct all_judged_are as (_ & _ & _ & _ & _ & ->). rewrite !filter_app.
  assert (filter is_by_sieve (judged_factors curves (coarseness_limits q)) = []) as ->.
  { unfold judged_factors. destruct (coarseness_limits q) as [(x, y)|]; [|reflexivity].
    destruct (less 0 x), (less y hundred); reflexivity. }
  assert (filter is_by_sieve (map (judged_modulus curves) (modulus_limits q)) = []) as ->.
  { generalize (modulus_limits q). intro l. induction l as [|((st, x), y) l IH]; [reflexivity | exact IH]. }
  rewrite !app_nil_r. generalize (told_limits curves limits). intro ls. induction ls as [|((s, l), m) ls IH]; [reflexivity|].
  cbn [map filter]. cbn [judged_sieve is_by_sieve by_what]. f_equal. exact IH.
Qed.

Lemma number_of_sieves : length (filter is_by_sieve js) = length (sieves_with_targets limits curves).
Proof. rewrite by_sieve_are, sieves_are, !map_length. reflexivity. Qed.

Lemma combine_first {A B} (xs ys : list A) (ts : list B) : length ts = length xs -> combine (xs ++ ys) ts = combine xs ts.
Proof.
  revert ts. induction xs as [|x xs IH]; intros [|t ts] L; try discriminate L; simpl; [destruct ys; reflexivity|].
  rewrite IH; [reflexivity | injection L as L; exact L].
Qed.

Lemma deviations_are M ns ts : length ts = length (sieves_with_targets limits curves) ->
  judged_deviations M js ts ns = deviations limits curves M ts ns.
Proof.
  intro L. unfold judged_deviations, deviations. rewrite sieves_are, map_length in *.
  destruct all_judged_are as (_ & _ & _ & _ & _ & ->). rewrite combine_first by (rewrite map_length; exact L). clear L.
  revert ts. generalize (told_limits curves limits). intro ls. induction ls as [|((s, l), m) ls IH]; intros [|t ts]; try reflexivity.
  cbn [map combine]. f_equal. apply IH.
Qed.

Lemma value_is ns :
  match aim_of q with
  | NoAim | Cost _ => True
  | Deviation ts | MaxDeviation ts | Squares ts => length ts = length (sieves_with_targets limits curves)
  end -> judged_value (steps q) (aim_of q) js ns = value limits curves q ns.
Proof.
  unfold judged_value, value. destruct (aim_of q) as [|cs|ts|ts|ts]; intro L; try reflexivity; rewrite deviations_are by exact L; reflexivity.
Qed.
End Judged.
