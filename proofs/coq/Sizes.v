(* One size per class: it loses nothing (Cond3), and it is where the certificate's witness says (Theorem 9). *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Spec Openings Reduction RealFacts.
Import ListNotations.
Open Scope R_scope.

Section Root.
Context {d : positive}.

(* ---- Cond3 --------------------------------------------------------------------------------------- *)

Lemma in_some_class js : forall x1 x, ascend_from d x1 js -> x1 < x <= top d x1 js -> exists j, In j js /\ in_class d j x.
Proof.
  induction js as [|j js IH]; intros x1 x A (L & U); [unfold top in U; simpl in U; lra|]. destruct A as (E & Lt & A).
  destruct (Rle_lt_dec x (upper_size d j)) as [Le|Gt].
  - exists j. split; [left; reflexivity | unfold in_class; lra].
  - destruct (IH (upper_size d j) x A) as (i & I & H); [split; [exact Gt | exact U]|].
    exists i. split; [right; exact I | exact H].
Qed.

Lemma one_size_articulate rs S :
  proper_rows rs -> describes d rs S -> one_size_a_class d (classes rs) S -> describes_articulately d rs S.
Proof.
  intros P D O. split; [exact D|]. intros x y X Y L.
  destruct (classes_ascend (d := d) rs P) as (As & T). destruct D as (_ & D).
  destruct (in_some_class (classes rs) _ x As) as (j & J & Jx); [rewrite T; apply D, X|].
  destruct (class_of_rows rs j J) as (_ & U & _). apply in_map_iff in U as (r & E & Ir).
  exists r. split; [exact Ir|]. rewrite E. split; [apply Jx|].
  destruct (Rle_lt_dec y (upper_size d j)) as [Le|]; [exfalso|assumption].
  assert (x = y) as K by (apply (O j); trivial; unfold in_class in *; lra). lra.
Qed.

(* Theorem 1: where a sample is, there is one of as many particles with one size a class. *)
Theorem one_size_suffices f rs S :
  mass_law f -> proper_rows rs -> describes_accurately d f rs S ->
  exists T, describes_articulately d rs T /\ describes_accurately d f rs T /\ length T = length S.
Proof.
  intros Law P (s & Sp & D & H). pose proof (proper_classes rs P) as Pj. 
  destruct (classes_ascend (d := d) rs P) as (As & Top).
  destruct (counts_sample f Law (classes rs) _ (map (fun j => (number d j S, held d f j S)) (classes rs)) As Pj) as (T & B & O & C).
  { clear -Pj Law. induction Pj; simpl; constructor; [apply sample_realizes; assumption | assumption]. }
  assert (describes d rs T) as DT by (split; [apply D | intros x X; rewrite <- Top; apply B, X]).
  assert (forall j, In j (classes rs) -> number d j T = number d j S /\ held d f j T = held d f j S) as E.
  { intros j J. clear -C J. induction (classes rs) as [|i l IH]; [destruct J|]. simpl in C. inversion C; subst.
    destruct J as [<-|J]; auto. }
  exists T. split; [apply one_size_articulate; assumption|]. split.
  - exists s. split; [exact Sp|]. split; [exact DT|]. intros j J. rewrite <- (H j J). apply E, J.
  - apply Nat2Z.inj. rewrite (describes_number rs T P DT), (describes_number rs S P D). f_equal.
    apply map_ext_in. intros j J. apply E, J.
Qed.

(* ---- Where the sizes are ------------------------------------------------------------------------- *)

Lemma check_size_sound a root j w n e x :
  (1 <= a)%nat -> root = Zpos d -> (0 < e)%Z -> 0 <= x -> x ^ (a * Pos.to_nat d) = IZR n / IZR e ->
  check_size (Z.of_nat a) root j w (n, e) = Ok tt -> Q2R (size_lo w) <= x <= Q2R (size_hi w).
Proof.
  intros A -> D X E H. unfold check_size in H. cbv zeta in H. passed H. passed H. passed H.
  rewrite !andb_true_iff in H0. destruct H0 as ((H0 & _) & Hl). apply less_real in H0. apply at_most_real in Hl.
  rewrite Q2R_0 in H0. pose proof (IZR_lt _ _ D) as Dr.
  replace (Z.of_nat a * Zpos d)%Z with (Z.of_nat (a * Pos.to_nat d)) in H by lia.
  assert (1 <= a * Pos.to_nat d)%nat as K by (pose proof (Pos2Nat.is_pos d); nia).
  set (k := (a * Pos.to_nat d)%nat) in *.
  assert (forall z, IZR (Qnum z ^ Z.of_nat k * e) = (Q2R z ^ k * IZR e) * IZR (Zpos (Qden z)) ^ k) as Left.
  { intro z. rewrite mult_IZR, <- pow_IZR, Q2R_num, Rpow_mult_distr. ring. }
  assert (forall z, IZR (n * Zpos (Qden z) ^ Z.of_nat k) = (x ^ k * IZR e) * IZR (Zpos (Qden z)) ^ k) as Right.
  { intro z. rewrite mult_IZR, <- pow_IZR, E. field. lra. }
  assert (forall z, 0 < IZR (Zpos (Qden z)) ^ k) as P by (intro z; apply pow_lt, den_positive).
  destruct (equal (size_lo w) (size_hi w)) eqn:Eq.
  - passed H. apply equal_real in Eq. apply Z.eqb_eq, (f_equal IZR) in H. rewrite Left, Right in H.
    apply Rmult_eq_reg_r in H; [|pose proof (P (size_lo w)); lra]. apply Rmult_eq_reg_r in H; [|lra].
    rewrite <- Eq. split; apply (pow_le_iff _ _ k); trivial; lra.
  - passed H. passed H. apply Z.leb_le, IZR_le in H3. apply Z.ltb_lt, IZR_lt in H. rewrite Left, Right in *.
    apply Rmult_le_reg_r in H3; [|apply P]. apply Rmult_le_reg_r in H3; [|exact Dr].
    apply Rmult_lt_reg_r in H; [|apply P]. apply Rmult_lt_reg_r in H; [|exact Dr].
    split; [apply (pow_le_iff _ _ k); trivial; lra|]. left. apply (pow_lt_iff _ _ k); trivial; lra.
Qed.

Lemma total_of_one (f : R -> R) (l : list R) x : (forall y, In y l -> y = x) -> total (map f l) = INR (length l) * f x.
Proof.
  induction l as [|y l IH]; intro H; [simpl; ring|].
  change (total (map f (y :: l))) with (f y + total (map f l)). rewrite IH by (intros; apply H; right; assumption).
  change (length (y :: l)) with (Datatypes.S (length l)). rewrite S_INR, (H y (or_introl eq_refl)). ring.
Qed.

(* The size of the particles of class j, to the power a, by their number and mass. *)
Lemma size_of_class na nb f rs S j x :
  power_law na nb f -> proper_rows rs -> describes d rs S -> one_size_a_class d (classes rs) S -> In j (classes rs) ->
  In x S -> in_class d j x -> x ^ na = (held d f j S / (IZR (number d j S) * Q2R (c j))) ^ nb /\ (1 <= number d j S)%Z.
Proof.
  intros (Law & P) W D O J X Jx. pose proof (proper_classes rs W) as Pj. rewrite Forall_forall in Pj.
  destruct (proper_sizes (d := d) j (Pj j J)) as (L & U). destruct (Pj j J) as (_ & C & _). assert (0 <= x) as X0 by (unfold in_class in Jx; lra).
  assert (forall y, In y (inside d j S) -> y = x) as One.
  { intros y Y. apply inside_in in Y as (Y & Jy). apply (O j); assumption. }
  assert (In x (inside d j S)) as I by (apply inside_in; auto).
  assert (1 <= number d j S)%Z as N by (unfold number; destruct (inside d j S); [destruct I | simpl length; lia]).
  split; [|exact N]. unfold held. rewrite (total_of_one f _ x One), INR_IZR_INZ. fold (number d j S).
  apply (IZR_le 1) in N. destruct (P x X0) as (_ & <-). f_equal. field. lra.
Qed.

(* What a line of the witness says of a sample. *)
Definition line_true (js : list class) (S : sample) (w : witness_line) : Prop :=
  exists j, nth_error js (Z.to_nat (index w - 1)) = Some j /\ number d j S = count w /\
    forall x, In x S -> in_class d j x -> Q2R (size_lo w) <= x <= Q2R (size_hi w).

End Root.

Arguments line_true : clear implicits.
