(* Theorems 14 (b) and 20 (e): an accepted tree proves that nothing with fewer particles than the bound satisfies the
   conditions. *)

From Coq Require Import ZArith QArith Reals Qreals RMicromega List Bool Lia Lra FMapPositive.
From Mdm Require Import Numbers NumbersFacts Certificate Leaf Windows Tree Spec Reduction RealFacts LeafSound WindowClass
  WindowsSound.
Import ListNotations.
Open Scope R_scope.

Section Tree.
Variable pr : problem.
Hypothesis mass_unit_positive : 0 < IZR (mass_unit pr).
Hypothesis share_unit_positive : 0 < IZR (share_unit pr).
Hypothesis targets_whole : sum (map g (classes_of pr)) = share_unit pr.
Hypothesis classes_ascend : Forall (fun x => (0 <= f x < F x)%Z) (classes_of pr).
Hypothesis volume_nonneg : 0 <= Q2R (volume pr).

Section Point.
Variable ss : list state.
Hypothesis solves : satisfies pr ss.
Notation M := (all_mass ss).
Notation t := (number_from 1 (classes_of pr) (PositiveMap.empty limits)).

(* What the splits on the way to a node say is true of the counts and of the mass. *)
Definition in_force (e : force) : Prop :=
  forced ss e /\ Q2R (above e) < M /\ forall u, up_to_mass e = Some u -> M <= Q2R u.

Lemma of_range_set i j v r i' j' :
  of_range i' j' (set_range i j v r) = if (i' =? i)%positive && (j' =? j)%positive then Some v else of_range i' j' r.
Proof.
  unfold of_range, set_range. destruct (Pos.eqb_spec i' i) as [->|Ni]; cbn [andb].
  - rewrite PositiveMap.gss. destruct (Pos.eqb_spec j' j) as [->|Nj]; [apply PositiveMap.gss|].
    rewrite PositiveMap.gso by exact Nj. destruct (PositiveMap.find i r); [reflexivity | apply PositiveMap.gempty].
  - rewrite PositiveMap.gso by exact Ni. reflexivity.
Qed.

Lemma split_forced e i j v : forced ss e -> forced ss (below e i j v) \/ forced ss (from e i j v).
Proof.
  intro Fo. unfold below, from.
  assert (forall u, (forall s0 s, state_before ss i = Some s0 -> state_at j 1 ss = Some s -> (N_of s - N_of s0 <= u)%Z) ->
            forced ss (Force (at_least_v e) (set_range i j u (at_most_v e)) (above e) (up_to_mass e))) as Upper.
  { intros u H i' j' s0 s B At. destruct (Fo i' j' s0 s B At) as (Lo & Up). split; [exact Lo|]. cbn [at_most_v]. intros w W.
    rewrite of_range_set in W. destruct (Pos.eqb_spec i' i) as [->|]; [|exact (Up w W)].
    destruct (Pos.eqb_spec j' j) as [->|]; [|exact (Up w W)]. injection W as <-. exact (H s0 s B At). }
  assert (forall u, (forall s0 s, state_before ss i = Some s0 -> state_at j 1 ss = Some s -> (u <= N_of s - N_of s0)%Z) ->
            forced ss (Force (set_range i j u (at_least_v e)) (at_most_v e) (above e) (up_to_mass e))) as Lower.
  { intros u H i' j' s0 s B At. destruct (Fo i' j' s0 s B At) as (Lo & Up). split; [|exact Up]. cbn [at_least_v].
    intros w W.
    rewrite of_range_set in W. destruct (Pos.eqb_spec i' i) as [->|]; [|exact (Lo w W)].
    destruct (Pos.eqb_spec j' j) as [->|]; [|exact (Lo w W)]. injection W as <-. exact (H s0 s B At). }
  destruct (state_before ss i) as [s0|] eqn:B; [|left; apply Upper; congruence].
  destruct (state_at j 1 ss) as [s|] eqn:At; [|left; apply Upper; congruence].
  destruct (Fo i j s0 s B At) as (Lo & Up).
  destruct (Z_lt_le_dec (N_of s - N_of s0) v) as [L|L]; [left; apply Upper | right; apply Lower]; intros ? ? [= <-] [= <-].
  - destruct (of_range i j (at_most_v e)) as [w|]; [specialize (Up w eq_refl)|]; lia.
  - destruct (of_range i j (at_least_v e)) as [w|]; [specialize (Lo w eq_refl)|]; lia.
Qed.

Lemma split_in_force e i j v : in_force e -> in_force (below e i j v) \/ in_force (from e i j v).
Proof. intros (Fo & Ma). destruct (split_forced e i j v Fo) as [B|B]; [left | right]; split; assumption. Qed.

Lemma split_of_mass e v : in_force e -> in_force (lighter e v) \/ in_force (heavier e v).
Proof.
  intros (Fo & Lo & Up). destruct (Rle_lt_dec M (Q2R v)) as [L|L]; [left | right]; (split; [exact Fo|]);
    cbn [above up_to_mass lighter heavier].
  - split; [exact Lo|]. intros u [= <-]. destruct (up_to_mass e) as [u|]; [|exact L].
    unfold smaller. destruct (less v u); [exact L | exact (Up u eq_refl)].
  - split; [|exact Up]. unfold larger. destruct (less (above e) v); assumption.
Qed.

Lemma nodes_sound nodes : forall to_come e,
  check_nodes pr t (bounds_of_shares pr) nodes to_come = Ok tt -> In e to_come -> ~ in_force e.
Proof.
  induction nodes as [|n nodes IH]; intros to_come e H I Fo.
  { destruct to_come; [destruct I | discriminate]. }
  cbn [check_nodes] in H. destruct n as [i j v|v|ks|ks].
  - destruct i as [|i|i], j as [|j|j]; try discriminate. destruct to_come as [|e0 to_come]; [discriminate|].
    destruct ((i <=? j)%positive && PositiveMap.mem j t); [|discriminate]. destruct I as [->|I].
    + destruct (split_in_force e i j v Fo) as [B|B]; [apply (IH _ _ H (or_introl eq_refl) B)|].
      apply (IH _ (from e i j v) H); [right; left; reflexivity | exact B].
    + apply (IH _ e H); [right; right; exact I | exact Fo].
  - destruct to_come as [|e0 to_come]; [discriminate|]. destruct I as [->|I].
    + destruct (split_of_mass e v Fo) as [B|B]; [apply (IH _ _ H (or_introl eq_refl) B)|].
      apply (IH _ (heavier e v) H); [right; left; reflexivity | exact B].
    + apply (IH _ e H); [right; right; exact I | exact Fo].
  - destruct to_come as [|e0 to_come]; [discriminate|]. destruct (refutes pr t e0 ks) eqn:R; [|discriminate].
    destruct I as [->|I]; [|exact (IH _ _ H I Fo)].
    exact (leaf_sound pr mass_unit_positive share_unit_positive ss solves e ks R (proj1 Fo)).
  - destruct to_come as [|e0 to_come]; [discriminate|].
    destruct (rules_out pr t (bounds_of_shares pr) e0 ks) eqn:R; [|discriminate].
    destruct I as [->|I]; [|exact (IH _ _ H I Fo)]. destruct Fo as (Fo & Lo & Up).
    exact (window_sound pr mass_unit_positive share_unit_positive targets_whole classes_ascend volume_nonneg ss solves e Fo
      Lo Up ks R).
Qed.

Lemma nothing_in_force : in_force nothing.
Proof.
  split; [|split].
  - intros i j s0 s _ _. unfold nothing, of_range. cbn [at_least_v at_most_v].
    split; intros v H; rewrite PositiveMap.gempty in H; discriminate.
  - cbn [nothing above]. rewrite Q2R_0. apply (sat_mass _ _ solves).
  - discriminate.
Qed.

End Point.

(* Theorem 14 (b), with windows of the mass Theorem 20 (e). *)
Theorem tree_sound nodes : check_tree pr nodes = Ok tt -> forall ss, ~ satisfies pr ss.
Proof.
  intros H ss S. unfold check_tree in H.
  exact (nodes_sound ss S nodes [nothing] nothing H (or_introl eq_refl) (nothing_in_force ss S)).
Qed.

End Tree.
