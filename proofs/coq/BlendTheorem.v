(* What a line about a blend means, and that an accepted one is true of the files: Theorem 22 (a) to (c). *)

From Coq Require Import ZArith QArith Qabs List Bool String Lia Lqa.
From Mdm Require Import Numbers NumbersFacts Rows GradationFile Judge JudgeTheorem FileRoot Blend BlendCertificate BlendSieves
  BlendCheck BlendSound BlendJudged BlendLine.
Import ListNotations.
Open Scope list_scope.
Open Scope Q_scope.

(* ---- The box of the shares -------------------------------------------------------------------------- *)

Lemma quotient_up_le n d m : (0 < d)%Z -> (quotient_up n d <= m <-> n <= m * d)%Z.
Proof.
  intro D. unfold quotient_up. pose proof (Z.div_mod (n + d - 1) d ltac:(lia)). pose proof (Z.mod_pos_bound (n + d - 1) d D).
  split; intro H1; nia.
Qed.

Lemma share_is M x y n : (1 <= M)%Z ->
  holds (quotient_up (Qnum x * M) (Zpos (Qden x)), Qnum y * M / Zpos (Qden y))%Z n <->
  x <= inject_Z n / inject_Z M <= y.
Proof.
  intro M1. unfold holds. cbn [fst snd]. rewrite quotient_up_le by reflexivity.
  assert (x <= inject_Z n / inject_Z M <-> (Qnum x * M <= n * Zpos (Qden x))%Z) as ->.
  { destruct M as [|M|M]; try lia. unfold Qle, Qdiv, Qmult, Qinv. cbn [Qnum Qden inject_Z]. rewrite !Pos.mul_1_l, Z.mul_1_r. reflexivity. }
  assert (inject_Z n / inject_Z M <= y <-> (n * Zpos (Qden y) <= Qnum y * M)%Z) as ->.
  { destruct M as [|M|M]; try lia. unfold Qle, Qdiv, Qmult, Qinv. cbn [Qnum Qden inject_Z]. rewrite !Pos.mul_1_l, Z.mul_1_r. reflexivity. }
  assert (n <= Qnum y * M / Zpos (Qden y) <-> n * Zpos (Qden y) <= Qnum y * M)%Z as ->; [|reflexivity].
  pose proof (Z.div_mod (Qnum y * M) (Zpos (Qden y)) ltac:(lia)). pose proof (Z.mod_pos_bound (Qnum y * M) (Zpos (Qden y)) ltac:(lia)).
  split; intro; nia.
Qed.

Lemma within_shares_are M limits ns : (1 <= M)%Z -> forall b b', within_share_limits M limits b = Ok b' ->
  in_box b' ns <-> in_box b ns /\
  forall i x y, In (i, x, y) limits -> exists n, numbered i ns = Some n /\ x <= inject_Z n / inject_Z M <= y.
Proof.
  intro M1. induction limits as [|((i, x), y) limits IH]; intros b b' H; simpl in H.
  { injection H as <-. split; [intro F; split; [exact F | intros ? ? ? []] | tauto]. }
  set (up := quotient_up (Qnum x * M) (Zpos (Qden x))) in *. set (down := (Qnum y * M / Zpos (Qden y))%Z) in *.
  destruct (changed i _ b) as [b1|] eqn:E; [|discriminate]. rewrite (IH _ _ H).
  assert (forall n, holds (up, down) n <-> x <= inject_Z n / inject_Z M <= y) as Sh by (intro n; apply (share_is M x y n M1)).
  split.
  - intros (F & A). apply (changed_before _ _ _ _ _ E) in F as (F & n & (lo, hi) & N & K).
    2: { intros (lo, hi) n. unfold holds. simpl. lia. }
    split; [exact F|]. intros i' x' y' [[= <- <- <-]|I]; [|exact (A _ _ _ I)].
    exists n. split; [exact N|]. apply Sh. revert K. unfold holds. simpl. lia.
  - intros (F & A). split; [|intros i' x' y' I; apply A; right; exact I].
    destruct (changed_keeps _ _ _ _ _ E F) as (n & N & K). apply K. intros (lo, hi) L.
    destruct (A i x y (or_introl eq_refl)) as (n' & N' & B). assert (n' = n) as -> by congruence.
    apply Sh in B. revert L B. unfold holds. simpl. lia.
Qed.

Lemma sum_of_steps_from_0 ns : Forall (fun n => (0 <= n)%Z) ns -> (0 <= sum_of_steps ns)%Z.
Proof. induction 1; simpl; lia. Qed.

Lemma full_box {A} (l : list A) M ns : sum_of_steps ns = M ->
  in_box (map (fun _ => (0, M)%Z) l) ns <-> List.length ns = List.length l /\ Forall (fun n => (0 <= n)%Z) ns.
Proof.
  intro S. split.
  - intro F. split; [rewrite <- (box_length _ _ F), map_length; reflexivity|]. clear S. revert ns F. induction l as [|x l IH]; intros ns F;
      inversion F as [|? n ? ms (H1 & _) F']; subst; constructor; [exact H1 | apply IH, F'].
  - intros (L & P). assert (sum_of_steps ns <= M)%Z as Le by lia. clear S. revert ns L P Le.
    induction l as [|x l IH]; intros [|n ns] L P Le; try discriminate L; [constructor|]. simpl in *. inversion P; subst.
    pose proof (sum_of_steps_from_0 ns ltac:(assumption)). constructor; [unfold holds; simpl; lia|]. apply IH; [congruence | assumption | lia].
Qed.

(* ---- An accepted certificate ------------------------------------------------------------------------ *)

Section Accepted.
Variables (C : blend_certificate) (curves : list curve) (limits : list (Q * Q * Q)) (js : list judged) (v : Q).
Let q := asked_blend C.
Hypothesis are_judged : all_judged curves limits q = Ok js.
Hypothesis accepted : check_blend_claim C curves js = Ok v.

Lemma steps_are_positive : (1 <= steps q)%Z.
Proof. pose proof accepted as H. unfold check_blend_claim in H. cbv zeta in H. passed H. apply Z.leb_le, H0. Qed.

Lemma aim_is_fit :
  match aim_of q with
  | NoAim => True
  | Cost cs => List.length cs = List.length curves
  | Deviation ts | MaxDeviation ts | Squares ts => List.length ts = List.length (sieves_with_targets limits curves)
  end.
Proof.
  pose proof accepted as H. unfold check_blend_claim in H. cbv zeta in H. passed H. passed H. passed H. passed H. fold q in H3.
  unfold check_aim in H3. rewrite <- (number_of_sieves curves limits q js are_judged).
  destruct (aim_of q); [exact I|..]; destruct x0; apply demand_ok in H3; apply Z.eqb_eq in H3; rewrite !size_is_length in H3; lia.
Qed.

Lemma question_is_answerable : answerable limits curves q.
Proof.
  destruct (all_judged_are curves limits q js are_judged) as (_ & _ & A & B & D & _). constructor; try assumption.
  - exact steps_are_positive.
  - exact aim_is_fit.
Qed.

(* In other words, what is allowed. *)
Lemma allowed_is b ns : whole_box q curves = Ok b ->
  allowed limits curves q ns <->
  sum_of_steps ns = steps q /\ in_box b ns /\ (forall K, most_stockpiles q = Some K -> (used ns <= K)%Z) /\
  Forall (keeps (steps q) ns) js.
Proof.
  intro Eb. pose proof steps_are_positive as M1. unfold whole_box in Eb.
  pose proof (within_shares_are (steps q) (share_limits q) ns M1 _ _ Eb) as Box. split.
  - intros [A1 A2 A3 A4 A5 A6 A7 A8]. split; [exact A3|]. split; [apply Box; split; [apply full_box; auto | exact A4]|].
    split; [exact A5|]. apply (judged_kept curves limits q js are_judged); auto.
  - intros (S & F & U & K). apply Box in F as (F & Sh). apply full_box in F as (L & P); [|exact S].
    apply (judged_kept curves limits q js are_judged) in K as (K1 & K2 & K3); trivial. constructor; assumption.
Qed.

Lemma tree_bounds b claimed : whole_box q curves = Ok b -> check_blend_tree q curves js claimed (blend_tree C) [b] = Ok tt ->
  forall ms, allowed limits curves q ms -> exists c, claimed = Some c /\ c <= value limits curves q ms.
Proof.
  intros Eb T ms A. pose proof A as [A1 A2 A3 _ A5 _ _ _]. apply (allowed_is b ms Eb) in A as (_ & F & _ & K).
  assert (match aim_of q with NoAim | Cost _ => True
    | Deviation ts | MaxDeviation ts | Squares ts => List.length ts = List.length (sieves_with_targets limits curves) end) as Fit.
  { pose proof aim_is_fit as Af. destruct (aim_of q); trivial. }
  rewrite <- (value_is curves limits q js are_judged ms Fit).
  apply (tree_below (steps q) js ms steps_are_positive) with (curves := curves) (nodes := blend_tree C) (open := [b]) (b := b);
    trivial; try (symmetry; assumption).
  - rewrite A1. apply (judged_of_each curves limits q js are_judged).
  - intros cs E. pose proof aim_is_fit as Af. rewrite E in Af. congruence.
  - left. reflexivity.
Qed.

(* Theorem 22 (a) to (c): an accepted blend is allowed and has its value, and none that is allowed has a lower one; or none is. *)
Theorem accepted_blend_best : best_blend limits curves q (claimed_blend C) v.
Proof.
  pose proof accepted as H. unfold check_blend_claim in H. cbv zeta in H. fold q in H. passed H. passed H. passed H. rename x into b.
  passed H. destruct x. clear H0 H1 H3. rename H2 into Eb.
  assert (match aim_of q with NoAim | Cost _ => True
    | Deviation ts | MaxDeviation ts | Squares ts => List.length ts = List.length (sieves_with_targets limits curves) end) as Fit.
  { pose proof aim_is_fit as Af. destruct (aim_of q); trivial. }
  unfold best_blend. destruct (claimed_blend C) as [ns|].
  - passed H. destruct x. unfold check_blend_itself in H0. passed H0. passed H0. passed H0. passed H0. apply demand_ok in H0.
    apply Z.eqb_eq in H2. apply is_in_box_is in H3.
    assert (value_of_blend (steps q) (aim_of q) js ns == value limits curves q ns) as V.
    { rewrite <- (value_is curves limits q js are_judged ns Fit). apply value_of_blend_is. }
    assert (allowed limits curves q ns) as A.
    { apply (allowed_is b ns Eb). split; [exact H2|]. split; [exact H3|]. split.
      - intros K E. rewrite E in H4. apply Z.leb_le, H4.
      - apply Forall_forall. intros j I. rewrite forallb_forall in H0. specialize (H0 j I). unfold keeps_limits in H0.
        apply andb_prop in H0 as (B1 & B2). apply at_most_spec in B1, B2. rewrite mean_of_is in B1, B2. split; assumption. }
    destruct (has_aim (aim_of q)) eqn:Ha.
    + passed H. destruct x. injection H as Ev. rewrite <- Ev. split; [exact A|]. split; [symmetry; exact V|]. intros ms Am.
      destruct (tree_bounds b _ Eb H5 ms Am) as (c & [= <-] & Le). exact Le.
    + injection H as Ev. rewrite <- Ev. split; [exact A|]. split; [symmetry; exact V|]. intros ms Am. unfold value.
      destruct (aim_of q); try discriminate Ha. apply Qle_refl.
  - passed H. destruct x. intros ms Am. destruct (tree_bounds b None Eb H0 ms Am) as (c & [=] & _).
Qed.
End Accepted.

(* ---- The line --------------------------------------------------------------------------------------- *)

Definition specification_has (f : file) (limits : list (Q * Q * Q)) : Prop :=
  exists R, read_gradation (bytes f) = Ok R /\ limits_in_mm R = Some limits.
Definition stockpile_has (f : file) (c : curve) : Prop := exists R, read_gradation (bytes f) = Ok R /\ curve_in R = Some c.

(* The sieves that the line names are those with targets, and it says of each stockpile at which of them it is interpolated. *)
Definition names_sieves (limits : list (Q * Q * Q)) (curves : list curve) (js : list judged) : Prop :=
  sizes_of_sieves js = sieves_with_targets limits curves.

Definition true_of_blend_line (specification : file) (stockpiles : list file) (line : string) : Prop :=
  exists s limits curves,
    line = blend_line s /\ specification_name s = name specification /\ stockpile_names s = map name stockpiles /\
    specification_has specification limits /\ Forall2 stockpile_has stockpiles curves /\
    answerable limits curves (question_said s) /\ names_sieves limits curves (judged_said s) /\
    best_blend limits curves (question_said s) (claim_said s) (value_said s).

Lemma sizes_are curves limits q js : all_judged curves limits q = Ok js -> names_sieves limits curves js.
Proof.
  intro J. unfold names_sieves. rewrite sieves_are.
  destruct (all_judged_are _ _ _ _ J) as (_ & _ & _ & _ & _ & ->). unfold sizes_of_sieves. rewrite !flat_map_app.
  assert (forall l, flat_map (fun j => match by_what j with BySieve s => [s] | _ => [] end) (map (judged_modulus curves) l) = []) as ->.
  { intro l. induction l as [|((st, x), y) l IH]; [reflexivity | exact IH]. }
  assert (forall l, flat_map (fun j => match by_what j with BySieve s => [s] | _ => [] end) (judged_factors curves l) = []) as ->.
  { intros [(x, y)|]; [|reflexivity]. unfold judged_factors. destruct (less 0 x), (less y hundred); reflexivity. }
  rewrite !app_nil_r. clear J. induction (told_limits curves limits) as [|((s, l), m) ls IH]; [reflexivity|].
  cbn [map flat_map]. rewrite IH. reflexivity.
Qed.

Lemma read_all_named_ok fs : forall Rs, read_all_named fs = Ok Rs -> Forall2 (fun f R => read_gradation (bytes f) = Ok R) fs Rs.
Proof.
  induction fs as [|f fs IH]; intros Rs H; simpl in H; [injection H as <-; constructor|].
  passed H. passed H. injection H as <-. constructor; [|apply IH, H1]. unfold read_named in H0.
  destruct (read_gradation (bytes f)); [exact H0 | discriminate..].
Qed.

Lemma all_curves_ok Rs : forall cs, all_curves Rs = Some cs -> Forall2 (fun R c => curve_in R = Some c) Rs cs.
Proof.
  induction Rs as [|R Rs IH]; intros cs H; simpl in H; [injection H as <-; constructor|].
  destruct (curve_in R) as [c|] eqn:E; [|discriminate]. destruct (all_curves Rs) as [cs'|]; [|discriminate].
  injection H as <-. constructor; [exact E | apply IH; reflexivity].
Qed.

(* If the line that is printed begins with "accepted", it is true of the specification and the stockpiles in the files. *)
Theorem accepted_blend_line_true specification stockpiles certificate line :
  printed (judge_blend specification stockpiles certificate) = Some line -> begins_with "accepted" line ->
  true_of_blend_line specification stockpiles line.
Proof.
  unfold judge_blend. cbv zeta. intros P B.
  destruct (bind (read_named specification) _) as [(R, Rs)| |] eqn:E; try discriminate P.
  passed E. passed E. injection E as -> ->.
  destruct (read_blend_certificate _) as [C| |]; try discriminate P.
  destruct (check_readings C R Rs) as [(js, v)|what|what] eqn:Ec; try discriminate P.
  2: { injection P as <-. destruct B as (rest & B). discriminate B. }
  injection P as <-. unfold check_readings in Ec. destruct (limits_in_mm R) as [limits|] eqn:El; [|discriminate].
  destruct (all_curves Rs) as [curves|] eqn:Ecs; [|discriminate]. unfold check_blend in Ec.
  passed Ec. passed Ec. passed Ec. injection Ec as -> ->.
  exists (statement_of_blend specification stockpiles C js v), limits, curves. split; [reflexivity|]. split; [reflexivity|].
  split; [reflexivity|]. split.
  { exists R. split; [|exact El]. unfold read_named in E0. destruct (read_gradation (bytes specification)); [exact E0 | discriminate..]. }
  split.
  { apply read_all_named_ok in E1. apply all_curves_ok in Ecs. clear -E1 Ecs. revert curves Ecs.
    induction E1 as [|f R fs Rs H F IH]; intros cs G; inversion G; subst; constructor; [exists R; auto | apply IH; assumption]. }
  split; [apply (question_is_answerable C curves limits js v Ec0 Ec2)|]. split; [apply (sizes_are _ _ _ _ Ec0)|].
  apply (accepted_blend_best C curves limits js v Ec0 Ec2).
Qed.
