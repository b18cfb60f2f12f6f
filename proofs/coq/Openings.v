(* Powers of real numbers, and the openings of Spec.v, which are roots. *)

From Coq Require Import ZArith QArith Reals Qreals Rpower Lia Lra.
From Mdm Require Import Gradation Spec.
Open Scope R_scope.

(* ---- Powers -------------------------------------------------------------------------------------- *)

Lemma pow_lt_compat x y n : 0 <= x < y -> (1 <= n)%nat -> x ^ n < y ^ n.
Proof.
  intros (X & L) N. destruct n as [|n]; [lia|]. clear N. induction n as [|n IH]; [simpl; lra|].
  change (x * x ^ S n < y * y ^ S n).
  assert (0 <= x ^ S n) by (apply pow_le; exact X).
  apply Rle_lt_trans with (y * x ^ S n); [apply Rmult_le_compat_r; lra|].
  apply Rmult_lt_compat_l; lra.
Qed.

Lemma pow_lt_iff x y n : 0 <= x -> 0 <= y -> (1 <= n)%nat -> x < y <-> x ^ n < y ^ n.
Proof.
  intros X Y N. split; [intro; apply pow_lt_compat; [lra | exact N]|].
  intro H. destruct (Rlt_le_dec x y) as [|L]; [assumption|]. pose proof (pow_incr y x n ltac:(lra)). lra.
Qed.

Lemma pow_le_iff x y n : 0 <= x -> 0 <= y -> (1 <= n)%nat -> x <= y <-> x ^ n <= y ^ n.
Proof.
  intros X Y N. split; [intro; apply pow_incr; lra|].
  intro H. destruct (Rle_lt_dec x y) as [|L]; [assumption|]. pose proof (pow_lt_compat y x n ltac:(lra) N). lra.
Qed.

Lemma real_root y n : 0 < y -> (1 <= n)%nat -> exists s, 0 < s /\ s ^ n = y.
Proof.
  intros Y N. exists (Rpower y (/ INR n)). assert (0 < Rpower y (/ INR n)) as P by apply exp_pos.
  split; [exact P|]. rewrite <- Rpower_pow by exact P. rewrite Rpower_mult, Rinv_l, Rpower_1; [reflexivity | exact Y|].
  apply not_0_INR. lia.
Qed.

(* ---- Openings ------------------------------------------------------------------------------------ *)

Lemma Q2R_0 : Q2R 0 = 0.
Proof. unfold Q2R; simpl. field. Qed.

Section Root.
Context {d : positive}.

Lemma degree_positive : 1 <= IZR (Zpos d).
Proof. apply (IZR_le 1). lia. Qed.

Lemma nth_root_nonneg y : 0 <= nth_root d y.
Proof. unfold nth_root. destruct (Rlt_dec 0 y); [left; apply exp_pos | lra]. Qed.

(* Of all y >= 0 the root is the only x >= 0 with x^d = y: nth_root_unique. *)
Lemma nth_root_power y : 0 <= y -> nth_root d y ^ Pos.to_nat d = y.
Proof.
  intro Y. unfold nth_root. destruct (Rlt_dec 0 y) as [P|N].
  - rewrite <- Rpower_pow, Rpower_mult by apply exp_pos.
    rewrite INR_IZR_INZ, positive_nat_Z, Rinv_l by (pose proof degree_positive; lra). apply Rpower_1, P.
  - rewrite pow_i by lia. lra.
Qed.

Lemma nth_root_lt x y : 0 <= x < y -> nth_root d x < nth_root d y.
Proof.
  intros (X & L). unfold nth_root. destruct (Rlt_dec 0 y) as [Y|]; [|lra].
  destruct (Rlt_dec 0 x) as [P|]; [|apply exp_pos].
  apply exp_increasing, Rmult_lt_compat_l; [apply Rinv_0_lt_compat; pose proof degree_positive; lra|].
  apply ln_increasing; assumption.
Qed.

Lemma nth_root_le x y : x <= y -> nth_root d x <= nth_root d y.
Proof.
  intro L. destruct (Rlt_le_dec 0 x) as [X|X].
  - destruct L as [L| ->]; [left; apply nth_root_lt; lra | lra].
  - pose proof (nth_root_nonneg y). unfold nth_root at 1. destruct (Rlt_dec 0 x); lra.
Qed.

Lemma nth_root_unique x : 0 <= x -> nth_root d (x ^ Pos.to_nat d) = x.
Proof.
  intro X. assert (0 <= x ^ Pos.to_nat d) as P by (apply pow_le, X). pose proof (nth_root_power _ P) as E.
  pose proof (nth_root_nonneg (x ^ Pos.to_nat d)) as R. set (r := nth_root d _) in *.
  destruct (Rtotal_order r x) as [L|[|L]]; [|assumption|].
  - pose proof (pow_lt_compat r x (Pos.to_nat d) ltac:(lra) ltac:(lia)). lra.
  - pose proof (pow_lt_compat x r (Pos.to_nat d) ltac:(lra) ltac:(lia)). lra.
Qed.

Lemma size_lt x y : 0 <= Q2R x < Q2R y -> 0 <= size_of d x < size_of d y.
Proof. intro H. split; [apply nth_root_nonneg | apply nth_root_lt, H]. Qed.

Lemma size_0 x : Q2R x = 0 -> size_of d x = 0.
Proof. intro E. unfold size_of, nth_root. destruct (Rlt_dec 0 (Q2R x)); lra. Qed.

End Root.

(* Where the root is 1, the openings are what the gradation has. *)
Lemma nth_root_1 y : 0 <= y -> nth_root 1 y = y.
Proof. intro Y. rewrite <- (nth_root_power (d := 1) y Y) at 2. symmetry. apply pow_1. Qed.

(* ---- The law at openings ------------------------------------------------------------------------- *)

(* What is known of a law at the openings of a gradation with the root d, which are given by their powers. *)
Definition opening_law (d : positive) (na nb : nat) (law : R -> R) : Prop :=
  mass_law law /\
  forall y, 0 <= Q2R y -> 0 <= law (size_of d y) /\ law (size_of d y) ^ nb = Q2R y ^ na.

(* x^(a/b) = Y^(a/(b d)), where Y = x^d. *)
Lemma law_at_openings d na nb law : power_law na nb law -> opening_law d na (nb * Pos.to_nat d) law.
Proof.
  intros (Law & P). split; [exact Law|]. intros y Y. destruct (P (size_of d y) (nth_root_nonneg _)) as (L & E).
  split; [exact L|]. rewrite pow_mult, E, <- pow_mult, Nat.mul_comm, pow_mult. f_equal. apply nth_root_power, Y.
Qed.

Lemma law_in_lowest_terms d na nb n law :
  (1 <= n)%nat -> opening_law d (na * n) (nb * n) law -> opening_law d na nb law.
Proof.
  intros N (Law & P). split; [exact Law|]. intros y Y. destruct (P y Y) as (L & E). split; [exact L|].
  rewrite !pow_mult in E. pose proof (pow_le _ nb L). pose proof (pow_le _ na Y).
  apply Rle_antisym; apply (pow_le_iff _ _ n); trivial; lra.
Qed.
