(* What is counted and added up of a sample with rational sizes, by a law with a whole power: its particles in a class, their
   mass and share, and the paper's conditions, as decisions in fractions (Theorem 23, where nothing is enclosed). *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Spec Openings RealFacts Reduction Sizes.
Import ListNotations.
Open Scope R_scope.

(* So many particles of one size: a row of a sample file. *)
Record particles := Particles { size_of_each : Q; how_many : Z }.

Definition real_size (r : particles) : R := Q2R (size_of_each r).
Definition sample_of (rows : list particles) : sample :=
  flat_map (fun r => repeat (real_size r) (Z.to_nat (how_many r))) rows.

Definition proper_particles (r : particles) : Prop := 0 < real_size r /\ (1 <= how_many r)%Z.

Section Sample.
Variables (d : positive) (a : nat) (f : R -> R).
Hypothesis law : power_law a 1 f.

(* ---- Computed --------------------------------------------------------------------------------------- *)

Definition is_in (j : class) (r : particles) : bool :=
  let y := power (size_of_each r) (Zpos d) in less (lower j) y && at_most y (upper j).
Definition count_in (j : class) (rows : list particles) : Z := sum (map how_many (filter (is_in j) rows)).
Definition mass_of_row (r : particles) : Q := times (of_integer (how_many r)) (power (size_of_each r) (Z.of_nat a)).
Definition sum_of (xs : list Q) : Q := fold_right add 0%Q xs.
Definition mass_in (j : class) (rows : list particles) : Q := times (c j) (sum_of (map mass_of_row (filter (is_in j) rows))).
Definition whole_mass (js : list class) (rows : list particles) : Q := sum_of (map (fun j => mass_in j rows) js).
Definition share_in (js : list class) (j : class) (rows : list particles) : Q := over (mass_in j rows) (whole_mass js rows).

(* What passes the upper opening of a class, and the errors of shares. *)
Definition passing_in (js : list class) (j : class) (rows : list particles) : Q :=
  sum_of (map (fun i => if at_most (upper i) (upper j) then mass_in i rows else 0%Q) js).
Definition target_passing_in (js : list class) (j : class) : Q :=
  sum_of (map (fun i => if at_most (upper i) (upper j) then mass i else 0%Q) js).
Definition mass_of_classes (js : list class) : Q := sum_of (map mass js).
Definition distance (x y : Q) : Q := if less x y then subtract y x else subtract x y.
Definition retained_error (js : list class) (rows : list particles) (j : class) : Q :=
  distance (share_in js j rows) (over (mass j) (mass_of_classes js)).
Definition passing_error (js : list class) (rows : list particles) (j : class) : Q :=
  distance (over (passing_in js j rows) (whole_mass js rows)) (over (target_passing_in js j) (mass_of_classes js)).
Definition total_error (js : list class) (rows : list particles) : Q := sum_of (map (retained_error js rows) js).

Definition in_some_of (js : list class) (r : particles) : bool := existsb (fun j => is_in j r) js.
Definition one_size (j : class) (rows : list particles) : bool :=
  match filter (is_in j) rows with
  | r :: rs => forallb (fun s => equal (size_of_each r) (size_of_each s)) rs
  | [] => true
  end.

(* ---- What it is ------------------------------------------------------------------------------------- *)

Lemma law_value x : 0 <= x -> f x = x ^ a.
Proof. intro X. destruct (proj2 law x X) as (_ & E). rewrite pow_1 in E. exact E. Qed.

Lemma is_in_class j r : 0 <= Q2R (lower j) -> 0 <= Q2R (upper j) -> proper_particles r ->
  (is_in j r = true <-> in_class d j (real_size r)).
Proof.
  intros L U (P & _). unfold is_in, in_class, lower_size, upper_size, size_of. cbv zeta.
  rewrite andb_true_iff, less_real, at_most_real, Q2R_power_pos. fold (real_size r).
  pose proof (nth_root_nonneg (d := d) (Q2R (lower j))) as Nl. pose proof (nth_root_nonneg (d := d) (Q2R (upper j))) as Nu.
  rewrite (pow_lt_iff (nth_root d (Q2R (lower j))) (real_size r) (Pos.to_nat d)) by (lra || lia).
  rewrite (pow_le_iff (real_size r) (nth_root d (Q2R (upper j))) (Pos.to_nat d)) by (lra || lia).
  rewrite !nth_root_power by assumption. reflexivity.
Qed.

Lemma inside_rows j rows : 0 <= Q2R (lower j) -> 0 <= Q2R (upper j) -> Forall proper_particles rows ->
  inside d j (sample_of rows) = sample_of (filter (is_in j) rows).
Proof.
  intros L U P. induction P as [|r rows Pr P IH]; [reflexivity|]. unfold sample_of in *. cbn [flat_map filter].
  rewrite inside_app, IH. pose proof (is_in_class j r L U Pr) as In. destruct (is_in j r).
  - cbn [flat_map]. rewrite inside_all; [reflexivity|]. intros x X. apply repeat_spec in X. subst x. apply In. reflexivity.
  - rewrite inside_none; [reflexivity|]. intros x X H. apply repeat_spec in X. subst x. apply In in H. discriminate H.
Qed.

Lemma length_rows rows : Forall proper_particles rows -> Z.of_nat (length (sample_of rows)) = sum (map how_many rows).
Proof.
  intro P. induction P as [|r rows (_ & Pr) P IH]; [reflexivity|]. unfold sample_of in *. cbn [flat_map map sum fold_right].
  rewrite app_length, repeat_length, Nat2Z.inj_add, IH, Z2Nat.id by lia. reflexivity.
Qed.

Lemma total_rows rows : Forall proper_particles rows ->
  total (map f (sample_of rows)) = Q2R (sum_of (map mass_of_row rows)).
Proof.
  intro P. induction P as [|r rows (S & Pr) P IH]; [symmetry; apply Q2R_0|]. unfold sample_of in *.
  cbn [flat_map map sum_of fold_right]. rewrite map_app, total_app, IH, Q2R_add, total_repeat. f_equal. unfold mass_of_row.
  rewrite Q2R_times, Q2R_integer, Q2R_power, law_value by lra. rewrite INR_IZR_INZ, Z2Nat.id by lia. reflexivity.
Qed.

Lemma filtered_proper such rows : Forall proper_particles rows -> Forall proper_particles (filter such rows).
Proof. rewrite !Forall_forall. intros P r I. apply filter_In in I as (I & _). apply P, I. Qed.

(* The particles of a class, and their mass. *)
Theorem count_is_number j rows : proper j -> Forall proper_particles rows ->
  number d j (sample_of rows) = count_in j rows.
Proof.
  intros ((L & U) & _) P. unfold number. rewrite inside_rows by (lra || assumption). apply length_rows, filtered_proper, P.
Qed.

Theorem mass_is_held j rows : proper j -> Forall proper_particles rows ->
  held d f j (sample_of rows) = Q2R (mass_in j rows).
Proof.
  intros ((L & U) & _) P. unfold held, mass_in. rewrite inside_rows by (lra || assumption).
  rewrite total_rows by apply filtered_proper, P. rewrite Q2R_times. reflexivity.
Qed.

Lemma total_sum {A} (g : A -> R) (h : A -> Q) l : (forall x, In x l -> g x = Q2R (h x)) -> total (map g l) = Q2R (sum_of (map h l)).
Proof.
  induction l as [|x l IH]; intro H; [symmetry; apply Q2R_0|]. cbn [map total fold_right sum_of]. rewrite Q2R_add, H by (left; reflexivity).
  f_equal. apply IH. intros y Y. apply H. right. exact Y.
Qed.

Lemma below_top js : forall x1 j x, ascend_from d x1 js -> In j js -> in_class d j x -> x <= top d x1 js.
Proof.
  induction js as [|i js IH]; intros x1 j x A I H; [destruct I|]. destruct A as (E & L & A).
  change (top d x1 (i :: js)) with (top d (upper_size d i) js). destruct I as [<-|I].
  - destruct H as (_ & H). pose proof (top_le (d := d) js _ A). lra.
  - exact (IH _ j x A I H).
Qed.

(* No opening is inside a class. *)
Lemma first_is_least r rs s : ascending (r :: rs) = true -> In s (r :: rs) -> Q2R (opening r) <= Q2R (opening s).
Proof.
  revert r. induction rs as [|t rs IH]; intros r A [<-|I]; try lra; [destruct I|]. cbn [ascending] in A.
  apply andb_prop in A as (A & B). apply less_real in A. specialize (IH t B I). lra.
Qed.

Lemma no_opening_inside rs : forall j s, ascending rs = true -> In j (classes rs) -> In s rs ->
  lower_size d j < size_of d (opening s) < upper_size d j -> False.
Proof.
  induction rs as [|x [|y rs] IH]; intros j s A J I (L & U); try (destruct J; fail).
  pose proof A as A'. cbn [ascending] in A. apply andb_prop in A as (A & B). apply less_real in A. destruct J as [<-|J].
  - unfold lower_size, upper_size in *. cbn [lower upper] in *. destruct I as [<-|I]; [lra|].
    pose proof (nth_root_le (d := d) _ _ (first_is_least y rs s B I)). unfold size_of in *. lra.
  - destruct I as [<-|I]; [|exact (IH j s B J I (conj L U))].
    destruct (class_of_rows _ _ J) as (K & _). apply in_map_iff in K as (t & E & K).
    pose proof (first_is_least y rs t B K) as F. rewrite E in F. unfold lower_size, size_of in L.
    pose proof (nth_root_le (d := d) (Q2R (opening x)) (Q2R (lower j)) ltac:(lra)). unfold size_of in *. lra.
Qed.

Section Gradation.
Variable rs : list row.
Hypothesis proper_gradation : proper_rows rs.
Variable rows : list particles.
Hypothesis sizes : Forall proper_particles rows.
Let js := classes rs.

Lemma proper_class j : In j js -> proper j.
Proof. intro J. pose proof (proper_classes rs proper_gradation) as P. rewrite Forall_forall in P. apply P, J. Qed.

(* The mass of all particles that are in classes, and the share of a class. *)
Theorem whole_is_mass_of_all : mass_of_all d f rs (sample_of rows) = Q2R (whole_mass js rows).
Proof. unfold mass_of_all, whole_mass. apply total_sum. intros j J. apply mass_is_held; [apply proper_class, J | exact sizes]. Qed.

Theorem share_is_retained j : In j js -> equal (whole_mass js rows) 0 = false ->
  share_retained d f rs j (sample_of rows) = Q2R (share_in js j rows).
Proof.
  intros J N. unfold share_retained, share_in. rewrite whole_is_mass_of_all, mass_is_held by (apply proper_class, J || exact sizes).
  rewrite Q2R_over; [reflexivity|]. intro E. rewrite <- Q2R_0 in E. apply equal_real in E. congruence.
Qed.

(* Errors, of what is retained, of what passes, and all together. *)
Hypothesis some_mass : 0 < Q2R (mass_of_classes js).
Hypothesis some_particles : 0 < Q2R (whole_mass js rows).

Lemma distance_real x y : Q2R (distance x y) = Rabs (Q2R x - Q2R y).
Proof.
  unfold distance. destruct (less x y) eqn:L; rewrite Q2R_subtract.
  - apply less_real in L. rewrite Rabs_left by lra. ring.
  - apply less_real_false in L. rewrite Rabs_right by lra. reflexivity.
Qed.

Lemma mass_of_gradation : gradation_mass rs = Q2R (mass_of_classes js).
Proof. unfold gradation_mass. apply total_sum. reflexivity. Qed.

Theorem retained_error_is j : In j js ->
  Rabs (share_retained d f rs j (sample_of rows) - target_retained rs j) = Q2R (retained_error js rows j).
Proof.
  intro J. unfold retained_error. rewrite distance_real, share_is_retained; [|exact J|].
  - unfold target_retained. rewrite mass_of_gradation, Q2R_over by lra. reflexivity.
  - destruct (equal (whole_mass js rows) 0) eqn:E; [|reflexivity]. apply equal_real in E. rewrite Q2R_0 in E. lra.
Qed.

Lemma passes i j : In i js -> In j js -> (upper_size d i <= upper_size d j <-> at_most (upper i) (upper j) = true).
Proof.
  intros I J. destruct (proper_class i I) as ((Li & Ui) & _), (proper_class j J) as ((Lj & Uj) & _). rewrite at_most_real. split.
  - intro H. destruct (Rle_lt_dec (Q2R (upper i)) (Q2R (upper j))) as [|L]; [assumption|].
    pose proof (nth_root_lt (d := d) (Q2R (upper j)) (Q2R (upper i)) ltac:(lra)). unfold upper_size, size_of in H. lra.
  - intro H. apply nth_root_le, H.
Qed.

Theorem passing_error_is j : In j js ->
  Rabs (share_passing d f rs (upper_size d j) (sample_of rows) - target_passing d rs (upper_size d j)) =
  Q2R (passing_error js rows j).
Proof.
  intro J. unfold passing_error. rewrite distance_real, !Q2R_over by lra. unfold share_passing, target_passing.
  rewrite whole_is_mass_of_all, mass_of_gradation. unfold mass_passing, passing_in, target_passing_in. fold js.
  assert (forall g h, (forall i, In i js -> g i = Q2R (h i)) ->
    total (map (fun i => if Rle_dec (upper_size d i) (upper_size d j) then g i else 0) js) =
    Q2R (sum_of (map (fun i => if at_most (upper i) (upper j) then h i else 0%Q) js))) as Some.
  { intros g h H. apply total_sum. intros i I. pose proof (passes i j I J) as P.
    destruct (Rle_dec (upper_size d i) (upper_size d j)) as [Y|N], (at_most (upper i) (upper j)).
    - exact (H i I).
    - discriminate (proj1 P Y).
    - contradiction (N (proj2 P eq_refl)).
    - symmetry. apply Q2R_0. }
  rewrite (Some (fun i => held d f i (sample_of rows)) (fun i => mass_in i rows)).
  - rewrite (Some (fun i => Q2R (mass i)) mass); [reflexivity|]. reflexivity.
  - intros i I. apply mass_is_held; [apply proper_class, I | exact sizes].
Qed.

Theorem total_error_is :
  total (map (fun j => Rabs (share_retained d f rs j (sample_of rows) - target_retained rs j)) js) =
  Q2R (total_error js rows).
Proof. apply total_sum. intros j J. exact (retained_error_is j J). Qed.

Lemma sample_rows x : In x (sample_of rows) <-> exists r, In r rows /\ real_size r = x.
Proof.
  unfold sample_of. rewrite in_flat_map. split.
  - intros (r & I & X). apply repeat_spec in X. eauto.
  - intros (r & I & <-). exists r. split; [exact I|]. rewrite Forall_forall in sizes. destruct (sizes r I) as (_ & P).
    destruct (Z.to_nat (how_many r)) eqn:E; [lia | left; reflexivity].
Qed.

(* Condition 2. *)
Theorem described : forallb (in_some_of js) rows = true <-> describes d rs (sample_of rows).
Proof.
  destruct (classes_ascend (d := d) rs proper_gradation) as (As & Top). rewrite forallb_forall. split.
  - intro H. split; [apply proper_gradation|]. intros x X. apply sample_rows in X as (r & I & <-).
    specialize (H r I). apply existsb_exists in H as (j & J & H). rewrite Forall_forall in sizes.
    destruct (proper_class j J) as ((L & U) & _). apply is_in_class in H; [|lra|lra|apply sizes, I].
    split; [exact (above_lower _ _ _ _ As J H)|]. rewrite <- Top. exact (below_top _ _ _ _ As J H).
  - intros (_ & H) r I. specialize (H (real_size r) (proj2 (sample_rows _) (ex_intro _ r (conj I eq_refl)))). rewrite <- Top in H.
    destruct (in_some_class (classes rs) _ _ As H) as (j & J & C). apply existsb_exists. exists j. split; [exact J|].
    rewrite Forall_forall in sizes. destruct (proper_class j J) as ((L & U) & _). apply is_in_class; [lra | lra | apply sizes, I | exact C].
Qed.

Lemma row_in r j : In r rows -> In j js -> (is_in j r = true <-> in_class d j (real_size r)).
Proof.
  intros I J. destruct (proper_class j J) as ((L & U) & _). rewrite Forall_forall in sizes. apply is_in_class; [lra | lra | apply sizes, I].
Qed.

Lemma one_size_iff j : In j js -> (one_size j rows = true <->
  forall r s, In r rows -> In s rows -> is_in j r = true -> is_in j s = true -> real_size r = real_size s).
Proof.
  intro J. unfold one_size. pose proof (fun r => filter_In (is_in j) r rows) as F. destruct (filter (is_in j) rows) as [|t ts].
  - split; [|reflexivity]. intros _ r s I _ H _. destruct (proj2 (F r) (conj I H)).
  - rewrite forallb_forall. split.
    + intro H. assert (forall r, In r rows -> is_in j r = true -> real_size t = real_size r) as All.
      { intros r I Hr. destruct (proj2 (F r) (conj I Hr)) as [<-|K]; [reflexivity|]. apply equal_real, H, K. }
      intros r s I I' Hr Hs. rewrite <- (All r I Hr). exact (All s I' Hs).
    + intros H s K. apply equal_real. destruct (proj1 (F t) (or_introl eq_refl)), (proj1 (F s) (or_intror K)). apply H; assumption.
Qed.

(* Condition 3: one size a class. *)
Theorem described_articulately :
  forallb (in_some_of js) rows = true /\ forallb (fun j => one_size j rows) js = true <->
  describes_articulately d rs (sample_of rows).
Proof.
  rewrite described, forallb_forall. split.
  - intros (D & H). apply one_size_articulate; [exact proper_gradation | exact D|]. intros j x y J X Y Cx Cy.
    apply sample_rows in X as (r & I & <-). apply sample_rows in Y as (s & I' & <-).
    apply (proj1 (one_size_iff j J) (H j J)); trivial; apply row_in; assumption.
  - intros (D & H). split; [exact D|]. intros j J. apply (one_size_iff j J). intros r s I I' Hr Hs.
    apply row_in in Hr, Hs; trivial. destruct proper_gradation as (A & _).
    assert (forall x y, In x (sample_of rows) -> In y (sample_of rows) -> in_class d j x -> in_class d j y -> x < y -> False) as No.
    { intros x y X Y (Lx & Ux) (Ly & Uy) L. destruct (H x y X Y L) as (t & It & Lt & Ut).
      apply (no_opening_inside rs j t A J It). lra. }
    pose proof (proj2 (sample_rows _) (ex_intro _ r (conj I eq_refl))) as X.
    pose proof (proj2 (sample_rows _) (ex_intro _ s (conj I' eq_refl))) as Y.
    destruct (Rtotal_order (real_size r) (real_size s)) as [L|[E|L]]; [|exact E|]; exfalso; eauto.
Qed.

(* Condition 4: up to one scale of the masses the classes hold what the gradation says. *)
Theorem described_accurately :
  forallb (in_some_of js) rows = true /\
  forallb (fun j => equal (times (mass_in j rows) (mass_of_classes js)) (times (mass j) (whole_mass js rows))) js = true <->
  describes_accurately d f rs (sample_of rows).
Proof.
  pose proof some_mass as M. pose proof some_particles as W. pose proof whole_is_mass_of_all as Whole.
  unfold mass_of_all in Whole. fold js in Whole.
  assert (Q2R (mass_of_classes js) = total (map (fun j => Q2R (mass j)) js)) as T.
  { symmetry. apply total_sum. reflexivity. }
  assert (forall j, In j js -> held d f j (sample_of rows) = Q2R (mass_in j rows)) as Held.
  { intros j J. apply mass_is_held; [apply proper_class, J | exact sizes]. }
  rewrite described, forallb_forall. split.
  - intros (D & H). exists (Q2R (whole_mass js rows) / Q2R (mass_of_classes js)). split; [apply Rdiv_lt_0_compat; assumption|].
    split; [exact D|]. intros j J. rewrite Held by exact J. specialize (H j J). apply equal_real in H. rewrite !Q2R_times in H.
    apply (Rmult_eq_reg_r (Q2R (mass_of_classes js))); [|lra]. rewrite H. field. lra.
  - intros (s & Sp & D & H). split; [exact D|]. intros j J. apply equal_real. rewrite !Q2R_times.
    assert (Q2R (whole_mass js rows) = s * Q2R (mass_of_classes js)) as E.
    { rewrite <- Whole, T. clear -H. fold js in H. assert (forall l, (forall j, In j l -> In j js) ->
        total (map (fun j => held d f j (sample_of rows)) l) = s * total (map (fun j => Q2R (mass j)) l)) as G.
      { induction l as [|j l IH]; intro Sub; cbn [map total fold_right]; [ring|]. unfold total in IH.
        rewrite IH by (intros; apply Sub; right; assumption). rewrite H by (apply Sub; left; reflexivity). ring. }
      apply G. auto. }
    rewrite E, <- Held by exact J. rewrite H by exact J. ring.
Qed.

End Gradation.
End Sample.
