(* Numbers are read as they are printed. *)

From Coq Require Import ZArith QArith Qreduction Qcanon List Bool String Ascii Lia Znumtheory.
From Mdm Require Import Numbers Certificate Text Decimals.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Digits ---------------------------------------------------------------------------------------- *)

(* A text of so many digits has the value n. *)
Inductive numeral : string -> Z -> Z -> Prop :=
| no_digit : numeral "" 0 0
| first_digit ch d w n length :
    digit ch = Some d -> 0 <= d <= 9 -> numeral w n length -> numeral (String ch w) (d * 10 ^ length + n) (length + 1).

Lemma numeral_length w n length : numeral w n length -> 0 <= length.
Proof. induction 1; lia. Qed.

Lemma numeral_bound w n length : numeral w n length -> 0 <= n < 10 ^ length.
Proof.
  induction 1 as [|ch d w n length E D N IH]; [simpl; lia|]. pose proof (numeral_length _ _ _ N).
  rewrite Z.pow_add_r by lia. change (10 ^ 1) with 10. nia.
Qed.

Lemma digit_read d : 0 <= d <= 9 -> digit (digit_of d) = Some d.
Proof.
  intro H. assert (d = 0 \/ d = 1 \/ d = 2 \/ d = 3 \/ d = 4 \/ d = 5 \/ d = 6 \/ d = 7 \/ d = 8 \/ d = 9) as C by lia.
  destruct C as [->|[->|[->|[->|[->|[->|[->|[->|[->| ->]]]]]]]]]; reflexivity.
Qed.

Lemma digits_read w n length :
  numeral w n length -> forall rest v k,
  digits (w ++ rest) v k = digits rest (v * 10 ^ length + n) (k + length).
Proof.
  induction 1 as [|ch d w n length E D N IH]; intros rest v k; simpl append.
  - f_equal; lia.
  - cbn [digits]. rewrite E, IH. pose proof (numeral_length _ _ _ N). f_equal; [|lia].
    rewrite Z.pow_add_r by lia. change (10 ^ 1) with 10. ring.
Qed.

Lemma file_digits_read w n length :
  numeral w n length -> forall rest v k, k + length <= most_digits_of_file ->
  file_digits (w ++ rest) v k = file_digits rest (v * 10 ^ length + n) (k + length).
Proof.
  induction 1 as [|ch d w n length E D N IH]; intros rest v k B; simpl append.
  - f_equal; lia.
  - cbn [file_digits]. pose proof (numeral_length _ _ _ N). rewrite E, IH by lia.
    rewrite (proj2 (Z.ltb_lt _ _)) by lia. f_equal; [|lia].
    rewrite Z.pow_add_r by lia. change (10 ^ 1) with 10. ring.
Qed.

(* ---- Integers -------------------------------------------------------------------------------------- *)

Lemma show_digits_numeral fuel : forall n w m length,
  numeral w m length -> 0 <= n < 10 ^ (Z.of_nat fuel + 1) ->
  exists all, length + 1 <= all /\ numeral (show_digits fuel n w) (n * 10 ^ length + m) all.
Proof.
  induction fuel as [|fuel IH]; intros n w m length N B; simpl;
    pose proof (Z.div_mod n 10 ltac:(lia)) as E; pose proof (Z.mod_pos_bound n 10 ltac:(lia)) as M;
    pose proof (numeral_length _ _ _ N) as L; unfold Z.div, Z.modulo in E, M;
    destruct (Z.div_eucl n 10) as (tens, ones) eqn:D;
    assert (numeral (String (digit_of ones) w) (ones * 10 ^ length + m) (length + 1)) as N'
      by (constructor; [apply digit_read; lia | lia | exact N]).
  - exists (length + 1). split; [lia|]. change (10 ^ (Z.of_nat 0 + 1)) with 10 in B.
    replace n with ones by lia. exact N'.
  - destruct (Z.eqb_spec tens 0) as [T|T].
    + exists (length + 1). split; [lia|]. replace n with ones by lia. exact N'.
    + destruct (IH tens _ _ _ N') as (all & A & R).
      * rewrite Nat2Z.inj_succ in B. replace (Z.succ (Z.of_nat fuel) + 1) with (Z.of_nat fuel + 1 + 1) in B by lia.
        rewrite Z.pow_add_r in B by lia. change (10 ^ 1) with 10 in B. nia.
      * exists all. split; [lia|]. rewrite Z.pow_add_r in R by lia. change (10 ^ 1) with 10 in R.
        replace (n * 10 ^ length + m) with (tens * (10 ^ length * 10) + (ones * 10 ^ length + m)) by (subst n; ring).
        exact R.
Qed.

Lemma show_digits_zero fuel : forall n w, 0 < n -> n < 10 ^ (Z.of_nat fuel + 1) ->
  starts_with_zero (show_digits fuel n w) = false.
Proof.
  assert (forall d w, 0 < d <= 9 -> starts_with_zero (String (digit_of d) w) = false) as First.
  { intros d w H. assert (d = 1 \/ d = 2 \/ d = 3 \/ d = 4 \/ d = 5 \/ d = 6 \/ d = 7 \/ d = 8 \/ d = 9) as C by lia.
    destruct C as [->|[->|[->|[->|[->|[->|[->|[->| ->]]]]]]]]; reflexivity. }
  induction fuel as [|fuel IH]; intros n w P B; simpl;
    pose proof (Z.div_mod n 10 ltac:(lia)) as E; pose proof (Z.mod_pos_bound n 10 ltac:(lia)) as M;
    unfold Z.div, Z.modulo in E, M; destruct (Z.div_eucl n 10) as (tens, ones) eqn:D.
  - change (10 ^ (Z.of_nat 0 + 1)) with 10 in B. apply First. lia.
  - destruct (Z.eqb_spec tens 0) as [T|T]; [apply First; lia|]. apply IH; [lia|].
    rewrite Nat2Z.inj_succ in B. replace (Z.succ (Z.of_nat fuel) + 1) with (Z.of_nat fuel + 1 + 1) in B by lia.
    rewrite Z.pow_add_r in B by lia. change (10 ^ 1) with 10 in B. nia.
Qed.

Lemma fuel_enough n : 0 <= n -> n < 10 ^ (Z.of_nat (Z.to_nat (Z.log2 n)) + 1).
Proof.
  intro H. pose proof (Z.log2_nonneg n). rewrite Z2Nat.id by lia.
  destruct (Z.eq_dec n 0) as [->|Z]; [reflexivity|].
  apply Z.lt_le_trans with (2 ^ (Z.log2 n + 1)).
  - pose proof (Z.log2_spec n ltac:(lia)) as (_ & S). exact S.
  - apply Z.pow_le_mono_l. lia.
Qed.

Lemma show_integer_numeral n : 0 <= n ->
  exists length, 1 <= length /\ numeral (show_integer n) n length /\
    (starts_with_zero (show_integer n) = false \/ length = 1).
Proof.
  intro H. destruct (show_digits_numeral _ n "" 0 0 no_digit (conj H (fuel_enough n H))) as (all & A & N).
  replace (n * 10 ^ 0 + 0) with n in N by lia. unfold show_integer.
  destruct (Z.eq_dec n 0) as [->|Z].
  - exists 1. split; [lia|]. split; [exact (first_digit "0" 0 "" 0 0 eq_refl ltac:(lia) no_digit) | right; reflexivity].
  - exists all. split; [lia|]. split; [exact N|]. left. apply show_digits_zero; [lia | exact (fuel_enough n H)].
Qed.

(* The digits of an integer n >= 0. *)
Fixpoint text_length (w : string) : Z := match w with String _ w => text_length w + 1 | EmptyString => 0 end.

Lemma numeral_text_length w n length : numeral w n length -> text_length w = length.
Proof. induction 1; simpl; lia. Qed.

Lemma append_empty w : w ++ "" = w.
Proof. induction w as [|ch w IH]; simpl; congruence. Qed.

Lemma append_assoc u v w : (u ++ v) ++ w = u ++ v ++ w.
Proof. induction u as [|ch u IH]; simpl; congruence. Qed.

Theorem whole_read most n :
  0 <= n -> text_length (show_integer n) <= most -> whole most (show_integer n) = Some n.
Proof.
  intros H B. destruct (show_integer_numeral n H) as (length & L & N & Z0). pose proof (numeral_text_length _ _ _ N) as T.
  unfold whole. pose proof (digits_read _ _ _ N "" 0 0) as D. rewrite append_empty in D. rewrite D. cbn [digits].
  replace (0 * 10 ^ length + n) with n by lia. replace (0 + length) with length by lia. unfold check.
  rewrite (proj2 (Z.leb_le 1 length) L), (proj2 (Z.leb_le length most)) by lia.
  destruct Z0 as [-> | ->]; [reflexivity|]. rewrite orb_true_r. reflexivity.
Qed.

(* ---- Decimals -------------------------------------------------------------------------------------- *)

(* The denominator divides a power of ten. *)
Definition is_decimal (x : Q) : Prop := exists places, 0 <= places /\ (Zpos (Qden x) | 10 ^ places).

Lemma fraction_digits_numeral d : 0 < d -> forall fuel r,
  0 <= r < d -> (d | r * 10 ^ Z.of_nat fuel) ->
  exists m length, numeral (fraction_digits fuel r d) m length /\ m * d = r * 10 ^ length /\
    (0 < r -> 0 < length /\ m mod 10 <> 0).
Proof.
  intro P. induction fuel as [|fuel IH]; intros r B Dv.
  - assert (r = 0) as ->.
    { simpl in Dv. rewrite Z.mul_1_r in Dv. destruct (Z.eq_dec r 0) as [|Z]; trivial.
      apply Z.divide_pos_le in Dv; lia. }
    exists 0, 0. split; [exact no_digit|]. split; lia.
  - cbn [fraction_digits]. destruct (Z.eqb_spec r 0) as [->|Z].
    + exists 0, 0. split; [exact no_digit|]. split; lia.
    + pose proof (Z.div_mod (10 * r) d ltac:(lia)) as E. pose proof (Z.mod_pos_bound (10 * r) d P) as M.
      unfold Z.div, Z.modulo in E, M. destruct (Z.div_eucl (10 * r) d) as (q, r') eqn:D.
      assert (0 <= q <= 9) as Q by nia.
      destruct (IH r' M) as (m & length & N & V & Last).
      { rewrite Nat2Z.inj_succ, Z.pow_succ_r in Dv by lia.
        replace (r' * 10 ^ Z.of_nat fuel) with (r * (10 * 10 ^ Z.of_nat fuel) - d * (q * 10 ^ Z.of_nat fuel)) by nia.
        apply Z.divide_sub_r; [exact Dv | exists (q * 10 ^ Z.of_nat fuel); ring]. }
      exists (q * 10 ^ length + m), (length + 1). split; [constructor; [apply digit_read, Q | exact Q | exact N]|].
      pose proof (numeral_length _ _ _ N) as L. split.
      * rewrite Z.pow_add_r by lia. change (10 ^ 1) with 10. nia.
      * intros _. split; [lia|]. destruct (Z.eq_dec r' 0) as [R0|R0].
        -- assert (fraction_digits fuel r' d = "") as F by (rewrite R0; destruct fuel; reflexivity).
           rewrite F in N. inversion N; subst. rewrite Z.mul_1_r, Z.add_0_r. rewrite Z.mod_small by lia. nia.
        -- destruct (Last ltac:(lia)) as (L1 & M10).
           replace length with (length - 1 + 1) by lia. rewrite Z.pow_add_r by lia. change (10 ^ 1) with 10.
           rewrite Z.add_comm, Z.mul_assoc, Z.mod_add by lia. exact M10.
Qed.

Lemma decimal_places k : 0 <= k -> forall d, 0 < d -> (d | 10 ^ k) -> (d | 10 ^ Z.log2 d).
Proof.
  intro K. pattern k. apply natlike_ind; [| |exact K]; clear k K.
  - intros d P D. simpl in D. apply Z.divide_1_r_nonneg in D; [|lia]. subst. apply Z.divide_refl.
  - intros k K IH d P D. set (g := Z.gcd d 10). assert (g <> 0) as G by (unfold g; intro E; apply Z.gcd_eq_0_r in E; lia).
    pose proof (Z.gcd_nonneg d 10) as Gp. fold g in Gp.
    destruct (Z.gcd_divide_l d 10) as (d' & E). destruct (Z.gcd_divide_r d 10) as (t & T). fold g in E, T.
    destruct (Z.eq_dec g 1) as [G1|G1].
    + apply IH; [exact P|]. rewrite Z.pow_succ_r in D by exact K. exact (Z.gauss _ _ _ D G1).
    + assert (Z.gcd d' t = 1) as C.
      { pose proof (Z.gcd_div_gcd d 10 g G eq_refl) as H. rewrite E in H at 1. rewrite T in H.
        rewrite !Z.div_mul in H by exact G. exact H. }
      assert (0 < d') as P' by nia.
      assert (d' | 10 ^ k) as D'.
      { apply Z.gauss with t; [|exact C]. rewrite Z.pow_succ_r in D by exact K. destruct D as (q & D). exists q.
        apply (Z.mul_reg_r _ _ g G). rewrite T, E in D at 1. nia. }
      specialize (IH d' P' D'). destruct IH as (q & Q).
      assert (Z.log2 d' + 1 <= Z.log2 d) as L.
      { replace (Z.log2 d' + 1) with (Z.log2 (2 * d')) by (rewrite Z.log2_double; lia).
        apply Z.log2_le_mono. nia. }
      replace (Z.log2 d) with (Z.log2 d' + 1 + (Z.log2 d - Z.log2 d' - 1)) by lia.
      pose proof (Z.log2_nonneg d'). rewrite Z.pow_add_r by lia. apply Z.divide_mul_l. rewrite Z.pow_add_r by lia.
      change (10 ^ 1) with 10. exists (q * t). rewrite Q. rewrite E, T at 1. ring.
Qed.

(* How a decimal is written: an integer, and a point and digits of which the last is not 0 if it is none. *)
Lemma show_decimal_form x :
  0 <= Qnum x -> is_decimal x ->
  exists whole n, 1 <= n /\ numeral (show_integer whole) whole n /\
    (starts_with_zero (show_integer whole) = false \/ n = 1) /\
    ((Qnum x = whole * Zpos (Qden x) /\ show_decimal x = show_integer whole) \/
     exists w m places, numeral w m places /\ 0 < places /\ m mod 10 <> 0 /\
       (whole * 10 ^ places + m) * Zpos (Qden x) = Qnum x * 10 ^ places /\
       show_decimal x = show_integer whole ++ String "." w).
Proof.
  intros P (k & K & D). destruct x as (n, d). cbn [Qnum Qden] in *. unfold show_decimal. cbn [Qnum Qden].
  pose proof (Z.div_mod n (Zpos d) ltac:(lia)) as E. pose proof (Z.mod_pos_bound n (Zpos d) ltac:(lia)) as M.
  pose proof (Z.div_pos n (Zpos d) P ltac:(lia)) as W. unfold Z.div, Z.modulo in E, M, W.
  destruct (Z.div_eucl n (Zpos d)) as (whole, r).
  destruct (show_integer_numeral whole W) as (length & L & N & Z0). exists whole, length.
  split; [exact L|]. split; [exact N|]. split; [exact Z0|].
  destruct (Z.eqb_spec r 0) as [R|R]; [left; split; [lia | reflexivity]|]. right.
  destruct (fraction_digits_numeral (Zpos d) ltac:(lia) (Z.to_nat (Z.log2 (Zpos d))) r M) as (m & places & F & V & Last).
  { rewrite Z2Nat.id by apply Z.log2_nonneg. apply Z.divide_mul_r, (decimal_places k K); [lia | exact D]. }
  destruct (Last ltac:(lia)) as (Lp & M10). exists (fraction_digits (Z.to_nat (Z.log2 (Zpos d))) r (Zpos d)), m, places.
  split; [exact F|]. split; [exact Lp|]. split; [exact M10|]. split; [|reflexivity]. rewrite E. nia.
Qed.

Lemma fraction_reduced n x t : 0 < t -> n * Zpos (Qden x) = Qnum x * t -> Qred x = x -> fraction n t = x.
Proof.
  intros T H R. rewrite <- R. unfold fraction. apply Qred_complete. unfold Qeq. cbn [Qnum Qden].
  rewrite Z2Pos.id by exact T. exact H.
Qed.

Lemma text_length_append u v : text_length (u ++ v) = text_length u + text_length v.
Proof. induction u as [|ch u IH]; simpl; lia. Qed.

(* A decimal in a certificate. *)
Theorem decimal_read x :
  0 <= Qnum x -> is_decimal x -> Qred x = x -> text_length (show_decimal x) <= most_digits ->
  decimal (show_decimal x) = Some x.
Proof.
  intros P D R B. destruct (show_decimal_form x P D) as (whole & n & L & N & Z0 & H).
  pose proof (numeral_text_length _ _ _ N) as T.
  assert ((1 <=? n) && (negb (starts_with_zero (show_integer whole)) || (n =? 1)) = true) as I.
  { rewrite (proj2 (Z.leb_le 1 n) L). destruct Z0 as [-> | ->]; [reflexivity | apply orb_true_r]. }
  destruct H as [(V & S)|(w & m & places & F & Lp & M & V & S)]; unfold decimal; rewrite S in *.
  - pose proof (digits_read _ _ _ N "" 0 0) as Dg. rewrite append_empty in Dg. rewrite Dg. cbn [digits].
    replace (0 + n) with n by lia. rewrite I. rewrite (proj2 (Z.leb_le n most_digits)) by lia. cbn [andb check].
    f_equal. unfold of_integer. rewrite <- R. rewrite <- (Qred_complete (0 * 10 ^ n + whole # 1) x).
    + symmetry. apply Qred_identity. cbn. apply Z.gcd_1_r.
    + unfold Qeq. cbn [Qnum Qden]. lia.
  - rewrite (digits_read _ _ _ N (String "." w) 0 0). cbn [digits]. change (digit ".") with (@None Z). cbv iota beta.
    pose proof (digits_read _ _ _ F "" (0 * 10 ^ n + whole) (0 + n)) as Dg. rewrite append_empty in Dg. rewrite Dg.
    cbn [digits].
    rewrite text_length_append in B. cbn [text_length] in B. rewrite (numeral_text_length _ _ _ F) in B.
    assert (starts_with_zero (show_integer whole ++ String "." w) = starts_with_zero (show_integer whole)) as Z1.
    { destruct (show_integer whole); [inversion N; lia | reflexivity]. }
    rewrite Z1. replace (0 + n) with n by lia. rewrite I.
    change (Ascii.eqb "." ".") with true. change (String.eqb "" "") with true.
    rewrite (proj2 (Z.ltb_lt n (n + places))) by lia. rewrite (proj2 (Z.leb_le _ most_digits)) by lia.
    assert (((0 * 10 ^ n + whole) * 10 ^ places + m) mod 10 <> 0) as M'.
    { replace places with (places - 1 + 1) by lia. rewrite Z.pow_add_r by lia. change (10 ^ 1) with 10.
      rewrite Z.add_comm, Z.mul_assoc, Z.mod_add by lia. exact M. }
    rewrite (proj2 (Z.eqb_neq _ _) M'). cbn [andb negb check]. f_equal. replace (n + places - n) with places by lia.
    apply fraction_reduced; [apply Z.pow_pos_nonneg; lia | rewrite <- V; ring | exact R].
Qed.
