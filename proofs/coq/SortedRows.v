(* Sorting keeps what it sorts. *)

From Coq Require Import ZArith List Bool Permutation Lia.
From Mdm Require Import Numbers Rows CsvRead.
Import ListNotations.

Section Sorted.
Context {A : Type} (smaller : A -> A -> bool).

Lemma merge_onto_nil ys done : merge_onto smaller [] ys done = rev_append ys done.
Proof. destruct ys; reflexivity. Qed.

Lemma merge_keeps xs : forall ys done, Permutation (merge_onto smaller xs ys done) (xs ++ ys ++ done).
Proof.
  induction xs as [|x xs IH]; intros ys.
  - intro done. rewrite merge_onto_nil, rev_append_rev. cbn [app]. apply Permutation_app_tail. symmetry. apply Permutation_rev.
  - induction ys as [|y ys IHy]; intro done.
    + change (merge_onto smaller (x :: xs) [] done) with (rev_append (x :: xs) done). rewrite rev_append_rev.
      cbn [app]. change (x :: xs ++ done) with ((x :: xs) ++ done). apply Permutation_app_tail. symmetry. apply Permutation_rev.
    + change (merge_onto smaller (x :: xs) (y :: ys) done) with
        (if smaller y x then merge_onto smaller (x :: xs) ys (y :: done) else merge_onto smaller xs (y :: ys) (x :: done)).
      destruct (smaller y x).
      * rewrite IHy. cbn [app]. apply perm_skip. apply Permutation_app_head. symmetry. apply Permutation_middle.
      * rewrite IH. replace (xs ++ (y :: ys) ++ x :: done) with ((xs ++ y :: ys) ++ x :: done) by (rewrite <- app_assoc; reflexivity).
        replace ((x :: xs) ++ (y :: ys) ++ done) with (x :: (xs ++ y :: ys) ++ done) by (rewrite <- app_assoc; reflexivity).
        symmetry. apply Permutation_middle.
Qed.

Lemma concat_rev (ls : list (list A)) : Permutation (concat (rev ls)) (concat ls).
Proof.
  induction ls as [|l ls IH]; [constructor|]. cbn [rev concat]. rewrite concat_app. cbn [concat]. rewrite app_nil_r, IH.
  apply Permutation_app_comm.
Qed.

Lemma pairs_keep n : forall ls done, (length ls <= n)%nat ->
  Permutation (concat (merge_pairs smaller ls done)) (concat ls ++ concat done) /\
  (2 * length (merge_pairs smaller ls done) <= length ls + 1 + 2 * length done)%nat.
Proof.
  induction n as [|n IH]; intros [|x [|y ls]] done L; cbn [length] in L; try lia.
  1, 2, 3: cbn [merge_pairs]; rewrite rev'_is_rev, concat_rev, rev_length; cbn [concat length]; rewrite ?app_nil_r;
    split; [reflexivity | lia].
  cbn [merge_pairs]. destruct (IH ls (rev' (merge_onto smaller x y []) :: done)) as (P & Le); [lia|].
  split; [|cbn [length] in *; lia]. rewrite P. cbn [concat]. rewrite rev'_is_rev, <- Permutation_rev, merge_keeps, app_nil_r.
  rewrite !app_assoc. apply Permutation_app_tail. rewrite <- app_assoc. apply Permutation_app_comm.
Qed.

Lemma merge_all_keeps rounds : forall ls, Z.of_nat (length ls) <= 2 ^ Z.of_nat rounds ->
  Permutation (merge_all smaller rounds ls) (concat ls).
Proof.
  induction rounds as [|rounds IH]; intros [|x [|y ls]] L; try (cbn; rewrite ?app_nil_r; reflexivity).
  - cbn [length] in L. change (2 ^ Z.of_nat 0)%Z with 1%Z in L. lia.
  - cbn [merge_all]. destruct (pairs_keep _ (x :: y :: ls) [] (le_n _)) as (P & Le).
    rewrite IH; [rewrite P; cbn [concat]; rewrite !app_nil_r; reflexivity|].
    rewrite Nat2Z.inj_succ, Z.pow_succ_r in L by lia. cbn [length] in *. lia.
Qed.

Lemma sorted_keeps l : Z.of_nat (length l) <= 2 ^ 64 -> Permutation (sorted smaller l) l.
Proof.
  intro L. unfold sorted. destruct (is_sorted smaller l); [reflexivity|].
  rewrite merge_all_keeps; rewrite map_all_is_map; [|rewrite map_length; exact L].
  clear L. induction l as [|x l IH]; [constructor|]. cbn [map concat app]. apply perm_skip, IH.
Qed.

End Sorted.
