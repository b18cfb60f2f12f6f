(* From samples to counts and masses (Theorems 1 and 12 (a)): only how many particles a class holds, and what
   mass, matters; one size per class loses nothing. *)

From Coq Require Import ZArith QArith Reals Qreals Ranalysis5 List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Spec Openings.
Import ListNotations.
Open Scope R_scope.

Section Root.
Context {d : positive}.

(* ---- Classes of a gradation ---------------------------------------------------------------------- *)

Definition proper (j : class) : Prop :=
  0 <= Q2R (lower j) < Q2R (upper j) /\ 0 < Q2R (c j) /\ 0 <= Q2R (mass j).

Lemma proper_sizes j : proper j -> 0 <= lower_size d j < upper_size d j.
Proof. intros (B & _). apply size_lt, B. Qed.

(* Ascending openings, from x1 up. *)
Fixpoint ascend_from (x1 : R) (js : list class) : Prop :=
  match js with
  | [] => True
  | j :: js => lower_size d j = x1 /\ x1 < upper_size d j /\ ascend_from (upper_size d j) js
  end.
Definition top (x1 : R) (js : list class) : R := fold_left (fun _ j => upper_size d j) js x1.

Lemma top_le js : forall x1, ascend_from x1 js -> x1 <= top x1 js.
Proof.
  induction js as [|j js IH]; intros x1 A; simpl; [lra|]. destruct A as (E & L & A).
  pose proof (IH _ A). unfold top in *. lra.
Qed.

(* What the rows of a gradation file are, after the question too. *)
Definition proper_rows (rs : list row) : Prop :=
  ascending rs = true /\ 0 <= Q2R (opening (hd (Row 0 0 1 0) rs)) /\ complete rs /\
  Forall (fun r => (0 <= retained r)%Q /\ (0 < factor r)%Q) rs.

Lemma classes_ascend rs :
  proper_rows rs ->
  ascend_from (least_opening d rs) (classes rs) /\ top (least_opening d rs) (classes rs) = largest_opening d rs.
Proof.
  intros (A & P & _). destruct rs as [|x rs]; [simpl; split; reflexivity|]. revert x A P.
  induction rs as [|y rs IH]; intros x A P; [simpl; split; reflexivity|].
  change (ascending (x :: y :: rs)) with (less (opening x) (opening y) && ascending (y :: rs))%bool in A.
  apply andb_prop in A as (L & A). apply less_spec, Qlt_Rlt in L. simpl in P.
  destruct (IH y A) as (B & T); [simpl; lra|]. clear IH.
  change (classes (x :: y :: rs)) with (Class (opening x) (opening y) (retained x) (factor x) :: classes (y :: rs)).
  change (least_opening d (y :: rs)) with (size_of d (opening y)) in *.
  change (least_opening d (x :: y :: rs)) with (size_of d (opening x)) in *.
  split; [split; [reflexivity | split; [apply (size_lt (opening x) (opening y)); lra | exact B]]|]. exact T.
Qed.

Lemma above_lower js : forall x1 j x, ascend_from x1 js -> In j js -> in_class d j x -> x1 < x.
Proof.
  induction js as [|i js IH]; intros x1 j x A I H; [destruct I|]. destruct A as (E & L & A).
  destruct I as [<-|I]; [unfold in_class in H; lra|]. pose proof (IH _ _ _ A I H). lra.
Qed.

(* ---- Lists of sizes ------------------------------------------------------------------------------ *)

Lemma total_app xs ys : total (xs ++ ys) = total xs + total ys.
Proof. induction xs as [|x xs IH]; simpl; [ring | rewrite IH; ring]. Qed.

Lemma inside_app j S T : inside d j (S ++ T) = inside d j S ++ inside d j T.
Proof. apply filter_app. Qed.

Lemma inside_in j S x : In x (inside d j S) <-> In x S /\ in_class d j x.
Proof.
  unfold inside. rewrite filter_In. destruct (in_class_dec d j x); split; intros (I & H); split; trivial; [discriminate | contradiction].
Qed.

Lemma inside_all j S : (forall x, In x S -> in_class d j x) -> inside d j S = S.
Proof.
  unfold inside. induction S as [|x S IH]; intro H; simpl; [reflexivity|].
  destruct (in_class_dec d j x) as [_|N]; [rewrite IH; auto; intros; apply H; right; assumption|].
  contradiction N. apply H. left; reflexivity.
Qed.

Lemma inside_none j S : (forall x, In x S -> ~ in_class d j x) -> inside d j S = [].
Proof.
  unfold inside. induction S as [|x S IH]; intro H; simpl; [reflexivity|].
  destruct (in_class_dec d j x) as [Y|_]; [exfalso; eapply H; [left; reflexivity | exact Y]|].
  apply IH. intros; apply H; right; assumption.
Qed.

(* Every particle between the ends of the classes is in one of them, and in one only. *)
Lemma number_total js : forall x1 S,
  ascend_from x1 js -> (forall x, In x S -> x1 < x <= top x1 js) ->
  Z.of_nat (length S) = sum (map (fun j => number d j S) js).
Proof.
  intros x1 S A. induction S as [|x S IH]; intro H.
  { simpl. clear A H. induction js; simpl; [reflexivity|]. unfold number at 1. simpl. exact IHjs. }
  assert (sum (map (fun j => number d j (x :: S)) js) = sum (map (fun j => number d j S) js) + 1)%Z as E.
  2: { rewrite E, <- IH by (intros; apply H; right; assumption). simpl length. lia. }
  specialize (H x (or_introl eq_refl)). clear IH. revert x1 A H.
  induction js as [|j js IH]; intros x1 A H; simpl in *; [unfold top in H; simpl in H; lra|].
  destruct A as (E & L & A). unfold number at 1. simpl. destruct (in_class_dec d j x) as [Y|N].
  - assert (sum (map (fun j => number d j (x :: S)) js) = sum (map (fun j => number d j S) js)) as E'.
    { f_equal. apply map_ext_in. intros i I. unfold number, inside. simpl.
      destruct (in_class_dec d i x) as [Yi|]; [|reflexivity].
      pose proof (above_lower _ _ _ _ A I Yi). unfold in_class in Y. lra. }
    rewrite E'. simpl length. unfold number, inside. lia.
  - assert (upper_size d j < x) as U by (unfold in_class in N; destruct (Rle_dec x (upper_size d j)); [exfalso; apply N; lra | lra]).
    rewrite (IH (upper_size d j) A); [unfold number, inside; lia|]. split; [exact U|]. apply H.
Qed.

(* ---- Theorem 1 (a) ------------------------------------------------------------------------------- *)

Section Law.
Variable f : R -> R.
Hypothesis law : mass_law f.

Lemma law_le x y : 0 <= x <= y -> f x <= f y.
Proof.
  intros (X & [L| ->]); [|lra]. left. apply law; lra.
Qed.

Lemma law_nonneg x : 0 <= x -> 0 <= f x.
Proof. intro H. pose proof (law_at_0 f law). pose proof (law_le 0 x). lra. Qed.

(* A class holds nothing, or what q particles of sizes in the class can have together. *)
Definition realizes (j : class) (q : Z) (t : R) : Prop :=
  (q = 0%Z /\ t = 0) \/
  ((1 <= q)%Z /\ IZR q * (Q2R (c j) * f (lower_size d j)) < t <= IZR q * (Q2R (c j) * f (upper_size d j))).

Lemma total_between lo hi xs :
  0 <= lo -> (forall x, In x xs -> lo < x <= hi) -> xs <> [] ->
  INR (length xs) * f lo < total (map f xs) <= INR (length xs) * f hi.
Proof.
  intros L H N. induction xs as [|x xs IH]; [congruence|]. clear N.
  assert (f lo < f x) as A by (apply law; split; [exact L | apply H; left; reflexivity]).
  assert (f x <= f hi) as B by (pose proof (H x (or_introl eq_refl)); apply law_le; lra).
  destruct xs as [|y xs]; [simpl; lra|].
  assert (INR (length (y :: xs)) * f lo < total (map f (y :: xs)) <= INR (length (y :: xs)) * f hi) as C.
  { apply IH; [intros; apply H; right; assumption | congruence]. }
  change (length (x :: y :: xs)) with (Datatypes.S (length (y :: xs))). rewrite S_INR.
  change (total (map f (x :: y :: xs))) with (f x + total (map f (y :: xs))). lra.
Qed.

Theorem sample_realizes j S : proper j -> realizes j (number d j S) (held d f j S).
Proof.
  intro P. destruct (proper_sizes j P) as (L & U). destruct P as (_ & C & _). unfold number, held. destruct (inside d j S) as [|x xs] eqn:E.
  { left. simpl. split; [reflexivity | ring]. }
  right. rewrite <- E in *. assert (inside d j S <> []) as N by congruence.
  pose proof (total_between (lower_size d j) (upper_size d j) (inside d j S) L) as T.
  assert (forall y, In y (inside d j S) -> lower_size d j < y <= upper_size d j) as I.
  { intros y Y. apply inside_in in Y. apply Y. }
  specialize (T I N). rewrite INR_IZR_INZ in T. split.
  - destruct (inside d j S); [congruence | simpl length; lia].
  - destruct T as (A & B). clear - A B C. generalize dependent (IZR (Z.of_nat (length (inside d j S)))). intros q A B.
    apply (Rmult_lt_compat_l (Q2R (c j))) in A; [|exact C].
    apply (Rmult_le_compat_l (Q2R (c j))) in B; [|lra]. lra.
Qed.

(* The intermediate value argument: the mass of one particle can be anything in (c f(lower), c f(upper)]. *)
Lemma some_size j y :
  proper j -> Q2R (c j) * f (lower_size d j) < y <= Q2R (c j) * f (upper_size d j) ->
  exists x, in_class d j x /\ Q2R (c j) * f x = y.
Proof.
  intros P (A & B). destruct (proper_sizes j P) as (L & U). destruct P as (_ & C & _). set (lo := lower_size d j) in *. set (hi := upper_size d j) in *.
  set (cj := Q2R (c j)) in *.
  destruct B as [B| ->]; [|exists hi; unfold in_class; fold lo hi; split; [lra | reflexivity]].
  destruct (IVT_interv (fun x => cj * f x - y) lo hi) as (x & (X1 & X2) & X); try lra.
  { intros z Z1 Z2. apply continuity_pt_minus.
    - apply continuity_pt_scal with (f := f). apply law. lra.
    - apply continuity_pt_const. intros ? ?. reflexivity. }
  exists x. split; [|lra]. unfold in_class; fold lo hi. split; [|exact X2].
  destruct X1 as [X1|X1]; [exact X1|]. subst x. lra.
Qed.

Lemma total_repeat x n : total (map f (repeat x n)) = INR n * f x.
Proof.
  induction n as [|n IH]; [simpl; ring|]. rewrite S_INR. simpl. rewrite IH. ring.
Qed.

(* q particles of one size with the mass t together. *)
Lemma some_particles j q t :
  proper j -> realizes j q t ->
  exists x, (forall y, In y (repeat x (Z.to_nat q)) -> in_class d j y) /\
    (0 <= q)%Z /\ Q2R (c j) * total (map f (repeat x (Z.to_nat q))) = t.
Proof.
  intros P [(-> & ->)|(Q & B)].
  { exists 0. simpl. split; [intros z []|]. split; [lia | ring]. }
  assert (1 <= IZR q) as Q1 by (apply (IZR_le 1); exact Q).
  destruct (some_size j (t / IZR q) P) as (x & X & E).
  { assert (0 < / IZR q) as I by (apply Rinv_0_lt_compat; lra). destruct B as (B1 & B2). unfold Rdiv. split.
    - apply (Rmult_lt_reg_l (IZR q)); [lra|]. replace (IZR q * (t * / IZR q)) with t by (field; lra). exact B1.
    - apply (Rmult_le_reg_l (IZR q)); [lra|]. replace (IZR q * (t * / IZR q)) with t by (field; lra). exact B2. }
  exists x. split; [intros z Z; apply repeat_spec in Z; subst; exact X|]. split; [lia|].
  rewrite total_repeat, INR_IZR_INZ, Z2Nat.id by lia.
  replace (Q2R (c j) * (IZR q * f x)) with (IZR q * (Q2R (c j) * f x)) by ring. rewrite E. field. lra.
Qed.

(* ---- Samples of given counts and masses ---------------------------------------------------------- *)

Definition one_size_a_class (js : list class) (S : sample) : Prop :=
  forall j x y, In j js -> In x S -> In y S -> in_class d j x -> in_class d j y -> x = y.

Theorem counts_sample js : forall x1 qts,
  ascend_from x1 js -> Forall proper js -> Forall2 (fun j qt => realizes j (fst qt) (snd qt)) js qts ->
  exists S, (forall x, In x S -> x1 < x <= top x1 js) /\ one_size_a_class js S /\
    Forall2 (fun j qt => number d j S = fst qt /\ held d f j S = snd qt) js qts.
Proof.
  induction js as [|j js IH]; intros x1 qts A P H; inversion H as [|? (q & t) ? qts' Hj Hjs]; subst; simpl in *.
  { exists []. split; [intros x []|]. split; [intros ? ? ? []|constructor]. }
  destruct A as (E & L & A). inversion P as [|? ? Pj Pjs]; subst.
  destruct (IH _ _ A Pjs Hjs) as (S & B & O & C). clear IH.
  destruct (some_particles j q t Pj Hj) as (x & X & Q & T).
  set (new := repeat x (Z.to_nat q)) in *.
  assert (forall y, In y S -> ~ in_class d j y) as NS.
  { intros y Y (_ & Z). specialize (B y Y). lra. }
  assert (forall i y, In i js -> In y new -> ~ in_class d i y) as NN.
  { intros i y I Y Z. pose proof (above_lower _ _ _ _ A I Z). destruct (X y Y) as (_ & W). lra. }
  exists (new ++ S). split; [|split].
  - unfold top in *; simpl. intros y Y. apply in_app_or in Y as [Y|Y].
    + pose proof (top_le _ _ A) as W. unfold top in W. destruct (X y Y) as (X1 & X2). lra.
    + specialize (B y Y). lra.
  - intros i y z I Y Z Iy Iz. apply in_app_or in Y, Z. destruct I as [<-|I].
    + destruct Y as [Y|Y]; [|destruct (NS _ Y Iy)]. destruct Z as [Z|Z]; [|destruct (NS _ Z Iz)].
      apply repeat_spec in Y, Z. congruence.
    + destruct Y as [Y|Y]; [destruct (NN _ _ I Y Iy)|]. destruct Z as [Z|Z]; [destruct (NN _ _ I Z Iz)|].
      eapply O; eassumption.
  - constructor; simpl.
    + unfold number, held. rewrite inside_app, (inside_none j S NS), app_nil_r, (inside_all j new X).
      unfold new. rewrite repeat_length. split; [lia | exact T].
    + clear -C NN. assert (forall i, In i js -> inside d i (new ++ S) = inside d i S) as K.
      { intros i I. rewrite inside_app, (inside_none i new); [reflexivity|]. intros; eapply NN; eassumption. }
      unfold number, held in *. clear NN. induction C as [|i qt js qts D _ IH]; constructor.
      * rewrite K by (left; reflexivity). exact D.
      * apply IH. intros; apply K; right; assumption.
Qed.

End Law.

(* ---- Gradations ---------------------------------------------------------------------------------- *)

Lemma proper_classes rs : proper_rows rs -> Forall proper (classes rs).
Proof.
  intros (A & L & _ & P). destruct rs as [|x rs]; [constructor|]. simpl in L.
  revert x A L P. induction rs as [|y rs IH]; intros x A L P; [constructor|].
  change (ascending (x :: y :: rs)) with (less (opening x) (opening y) && ascending (y :: rs))%bool in A.
  apply andb_prop in A as (Lt & A). apply less_spec, Qlt_Rlt in Lt.
  change (classes (x :: y :: rs)) with (Class (opening x) (opening y) (retained x) (factor x) :: classes (y :: rs)).
  inversion P as [|? ? (M & C) P']; subst. constructor.
  - unfold proper; simpl. rewrite <- Q2R_0. repeat split.
    + rewrite Q2R_0. exact L.
    + exact Lt.
    + apply Qlt_Rlt, C.
    + apply Qle_Rle, M.
  - apply IH; [exact A | lra | exact P'].
Qed.

(* Theorems 1 and 12 (a): counts and masses belong to a sample iff each class can hold them; then they belong to
   one with one size a class. *)
Theorem realizable f rs qts :
  mass_law f -> proper_rows rs ->
  (exists S, describes d rs S /\
     Forall2 (fun j qt => number d j S = fst qt /\ held d f j S = snd qt) (classes rs) qts) <->
  Forall2 (fun j qt => realizes f j (fst qt) (snd qt)) (classes rs) qts.
Proof.
  intros Law P. pose proof (proper_classes rs P) as Pj. destruct (classes_ascend rs P) as (As & T). destruct P as (_ & _ & C & _). split.
  - intros (S & D & H). clear -H Pj Law. induction H as [|j qt js qts (Q & W) _ IH]; constructor.
    + rewrite <- Q, <- W. apply sample_realizes; [exact Law|]. inversion Pj; assumption.
    + apply IH. inversion Pj; assumption.
  - intro H. destruct (counts_sample f Law _ _ _ As Pj H) as (S & B & O & K).
    exists S. split; [|exact K]. split; [exact C|]. intros x X. rewrite <- T. apply B, X.
Qed.

Lemma describes_number rs S :
  proper_rows rs -> describes d rs S -> Z.of_nat (length S) = sum (map (fun j => number d j S) (classes rs)).
Proof.
  intros P (_ & D). destruct (classes_ascend rs P) as (As & T).
  apply (number_total _ _ S As). intros x X. rewrite T. apply D, X.
Qed.

(* Theorem 1 (b). *)
Theorem match_counts f rs n :
  mass_law f -> proper_rows rs ->
  (exists S, describes_accurately d f rs S /\ Z.of_nat (length S) = n) <->
  (exists s qs, 0 < s /\ Forall2 (fun j q => realizes f j q (s * Q2R (mass j))) (classes rs) qs /\ sum qs = n).
Proof.
  intros Law P. split.
  - intros (S & (s & Sp & D & H) & N). exists s, (map (fun j => number d j S) (classes rs)).
    split; [exact Sp|]. split; [|rewrite <- N; symmetry; apply describes_number; assumption].
    pose proof (proper_classes rs P) as Pj. clear -H Pj Law.
    induction (classes rs) as [|j js IH]; constructor; inversion Pj; subst.
    + rewrite <- H by (left; reflexivity). apply sample_realizes; assumption.
    + apply IH; [intros; apply H; right|]; assumption.
  - intros (s & qs & Sp & H & N).
    destruct (proj2 (realizable f rs (map (fun '(j, q) => (q, s * Q2R (mass j))) (combine (classes rs) qs)) Law P))
      as (S & D & K).
    { clear -H. induction H; constructor; auto. }
    exists S. split.
    + exists s. split; [exact Sp|]. split; [exact D|].
      clear -H K. induction H as [|j q js qs _ _ IH]; intros i I; [destruct I|].
      simpl in K. inversion K as [|? ? ? ? (_ & E) K']; subst. destruct I as [<-|I]; [exact E | apply IH; assumption].
    + rewrite (describes_number rs S P D), <- N. clear -H K. f_equal.
      induction H as [|j q js qs _ _ IH]; simpl in *; [reflexivity|].
      inversion K as [|? ? ? ? (E & _) K']; subst. simpl in *. rewrite E, IH by exact K'. reflexivity.
Qed.

End Root.

Arguments ascend_from : clear implicits.
Arguments top : clear implicits.
Arguments realizes : clear implicits.
Arguments one_size_a_class : clear implicits.
