(* The bounds of pi that the checker accepts are bounds of the pi of Coq's real numbers (Machin's formula). *)

From Coq Require Import ZArith QArith Reals Qreals Ratan Machin AltSeries Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Certificate Question Spec Reduction RealFacts.
Open Scope R_scope.

(* The terms k, k + 1, ... of the series of arctan(x). *)
Fixpoint terms_from (x : R) (k n : nat) : R :=
  match n with
  | O => 0
  | S n => tg_alt (Ratan_seq x) k + terms_from x (S k) n
  end.

Lemma terms_last x n : forall k, terms_from x k (S n) = terms_from x k n + tg_alt (Ratan_seq x) (k + n).
Proof.
  induction n as [|n IH]; intro k; [simpl; rewrite Nat.add_0_r; ring|].
  change (terms_from x k (S (S n))) with (tg_alt (Ratan_seq x) k + terms_from x (S k) (S n)).
  rewrite IH. simpl. replace (k + S n)%nat with (S (k + n)) by lia. ring.
Qed.

Lemma terms_sum x n : sum_f_R0 (tg_alt (Ratan_seq x)) n = terms_from x 0 (S n).
Proof.
  induction n as [|n IH]; [simpl; ring|]. rewrite terms_last. simpl sum_f_R0. rewrite IH. reflexivity.
Qed.

(* Enough terms of an even number are below arctan(x), and off by less than the next term. *)
Lemma arctan_terms x n :
  0 < x < 1 ->
  terms_from x 0 (S (S (2 * n))) <= atan x <= terms_from x 0 (S (S (2 * n))) + x ^ (2 * (2 * S n) + 1) / INR (2 * (2 * S n) + 1).
Proof.
  intro X. rewrite atan_eq_ps_atan by exact X. unfold ps_atan.
  destruct (in_int x) as [I|I]; [|lra]. destruct (ps_atan_exists_1 x I) as (l & L).
  pose proof (Ratan_seq_decreasing x ltac:(lra)) as D. pose proof (Ratan_seq_converging x ltac:(lra)) as C.
  destruct (alternated_series_ineq _ _ n D C L) as (A & _).
  destruct (alternated_series_ineq _ _ (S n) D C L) as (_ & B).
  rewrite terms_sum in A, B. split; [exact A|].
  rewrite terms_last in B. replace (0 + 2 * S n)%nat with (2 * S n)%nat in B by lia.
  unfold tg_alt in B. rewrite pow_1_even in B. unfold Ratan_seq in B.
  replace (S (S (2 * n))) with (2 * S n)%nat by lia. lra.
Qed.

Lemma div_real x d : (0 < d)%Z -> IZR (x / d) <= IZR x / IZR d < IZR (x / d) + 1.
Proof.
  intro D. pose proof (IZR_lt _ _ D) as Dr. pose proof (Z.div_mod x d ltac:(lia)) as E.
  pose proof (Z.mod_pos_bound x d D) as (M0 & M1). apply IZR_le in M0. apply IZR_lt in M1.
  apply (f_equal IZR) in E. rewrite plus_IZR, mult_IZR in E. split.
  - apply (Rmult_le_reg_l (IZR d)); [exact Dr|]. replace (IZR d * (IZR x / IZR d)) with (IZR x) by (field; lra). lra.
  - apply (Rmult_lt_reg_l (IZR d)); [exact Dr|]. replace (IZR d * (IZR x / IZR d)) with (IZR x) by (field; lra). lra.
Qed.

Lemma term_real unit m k :
  (2 <= m)%Z ->
  let n := (2 * Z.of_nat k + 1)%Z in
  let term := (unit / m ^ n / n)%Z in
  IZR term <= IZR unit * Ratan_seq (/ IZR m) k < IZR term + 1.
Proof.
  intros Hm n term. assert (0 < m ^ n)%Z as P by (apply Z.pow_pos_nonneg; lia).
  assert (term = unit / (m ^ n * n))%Z as -> by (unfold term; apply Z.div_div; lia).
  assert (IZR unit * Ratan_seq (/ IZR m) k = IZR unit / IZR (m ^ n * n)) as ->.
  { unfold Ratan_seq, n. replace (2 * Z.of_nat k + 1)%Z with (Z.of_nat (2 * k + 1)) by lia.
    rewrite mult_IZR, <- pow_IZR, INR_IZR_INZ. apply (IZR_le 2) in Hm.
    rewrite pow_inv. pose proof (pow_lt (IZR m) (2 * k + 1) ltac:(lra)).
    assert (IZR (Z.of_nat (2 * k + 1)) > 0) by (apply IZR_lt; lia). field. lra. }
  apply div_real. lia.
Qed.

Lemma sign_real k : if (((2 * Z.of_nat k + 1) mod 4) =? 1)%Z then (-1) ^ k = 1 else (-1) ^ k = -1.
Proof.
  destruct (Nat.Even_or_Odd k) as [(i & ->)|(i & ->)].
  - replace (2 * Z.of_nat (2 * i) + 1)%Z with (1 + Z.of_nat i * 4)%Z by lia. rewrite Z.mod_add by lia.
    change (1 mod 4 =? 1)%Z with true. apply pow_1_even.
  - replace (2 * Z.of_nat (2 * i + 1) + 1)%Z with (3 + Z.of_nat i * 4)%Z by lia. rewrite Z.mod_add by lia.
    change (3 mod 4 =? 1)%Z with false. replace (2 * i + 1)%nat with (S (2 * i)) by lia. apply pow_1_odd.
Qed.

Lemma arctangent_real unit m terms : (2 <= m)%Z -> forall k total,
  Rabs (IZR (arctangent m (2 * Z.of_nat k + 1) (unit / m ^ (2 * Z.of_nat k + 1)) total terms) - IZR total
        - IZR unit * terms_from (/ IZR m) k terms) <= INR terms.
Proof.
  intro Hm. induction terms as [|terms IH]; intros k total; cbn [arctangent terms_from].
  { simpl. rewrite Rabs_right; lra. }
  set (n := (2 * Z.of_nat k + 1)%Z).
  assert (unit / m ^ n / (m * m) = unit / m ^ (2 * Z.of_nat (S k) + 1))%Z as ->.
  { rewrite Z.div_div by (try apply Z.pow_nonzero; nia). f_equal. unfold n.
    replace (2 * Z.of_nat (S k) + 1)%Z with (2 * Z.of_nat k + 1 + 1 + 1)%Z by lia.
    rewrite !(Z.pow_add_r m _ 1) by lia. ring. }
  replace (n + 2)%Z with (2 * Z.of_nat (S k) + 1)%Z by lia.
  pose proof (term_real unit m k Hm) as T. cbn zeta in T. fold n in T.
  pose proof (sign_real k) as Sg. fold n in Sg. unfold tg_alt at 1.
  set (term := (unit / m ^ n / n)%Z) in *.
  set (total' := (if (n mod 4 =? 1)%Z then (total + term)%Z else (total - term)%Z)).
  specialize (IH (S k) total'). rewrite S_INR.
  assert (IZR total' = IZR total + (-1) ^ k * IZR term) as Et.
  { unfold total'. destruct (n mod 4 =? 1)%Z; rewrite Sg; [rewrite plus_IZR | rewrite minus_IZR]; ring. }
  rewrite Et in IH. set (rest := terms_from (/ IZR m) (S k) terms) in *. set (A := IZR (arctangent _ _ _ _ _)) in *.
  set (y := Ratan_seq (/ IZR m) k) in *.
  replace (A - IZR total - IZR unit * ((-1) ^ k * y + rest))
    with ((A - (IZR total + (-1) ^ k * IZR term) - IZR unit * rest) + (-1) ^ k * (IZR term - IZR unit * y)) by ring.
  eapply Rle_trans; [apply Rabs_triang|].
  assert (Rabs ((-1) ^ k * (IZR term - IZR unit * y)) <= 1); [|lra].
  rewrite Rabs_mult, pow_1_abs, Rmult_1_l. apply Rabs_le. lra.
Qed.

Lemma arctangent_bound unit m n :
  (2 <= m)%Z -> (0 < unit <= m ^ Z.of_nat (2 * (2 * S n) + 1))%Z ->
  Rabs (IZR (arctangent m 1 (unit / m) 0 (2 * S n)) - IZR unit * atan (/ IZR m)) < INR (2 * S n) + 1.
Proof.
  intros Hm (U & L). pose proof (arctangent_real unit m (2 * S n) Hm 0 0) as A.
  change (2 * Z.of_nat 0 + 1)%Z with 1%Z in A. rewrite Z.pow_1_r, Rminus_0_r in A.
  pose proof (IZR_le 2 _ Hm) as Mr. assert (0 < / IZR m < 1) as X.
  { split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_lt_contravar; lra. }
  destruct (arctan_terms (/ IZR m) n X) as (B1 & B2).
  replace (S (S (2 * n))) with (2 * S n)%nat in B1, B2 by lia.
  set (S_T := terms_from _ _ _) in *. set (A_T := IZR (arctangent _ _ _ _ _)) in *.
  set (e := (2 * (2 * S n) + 1)%nat) in *.
  assert (IZR unit * ((/ IZR m) ^ e / INR e) < 1) as E.
  { assert (1 < INR e) as I1 by (apply (lt_INR 1); unfold e; lia).
    rewrite pow_inv. apply IZR_le in L. apply IZR_lt in U. rewrite <- pow_IZR in L.
    pose proof (pow_lt (IZR m) e ltac:(lra)) as P.
    apply (Rmult_lt_reg_r (IZR m ^ e * INR e)); [apply Rmult_lt_0_compat; lra|].
    replace (IZR unit * (/ IZR m ^ e / INR e) * (IZR m ^ e * INR e)) with (IZR unit) by (field; lra).
    assert (IZR m ^ e * 1 < IZR m ^ e * INR e) by (apply Rmult_lt_compat_l; lra). lra. }
  apply IZR_lt in U. apply (Rmult_le_compat_l (IZR unit)) in B1; [|lra]. apply (Rmult_le_compat_l (IZR unit)) in B2; [|lra].
  unfold Rabs in A |- *. destruct (Rcase_abs _), (Rcase_abs _); lra.
Qed.

Lemma unit_of_pi_bounded p r : (0 < unit_of_pi p r <= 10 ^ 1100)%Z.
Proof.
  unfold unit_of_pi. destruct (_ && _); (split; [reflexivity | apply Z.leb_le; vm_compute; reflexivity]).
Qed.

Theorem check_pi_sound v p r : check_pi (Volume v p r) = Ok tt -> Q2R p < PI < Q2R r.
Proof.
  intro H. unfold check_pi in H.
  remember (unit_of_pi p r) as unit eqn:Eu.
  remember (arctangent 5 1 (unit / 5) 0 800) as a5 eqn:E5.
  remember (arctangent 239 1 (unit / 239) 0 240) as a239 eqn:E239.
  cbv zeta in H. passed H. passed H.
  apply at_most_real in H, H0. rewrite Q2R_mult, !Q2R_integer in *.
  destruct (unit_of_pi_bounded p r) as (U & M). rewrite <- Eu in U, M.
  assert (Rabs (IZR a5 - IZR unit * atan (/ 5)) < 801) as B5.
  { pose proof (arctangent_bound unit 5 399 ltac:(lia)) as B. change (2 * S 399)%nat with 800%nat in B.
    rewrite <- E5 in B. replace 801 with (INR 800 + 1) by (rewrite INR_IZR_INZ; simpl; lra). apply B.
    split; [exact U|]. eapply Z.le_trans; [exact M|]. apply Z.leb_le. vm_compute. reflexivity. }
  assert (Rabs (IZR a239 - IZR unit * atan (/ 239)) < 241) as B239.
  { pose proof (arctangent_bound unit 239 119 ltac:(lia)) as B. change (2 * S 119)%nat with 240%nat in B.
    rewrite <- E239 in B. replace 241 with (INR 240 + 1) by (rewrite INR_IZR_INZ; simpl; lra). apply B.
    split; [exact U|]. eapply Z.le_trans; [exact M|]. apply Z.leb_le. vm_compute. reflexivity. }
  pose proof Machin_4_5_239 as Ma. apply IZR_lt in U. clear Eu E5 E239.
  rewrite minus_IZR, minus_IZR, !mult_IZR in H0. rewrite plus_IZR, minus_IZR, !mult_IZR in H.
  change (IZR (16 * 801 + 4 * 241)) with 13780 in *.
  apply Rabs_def2 in B5, B239.
  assert (IZR unit * PI = 16 * (IZR unit * atan (/ 5)) - 4 * (IZR unit * atan (/ 239))) as K.
  { replace PI with (4 * (PI / 4)) by field. rewrite Ma. ring. }
  split; apply (Rmult_lt_reg_l (IZR unit)); lra.
Qed.
