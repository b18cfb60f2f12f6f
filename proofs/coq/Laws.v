(* The mass laws exist: spheres, and x^(a/b) for all a, b >= 1. *)

From Coq Require Import ZArith Reals Rpower Ranalysis Lia Lra.
From Mdm Require Import Spec Openings.
Open Scope R_scope.

Lemma pow_law n : (1 <= n)%nat -> power_law n 1 (fun x => x ^ n).
Proof.
  intro N. split.
  - split.
    + intros x _. apply derivable_continuous_pt, derivable_pt_pow.
    + intros x y H. apply pow_lt_compat; [lra | exact N].
    + rewrite pow_i by lia. lra.
  - intros x X. split; [apply pow_le, X | apply pow_1].
Qed.

Theorem sphere_law : power_law 3 1 sphere.
Proof. exact (pow_law 3 ltac:(lia)). Qed.

Definition root_of_power (a b : nat) (x : R) : R := if Rlt_dec 0 x then Rpower x (INR a / INR b) else 0.

Theorem power_law_exists a b : (1 <= a)%nat -> (1 <= b)%nat -> power_law a b (root_of_power a b).
Proof.
  intros A B. apply le_INR in A as Ar. apply le_INR in B as Br. simpl in Ar, Br.
  set (e := INR a / INR b). assert (0 < e) as E by (apply Rdiv_lt_0_compat; lra).
  assert (forall x, 0 < x -> root_of_power a b x = Rpower x e) as Pos.
  { intros x X. unfold root_of_power. destruct (Rlt_dec 0 x); [reflexivity | contradiction]. }
  assert (forall x, x <= 0 -> root_of_power a b x = 0) as Neg.
  { intros x X. unfold root_of_power. destruct (Rlt_dec 0 x); [lra | reflexivity]. }
  assert (forall x y, 0 <= x < y -> root_of_power a b x < root_of_power a b y) as Inc.
  { intros x y (X & L). rewrite (Pos y) by lra. destruct X as [X| <-].
    - rewrite (Pos x) by exact X. apply exp_increasing, Rmult_lt_compat_l; [exact E | apply ln_increasing; lra].
    - rewrite (Neg 0) by lra. apply exp_pos. }
  split; [split|].
  - intros x X. destruct X as [X| <-].
    + apply (continuity_pt_locally_ext (fun y => Rpower y e) _ x x X).
      * intros y Y. symmetry. apply Pos. unfold R_dist in Y. apply Rabs_def2 in Y. lra.
      * apply derivable_continuous_pt. exists (e * Rpower x (e - 1)). apply derivable_pt_lim_power, X.
    + intros eps H. exists (Rpower eps (/ e)). split; [apply exp_pos|].
      intros y (_ & Y). simpl in *. unfold R_dist in *. rewrite (Neg 0), Rminus_0_r in * by lra.
      destruct (Rlt_le_dec 0 y) as [P|N]; [|rewrite (Neg y N), Rabs_R0; exact H].
      rewrite Rabs_right in Y by lra. rewrite (Pos y P), Rabs_right by (left; apply exp_pos).
      replace eps with (Rpower (Rpower eps (/ e)) e)
        by (rewrite Rpower_mult, Rinv_l, Rpower_1 by lra; reflexivity).
      apply exp_increasing, Rmult_lt_compat_l; [exact E | apply ln_increasing; assumption].
  - exact Inc.
  - rewrite Neg; lra.
  - intros x X. destruct X as [X| <-].
    + rewrite (Pos x X). split; [left; apply exp_pos|].
      rewrite <- Rpower_pow by apply exp_pos. rewrite Rpower_mult. unfold e.
      replace (INR a / INR b * INR b) with (INR a) by (field; lra). apply Rpower_pow, X.
    + rewrite Neg by lra. split; [lra|]. rewrite !pow_i by lia. reflexivity.
Qed.
