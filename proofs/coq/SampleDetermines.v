(* A line about a sample says one thing: statements that have the same line are the same. *)

From Coq Require Import ZArith QArith List Bool String Ascii Lia.
From Mdm Require Import Numbers Gradation Certificate Question Text Decimals Rows GradationFile Document VerdictLine Judge
  SampleCertificate SampleCheck SampleLine JudgeTheorem LinePhrases LineDetermines SampleTheorem.
Import ListNotations.
Open Scope string_scope.

(* ---- Numbers ------------------------------------------------------------------------------------------- *)

Lemma percents_form x y s : percents_phrase (x, y) ++ s =
  show_decimal x ++ (if String.eqb (show_decimal x) (show_decimal y) then " %" else " to " ++ show_decimal y ++ " %") ++ s.
Proof.
  unfold percents_phrase. cbv zeta. cbn [fst snd]. destruct (String.eqb _ _); rewrite ?append_associates; reflexivity.
Qed.

Lemma percents_end (b : bool) u s : number_ends ((if b then " %" else " to " ++ u) ++ s) = true.
Proof. destruct b; reflexivity. Qed.

Lemma same_percents p p' s t : plain_percents p = true -> plain_percents p' = true ->
  percents_phrase p ++ s = percents_phrase p' ++ t -> p = p' /\ s = t.
Proof.
  destruct p as (x, y), p' as (x', y'). unfold plain_percents. cbn [fst snd]. rewrite !andb_true_iff. intros (X & Y) (X' & Y') E.
  rewrite !percents_form in E.
  apply same_decimals in E as (-> & E); trivial; try apply percents_end.
  destruct (String.eqb (show_decimal x') (show_decimal y)) eqn:A, (String.eqb (show_decimal x') (show_decimal y')) eqn:B;
    cbn [append] in E; try discriminate E.
  - apply String.eqb_eq in A, B. apply plain_same in A as <-; trivial. apply plain_same in B as <-; trivial. injection E as ->. auto.
  - repeat (injection E as E). rewrite !append_associates in E. apply same_decimals in E as (-> & E); trivial. injection E as ->. auto.
Qed.

Lemma same_errors_in_class E E' s t : plain_error E = true -> plain_error E' = true -> number_ends s = true -> number_ends t = true ->
  forall words ch, percents_phrase (error_within E) ++ String ch words ++ show_integer (at_class E) ++ s =
    percents_phrase (error_within E') ++ String ch words ++ show_integer (at_class E') ++ t -> E = E' /\ s = t.
Proof.
  destruct E as (j, p), E' as (j', p'). unfold plain_error. cbn [error_within at_class]. rewrite !andb_true_iff.
  intros (P & J) (P' & J') S T words ch H. apply same_percents in H as (-> & H); trivial. cbn [append] in H. injection H as H.
  apply same_after in H. apply same_integers in H as (-> & ->); auto.
Qed.

(* ---- Phrases ------------------------------------------------------------------------------------------- *)

(* Of what is found, up to what is asked for. *)
Lemma same_values what what' p p' s t : plain_value what = true -> plain_value what' = true ->
  plain_percents p = true -> plain_percents p' = true -> number_ends s = true -> number_ends t = true ->
  value_phrase what (percents_phrase p) ++ s = value_phrase what' (percents_phrase p') ++ t -> what = what' /\ p = p' /\ s = t.
Proof.
  intros W W' P P' S T E.
  assert (forall q ch u w, plain_percents q = true -> in_number ch = false -> percents_phrase q ++ u <> String ch w) as Head.
  { intros (x, y) ch u w Q C. rewrite percents_form. apply andb_prop in Q as (Q & _). apply decimal_head; assumption. }
  destruct what as [j|j|], what' as [j'|j'|]; cbn [plain_value] in W, W'; unfold value_phrase in E;
    rewrite ?append_associates in E; cbn [append] in E; try discriminate E;
    try (exfalso; revert E; apply Head; [assumption | reflexivity]);
    try (exfalso; symmetry in E; revert E; apply Head; [assumption | reflexivity]).
  - repeat (injection E as E). apply same_integers in E as (-> & E); trivial. cbn [append] in E. repeat (injection E as E).
    apply same_percents in E as (-> & ->); auto.
  - apply same_percents in E as (-> & E); trivial. cbn [append] in E. repeat (injection E as E).
    apply same_integers in E as (-> & ->); auto.
  - repeat (injection E as E). apply same_percents in E as (-> & ->); auto.
Qed.

(* No value begins as the number outside does. *)
Lemma no_number_outside n what p s t : plain_integer n = true -> plain_percents p = true ->
  show_integer n ++ " outside" ++ s <> value_phrase what (percents_phrase p) ++ t.
Proof.
  intros N P E. destruct what as [j|j|]; unfold value_phrase in E; rewrite ?append_associates in E; cbn [append] in E;
    try (revert E; apply integer_head; [exact N | reflexivity]).
  destruct p as (x, y). rewrite percents_form in E. apply andb_prop in P as (P & _). cbn [fst] in P.
  apply plain_text in P as (_ & P & _). apply plain_integer_text in N as (_ & N & _).
  apply (same_heads in_number) in E as (_ & E); trivial.
  - destruct (String.eqb _ _) in E; discriminate E.
  - apply percents_end.
Qed.

Lemma same_reasons f f' n n' s t : plain_finding f n = true -> plain_finding f' n' = true ->
  reason_phrase f n ++ String ";" s = reason_phrase f' n' ++ String ";" t -> f = f' /\ n = n' /\ s = t.
Proof.
  intros P P' E. destruct f as [| |what p least v], f' as [| |what' p' least' v']; unfold reason_phrase in E;
    rewrite ?append_associates in E; cbn [append] in E; try discriminate E; cbn [plain_finding] in P, P';
    rewrite ?andb_true_iff, ?Z.eqb_eq in P; rewrite ?andb_true_iff, ?Z.eqb_eq in P'.
  - subst. injection E as ->. auto.
  - repeat (injection E as E). apply same_integers in E as (-> & E); trivial. cbn [append] in E. repeat (injection E as E).
    subst. auto.
  - exfalso. destruct P' as (((_ & _) & Q) & _). repeat (injection E as E). exact (no_number_outside _ _ _ _ _ P Q E).
  - exfalso. destruct P as (((_ & _) & Q) & _). repeat (injection E as E). symmetry in E. exact (no_number_outside _ _ _ _ _ P' Q E).
  - destruct P as (((-> & W) & Q) & V), P' as (((-> & W') & Q') & V'). repeat (injection E as E).
    apply same_values in E as (-> & -> & E); trivial. cbn [append] in E. repeat (injection E as E).
    assert (least = least' /\ show_decimal v ++ " % are asked for;" ++ s = show_decimal v' ++ " % are asked for;" ++ t) as (-> & E').
    { destruct least, least'; cbn [append] in E; try discriminate E; repeat (injection E as E); auto. }
    apply same_decimals in E' as (-> & E'); trivial. cbn [append] in E'. repeat (injection E' as E'). subst. auto.
Qed.

Lemma same_errors e e' s t : plain_errors e = true -> plain_errors e' = true ->
  errors_phrase e ++ String ";" s = errors_phrase e' ++ String ";" t -> e = e' /\ s = t.
Proof.
  destruct e as [E O p], e' as [E' O' p']. unfold plain_errors, errors_phrase. cbn [of_shares of_passing of_all_shares].
  rewrite !andb_true_iff. intros ((P & Q) & W) ((P' & Q') & W') H. rewrite !append_associates in H. apply same_after in H.
  apply same_errors_in_class in H as (-> & H); trivial; try (destruct O; reflexivity); try (destruct O'; reflexivity).
  assert (forall u v, "; all together " ++ percents_phrase p ++ String ";" u = "; all together " ++ percents_phrase p' ++ String ";" v ->
    p = p' /\ u = v) as All.
  { intros u v A. apply same_after, same_percents in A as (-> & A); trivial. injection A as ->. auto. }
  destruct O as [F|], O' as [F'|]; rewrite ?append_associates in H.
  - apply same_after in H. apply same_errors_in_class in H as (-> & H); trivial. apply All in H as (-> & ->). auto.
  - discriminate H.
  - discriminate H.
  - apply All in H as (-> & ->). auto.
Qed.

Lemma same_answer c c' s t : answer_phrase c ++ s = answer_phrase c' ++ t -> c = c' /\ s = t.
Proof. intro E. destruct c, c'; try discriminate E; apply same_after in E as ->; auto. Qed.

Lemma same_answers_said i cs : forall j cs' s t, i = j -> cs <> [] -> cs' <> [] ->
  joined ", " (conditions_phrases i cs) ++ String " " s = joined ", " (conditions_phrases j cs') ++ String " " t -> cs = cs' /\ s = t.
Proof.
  revert i. induction cs as [|c cs IH]; intros i j [|c' cs'] s t <- N N' E; try contradiction. cbn [conditions_phrases] in E.
  rewrite !joined_form, !append_associates in E. apply same_after in E.
  apply same_after, same_answer in E as (-> & E').
  destruct cs as [|d cs], cs' as [|d' cs']; cbn [conditions_phrases append] in E'.
  - injection E' as ->. auto.
  - discriminate E'.
  - discriminate E'.
  - injection E' as E'. assert (d :: cs = d' :: cs' /\ s = t) as (Same & ->)
      by (apply (IH (i + 1)%Z _ _ _ _ eq_refl); [discriminate..|exact E']).
    rewrite Same. auto.
Qed.

Lemma same_conditions cs cs' s t :
  joined ", " (conditions_phrases 1 cs) ++ " (" ++ s = joined ", " (conditions_phrases 1 cs') ++ " (" ++ t -> cs = cs' /\ s = t.
Proof.
  intro E. destruct cs as [|c cs], cs' as [|c' cs'].
  - cbn in E. injection E as ->. auto.
  - cbn [conditions_phrases] in E. rewrite joined_form, append_associates in E. discriminate E.
  - cbn [conditions_phrases] in E. rewrite joined_form, append_associates in E. discriminate E.
  - cbn [append] in E. apply same_answers_said in E as (-> & E); try discriminate; [|reflexivity]. injection E as ->. auto.
Qed.

(* ---- The line ------------------------------------------------------------------------------------------ *)

Theorem sample_line_determines s s' : plain_sample_statement s = true -> plain_sample_statement s' = true ->
  sample_line s = sample_line s' -> s = s'.
Proof.
  unfold plain_sample_statement. rewrite !andb_true_iff.
  intros ((((Q & N) & P) & F) & L) ((((Q' & N') & P') & F') & L') E. pose proof (same_parts _ _ Q Q') as Parts.
  destruct s as [q name n f o e cs], s' as [q' name' n' f' o' e' cs'].
  cbn [question_in_line sample_name particles_said finding_said outside_said errors_of conditions_said] in *.
  unfold sample_line in E. cbv zeta in E.
  cbn [question_in_line sample_name particles_said finding_said outside_said errors_of conditions_said] in E.
  set (tail := joined "; " (map_all (phrase (unit_of q)) (parts q))) in *.
  set (tail' := joined "; " (map_all (phrase (unit_of q')) (parts q'))) in *.
  apply same_after in E.
  apply same_integers in E as (-> & E); trivial; try (clear; destruct (_ =? _)%Z; reflexivity).
  set (one := (n' =? 1)%Z) in *. clearbody one. apply same_after in E. apply same_names in E as (-> & E).
  set (verb := fun f : finding =>
    if is_match f then if one then " matches " else " match " else if one then " does not match " else " do not match ").
  assert (forall g g' u v, verb g ++ in_quotes (file_name q) ++ u = verb g' ++ in_quotes (file_name q') ++ v ->
    is_match g = is_match g' /\ file_name q = file_name q' /\ u = v) as Verb.
  { intros g g' u v H. unfold verb in H. destruct (is_match g), (is_match g'), one; try discriminate H;
      apply same_after, same_names in H; tauto. }
  fold (verb f) in E. fold (verb f') in E. apply Verb in E as (M & File & E). clear Verb verb.
  assert (is_exact q = is_exact q' /\ f = f' /\ o = o' /\ e = e' /\ cs = cs' /\ tail ++ ")" = tail' ++ ")")
    as (Ex & -> & -> & -> & -> & End).
  { set (said := fun e => match e with Some e => errors_phrase e | None => "" end). fold (said e) in E. fold (said e') in E.
    set (u := joined ", " (conditions_phrases 1 cs) ++ " (" ++ tail ++ ")") in *.
    set (u' := joined ", " (conditions_phrases 1 cs') ++ " (" ++ tail' ++ ")") in *.
    assert (forall g v, exists w, said g ++ "; conditions " ++ v = String ";" w) as Semicolon
      by (intros [g|] v; eexists; reflexivity).
    assert (is_exact q = is_exact q' /\ f = f' /\ o = o' /\ said e ++ "; conditions " ++ u = said e' ++ "; conditions " ++ u')
      as (Ex & -> & -> & E').
    { destruct (Semicolon e u) as (w & W), (Semicolon e' u') as (w' & W'). rewrite W, W' in *.
      destruct (is_exact q), (is_exact q'); try discriminate E; apply same_after, same_reasons in E as (-> & -> & ->); auto. }
    unfold said, u, u' in E'. destruct e as [e|], e' as [e'|].
    - cbn [append] in E'. apply same_errors in E' as (-> & E'); trivial. repeat (injection E' as E').
      apply same_conditions in E' as (-> & ->). auto 8.
    - discriminate E'.
    - discriminate E'.
    - apply same_after, same_after, same_conditions in E' as (-> & ->). auto 8. }
  apply (same_last _ _ _) in End. apply Parts in End as (Units & Same). repeat f_equal.
  unfold claims_nothing in N, N'. destruct q as [? ? c m ? ?], q' as [? ? c' m' ? ?]. cbn in *.
  destruct c, c'; try discriminate N; try discriminate N'. apply Z.eqb_eq in N, N'. subst. reflexivity.
Qed.

(* So a line is true of a sample and a gradation if its only statement is. *)
Theorem true_of_its_sample_statement gradation sample s : plain_sample_statement s = true ->
  (true_of_sample_line gradation sample (sample_line s) <-> is_true_of_sample gradation sample s).
Proof.
  intro P. split; [|intro T; exists s; auto]. intros (s' & P' & E & T). rewrite (sample_line_determines _ _ P P' E). exact T.
Qed.
