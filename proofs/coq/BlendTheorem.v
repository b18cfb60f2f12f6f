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

(* Where a stockpile is interpolated: at the sieves that have targets, at those of the moduli, and at those of a factor that is
   limited. *)
Definition factor_limits_something (q : blend_question) : bool :=
  match coarseness_limits q with Some (x, y) => less 0 x || less y hundred | None => false end.
Definition interpolated_at (limits : list (Q * Q * Q)) (curves : list curve) (q : blend_question) (c : curve) : interpolation :=
  Interpolation
    (filter (fun s => is_interpolated_at s c) (sieves_with_targets limits curves))
    (existsb (fun '(st, _, _) => existsb (fun s => is_interpolated_at s c) (sieves_of_modulus st)) (modulus_limits q))
    (factor_limits_something q && (is_interpolated_at coarse_sieve c || is_interpolated_at fine_sieve c)).

(* The statement is true of these files: of the limits and the stockpiles that are read from their bytes. *)
Definition is_true_of_blend (specification : file) (stockpiles : list file) (s : blend_statement) : Prop :=
  let q := question_said s in
  specification_name s = name specification /\ stockpile_names s = map name stockpiles /\
  exists limits curves, specification_has specification limits /\ Forall2 stockpile_has stockpiles curves /\
    answerable limits curves q /\ sieves_said s = sieves_with_targets limits curves /\
    interpolations_said s = map (interpolated_at limits curves q) curves /\
    best_blend limits curves q (claim_said s) (value_said s).

(* A line has one statement at most: blend_line_determines. *)
Definition true_of_blend_line (specification : file) (stockpiles : list file) (line : string) : Prop :=
  exists s, plain_blend_statement s = true /\ line = blend_line s /\ is_true_of_blend specification stockpiles s.

(* ---- What the line says of sieves and of the aim ----------------------------------------------------- *)

Lemma sizes_of_others f js : (forall j, In j js -> is_by_sieve j = false) -> sizes_of_sieves (filter f js) = [].
Proof.
  intro N. unfold sizes_of_sieves. induction js as [|j js IH]; [reflexivity|]. pose proof (N j (or_introl eq_refl)) as B.
  specialize (IH (fun k I => N k (or_intror I))). cbn [filter]. destruct (f j); [|exact IH]. cbn [flat_map]. rewrite IH.
  unfold is_by_sieve in B. destruct (by_what j); [discriminate B | reflexivity | reflexivity].
Qed.

Lemma moduli_are_no_sieves curves ls j : In j (map (judged_modulus curves) ls) -> by_what j = ByModulus.
Proof. intro I. apply in_map_iff in I as (((st, x), y) & <- & _). reflexivity. Qed.

Lemma factors_are_no_sieves curves l j : In j (judged_factors curves l) -> by_what j = ByFactor.
Proof.
  destruct l as [(x, y)|]; [|intros []]. unfold judged_factors.
  destruct (less 0 x), (less y hundred); cbn [app In]; intuition (subst; reflexivity).
Qed.

Lemma no_others (js : list judged) (f p : judged -> bool) : (forall j, In j js -> p j = false) -> existsb p (filter f js) = false.
Proof.
  intro N. apply not_true_is_false. intro H. apply existsb_exists in H as (j & I & P). apply filter_In in I as (I & _).
  rewrite (N j I) in P. discriminate P.
Qed.

Section Interpolated.
Variables (limits : list (Q * Q * Q)) (curves : list curve) (q : blend_question) (js : list judged).
Hypothesis are_judged : all_judged curves limits q = Ok js.

Let sieves := map (judged_sieve curves) (told_limits curves limits).
Let moduli := map (judged_modulus curves) (modulus_limits q).
Let factors := judged_factors curves (coarseness_limits q).

Lemma judged_in_parts : js = sieves ++ moduli ++ factors.
Proof. apply (all_judged_are _ _ _ _ are_judged). Qed.

Lemma sizes_are : sizes_of_sieves js = sieves_with_targets limits curves.
Proof.
  rewrite judged_in_parts, sieves_are. unfold sizes_of_sieves. rewrite !flat_map_app.
  assert (forall l, (forall j, In j l -> by_what j = ByModulus \/ by_what j = ByFactor) ->
    flat_map (fun j => match by_what j with BySieve s => [s] | _ => [] end) l = []) as None.
  { induction l as [|j l IH]; intro N; [reflexivity|]. cbn [flat_map]. rewrite IH by (intros k I; apply N; right; exact I).
    destruct (N j (or_introl eq_refl)) as [-> | ->]; reflexivity. }
  rewrite (None moduli) by (intros j I; left; exact (moduli_are_no_sieves _ _ _ I)).
  rewrite (None factors) by (intros j I; right; exact (factors_are_no_sieves _ _ _ I)).
  rewrite !app_nil_r. unfold sieves. induction (told_limits curves limits) as [|((s, l), m) ls IH]; [reflexivity|].
  cbn [map flat_map]. rewrite IH. reflexivity.
Qed.

Lemma interpolation_is i c : nth_error curves i = Some c -> interpolation_of js i = interpolated_at limits curves q c.
Proof.
  intro N. unfold interpolation_of, interpolated_at. cbv zeta. rewrite judged_in_parts.
  unfold interpolated_in. set (f := fun j => nth i (interpolated_judged j) false). rewrite !filter_app.
  assert (forall g, nth i (map g curves) false = g c) as Nth.
  { intro g. apply (map_nth_error g) in N. exact (nth_error_nth _ _ _ N). }
  f_equal.
  - unfold sizes_of_sieves. rewrite !flat_map_app. fold (sizes_of_sieves (filter f moduli)) (sizes_of_sieves (filter f factors)).
    rewrite (sizes_of_others f moduli) by (intros j I; unfold is_by_sieve; rewrite (moduli_are_no_sieves _ _ _ I); reflexivity).
    rewrite (sizes_of_others f factors) by (intros j I; unfold is_by_sieve; rewrite (factors_are_no_sieves _ _ _ I); reflexivity).
    rewrite !app_nil_r, sieves_are. unfold sieves. induction (told_limits curves limits) as [|((s, l), m) ls IH]; [reflexivity|].
    cbn [map filter]. unfold f at 1. cbn [judged_sieve interpolated_judged]. rewrite Nth.
    destruct (is_interpolated_at s c); [|exact IH]. cbn [flat_map judged_sieve by_what app]. rewrite IH. reflexivity.
  - rewrite !existsb_app, (no_others sieves), (no_others factors); [cbn [orb]; rewrite orb_false_r| |].
    + unfold moduli. induction (modulus_limits q) as [|((st, x), y) ls IH]; [reflexivity|]. cbn [map filter existsb]. rewrite <- IH.
      unfold f at 1. cbn [judged_modulus interpolated_judged]. rewrite Nth. destruct (existsb _ (sieves_of_modulus st)); reflexivity.
    + intros j I. unfold is_by_modulus. rewrite (factors_are_no_sieves _ _ _ I). reflexivity.
    + intros j I. apply in_map_iff in I as (((s, x), y) & <- & _). reflexivity.
  - rewrite !existsb_app, (no_others sieves), (no_others moduli); [cbn [orb]| |].
    + unfold factors, judged_factors, factor_limits_something. destruct (coarseness_limits q) as [(x, y)|]; [|reflexivity].
      assert (forall z l m js', existsb is_by_factor (filter f (judged_factor curves z l m :: js')) =
        (is_interpolated_at coarse_sieve c || is_interpolated_at fine_sieve c) || existsb is_by_factor (filter f js')) as Factor.
      { intros z l m js'. cbn [filter]. unfold f at 1. cbn [judged_factor interpolated_judged]. rewrite Nth.
        destruct (is_interpolated_at coarse_sieve c || is_interpolated_at fine_sieve c); reflexivity. }
      destruct (less 0 x), (less y hundred); cbn [app]; rewrite ?Factor;
        destruct (is_interpolated_at coarse_sieve c || is_interpolated_at fine_sieve c); reflexivity.
    + intros j I. unfold is_by_factor. rewrite (moduli_are_no_sieves _ _ _ I). reflexivity.
    + intros j I. apply in_map_iff in I as (((s, x), y) & <- & _). reflexivity.
Qed.

Lemma same_length {A B} (P : A -> B -> Prop) l m : Forall2 P l m -> List.length l = List.length m.
Proof. induction 1; cbn [List.length]; congruence. Qed.

Lemma interpolations_are fs : forall i cs, (forall n, nth_error curves (i + n) = nth_error cs n) -> List.length fs = List.length cs ->
  interpolations_of js i fs = map (interpolated_at limits curves q) cs.
Proof.
  induction fs as [|f fs IH]; intros i [|c cs] N L; try discriminate L; [reflexivity|]. cbn [interpolations_of map]. f_equal.
  - apply interpolation_is. rewrite <- (Nat.add_0_r i), N. reflexivity.
  - apply IH; [|injection L as L; exact L]. intro n. rewrite Nat.add_succ_comm, N. reflexivity.
Qed.
End Interpolated.

Section Aim.
Variables (limits : list (Q * Q * Q)) (curves : list curve) (C : blend_certificate).
Let q := asked_blend C.

Lemma allowed_in_line ns : allowed limits curves (asked_in_line C) ns -> allowed limits curves q ns.
Proof. intros [A1 A2 A3 A4 A5 A6 A7 A8]. constructor; assumption. Qed.

Lemma answerable_in_line : answerable limits curves q -> answerable limits curves (asked_in_line C).
Proof.
  intros [A1 A2 A3 A4 A5]. constructor; try assumption. cbn [asked_in_line aim_of]. fold q.
  destruct (claimed_blend C), (aim_of q); exact A5.
Qed.

Lemma best_in_line v : best_blend limits curves q (claimed_blend C) v -> best_blend limits curves (asked_in_line C) (claimed_blend C) v.
Proof.
  intro B. destruct (claimed_blend C) as [ns|] eqn:E.
  - assert (asked_in_line C = q) as -> by (unfold asked_in_line; rewrite E; fold q; destruct q; reflexivity). exact B.
  - intros ms A. exact (B ms (allowed_in_line ms A)).
Qed.
End Aim.

(* ---- The line is true -------------------------------------------------------------------------------- *)

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
  unfold judge_blend. cbv zeta. intros P B. destruct (given_twice _); [discriminate P|].
  destruct (bind (read_named specification) _) as [(R, Rs)| |] eqn:E; try discriminate P.
  passed E. passed E. injection E as -> ->.
  destruct (read_blend_certificate _) as [C| |]; try discriminate P.
  destruct (bind (check_readings C R Rs) _) as [s|what|what] eqn:Ec; try discriminate P.
  2: { injection P as <-. destruct B as (rest & B). discriminate B. }
  injection P as <-. passed Ec. destruct x as (js, v). passed Ec. injection Ec as <-. rename Ec0 into Ec, Ec1 into Plain.
  unfold check_readings in Ec. destruct (limits_in_mm R) as [limits|] eqn:El; [|discriminate].
  destruct (all_curves Rs) as [curves|] eqn:Ecs; [|discriminate]. unfold check_blend in Ec.
  passed Ec. passed Ec. passed Ec. injection Ec as -> ->.
  assert (Forall2 stockpile_has stockpiles curves) as Curves.
  { apply read_all_named_ok in E1. apply all_curves_ok in Ecs. clear -E1 Ecs. revert curves Ecs.
    induction E1 as [|f R fs Rs H F IH]; intros cs G; inversion G; subst; constructor; [exists R; auto | apply IH; assumption]. }
  exists (statement_of_blend specification stockpiles C js v). split; [exact Plain|]. split; [reflexivity|]. split; [reflexivity|].
  split; [reflexivity|]. exists limits, curves. split.
  { exists R. split; [|exact El]. unfold read_named in E0. destruct (read_gradation (bytes specification)); [exact E0 | discriminate..]. }
  split; [exact Curves|]. cbn [statement_of_blend question_said sieves_said interpolations_said claim_said value_said].
  split; [apply answerable_in_line, (question_is_answerable C curves limits js v Ec0 Ec2)|].
  split; [exact (sizes_are _ _ _ _ Ec0)|]. split; [|apply best_in_line, (accepted_blend_best C curves limits js v Ec0 Ec2)].
  rewrite (interpolations_are _ _ _ _ Ec0 stockpiles 0%nat curves (fun n => eq_refl) (same_length _ _ _ Curves)). reflexivity.
Qed.
