(* Fractions and powers as real numbers. *)

From Coq Require Import ZArith QArith Reals Qreals Rpower List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Exact Spec Openings Reduction.
Import ListNotations.
Open Scope R_scope.

(* ---- Fractions ----------------------------------------------------------------------------------- *)

Lemma Q2R_red x : Q2R (Qred x) = Q2R x.
Proof. apply Qeq_eqR, Qred_correct. Qed.

Lemma Q2R_integer n : Q2R (of_integer n) = IZR n.
Proof. unfold Q2R, of_integer; simpl. field. Qed.

Lemma Q2R_times x y : Q2R (times x y) = Q2R x * Q2R y.
Proof. unfold times. rewrite Q2R_red. apply Q2R_mult. Qed.

Lemma Q2R_add x y : Q2R (add x y) = Q2R x + Q2R y.
Proof. unfold add. rewrite Q2R_red. apply Q2R_plus. Qed.

Lemma Q2R_subtract x y : Q2R (subtract x y) = Q2R x - Q2R y.
Proof. unfold subtract. rewrite Q2R_red. apply Q2R_minus. Qed.

Lemma Q2R_over x y : Q2R y <> 0 -> Q2R (over x y) = Q2R x / Q2R y.
Proof.
  intro H. unfold over. rewrite Q2R_red. apply Q2R_div. intro E. apply H. rewrite (Qeq_eqR _ _ E). apply Q2R_0.
Qed.

Lemma Q2R_power x n : Q2R (power x (Z.of_nat n)) = Q2R x ^ n.
Proof.
  unfold Q2R, power; simpl Qnum; simpl Qden. rewrite Z2Pos.id by (apply Z.pow_pos_nonneg; lia).
  rewrite <- !pow_IZR, Rpow_mult_distr, pow_inv. reflexivity.
Qed.

Lemma Q2R_power_pos x d : Q2R (power x (Zpos d)) = Q2R x ^ Pos.to_nat d.
Proof. rewrite <- positive_nat_Z. apply Q2R_power. Qed.

Lemma den_positive x : 0 < IZR (Zpos (Qden x)).
Proof. apply IZR_lt. reflexivity. Qed.

Lemma Q2R_fraction n d : (0 < d)%Z -> Q2R (fraction n d) = IZR n / IZR d.
Proof.
  intro D. unfold fraction. rewrite Q2R_red. unfold Q2R; simpl. rewrite Z2Pos.id by exact D. reflexivity.
Qed.

Lemma Q2R_num x : IZR (Qnum x) = Q2R x * IZR (Zpos (Qden x)).
Proof. unfold Q2R. pose proof (den_positive x). field. lra. Qed.

Lemma less_real x y : less x y = true <-> Q2R x < Q2R y.
Proof. rewrite less_spec. split; [apply Qlt_Rlt | apply Rlt_Qlt]. Qed.

Lemma at_most_real x y : at_most x y = true <-> Q2R x <= Q2R y.
Proof. rewrite at_most_spec. split; [apply Qle_Rle | apply Rle_Qle]. Qed.

Lemma equal_real x y : equal x y = true <-> Q2R x = Q2R y.
Proof. rewrite equal_spec. split; [apply Qeq_eqR | apply eqR_Qeq]. Qed.

Lemma less_real_false x y : less x y = false <-> Q2R y <= Q2R x.
Proof. rewrite less_false. split; [apply Qle_Rle | apply Rle_Qle]. Qed.

(* ---- Units --------------------------------------------------------------------------------------- *)

Lemma common_denominator_from xs : forall n,
  (0 < n)%Z -> let common := fold_left (fun common x => Z.lcm common (Zpos (Qden x))) xs n in
  (0 < common)%Z /\ (n | common)%Z /\ forall x, In x xs -> (Zpos (Qden x) | common)%Z.
Proof.
  induction xs as [|x xs IH]; intros n N; simpl; [split; [exact N|]; split; [apply Z.divide_refl | intros ? []]|].
  destruct (IH (Z.lcm n (Zpos (Qden x)))) as (P & D & A).
  { pose proof (Z.lcm_nonneg n (Zpos (Qden x))).
    assert (Z.lcm n (Zpos (Qden x)) <> 0)%Z by (rewrite Z.lcm_eq_0; lia). lia. }
  split; [exact P|]. split; [eapply Z.divide_trans; [apply Z.divide_lcm_l | exact D]|].
  intros y [<-|I]; [eapply Z.divide_trans; [apply Z.divide_lcm_r | exact D] | apply A, I].
Qed.

Lemma common_denominator_spec xs :
  (0 < common_denominator xs)%Z /\ forall x, In x xs -> (Zpos (Qden x) | common_denominator xs)%Z.
Proof. destruct (common_denominator_from xs 1) as (P & _ & A); [lia|]. split; assumption. Qed.

Lemma in_units_real x unit : (Zpos (Qden x) | unit)%Z -> IZR (in_units x unit) = Q2R x * IZR unit.
Proof.
  intros (k & ->). unfold in_units. rewrite Z.div_mul by lia. rewrite !mult_IZR, Q2R_num. ring.
Qed.

Lemma include_ok common divisor result :
  (0 < common)%Z -> (0 < divisor)%Z -> include common divisor = Ok result ->
  (0 < result)%Z /\ (common | result)%Z /\ (divisor | result)%Z.
Proof.
  intros C D H. unfold include in H. destruct (Z.eqb_spec (common mod divisor) 0) as [E|E].
  - injection H as <-. repeat split; [exact C | apply Z.divide_refl | apply Z.mod_divide; [lia | exact E]].
  - cbv zeta in H. passed H. injection H as <-.
    pose proof (Z.lcm_nonneg common divisor). assert (Z.lcm common divisor <> 0)%Z by (rewrite Z.lcm_eq_0; lia).
    repeat split; [lia | apply Z.divide_lcm_l | apply Z.divide_lcm_r].
Qed.

Lemma include_all_ok divisors : forall common result,
  (0 < common)%Z -> (forall d, In d divisors -> 0 < d)%Z -> include_all divisors common = Ok result ->
  (0 < result)%Z /\ (common | result)%Z /\ forall d, In d divisors -> (d | result)%Z.
Proof.
  induction divisors as [|d ds IH]; intros common result C D H; simpl in H.
  { injection H as <-. repeat split; [exact C | apply Z.divide_refl | intros ? []]. }
  passed H. apply include_ok in H0 as (P & Dc & Dd); [|exact C|apply D; left; reflexivity].
  apply IH in H as (Pr & Dr & A); [|exact P|intros; apply D; right; assumption].
  repeat split; [exact Pr | eapply Z.divide_trans; eassumption|].
  intros e [<-|I]; [eapply Z.divide_trans; eassumption | apply A, I].
Qed.

(* ---- Gradation files ----------------------------------------------------------------------------- *)

Lemma well_formed_root G : well_formed G = true -> root G = Zpos (root_of G).
Proof.
  unfold well_formed. rewrite !andb_true_iff, !Z.leb_le. intros ((((((A & _) & _) & _) & _) & _) & _).
  unfold root_of. rewrite Z2Pos.id by lia. reflexivity.
Qed.

Lemma well_formed_proper G : well_formed G = true -> proper_rows (rows G) /\ exists j, In j (classes (rows G)) /\ 0 < Q2R (mass j).
Proof.
  unfold well_formed. rewrite !andb_true_iff. intros ((((N & A) & P) & C) & M).
  assert (Forall (fun r => (0 <= retained r)%Q /\ (0 < factor r)%Q) (rows G)) as F.
  { apply Forall_forall. rewrite forallb_forall in P. intros r I. specialize (P r I). rewrite !andb_true_iff in P.
    destruct P as (((_ & P1) & P2) & _). apply at_most_spec in P1. apply less_spec in P2. auto. }
  apply equal_spec in C. split.
  - split; [exact A|]. split; [|split; [exact C | exact F]].
    destruct (rows G) as [|r rs]; simpl; [rewrite Q2R_0; lra|].
    simpl in P. rewrite !andb_true_iff in P. destruct P as ((((P & _) & _) & _) & _).
    apply at_most_real in P. rewrite Q2R_0 in P. exact P.
  - apply existsb_exists in M as (r & I & M). apply less_spec in M. revert C I. unfold last_row.
    generalize (rows G). clear -M. intro rs. induction rs as [|x rs IH]; [intros _ []|].
    destruct rs as [|y rs].
    + intros C [<-|[]]. simpl in C. rewrite C in M. discriminate.
    + intros C [<-|I].
      * eexists. split; [left; reflexivity|]. simpl. apply Qlt_Rlt in M. rewrite Q2R_0 in M. exact M.
      * destruct (IH C I) as (j & J & Mj). exists j. split; [right; exact J | exact Mj].
Qed.

(* Classes have the openings, masses and factors of rows. *)
Lemma class_of_rows rs j : In j (classes rs) ->
  In (lower j) (map opening rs) /\ In (upper j) (map opening rs) /\ In (mass j) (map retained rs) /\
  In (c j) (map factor rs).
Proof.
  induction rs as [|x rs IH]; [intros []|]. destruct rs as [|y rs]; [intros []|].
  intros [<-|I]; [simpl; auto 10|]. destruct (IH I) as (A & B & C & D). simpl in *. auto 10.
Qed.
