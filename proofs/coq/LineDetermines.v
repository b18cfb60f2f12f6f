(* A verdict's line says one thing: statements that have the same line are the same. *)

From Coq Require Import ZArith QArith List Bool String Ascii Lia.
From Mdm Require Import Numbers Gradation Certificate Question Text Decimals Rows GradationFile Document VerdictLine Judge
  JudgeTheorem LineTheorem LinePhrases.
Import ListNotations.
Open Scope string_scope.

Lemma same_or_more m n s t : plain_integer m = true -> plain_integer n = true -> (0 <= m)%Z -> (0 <= n)%Z ->
  or_more_phrase m ++ String " " s = or_more_phrase n ++ String " " t -> m = n /\ s = t.
Proof.
  unfold or_more_phrase. intros M N Pm Pn E. destruct (Z.ltb_spec 0 m), (Z.ltb_spec 0 n); try discriminate E.
  - cbn [append] in E. injection E as E. rewrite !append_associates in E.
    apply same_integers in E as (-> & E); trivial. cbn [append] in E. injection E as ->. auto.
  - cbn [append] in E. injection E as ->. split; [lia | reflexivity].
Qed.

Lemma no_number_below m n s t : or_more_phrase m ++ " matches " ++ s <> " below " ++ show_integer n ++ t.
Proof. unfold or_more_phrase. destruct (0 <? m)%Z; discriminate. Qed.

Lemma plain_parts s : plain_statement s = true ->
  (forall p, In p (parts s) -> plain_part (unit_of s) p = true) /\ In (SizesIn (unit_of s)) (parts s).
Proof.
  unfold plain_statement. rewrite !andb_true_iff. intros ((_ & P) & E). rewrite forallb_forall in P. split; [exact P|].
  apply existsb_exists in E as (p & I & E). destruct p; try discriminate E. pose proof (P _ I) as U. apply unit_same in U.
  subst. exact I.
Qed.

Lemma same_parts s s' : plain_statement s = true -> plain_statement s' = true ->
  joined "; " (map_all (phrase (unit_of s)) (parts s)) = joined "; " (map_all (phrase (unit_of s')) (parts s')) ->
  unit_of s = unit_of s' /\ parts s = parts s'.
Proof.
  intros P P' E. apply plain_parts in P as (P & U), P' as (P' & U'). unfold map_all in E. rewrite !map_all_map in E.
  assert (forall (p : part) ps, In p ps -> ps <> []) as NE by (intros p [|? ?] []; discriminate).
  apply same_joined in E; [|exact P|exact P'|exact (NE _ _ U)|exact (NE _ _ U')].
  assert (unit_of s = unit_of s') as Same.
  { apply (in_map (phrase (unit_of s))) in U. rewrite E in U. apply in_map_iff in U as (p & Ep & I). specialize (P' p I).
    destruct (unit_of s) eqn:Us, (unit_of s') eqn:Us', p; try reflexivity; try (destruct share); try (destruct unit); try discriminate Ep;
      try discriminate P'; exfalso; unfold plain_part in P'; rewrite ?andb_true_iff in P';
      repeat match type of P' with _ /\ _ => destruct P' as (P' & ?) end; unfold phrase in Ep; cbv zeta in Ep;
      revert Ep; apply decimal_head; trivial. }
  split; [exact Same|]. rewrite <- Same in *. clear -E P P'. revert P P' E. generalize (parts s') as qs, (unit_of s) as u.
  induction (parts s) as [|p ps IH]; intros [|q qs] u P P' E; try discriminate E; [reflexivity|].
  cbn [map] in E. injection E as Ep E. f_equal.
  - apply (same_phrases u); [apply P | apply P' | exact Ep]; left; reflexivity.
  - apply (IH qs u); [intros; apply P; right; assumption | intros; apply P'; right; assumption | exact E].
Qed.

Theorem line_determines s s' : plain_statement s = true -> plain_statement s' = true ->
  accepted_line s = accepted_line s' -> s = s'.
Proof.
  intros P P' E. pose proof (same_parts s s' P P') as Parts.
  unfold plain_statement in P, P'. rewrite !andb_true_iff, Z.leb_le in P, P'.
  destruct P as (((C & Pm & Om) & _) & _), P' as (((C' & Pm' & Om') & _) & _).
  unfold accepted_line in E. cbv zeta in E.
  assert (forall x y : bool, forall u v, (if x then " exactly" else " within a tolerance") ++ String " " u =
    (if y then " exactly" else " within a tolerance") ++ String " " v -> x = y /\ u = v) as Exactly.
  { intros [] [] u v H; try discriminate H; cbn [append] in H; injection H as ->; auto. }
  set (tail := joined "; " (map_all (phrase (unit_of s)) (parts s))) in *.
  set (tail' := joined "; " (map_all (phrase (unit_of s')) (parts s'))) in *.
  destruct s as [name u claim m exact ps], s' as [name' u' claim' m' exact' ps'].
  cbn [claim_of or_more file_name is_exact unit_of parts] in *.
  assert (forall (x y : bool) u v, in_quotes name ++ (if x then " exactly" else " within a tolerance") ++ String " " u =
    in_quotes name' ++ (if y then " exactly" else " within a tolerance") ++ String " " v -> name = name' /\ x = y /\ u = v) as Rest.
  { intros x y a b H. apply same_names in H as (-> & H). apply Exactly in H as (-> & ->). auto. }
  set (w := in_quotes name) in *. set (w' := in_quotes name') in *. clearbody w w'.
  assert (forall ch, tail ++ String ch "" = tail' ++ String ch "" -> u = u' /\ ps = ps') as End.
  { intros ch H. apply Parts, (same_last _ _ ch), H. }
  destruct claim as [N|B N|B|], claim' as [N'|B' N'|B'|]; rewrite ?andb_true_iff in C, C';
    rewrite ?append_associates in E; cbn [append] in E; try discriminate E; repeat (injection E as E);
    rewrite ?append_associates in E; cbn [append] in E.
  - apply same_integers in E as (-> & E); trivial. cbn [append] in E. injection E as E. rewrite ?append_associates in E.
    apply same_or_more in E as (-> & E); trivial. cbn [append] in E. injection E as E.
    apply Rest in E as (-> & -> & E). injection E as E. apply End in E as (-> & ->). reflexivity.
  - destruct C as (C1 & C2), C' as (C1' & C2'). apply same_or_more in E as (-> & E); trivial. cbn [append] in E. injection E as E.
    apply Rest in E as (-> & -> & E). injection E as E. rewrite ?append_associates in E.
    apply same_integers in E as (-> & E); trivial. cbn [append] in E. injection E as E. rewrite ?append_associates in E.
    apply same_integers in E as (-> & E); trivial. cbn [append] in E. injection E as E.
    apply End in E as (-> & ->). reflexivity.
  - apply same_integers in E as (-> & E); trivial; try (unfold or_more_phrase; destruct (0 <? _)%Z; reflexivity).
    apply same_or_more in E as (-> & E); trivial. cbn [append] in E. injection E as E.
    apply Rest in E as (-> & -> & E). injection E as E. apply End in E as (-> & ->). reflexivity.
  - symmetry in E. exfalso. exact (no_number_below _ _ _ _ E).
  - exfalso. exact (no_number_below _ _ _ _ E).
  - apply same_or_more in E as (-> & E); trivial. cbn [append] in E. injection E as E.
    apply Rest in E as (-> & -> & E). injection E as E. apply End in E as (-> & ->). reflexivity.
Qed.

(* So a line is true of a file if its only statement is. *)
Theorem true_of_its_statement gradation s : plain_statement s = true ->
  (true_of_line gradation (accepted_line s) <-> is_true gradation s).
Proof.
  intro P. split; [|intro T; exists s; auto]. intros (s' & P' & E & T). rewrite (line_determines _ _ P P' E). exact T.
Qed.
