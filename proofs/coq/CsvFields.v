(* The fields of a line of CSV, as a grammar, and that they are what is read, and nothing else is (certificate-format.md,
   section 4). *)

From Coq Require Import ZArith String Ascii List Bool Lia.
From Mdm Require Import Numbers Certificate Text Csv NumberTexts.
Import ListNotations.
Open Scope string_scope.

(* ---- The grammar ------------------------------------------------------------------------------------ *)

Definition blank (w : string) : Prop := every is_blank w = true.

(* Text within quotes, and what it stands for: two quotes for one. *)
Inductive quoted_text : string -> string -> Prop :=
| nothing_quoted : quoted_text "" ""
| quoted_character ch raw value : ch <> quote -> quoted_text raw value -> quoted_text (String ch raw) (String ch value)
| quoted_quote raw value : quoted_text raw value -> quoted_text (String quote (String quote raw)) (String quote value).

(* A field as it stands between delimiters, and its value; a bare one neither begins nor ends with a blank. *)
Inductive field_of (delimiter : ascii) : string -> string -> Prop :=
| empty_field raw : blank raw -> field_of delimiter raw ""
| bare_field before raw after :
    blank before -> blank after -> raw <> "" -> some (Ascii.eqb delimiter) raw = false ->
    without_first is_blank raw = raw -> without_first is_blank (reversed raw) = reversed raw ->
    (forall rest, raw <> String quote rest) ->
    field_of delimiter (before ++ raw ++ after) raw
| quoted_field before raw value after :
    blank before -> blank after -> quoted_text raw value ->
    field_of delimiter (before ++ String quote (raw ++ String quote after)) value.

(* A line and the values of its fields, one or more. *)
Inductive line_of_fields (delimiter : ascii) : string -> list string -> Prop :=
| last_field raw value : field_of delimiter raw value -> line_of_fields delimiter raw [value]
| one_more_field raw value rest values :
    field_of delimiter raw value -> line_of_fields delimiter rest values ->
    line_of_fields delimiter (raw ++ String delimiter rest) (value :: values).

(* ---- What the grammar allows is read ---------------------------------------------------------------- *)

Section Fields.
Variable delimiter : ascii.
Hypothesis not_blank : is_blank delimiter = false.
Hypothesis not_quote : Ascii.eqb quote delimiter = false.

(* What ends a field: the end of the line, or the delimiter, with what then is read. *)
Definition ends (rest value : string) (done : list string) : option (list string) :=
  match rest with
  | EmptyString => Some (rev' (value :: done))
  | String _ rest => split delimiter rest Before "" (value :: done)
  end.
Definition at_end (rest : string) : Prop := rest = "" \/ exists w, rest = String delimiter w.

Lemma blank_char ch w : blank (String ch w) -> is_blank ch = true /\ blank w.
Proof. unfold blank. simpl. apply andb_prop. Qed.

Lemma blank_no_delimiter ch : is_blank ch = true -> Ascii.eqb ch delimiter = false.
Proof. intro B. destruct (Ascii.eqb_spec ch delimiter) as [->|]; congruence. Qed.

Lemma before_blank w : blank w -> forall rest done,
  split delimiter (w ++ rest) Before "" done = split delimiter rest Before "" done.
Proof.
  induction w as [|ch w IH]; intros B rest done; [reflexivity|]. apply blank_char in B as (C & B).
  change (String ch w ++ rest) with (String ch (w ++ rest)). cbn [split].
  rewrite blank_no_delimiter, C by exact C. apply IH, B.
Qed.

Lemma ended (at_ : place) field rest done value : at_end rest -> at_ <> InQuotes ->
  match at_ with Before => "" | Bare => reversed (without_first is_blank field) | _ => reversed field end = value ->
  split delimiter rest at_ field done = ends rest value done.
Proof.
  intros [->|(w & ->)] N E; cbn [split ends]; rewrite E.
  - destruct at_; congruence.
  - pose proof (Ascii.eqb_refl delimiter) as R.
    destruct at_; rewrite ?R; trivial; try congruence.
    destruct (Ascii.eqb_spec delimiter quote) as [Q|]; [|reflexivity].
    rewrite Q, Ascii.eqb_refl in not_quote. discriminate.
Qed.

Lemma onto_reversed u : forall w, onto (onto u w) "" = onto w u.
Proof. induction u as [|ch u IH]; intro w; simpl; [reflexivity|]. rewrite IH. reflexivity. Qed.

Lemma bare w : some (Ascii.eqb delimiter) w = false -> forall rest field done,
  split delimiter (w ++ rest) Bare field done = split delimiter rest Bare (onto w field) done.
Proof.
  induction w as [|ch w IH]; intros S rest field done; [reflexivity|]. simpl in S. apply orb_false_elim in S as (C & S).
  change (String ch w ++ rest) with (String ch (w ++ rest)). cbn [split onto].
  rewrite Ascii.eqb_sym, C. apply IH, S.
Qed.

Lemma blank_no_delimiters w : blank w -> some (Ascii.eqb delimiter) w = false.
Proof.
  induction w as [|ch w IH]; intro B; [reflexivity|]. apply blank_char in B as (C & B). simpl.
  rewrite Ascii.eqb_sym, blank_no_delimiter, IH; trivial.
Qed.

Lemma drop_blanks w : blank w -> forall field, without_first is_blank (onto w field) = without_first is_blank field.
Proof.
  induction w as [|ch w IH]; intros B field; [reflexivity|]. apply blank_char in B as (C & B). simpl.
  rewrite IH by exact B. simpl. rewrite C. reflexivity.
Qed.

Lemma in_quotes raw value : quoted_text raw value -> forall rest field done,
  split delimiter (raw ++ rest) InQuotes field done = split delimiter rest InQuotes (onto value field) done.
Proof.
  induction 1 as [|ch raw value N Q IH|raw value Q IH]; intros rest field done; [reflexivity| |].
  - change (String ch raw ++ rest) with (String ch (raw ++ rest)). cbn [split onto].
    destruct (Ascii.eqb_spec ch quote); [contradiction|]. apply IH.
  - change (String quote (String quote raw) ++ rest) with (String quote (String quote (raw ++ rest))).
    cbn [split onto]. rewrite !Ascii.eqb_refl. apply IH.
Qed.

Lemma behind_blank w : blank w -> forall (at_ : place) rest field done, at_ = Closing \/ at_ = Behind -> at_end rest ->
  split delimiter (w ++ rest) at_ field done = ends rest (reversed field) done.
Proof.
  induction w as [|ch w IH]; intros B at_ rest field done A E.
  - apply ended; [exact E | destruct A; congruence | destruct A as [-> | ->]; reflexivity].
  - apply blank_char in B as (C & B). change (String ch w ++ rest) with (String ch (w ++ rest)).
    assert (Ascii.eqb ch quote = false) as Q by (destruct (Ascii.eqb_spec ch quote) as [->|]; [discriminate C | reflexivity]).
    destruct A as [-> | ->]; cbn [split]; rewrite ?Q, blank_no_delimiter, C by exact C; apply IH; auto.
Qed.

Lemma without_first_shorter such w : (text_length (without_first such w) <= text_length w)%Z.
Proof. induction w as [|ch w IH]; simpl; [lia|]. destruct (such ch); simpl; lia. Qed.

Lemma field_read raw value rest done : field_of delimiter raw value -> at_end rest ->
  split delimiter (raw ++ rest) Before "" done = ends rest value done.
Proof.
  intros F E. destruct F as [raw B|before raw after Bb Ba N S First Last Nq|before raw value after Bb Ba Q].
  - rewrite before_blank by exact B. apply ended; [exact E | discriminate | reflexivity].
  - rewrite !append_assoc, before_blank by exact Bb. destruct raw as [|ch raw]; [contradiction|].
    assert (is_blank ch = false) as Nb.
    { simpl in First. destruct (is_blank ch); [|reflexivity]. apply (f_equal text_length) in First. simpl in First.
      pose proof (without_first_shorter is_blank raw). lia. }
    simpl in S. apply orb_false_elim in S as (C & S).
    change (String ch raw ++ after ++ rest) with (String ch (raw ++ after ++ rest)). cbn [split].
    rewrite Ascii.eqb_sym, C, Nb. destruct (Ascii.eqb_spec ch quote) as [->|]; [destruct (Nq raw eq_refl)|].
    rewrite bare by exact S. rewrite bare by (apply blank_no_delimiters, Ba).
    apply ended; [exact E | discriminate|]. rewrite drop_blanks by exact Ba.
    unfold reversed in Last. cbn [onto] in Last.
    rewrite Last. unfold reversed. rewrite onto_reversed. reflexivity.
  - rewrite !append_assoc, before_blank by exact Bb.
    change (String quote (raw ++ String quote after) ++ rest) with (String quote ((raw ++ String quote after) ++ rest)).
    cbn [split]. rewrite not_quote. change (is_blank quote) with false. rewrite Ascii.eqb_refl, append_assoc.
    rewrite (in_quotes raw value Q).
    change (String quote after ++ rest) with (String quote (after ++ rest)). cbn [split]. rewrite Ascii.eqb_refl.
    rewrite behind_blank by auto. unfold reversed. rewrite onto_reversed. reflexivity.
Qed.

(* Every line of the grammar is read as the values of its fields. *)
Theorem fields_read w values : line_of_fields delimiter w values -> fields_of delimiter w = Some values.
Proof.
  unfold fields_of. enough (line_of_fields delimiter w values ->
    forall done, split delimiter w Before "" done = Some (rev done ++ values)%list) as H.
  { intro L. exact (H L []). }
  induction 1 as [raw value F|raw value rest values F L IH]; intro done.
  - pose proof (field_read raw value "" done F (or_introl eq_refl)) as R. rewrite append_empty in R. rewrite R.
    unfold ends, rev'. rewrite <- rev_alt. reflexivity.
  - rewrite (field_read raw value _ done F) by (right; eauto). cbn [ends]. rewrite IH. simpl. rewrite <- app_assoc.
    reflexivity.
Qed.

(* ---- What is read is what the grammar allows ---------------------------------------------------------- *)

Lemma blank_append u v : blank u -> blank v -> blank (u ++ v).
Proof. unfold blank. induction u as [|ch u IH]; simpl; [trivial|]. rewrite !andb_true_iff. tauto. Qed.

Lemma blank_before_field ch raw value : is_blank ch = true -> field_of delimiter raw value -> field_of delimiter (String ch raw) value.
Proof.
  intros B F. assert (forall w, blank w -> blank (String ch w)) as C.
  { unfold blank. intros w W. simpl. rewrite B. exact W. }
  destruct F as [raw W|before raw after Wb|before raw value after Wb].
  - apply empty_field, C, W.
  - change (String ch (before ++ raw ++ after)) with (String ch before ++ raw ++ after). apply bare_field; auto.
  - change (String ch (before ++ ?rest)) with (String ch before ++ rest). apply quoted_field; auto.
Qed.

Lemma blank_before_line ch w values :
  is_blank ch = true -> line_of_fields delimiter w values -> line_of_fields delimiter (String ch w) values.
Proof.
  intros B L. destruct L as [raw value F|raw value rest values F L].
  - apply last_field, blank_before_field; assumption.
  - change (String ch (raw ++ ?rest)) with (String ch raw ++ rest). apply one_more_field; [|exact L].
    apply blank_before_field; assumption.
Qed.

Lemma onto_append u : forall w, onto u w = reversed u ++ w.
Proof.
  unfold reversed. induction u as [|ch u IH]; intro w; simpl; [reflexivity|].
  rewrite IH, (IH (String ch "")), append_assoc. reflexivity.
Qed.

Lemma reversed_cons ch u : reversed (String ch u) = reversed u ++ String ch "".
Proof. apply (onto_append u). Qed.

Lemma reversed_append u v : reversed (u ++ v) = reversed v ++ reversed u.
Proof.
  induction u as [|ch u IH]; [simpl; rewrite append_empty; reflexivity|].
  change (String ch u ++ v) with (String ch (u ++ v)). rewrite !reversed_cons, IH, append_assoc. reflexivity.
Qed.

Lemma reversed_snoc u ch : reversed (u ++ String ch "") = String ch (reversed u).
Proof. rewrite reversed_append. reflexivity. Qed.

Lemma reversed_twice u : reversed (reversed u) = u.
Proof. unfold reversed at 1. apply onto_reversed. Qed.

Lemma blank_reversed w : blank w -> blank (reversed w).
Proof.
  induction w as [|ch w IH]; intro B; [reflexivity|]. apply blank_char in B as (C & B). rewrite reversed_cons.
  apply blank_append; [apply IH, B|]. unfold blank. simpl. rewrite C. reflexivity.
Qed.

(* Blanks at the head, and a text that begins with none. *)
Lemma blanks_first w : exists blanks, blank blanks /\ w = blanks ++ without_first is_blank w.
Proof.
  induction w as [|ch w (blanks & B & E)]; [exists ""; split; reflexivity|]. simpl. destruct (is_blank ch) eqn:C.
  - exists (String ch blanks). split; [unfold blank; simpl; rewrite C; exact B | simpl; congruence].
  - exists "". split; reflexivity.
Qed.

Lemma without_first_twice such w : without_first such (without_first such w) = without_first such w.
Proof.
  induction w as [|ch w IH]; simpl; [reflexivity|]. destruct (such ch) eqn:C; [exact IH|]. simpl. rewrite C. reflexivity.
Qed.

Lemma some_append such u v : some such (u ++ v) = some such u || some such v.
Proof. induction u as [|ch u IH]; simpl; [reflexivity|]. rewrite IH, orb_assoc. reflexivity. Qed.

(* The value of a bare field is what is left without the blanks at its end. *)
Lemma bare_value ch u : is_blank ch = false -> ch <> quote -> some (Ascii.eqb delimiter) (String ch u) = false ->
  field_of delimiter (String ch u) (reversed (without_first is_blank (reversed (String ch u)))).
Proof.
  intros B Q S. destruct (blanks_first (reversed (String ch u))) as (blanks & Bl & E).
  set (value := without_first is_blank (reversed (String ch u))) in *.
  apply (f_equal reversed) in E. rewrite reversed_twice, reversed_append in E.
  assert (exists v, reversed value = String ch v) as (v & V).
  { destruct (reversed value) as [|x v] eqn:R; simpl in E.
    - pose proof (blank_reversed blanks Bl) as N. rewrite <- E in N. apply blank_char in N. destruct N. congruence.
    - injection E as <- _. eauto. }
  rewrite E. apply (bare_field delimiter "" (reversed value) (reversed blanks)).
  - reflexivity.
  - apply blank_reversed, Bl.
  - rewrite V. discriminate.
  - rewrite E, some_append in S. apply orb_false_elim in S. apply S.
  - rewrite V. simpl. rewrite B. reflexivity.
  - rewrite reversed_twice. apply without_first_twice.
  - intros rest R. rewrite V in R. injection R as R _. contradiction.
Qed.

Lemma quoted_append u v : quoted_text u v -> forall u' v', quoted_text u' v' -> quoted_text (u ++ u') (v ++ v').
Proof.
  induction 1 as [|ch raw value N Q IH|raw value Q IH]; intros u' v' Q'; [exact Q'| |];
    [apply quoted_character | apply quoted_quote]; auto.
Qed.

(* What of a line, from its last delimiter on, has led to a place in it. *)
Definition read_before (at_ : place) (field before : string) : Prop :=
  match at_ with
  | Before => before = "" /\ field = ""
  | Bare =>
    exists ch u, before = String ch u /\ field = reversed before /\
      is_blank ch = false /\ ch <> quote /\ some (Ascii.eqb delimiter) before = false
  | InQuotes => exists raw value, before = String quote raw /\ field = reversed value /\ quoted_text raw value
  | _ =>
    exists raw value after,
      before = String quote (raw ++ String quote after) /\ field = reversed value /\ quoted_text raw value /\
      match at_ with Closing => after = "" | _ => blank after end
  end.

Definition value_at (at_ : place) (field : string) : string :=
  match at_ with Before => "" | Bare => reversed (without_first is_blank field) | _ => reversed field end.

Lemma field_before at_ field before :
  read_before at_ field before -> at_ <> InQuotes -> field_of delimiter before (value_at at_ field).
Proof.
  destruct at_; simpl; intros R N; [| | contradiction | |].
  - destruct R as (-> & _). apply empty_field. reflexivity.
  - destruct R as (ch & u & -> & -> & B & Q & S). apply bare_value; assumption.
  - destruct R as (raw & value & after & -> & -> & Q & ->). rewrite reversed_twice.
    apply (quoted_field delimiter "" raw value ""); trivial; reflexivity.
  - destruct R as (raw & value & after & -> & -> & Q & A). rewrite reversed_twice.
    apply (quoted_field delimiter "" raw value after); trivial; reflexivity.
Qed.

Lemma append_snoc u ch w : u ++ String ch w = (u ++ String ch "") ++ w.
Proof. rewrite append_assoc. reflexivity. Qed.

Lemma split_line w : forall at_ field before done values,
  read_before at_ field before -> split delimiter w at_ field done = Some values ->
  exists vs, values = (rev done ++ vs)%list /\ line_of_fields delimiter (before ++ w) vs.
Proof.
  induction w as [|ch w IH]; intros at_ field before done values R S.
  - assert (at_ <> InQuotes /\ values = (rev done ++ [value_at at_ field])%list) as (N & ->).
    { destruct at_; simpl in S; try discriminate S; injection S as <-; (split; [discriminate|]);
        unfold rev'; rewrite <- rev_alt; reflexivity. }
    eexists. split; [reflexivity|]. rewrite append_empty. apply last_field, field_before; assumption.
  - (* A delimiter ends the field; any other character goes on from the place that it leads to. *)
    assert (at_ <> InQuotes -> split delimiter w Before "" (value_at at_ field :: done) = Some values -> ch = delimiter ->
            exists vs, values = (rev done ++ vs)%list /\ line_of_fields delimiter (before ++ String ch w) vs) as Ended.
    { intros N S' ->. destruct (IH Before "" "" _ _ (conj eq_refl eq_refl) S') as (vs & -> & L).
      exists (value_at at_ field :: vs). split; [simpl; rewrite <- app_assoc; reflexivity|].
      apply one_more_field; [apply field_before; assumption | exact L]. }
    assert (forall at' field', read_before at' field' (before ++ String ch "") -> split delimiter w at' field' done = Some values ->
            exists vs, values = (rev done ++ vs)%list /\ line_of_fields delimiter (before ++ String ch w) vs) as On.
    { intros at' field' R' S'. rewrite append_snoc. exact (IH at' field' _ done values R' S'). }
    destruct at_; cbn [split] in S.
    + destruct R as (-> & ->). destruct (Ascii.eqb_spec ch delimiter) as [D|D]; [apply Ended; auto; discriminate|].
      destruct (is_blank ch) eqn:B.
      * destruct (IH Before "" "" done values (conj eq_refl eq_refl) S) as (vs & E & L). exists vs. split; [exact E|].
        apply blank_before_line; assumption.
      * destruct (Ascii.eqb_spec ch quote) as [Q|Q].
        -- apply (On InQuotes ""); [|exact S]. exists "", "". subst ch. repeat split. constructor.
        -- apply (On Bare (String ch "")); [|exact S]. exists ch, "". repeat split; trivial. simpl.
           destruct (Ascii.eqb_spec delimiter ch) as [E|]; [congruence | reflexivity].
    + destruct (Ascii.eqb_spec ch delimiter) as [D|D]; [apply Ended; auto; discriminate|].
      destruct R as (first & u & -> & -> & B & Q & N). apply (On Bare (String ch (reversed (String first u)))); [|exact S].
      exists first, (u ++ String ch ""). split; [reflexivity|]. split; [symmetry; apply reversed_snoc|].
      split; [exact B|]. split; [exact Q|]. rewrite some_append, N. simpl.
      destruct (Ascii.eqb_spec delimiter ch) as [E|]; [congruence | reflexivity].
    + destruct R as (raw & value & -> & -> & T). destruct (Ascii.eqb_spec ch quote) as [->|Q].
      * apply (On Closing (reversed value)); [|exact S]. exists raw, value, "". repeat split. exact T.
      * apply (On InQuotes (String ch (reversed value))); [|exact S]. exists (raw ++ String ch ""), (value ++ String ch "").
        split; [reflexivity|]. split; [symmetry; apply reversed_snoc|].
        apply quoted_append; [exact T | apply quoted_character; [exact Q | constructor]].
    + destruct R as (raw & value & after & E & F & T & ->). destruct (Ascii.eqb_spec ch quote) as [->|Q].
      * apply (On InQuotes (String quote field)); [|exact S].
        exists (raw ++ String quote (String quote "")), (value ++ String quote ""). subst. split; [|split].
        -- simpl. rewrite append_assoc. reflexivity.
        -- symmetry. apply reversed_snoc.
        -- apply quoted_append; [exact T | apply quoted_quote; constructor].
      * destruct (Ascii.eqb_spec ch delimiter) as [D|D]; [apply Ended; auto; discriminate|].
        destruct (is_blank ch) eqn:B; [|discriminate S]. apply (On Behind field); [|exact S].
        exists raw, value, (String ch ""). subst. split; [simpl; rewrite append_assoc; reflexivity|].
        repeat split; trivial. unfold blank. simpl. rewrite B. reflexivity.
    + destruct R as (raw & value & after & E & F & T & A).
      destruct (Ascii.eqb_spec ch delimiter) as [D|D]; [apply Ended; auto; discriminate|].
      destruct (is_blank ch) eqn:B; [|discriminate S]. apply (On Behind field); [|exact S].
      exists raw, value, (after ++ String ch ""). subst. split; [simpl; rewrite append_assoc; reflexivity|].
      repeat split; trivial. apply blank_append; [exact A|]. unfold blank. simpl. rewrite B. reflexivity.
Qed.

(* A line is read as these fields if and only if the grammar has it with these values: it has no others, and a line that
   is refused is none of the grammar. *)
Theorem fields_read_exactly w values : fields_of delimiter w = Some values <-> line_of_fields delimiter w values.
Proof.
  split; [|apply fields_read]. intro S.
  destruct (split_line w Before "" "" [] values (conj eq_refl eq_refl) S) as (vs & -> & L). exact L.
Qed.

End Fields.
