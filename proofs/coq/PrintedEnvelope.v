(* What is read of an envelope is what its own limits make: they stand for the file, in whatever order its rows were. *)

From Coq Require Import ZArith QArith String Ascii List Bool Permutation Lia.
From Mdm Require Import Numbers Gradation Certificate Text Decimals Rows Csv GradationFile NumberTexts CsvFields
  CsvRead GradationRead EnvelopeRead SortedRows FileRoot CsvEntries PrintedSizes.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(* ---- Order ----------------------------------------------------------------------------------------------- *)

Definition openings (ps : list placed_row) : list Q := map (fun p => opening (fst p)) ps.

Lemma finer_openings ps : is_sorted finer ps = is_sorted less (openings ps).
Proof. induction ps as [|p [|p' ps] IH]; [reflexivity | reflexivity|]. cbn [openings map is_sorted] in *. rewrite IH. reflexivity. Qed.

Lemma checked_sorted ps : forall before, check_rows before ps = Ok tt ->
  is_sorted less (openings ps) = true /\
  match before, ps with Some x, p :: _ => less x (opening (fst p)) = true | _, _ => True end.
Proof.
  induction ps as [|(r, e) ps IH]; intros before C; [split; [reflexivity | destruct before; exact I]|].
  cbn [check_rows] in C. unfold demand_at in C. destruct (at_most 0 (opening r)); [|discriminate C]. cbn [bind] in C.
  destruct (match before with Some x => less x (opening r) | None => true end) eqn:B; [|discriminate C]. cbn [bind] in C.
  destruct (at_most 0 (retained r)); [|discriminate C]. cbn [bind] in C.
  destruct (less 0 (factor r) && at_most 0 (tolerance r)); [|discriminate C]. cbn [bind] in C.
  destruct (IH _ C) as (S & N). split; [|destruct before; trivial].
  destruct ps as [|p ps]; [reflexivity|]. cbn [openings map is_sorted fst] in *. rewrite N. exact S.
Qed.

Lemma tail_sorted x l : is_sorted less (x :: l) = true -> is_sorted less l = true.
Proof. destruct l; [reflexivity|]. cbn [is_sorted]. intro H. apply andb_prop in H. apply H. Qed.

(* ---- Rows that differ in their lines ------------------------------------------------------------------------ *)

Definition alike (p p' : placed_row) : Prop :=
  fst p = fst p' /\ value_of (snd p) = value_of (snd p') /\ most_of (snd p) = most_of (snd p').
Definition all_alike : list placed_row -> list placed_row -> Prop := Forall2 alike.

Lemma alike_rows ps ps' : all_alike ps ps' -> map fst ps = map fst ps'.
Proof. induction 1 as [|p p' ps ps' (E & _) _ IH]; [reflexivity|]. cbn [map]. congruence. Qed.

Lemma alike_limits ps ps' : all_alike ps ps' -> check_limits ps = Ok tt -> check_limits ps' = Ok tt.
Proof.
  induction 1 as [|(r, e) (r', e') ps ps' (E & V & M) A IH]; intro C; [reflexivity|]. cbn [fst snd] in *. subst r'.
  cbn [check_limits] in *. unfold demand_at in *. rewrite <- V, <- M.
  destruct (_ && _); [|discriminate C]. cbn [bind] in *. destruct (_ || _); [|discriminate C]. cbn [bind] in *.
  replace (match ps' with [] => equal (most_of e) (of_integer 100) | _ => true end)
    with (match ps with [] => equal (most_of e) (of_integer 100) | _ => true end) by (inversion A; reflexivity).
  destruct (match ps with [] => equal (most_of e) (of_integer 100) | _ => true end); [exact (IH C) | discriminate C].
Qed.

Lemma alike_middle ps ps' : all_alike ps ps' -> middle (map snd ps) = middle (map snd ps').
Proof.
  intro A. unfold middle.
  assert (forall least done, least_passing (map snd ps) least done = least_passing (map snd ps') least done) as ->; [|reflexivity].
  induction A as [|p p' ps ps' (_ & V & M) _ IH]; intros least done; [reflexivity|]. cbn [map least_passing]. rewrite V, M. apply IH.
Qed.

Lemma alike_with_middle ps ps' : all_alike ps ps' -> forall ms done done', all_alike done done' ->
  all_alike (with_middle ps ms done) (with_middle ps' ms done').
Proof.
  assert (forall done done', all_alike done done' -> all_alike (rev' done) (rev' done')) as R.
  { intros done done' D. rewrite !rev'_is_rev. induction D as [|p p' ds ds' P D IH]; [constructor|]. cbn [rev].
    apply Forall2_app; [exact IH | constructor; [exact P | constructor]]. }
  induction 1 as [|(r, e) (r', e') ps ps' (E & V & M) A IH]; intros ms done done' D; cbn [with_middle]; [apply R, D|].
  destruct ms as [|m ms]; [apply R, D|]. cbn [fst] in E. subst r'.
  apply IH. constructor; [|exact D]. split; [|split; assumption]. cbn [fst]. inversion A; reflexivity.
Qed.

Lemma alike_differences ps ps' : all_alike ps ps' -> forall done done', all_alike done done' ->
  all_alike (differences ps done) (differences ps' done').
Proof.
  induction 1 as [|(r, e) (r', e') ps ps' (E & V & M) A IH]; intros done done' D; [exact D|]. cbn [fst] in E. subst r'.
  inversion A as [|(s, f) (s', f') qs qs' (Es & _) A' H1 H2]; subst.
  - constructor; [|exact D]. repeat split; assumption.
  - cbn [fst] in Es. subst s'. apply IH. constructor; [|exact D]. repeat split; assumption.
Qed.

Lemma alike_reversed ps ps' : all_alike ps ps' -> all_alike (rev' ps) (rev' ps').
Proof.
  rewrite !rev'_is_rev. induction 1 as [|p p' ds ds' P D IH]; [constructor|]. cbn [rev].
  apply Forall2_app; [exact IH | constructor; [exact P | constructor]].
Qed.

Lemma alike_passing ps ps' most implies rs implied : all_alike ps ps' -> from_passing ps most implies = Ok (rs, implied) ->
  exists rs', from_passing ps' most implies = Ok (rs', implied) /\ all_alike rs rs'.
Proof.
  intros A E. pose proof (alike_rows _ _ A) as R.
  assert (forall done done', all_alike done done' -> all_alike (rev' (differences ps done)) (rev' (differences ps' done'))) as Dif
    by (intros; apply alike_reversed, alike_differences; assumption).
  destruct A as [|(r, e) (r', e') qs qs' P A]; [injection E as <- <-; exists []; split; [reflexivity | constructor]|].
  pose proof P as (F & _). cbn [fst] in F. subst r'. unfold from_passing in *. unfold demand_at in *.
  destruct (at_most 0 (retained r)); [|discriminate E]. cbn [bind] in *. rewrite map_all_is_map in E. rewrite map_all_is_map, <- R.
  match type of E with bind (if ?b then _ else _) _ = _ => destruct b; [|discriminate E] end. cbn [bind] in *.
  destruct (equal (retained r) 0).
  - injection E as <- <-. eexists. split; [reflexivity|]. apply Dif. constructor.
  - destruct (less 0 (opening r) && implies); [|discriminate E]. cbn [bind] in *. injection E as <- <-.
    eexists. split; [reflexivity|]. apply alike_reversed.
    apply (alike_differences ((Row 0 0 1 0, e) :: (r, e) :: qs) ((Row 0 0 1 0, e') :: (r, e') :: qs')); [|constructor].
    constructor; [split; [reflexivity | split; apply P] | constructor; assumption].
Qed.

Lemma alike_checked ps ps' : all_alike ps ps' -> forall before, check_rows before ps = Ok tt -> check_rows before ps' = Ok tt.
Proof.
  induction 1 as [|(r, e) (r', e') ps ps' (E & _) A IH]; intros before C; [reflexivity|]. cbn [fst] in E. subst r'.
  cbn [check_rows] in *. unfold demand_at in *.
  repeat match type of C with bind (if ?b then _ else _) _ = _ => destruct b; [|discriminate C]; cbn [bind] in * end.
  apply IH, C.
Qed.

(* ---- Openings of what passes --------------------------------------------------------------------------------- *)

Lemma middle_length es : List.length (middle es) = List.length es.
Proof.
  unfold middle. rewrite map_all_is_map, map_length.
  assert (forall es least done, List.length (least_passing es least done) = (List.length es + List.length done)%nat) as L.
  { induction es0 as [|e es0 IH]; intros least done; [reflexivity|]. cbn [least_passing]. rewrite IH. cbn [List.length]. lia. }
  assert (forall bs most done, List.length (most_passing bs most done) = (List.length bs + List.length done)%nat) as M.
  { induction bs as [|(l, h) bs IH]; intros most done; [reflexivity|]. cbn [most_passing]. rewrite IH. cbn [List.length]. lia. }
  rewrite M, L. cbn [List.length]. lia.
Qed.

Lemma middle_openings ps : forall ms done, List.length ms = List.length ps ->
  openings (with_middle ps ms done) = rev (openings done) ++ openings ps.
Proof.
  induction ps as [|(r, e) ps IH]; intros ms done L; cbn [with_middle].
  - rewrite rev'_is_rev. unfold openings. rewrite map_rev, app_nil_r. reflexivity.
  - destruct ms as [|m ms]; [discriminate L|]. rewrite IH by (injection L as L; exact L). cbn [openings map rev fst with_retained opening].
    rewrite <- app_assoc. reflexivity.
Qed.

Lemma differences_openings ps : forall done, openings (differences ps done) = rev (openings ps) ++ openings done.
Proof.
  induction ps as [|(r, e) ps IH]; intro done; [reflexivity|]. destruct ps as [|(r', e') ps]; [reflexivity|].
  change (openings (differences ((r, e) :: (r', e') :: ps) done))
    with (openings (differences ((r', e') :: ps) ((with_retained (subtract (retained r') (retained r)) r, e) :: done))).
  rewrite IH. cbn [openings map rev fst with_retained opening]. rewrite <- !app_assoc. reflexivity.
Qed.

Lemma passing_openings ps most implies rs implied : from_passing ps most implies = Ok (rs, implied) ->
  openings rs = (if implied then [0%Q] else []) ++ openings ps.
Proof.
  unfold from_passing. destruct ps as [|(r, e) ps]; [intros [= <- <-]; reflexivity|]. unfold demand_at.
  destruct (at_most 0 (retained r)); [|discriminate]. cbn [bind].
  match goal with |- context [if ?b then Ok tt else _] => destruct b end; [|discriminate]. cbn [bind].
  assert (forall qs, openings (rev' (differences qs [])) = openings qs) as D.
  { intro qs. rewrite rev'_is_rev. unfold openings at 1. rewrite map_rev. fold (openings (differences qs [])).
    rewrite differences_openings, app_nil_r. apply rev_involutive. }
  destruct (equal (retained r) 0); [intros [= <- <-]; exact (D ((r, e) :: ps))|].
  destruct (less 0 (opening r) && implies); [|discriminate]. cbn [bind]. intros [= <- <-]. exact (D ((Row 0 0 1 0, e) :: (r, e) :: ps)).
Qed.

(* ---- The envelope ---------------------------------------------------------------------------------------------- *)

Lemma checked_openings ps : forall before, check_rows before ps = Ok tt -> forall x, In x (openings ps) -> 0 <= Qnum x.
Proof.
  induction ps as [|(r, e) ps IH]; intros before C x I; [destruct I|].
  cbn [check_rows] in C. unfold demand_at in C. destruct (at_most 0 (opening r)) eqn:P; [|discriminate C]. cbn [bind] in C.
  repeat match type of C with bind (if ?b then _ else _) _ = _ => destruct b; [|discriminate C]; cbn [bind] in C end.
  destruct I as [<-|I]; [|exact (IH _ C x I)]. cbn [fst]. unfold at_most in P. apply Z.leb_le in P. cbn [Qnum Qden] in P. lia.
Qed.

Lemma limits_not_negative ps : check_limits ps = Ok tt ->
  forall p, In p ps -> 0 <= Qnum (value_of (snd p)) /\ 0 <= Qnum (most_of (snd p)).
Proof.
  induction ps as [|(r, e) ps IH]; intros C p I; [destruct I|].
  cbn [check_limits] in C. unfold demand_at in C.
  destruct ((at_most 0 (value_of e) && at_most (value_of e) (of_integer 100)) &&
            (at_most 0 (most_of e) && at_most (most_of e) (of_integer 100))) eqn:W; [|discriminate C]. cbn [bind] in C.
  repeat match type of C with bind (if ?b then _ else _) _ = _ => destruct b; [|discriminate C]; cbn [bind] in C end.
  destruct I as [<-|I]; [|exact (IH C p I)]. rewrite !andb_true_iff in W. destruct W as ((V & _) & M & _).
  unfold at_most in V, M. apply Z.leb_le in V, M. cbn [Qnum Qden snd] in *. lia.
Qed.

Definition limit_of (p : placed_row) : Q * Q * Q := let (r, e) := p in (opening r, value_of e, most_of e).

Lemma alike_limits_of ps ps' : all_alike ps ps' -> map limit_of ps = map limit_of ps'.
Proof.
  induction 1 as [|(r, e) (r', e') ps ps' (E & V & M) _ IH]; [reflexivity|]. cbn [map limit_of fst snd] in *. congruence.
Qed.

Lemma alike_again unit ps : (forall p, In p ps -> short_limit unit (limit_of p) /\
    fst p = Row (opening (fst p)) (value_of (snd p)) 1 0) ->
  forall line, all_alike ps (map (row_of unit 1) (entries_from (limit_entry unit) (map limit_of ps) line)).
Proof.
  induction ps as [|(r, e) ps IH]; intros P line; [constructor|]. cbn [map entries_from].
  constructor; [|apply IH; intros p I; apply P; right; exact I].
  destruct (P _ (or_introl eq_refl)) as ((S & _) & E). cbn [fst snd] in *.
  unfold alike, limit_of, limit_entry, row_of. cbn [fst snd size_of value_of most_of factor_of tolerance_of].
  rewrite opening_said by (assumption || lia). auto.
Qed.

(* Every envelope that is read is canonical, but for numbers of more digits, or a text longer, than a file may have. *)
Theorem envelope_canonical unit line es R ls :
  gradation_of_entries unit Limits false false line es = Ok R ->
  Forall (entry_good false false) es -> Z.of_nat (List.length es) <= most_rows -> limits R = Some ls ->
  (forall l, In l (gradation_lines R) -> short_line l = true) ->
  text_length (text_of_lines (gradation_lines R)) <= most_text -> canonical_envelope R ls.
Proof.
  intros E G C L Lines Le. unfold gradation_of_entries in E. destruct (file_root unit es) as [d| |] eqn:Rt; try discriminate E.
  cbn [bind] in E. unfold demand_at in E at 1. destruct (Z.eqb_spec d 1) as [->|]; [|discriminate E]. cbn [bind] in E.
  rewrite map_all_is_map in E. set (sieves := sorted finer (map (row_of unit 1) es)) in E.
  assert (Permutation sieves (map (row_of unit 1) es)) as Pm.
  { apply sorted_keeps. rewrite map_length. unfold most_rows in C. change (2 ^ 64) with (2 ^ 20 * 2 ^ 44). lia. }
  destruct (check_limits sieves) as [[]| |] eqn:Cl; try discriminate E. cbn [bind] in E.
  destruct (from_passing _ _ _) as [(rs, implied)| |] eqn:Ps; try discriminate E. cbn [bind] in E.
  destruct (check_rows None rs) as [[]| |] eqn:Cr; try discriminate E. cbn [bind] in E.
  unfold demand_at in E. match type of E with bind (if ?b then _ else _) _ = _ => destruct b eqn:D1; [|discriminate E] end.
  cbn [bind] in E. match type of E with bind (if ?b then _ else _) _ = _ => destruct b eqn:D2; [|discriminate E] end.
  cbn [bind] in E. assert (R = Reading (Gradation (map_all fst rs) 1 false) unit false implied None (Some (map_all limit_of sieves))) as ->
    by (injection E as <-; reflexivity).
  cbn [limits] in L. injection L as L. rewrite map_all_is_map in L.
  assert (openings rs = (if implied then [0%Q] else []) ++ openings sieves) as Op.
  { rewrite (passing_openings _ _ _ _ _ Ps). f_equal. rewrite middle_openings; [reflexivity|].
    rewrite middle_length, map_all_is_map, map_length. reflexivity. }
  assert (is_sorted less (openings sieves) = true) as So.
  { destruct (checked_sorted _ _ Cr) as (S & _). rewrite Op in S. destruct implied; [exact (tail_sorted _ _ S) | exact S]. }
  rewrite Forall_forall in G.
  assert (forall p, In p sieves -> exists e, In e es /\ p = row_of unit 1 e) as Of.
  { intros p I. apply (Permutation_in _ Pm) in I. apply in_map_iff in I as (e & <- & I). eauto. }
  assert (forall p, In p sieves -> short_limit (printed_unit unit) (limit_of p) /\
            fst p = Row (opening (fst p)) (value_of (snd p)) 1 0) as Short.
  { intros p I. destruct (Of p I) as (e & J & Ep). destruct (G e J) as [Gs Gv Gm _ _ Nt Nf].
    destruct (limits_not_negative _ Cl p I) as (V & M).
    assert (0 <= Qnum (opening (fst p))) as X.
    { apply (checked_openings _ _ Cr). rewrite Op. apply in_or_app. right. unfold openings.
      apply (in_map (fun p => opening (fst p)) _ _ I). }
    assert (In (joined "," (limit_fields (printed_unit unit) (limit_of p)))
              (gradation_lines (Reading (Gradation (map_all fst rs) 1 false) unit false implied None (Some (map_all limit_of sieves))))) as Line.
    { unfold gradation_lines. cbn [limits sizes_in]. right. rewrite !map_all_is_map, map_map. apply in_map_iff. exists p. split; [|exact I].
      destruct p as (r, e'). unfold show_limits, limit_fields, limit_of. cbn [sizes_in]. rewrite size_printed. reflexivity. }
    apply Lines in Line. subst p. unfold row_of in *. cbn [fst snd opening limit_of] in *. split; [|rewrite Nt, Nf; reflexivity].
    assert (size_form (printed_unit unit) 1 (opening_of unit 1 (size_of e))) as F by apply (opening_form unit es 1 e Rt J Gs).
    pose proof (short_fields (limit_fields (printed_unit unit) (opening_of unit 1 (size_of e), value_of e, most_of e)) ltac:(discriminate)) as Sp.
    specialize (fun T => Sp T Line). unfold limit_fields in Sp.
    assert (forall w, In w [show_size (printed_unit unit) 1 (opening_of unit 1 (size_of e)); show_decimal (value_of e); show_decimal (most_of e)] ->
              is_short w = true) as Short.
    { apply Sp. intros w [<-|[<-|[<-|[]]]]; [apply form_text | apply decimal_text | apply decimal_text]; assumption. }
    clear Sp. split; [|split].
    - apply short_size; [exact F | exact X | apply Short; left; reflexivity].
    - split; [exact V|]. split; [apply Gv|]. split; [apply Gv | apply Short; right; left; reflexivity].
    - split; [exact M|]. split; [apply Gm|]. split; [apply Gm | apply Short; right; right; left; reflexivity]. }
  split; cbn [limits sizes_in].
  - rewrite map_all_is_map, L. reflexivity.
  - intros l I. rewrite <- L in I. apply in_map_iff in I as (p & <- & I). apply (Short p I).
  - unfold envelope_of, printed_envelope. cbn [gradation_of sizes_in has_factors implied_pan limits].
    set (es' := entries_from (limit_entry (printed_unit unit)) ls 2).
    assert (all_alike sieves (map (row_of (printed_unit unit) 1) es')) as Al by (unfold es'; rewrite <- L; apply alike_again, Short).
    unfold gradation_of_entries.
    assert (file_root (printed_unit unit) es' = Ok 1) as ->.
    { apply (root_again unit es 1 es' Rt).
      - apply Forall_forall. intros e J. apply (G e J).
      - intros e' I. apply entries_from_in in I as (l & n & J & ->). rewrite <- L in J. apply in_map_iff in J as (p & <- & J).
        destruct (Of p J) as (e & K & ->). exists (opening_of unit 1 (size_of e)). split; [reflexivity|]. right. eauto.
      - intros e J. destruct (in_entries_from (limit_entry (printed_unit unit)) ls (limit_of (row_of unit 1 e))) with (line := 2) as (n & I).
        + rewrite <- L. apply in_map, (Permutation_in _ (Permutation_sym Pm)), in_map, J.
        + eexists. split; [exact I | reflexivity].
      - intros _. rewrite !size_is_length. unfold es'. rewrite entries_from_length, <- L, map_length, (Permutation_length Pm), map_length. lia. }
    cbn [bind]. unfold demand_at at 1. change (1 =? 1) with true. cbn [bind]. rewrite map_all_is_map.
    assert (sorted finer (map (row_of (printed_unit unit) 1) es') = map (row_of (printed_unit unit) 1) es') as ->.
    { unfold sorted. rewrite finer_openings. replace (openings (map (row_of (printed_unit unit) 1) es')) with (openings sieves); [rewrite So; reflexivity|].
      unfold openings. rewrite <- !(map_map fst opening). rewrite (alike_rows _ _ Al). reflexivity. }
    rewrite (alike_limits _ _ Al Cl). cbn [bind]. rewrite map_all_is_map, <- (alike_middle _ _ Al).
    rewrite map_all_is_map in Ps.
    destruct (alike_passing _ (with_middle (map (row_of (printed_unit unit) 1) es') (middle (map snd sieves)) []) _ _ _ _
                (alike_with_middle _ _ Al _ _ _ (Forall2_nil _)) Ps) as (rs' & Ps' & Ar).
    rewrite Ps'. cbn [bind]. rewrite (alike_checked _ _ Ar None Cr). cbn [bind].
    rewrite !map_all_is_map in *. rewrite <- (alike_rows _ _ Ar). unfold demand_at. rewrite D1, D2. cbn [bind].
    rewrite (alike_limits_of _ _ Al). reflexivity.
  - rewrite <- L, map_length, (Permutation_length Pm), map_length. exact C.
  - exact Le.
Qed.

Lemma envelope_limits_there unit t c line es R :
  gradation_of_entries unit Limits t c line es = Ok R -> exists ls, limits R = Some ls.
Proof.
  intro E. unfold gradation_of_entries in E.
  repeat match type of E with
    | bind ?r _ = _ => let H := fresh in destruct r eqn:H; try discriminate E; cbn [bind] in E; clear H
    | (let (_, _) := ?p in _) = _ => destruct p
    end.
  injection E as <-. eexists. reflexivity.
Qed.
