(* Whatever file a gradation was read from, what is printed of it is read as the same gradation. *)

From Coq Require Import ZArith QArith Qreduction String Ascii List Bool Permutation Lia.
From Mdm Require Import Numbers Gradation Certificate Text Decimals Rows Csv GradationFile Judge NumberTexts CsvFields
  CsvRead GradationRead EnvelopeRead SortedRows FileRoot CsvEntries JsonEntries PrintedSizes PrintedEnvelope.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.
Open Scope list_scope.

(* ---- Rows of decimals -------------------------------------------------------------------------------------- *)

Record row_good (t c : bool) (r : row) : Prop := {
  mass_good : good (retained r);
  row_factor_good : good (factor r);
  row_tolerance_good : good (tolerance r);
  row_no_tolerance : t = false -> tolerance r = 0%Q;
  row_no_factor : c = false -> factor r = 1%Q }.

Definition rows_good (t c : bool) (ps : list placed_row) : Prop := Forall (fun p => row_good t c (fst p)) ps.

Lemma with_retained_good t c r m : row_good t c r -> good m -> row_good t c (with_retained m r).
Proof. intros [M F T Nt Nf] G. split; assumption. Qed.

Lemma differences_good t c ps : forall done, rows_good t c ps -> rows_good t c done -> rows_good t c (differences ps done).
Proof.
  induction ps as [|(r, e) ps IH]; intros done G D; [exact D|]. inversion G as [|? ? Gr G']; subst. cbn [fst] in Gr.
  destruct ps as [|(r', e') ps].
  - constructor; [|exact D]. apply with_retained_good; [exact Gr | exact good_0].
  - inversion G' as [|? ? Gr' _]; subst. cbn [fst] in Gr'. apply (IH _ G'). constructor; [|exact D].
    apply with_retained_good; [exact Gr|]. apply good_subtract; [apply Gr' | apply Gr].
Qed.

Lemma passing_good t c ps most implies rs implied : rows_good t c ps ->
  from_passing ps most implies = Ok (rs, implied) -> rows_good t c rs.
Proof.
  intros G. unfold from_passing. destruct ps as [|(r, e) ps]; [intros [= <- _]; constructor|]. unfold demand_at.
  destruct (at_most 0 (retained r)); [|discriminate]. cbn [bind].
  match goal with |- context [if ?b then Ok tt else _] => destruct b end; [|discriminate]. cbn [bind].
  assert (forall qs, rows_good t c qs -> rows_good t c (rev' (differences qs []))) as D.
  { intros qs Q. rewrite rev'_is_rev. apply Forall_rev, differences_good; [exact Q | constructor]. }
  destruct (equal (retained r) 0); [intros [= <- _]; exact (D ((r, e) :: ps) G)|].
  destruct (less 0 (opening r) && implies); [|discriminate]. cbn [bind]. intros [= <- _].
  apply (D ((Row 0 0 1 0, e) :: (r, e) :: ps)). constructor; [|exact G]. split; auto using good_0, good_1.
Qed.

Lemma entries_good t c unit d es : Forall (entry_good t c) es -> rows_good t c (map (row_of unit d) es).
Proof. intro G. apply Forall_map. revert G. apply Forall_impl. intros e [Gs Gv Gm Gf Gt Nt Nf]. split; assumption. Qed.

(* ---- Masses --------------------------------------------------------------------------------------------------- *)

(* What is known of a gradation of masses, in whatever way its file gives them. *)
Record masses_read (unit : size_unit) (t c : bool) (es : list entry) (R : reading) : Prop := {
  read_unit : sizes_in R = unit;
  read_tolerances : has_tolerances (gradation_of R) = t;
  read_factors : has_factors R = c;
  read_limits : limits R = None;
  read_well_formed : well_formed (gradation_of R) = true;
  read_root : file_root unit es = Ok (root (gradation_of R));
  read_rows : Forall (row_good t c) (rows (gradation_of R));
  read_openings : exists sizes, Permutation sizes (map (fun e => opening_of unit (root (gradation_of R)) (size_of e)) es) /\
    map opening (rows (gradation_of R)) = (if implied_pan R then [0%Q] else []) ++ sizes }.

Lemma entries_read_masses unit what t c line es R :
  gradation_of_entries unit what t c line es = Ok R -> what <> Limits ->
  Forall (entry_good t c) es -> Z.of_nat (List.length es) <= most_rows -> masses_read unit t c es R.
Proof.
  intros E N G C. unfold gradation_of_entries in E. destruct (file_root unit es) as [d| |] eqn:Rt; try discriminate E.
  cbn [bind] in E. rewrite map_all_is_map in E. set (sieves := sorted finer (map (row_of unit d) es)) in E.
  assert (Permutation sieves (map (row_of unit d) es)) as Pm.
  { apply sorted_keeps. rewrite map_length. unfold most_rows in C. change (2 ^ 64) with (2 ^ 20 * 2 ^ 44). lia. }
  assert (rows_good t c sieves) as Gs.
  { apply (Permutation_Forall (Permutation_sym Pm)), entries_good, G. }
  match type of E with bind ?r _ = _ => destruct r as [(rs, implied)| |] eqn:Ps end; try discriminate E. cbn [bind] in E.
  assert (rows_good t c rs /\ openings rs = (if implied then [0%Q] else []) ++ openings sieves) as (Gr & Op).
  { destruct what; try contradiction.
    - injection Ps as <- <-. split; [exact Gs | reflexivity].
    - injection Ps as <- <-. split; [exact Gs | reflexivity].
    - split; [exact (passing_good _ _ _ _ _ _ _ Gs Ps) | exact (passing_openings _ _ _ _ _ Ps)].
    - rewrite map_all_is_map in Ps. split.
      + refine (passing_good t c _ _ _ _ _ _ Ps). apply Forall_map. revert Gs. apply Forall_impl.
        intros (r, e) Gr. apply with_retained_good; [exact Gr|]. apply good_subtract; [apply good_100 | apply Gr].
      + rewrite (passing_openings _ _ _ _ _ Ps). f_equal. unfold openings. rewrite map_map. apply map_ext. intros (r, e).
        reflexivity. }
  clear Ps. destruct (check_rows None rs) as [[]| |]; try discriminate E. cbn [bind] in E. unfold demand_at in E.
  match type of E with bind (if ?b then _ else _) _ = _ => destruct b; [|discriminate E] end. cbn [bind] in E.
  match type of E with bind (if ?b then _ else _) _ = _ => destruct b eqn:W; [|discriminate E] end. cbn [bind] in E.
  rewrite map_all_is_map in *. assert (R = Reading (Gradation (map fst rs) d t) unit c implied (sum_to R) None) as Er.
  { injection E as <-. cbn [sum_to]. f_equal. destruct what; try contradiction; reflexivity. }
  rewrite Er. split; cbn [sizes_in gradation_of has_tolerances has_factors limits root rows implied_pan]; trivial.
  - apply Forall_map, Gr.
  - exists (openings sieves). split; [|rewrite map_map; exact Op].
    unfold openings. rewrite (Permutation_map (fun p => opening (fst p)) Pm), map_map. reflexivity.
Qed.

(* A pan that is implied is one row more where it is printed. *)
Definition room_for_pan (R : reading) : Prop :=
  implied_pan R = true ->
  Z.of_nat (List.length (rows (gradation_of R))) <= most_rows /\
  (sizes_in R = Phi -> file_root Phi (entries_from (entry_of Phi (root (gradation_of R))) (rows (gradation_of R)) 2) = Ok (root (gradation_of R))).

Section Masses.
Variables (unit : size_unit) (t c : bool) (es : list entry) (R : reading).
Hypothesis read : masses_read unit t c es R.
Hypothesis entries_are : Forall (entry_good t c) es.
Hypothesis few : Z.of_nat (List.length es) <= most_rows.

Lemma row_form r : In r (rows (gradation_of R)) ->
  row_good t c r /\ size_form (printed_unit unit) (root (gradation_of R)) (opening r) /\
  0 <= Qnum (opening r) /\ 0 <= Qnum (retained r) /\ 0 <= Qnum (factor r) /\ 0 <= Qnum (tolerance r).
Proof.
  intro I. destruct read as [_ _ _ _ W Rt Rw (sizes & Pm & Op)]. rewrite Forall_forall in Rw. split; [exact (Rw r I)|]. split.
  - pose proof (in_map opening _ _ I) as J. rewrite Op in J. apply in_app_or in J as [J|J].
    + destruct (implied_pan R); [|destruct J]. destruct J as [<-|[]].
      destruct unit; cbn [printed_unit size_form]; try exact good_0. left. reflexivity.
    + apply (Permutation_in _ Pm) in J. apply in_map_iff in J as (e & <- & K).
      apply (opening_form unit es _ e Rt K). rewrite Forall_forall in entries_are. apply (entries_are e K).
  - unfold well_formed in W. rewrite !andb_true_iff in W. destruct W as (((_ & P) & _) & _).
    rewrite forallb_forall in P. specialize (P r I). rewrite !andb_true_iff in P. destruct P as (((P1 & P2) & P3) & P4).
    unfold at_most, less in *. apply Z.leb_le in P1, P2, P4. apply Z.ltb_lt in P3. cbn [Qnum Qden] in *. lia.
Qed.

Lemma row_texts_of r : In r (rows (gradation_of R)) ->
  forall w, In w (row_fields (printed_unit unit) (root (gradation_of R)) t c r) -> field_text w.
Proof.
  intros I w. destruct (row_form r I) as ([Gm Gf Gt _ _] & F & Px & Pm & Pf & Pt). unfold row_fields. rewrite !in_app_iff.
  intros [[<-|[<-|[]]]|[J|J]].
  - apply form_text; assumption.
  - apply decimal_text; assumption.
  - destruct t; [|destruct J]. destruct J as [<-|[]]. apply decimal_text; assumption.
  - destruct c; [|destruct J]. destruct J as [<-|[]]. apply decimal_text; assumption.
Qed.

Theorem masses_canonical :
  (forall l, In l (gradation_lines R) -> short_line l = true) ->
  room_for_pan R -> text_length (text_of_lines (gradation_lines R)) <= most_text -> canonical R.
Proof.
  intros Lines Room Le. pose proof row_form as Form. pose proof row_texts_of as Texts.
  destruct read as [U T Fc L W Rt _ (sizes & Pm & Op)].
  assert (forall r, In r (rows (gradation_of R)) -> forall w,
    In w (row_fields (printed_unit unit) (root (gradation_of R)) t c r) -> is_short w = true) as Sh.
  { intros r I. apply short_fields; [discriminate | exact (Texts r I)|]. apply Lines. unfold gradation_lines. rewrite L. right.
    rewrite map_all_is_map. apply in_map_iff. exists r. split; [|exact I]. unfold show_row, row_fields.
    rewrite U, T, Fc, size_printed. reflexivity. }
  split; trivial; rewrite ?U, ?T, ?Fc.
  - intros r I. destruct (Form r I) as ([Gm Gf Gt Nt Nf] & F & Px & Pm' & Pf & Pt). specialize (Sh r I). unfold row_fields in Sh.
    split; [|split; [|split]].
    + apply short_size; [exact F | exact Px | apply Sh; left; reflexivity].
    + split; [exact Pm'|]. split; [apply Gm|]. split; [apply Gm|]. apply Sh. right. left. reflexivity.
    + destruct t; [|auto]. split; [exact Pt|]. split; [apply Gt|]. split; [apply Gt|]. apply Sh. right. right. left. reflexivity.
    + destruct c; [|auto]. split; [exact Pf|]. split; [apply Gf|]. split; [apply Gf|]. apply Sh. rewrite !in_app_iff. right. right.
      left. reflexivity.
  - destruct (implied_pan R && match unit with Phi => true | _ => false end) eqn:B.
    + apply andb_prop in B as (B & V). destruct (Room B) as (_ & Rf). rewrite U in Rf. destruct unit; try discriminate V. exact (Rf eq_refl).
    + apply (root_again unit es _ _ Rt).
      * revert entries_are. apply Forall_impl. intros e H. apply H.
      * intros e' I. apply entries_from_in in I as (r & n & J & ->). exists (opening r). split; [reflexivity|].
        apply (in_map opening) in J. rewrite Op in J. apply in_app_or in J as [J|J].
        -- left. destruct (implied_pan R); [|destruct J]. destruct J as [<-|[]]. reflexivity.
        -- right. apply (Permutation_in _ Pm) in J. apply in_map_iff in J as (e & <- & K). eauto.
      * intros e J. apply (in_map (fun e => opening_of unit (root (gradation_of R)) (size_of e))) in J.
        apply (Permutation_in _ (Permutation_sym Pm)) in J.
        assert (In (opening_of unit (root (gradation_of R)) (size_of e)) (map opening (rows (gradation_of R)))) as K
          by (rewrite Op; apply in_or_app; right; exact J).
        apply in_map_iff in K as (r & Er & K).
        destruct (in_entries_from (entry_of (printed_unit unit) (root (gradation_of R))) _ r K 2) as (n & H).
        eexists. split; [exact H|]. unfold entry_of. cbn [size_of]. rewrite Er. reflexivity.
      * intros ->. rewrite andb_true_r in B. rewrite !size_is_length, entries_from_length.
        rewrite <- (map_length opening (rows (gradation_of R))), Op, B. cbn [app]. rewrite (Permutation_length Pm), map_length. lia.
  - destruct (implied_pan R) eqn:B; [apply (Room B)|].
    rewrite <- (map_length opening), Op. cbn [app]. rewrite (Permutation_length Pm), map_length. exact few.
Qed.

End Masses.

(* ---- Any file ---------------------------------------------------------------------------------------------- *)

(* What is read of the text that was printed. *)
Definition read_again (R : reading) : reading := match limits R with Some _ => printed_envelope R | None => printed R end.

(* What --print writes of any gradation file is read as the gradation that was read of this file, where it is no longer than
   a file may be and a pan that was implied has room. *)
Theorem print_read f text R :
  read_gradation (bytes f) = Ok R -> print_gradation f = Ok text ->
  text_length text <= most_text -> room_for_pan R -> read_gradation text = Ok (read_again R).
Proof.
  intros E P Le Room. unfold print_gradation, MixtureFile.read_any_gradation in P. rewrite E in P.
  destruct (forallb _ (gradation_lines R)) eqn:Sh; [|discriminate P]. cbn [demand_form bind] in P. injection P as <-.
  assert (forall l, In l (gradation_lines R) -> short_line l = true) as Lines by (apply forallb_forall; exact Sh).
  apply file_entries in E as (unit & what & t & c & line & es & E & G & C & N). unfold read_again.
  destruct (limits R) as [ls|] eqn:L.
  - assert (what = Limits) as ->.
    { destruct what; trivial; exfalso;
        destruct (entries_read_masses _ _ _ _ _ _ _ E ltac:(discriminate) G C) as [_ _ _ L' _ _ _ _]; congruence. }
    destruct (N eq_refl) as (-> & ->). apply (envelope_read R ls). exact (envelope_canonical _ _ _ _ _ E G C L Lines Le).
  - apply gradation_read. assert (what <> Limits) as W.
    { intros ->. destruct (N eq_refl) as (-> & ->). destruct (envelope_limits_there _ _ _ _ _ _ E) as (ls & L'). congruence. }
    exact (masses_canonical unit t c es R (entries_read_masses _ _ _ _ _ _ _ E W G C) G C Lines Room Le).
Qed.
