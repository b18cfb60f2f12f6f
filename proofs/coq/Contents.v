(* What classes hold, class by class: counts and masses. Matches are first found and bounded as such, whatever samples have
   them; here they are of samples of one gradation. *)

From Coq Require Import ZArith QArith Reals Qreals List Bool Lia Lra.
From Mdm Require Import Numbers NumbersFacts Gradation Certificate Question Spec Openings Reduction RealFacts Sizes.
Import ListNotations.
Open Scope R_scope.

Definition contents : Type := list (Z * R).

(* The particles of class j, as many as the line w of the witness says and with the mass t together, have the size x of the
   line if they have one size. *)
Definition size_fits (na nb : nat) (j : class) (t : R) (w : witness_line) : Prop :=
  forall x, 0 <= x -> x ^ na = (t / (IZR (count w) * Q2R (c j))) ^ nb -> Q2R (size_lo w) <= x <= Q2R (size_hi w).

Definition line_fits (na nb : nat) (js : list class) (qts : contents) (w : witness_line) : Prop :=
  exists j t, nth_error js (Z.to_nat (index w - 1)) = Some j /\ nth_error qts (Z.to_nat (index w - 1)) = Some (count w, t) /\
    size_fits na nb j t w.

(* The elements behind those that come before. *)
Lemma nth_behind {A} (pre post : list A) x n : n = length pre -> nth_error (pre ++ x :: post) n = Some x.
Proof. intros ->. rewrite nth_error_app2, Nat.sub_diag by lia. reflexivity. Qed.

Section Root.
Context {d : positive}.

Definition has_contents (law : R -> R) (js : list class) (S : sample) (qts : contents) : Prop :=
  Forall2 (fun j qt => number d j S = fst qt /\ held d law j S = snd qt) js qts.

Definition contents_of (law : R -> R) (js : list class) (S : sample) : contents :=
  map (fun j => (number d j S, held d law j S)) js.

Lemma contents_are law js S qts : has_contents law js S qts -> qts = contents_of law js S.
Proof.
  induction 1 as [|j (n, t) js qts (N & T) _ IH]; [reflexivity|]. cbn [contents_of map fst snd] in *. rewrite N, T, IH. reflexivity.
Qed.

Lemma counts_of_contents law js S : map fst (contents_of law js S) = map (fun j => number d j S) js.
Proof. unfold contents_of. rewrite map_map. reflexivity. Qed.

Lemma masses_of_contents law js S : map snd (contents_of law js S) = map (fun j => held d law j S) js.
Proof. unfold contents_of. rewrite map_map. reflexivity. Qed.

Lemma line_of_sample na nb law rs S w : power_law na nb law -> proper_rows rs -> describes d rs S ->
  one_size_a_class d (classes rs) S -> line_fits na nb (classes rs) (contents_of law (classes rs) S) w ->
  line_true d (classes rs) S w.
Proof.
  intros P W D O (j & t & J & C & Fits). exists j. split; [exact J|]. unfold contents_of in C.
  rewrite nth_error_map, J in C. injection C as N T. split; [exact N|]. intros x X Jx. apply nth_error_In in J.
  pose proof (proper_classes rs W) as Pj. rewrite Forall_forall in Pj.
  destruct (proper_sizes (d := d) j (Pj j J)) as (L & _).
  destruct (size_of_class na nb law rs S j x P W D O J X Jx) as (E & _). rewrite N, T in E.
  apply Fits; [|exact E]. unfold in_class in Jx. lra.
Qed.

(* Theorem 1 (a): a sample with given counts and masses, one size in each class. *)
Lemma sample_with_contents law rs qts : mass_law law -> proper_rows rs ->
  Forall2 (fun j qt => realizes d law j (fst qt) (snd qt)) (classes rs) qts ->
  exists S, describes d rs S /\ one_size_a_class d (classes rs) S /\ has_contents law (classes rs) S qts.
Proof.
  intros Law W H. destruct (classes_ascend (d := d) rs W) as (As & T).
  destruct (counts_sample (d := d) law Law (classes rs) _ qts As (proper_classes rs W) H) as (S & B & O & C).
  exists S. split; [|split; assumption]. split; [apply W|]. intros x X. rewrite <- T. apply B, X.
Qed.

Lemma contents_realize law rs S : mass_law law -> proper_rows rs ->
  Forall2 (fun j qt => realizes d law j (fst qt) (snd qt)) (classes rs) (contents_of law (classes rs) S).
Proof.
  intros Law W. pose proof (proper_classes rs W) as P. unfold contents_of. induction P as [|j js Pj _ IH]; constructor; [|exact IH].
  apply sample_realizes; assumption.
Qed.

End Root.

Arguments has_contents : clear implicits.
Arguments contents_of : clear implicits.
