(* What the functions of Numbers.v compute. *)

From Coq Require Import ZArith QArith List Bool Lia Lqa.
From Mdm Require Import Numbers.
Import ListNotations.
Open Scope Z_scope.

Lemma demand_ok holds what : demand holds what = Ok tt -> holds = true.
Proof. destruct holds; [reflexivity | discriminate]. Qed.

Lemma demand_form_ok holds what : demand_form holds what = Ok tt -> holds = true.
Proof. destruct holds; [reflexivity | discriminate]. Qed.

Lemma bind_ok {A B} (x : result A) (next : A -> result B) y :
  bind x next = Ok y -> exists z, x = Ok z /\ next z = Ok y.
Proof. destruct x; [exists a; auto | discriminate | discriminate]. Qed.

(* Takes apart a check that was passed. *)
Ltac passed H :=
  match type of H with
  | bind _ _ = Ok _ =>
    let x := fresh "x" in let H1 := fresh H in
    apply bind_ok in H as (x & H1 & H); cbv beta in H;
    try (destruct x;
         match type of H1 with
         | demand _ _ = _ => apply demand_ok in H1
         | demand_form _ _ = _ => apply demand_form_ok in H1
         end)
  | demand _ _ = _ => apply demand_ok in H
  | demand_form _ _ = _ => apply demand_form_ok in H
  end.

(* ---- Roots --------------------------------------------------------------------------------------- *)

Lemma root_digits_spec b n : 1 <= b -> forall i r,
  0 <= r -> r ^ b <= n < (r + 2 ^ Z.of_nat i) ^ b ->
  0 <= root_digits b n r i /\ root_digits b n r i ^ b <= n < (root_digits b n r i + 1) ^ b.
Proof.
  intros Hb. induction i as [|i IH]; intros r Hr H.
  - cbn [root_digits]. change (2 ^ Z.of_nat 0) with 1 in H. auto.
  - cbn [root_digits]. rewrite Nat2Z.inj_succ, Z.pow_succ_r in H by lia.
    assert (0 < 2 ^ Z.of_nat i) by (apply Z.pow_pos_nonneg; lia).
    destruct (Z.leb_spec ((r + 2 ^ Z.of_nat i) ^ b) n).
    + apply IH; [lia|]. split; [assumption|].
      replace (r + 2 ^ Z.of_nat i + 2 ^ Z.of_nat i) with (r + 2 * 2 ^ Z.of_nat i) by lia. apply H.
    + apply IH; [assumption|]. lia.
Qed.

Lemma root_spec b n : 1 <= b -> 0 <= n -> 0 <= root b n /\ root b n ^ b <= n < (root b n + 1) ^ b.
Proof.
  intros Hb Hn. unfold root. destruct (Z.eqb_spec b 1) as [->|N].
  { rewrite !Z.pow_1_r. lia. }
  apply root_digits_spec; [exact Hb | lia |]. rewrite Z.pow_0_l by lia. split; [exact Hn|].
  rewrite Z2Nat.id by (pose proof (Z.log2_nonneg n); pose proof (Z.div_pos (Z.log2 n) b); lia).
  rewrite Z.add_0_l, <- Z.pow_mul_r by (pose proof (Z.div_pos (Z.log2 n) b (Z.log2_nonneg n)); lia).
  destruct (Z.eq_dec n 0) as [->|]; [apply Z.pow_pos_nonneg; [lia|]; change (Z.log2 0) with 0; rewrite Z.div_0_l; lia|].
  apply Z.lt_le_trans with (2 ^ Z.succ (Z.log2 n)); [apply Z.log2_spec; lia|].
  apply Z.pow_le_mono_r; [lia|].
  pose proof (Z.div_mod (Z.log2 n) b ltac:(lia)). pose proof (Z.mod_pos_bound (Z.log2 n) b ltac:(lia)). lia.
Qed.

(* A count is above the root iff its power is above. *)
Lemma root_lt b n q : 1 <= b -> 0 <= n -> 0 <= q -> n < q ^ b <-> root b n < q.
Proof.
  intros Hb Hn Hq. destruct (root_spec b n Hb Hn) as (R0 & R1 & R2). split; intro H.
  - apply (Z.pow_lt_mono_l_iff _ _ b); lia.
  - apply Z.lt_le_trans with ((root b n + 1) ^ b); [exact R2|]. apply Z.pow_le_mono_l. lia.
Qed.

(* ---- Fractions ----------------------------------------------------------------------------------- *)

Lemma less_spec x y : less x y = true <-> (x < y)%Q.
Proof. unfold less, Qlt. apply Z.ltb_lt. Qed.

Lemma at_most_spec x y : at_most x y = true <-> (x <= y)%Q.
Proof. unfold at_most, Qle. apply Z.leb_le. Qed.

Lemma equal_spec x y : equal x y = true <-> (x == y)%Q.
Proof. unfold equal, Qeq. apply Z.eqb_eq. Qed.

Lemma less_false x y : less x y = false <-> (y <= x)%Q.
Proof. unfold less, Qle. apply Z.ltb_ge. Qed.

Lemma equal_false x y : equal x y = false <-> ~ (x == y)%Q.
Proof. unfold equal, Qeq. apply Z.eqb_neq. Qed.

Lemma sum_le xs ys : Forall2 Z.le xs ys -> sum xs <= sum ys.
Proof. induction 1; simpl; lia. Qed.
