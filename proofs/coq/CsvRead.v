(* Lines of numbers, as canonical CSV has them, are read as they are printed. *)

From Coq Require Import ZArith QArith Qreduction Qcanon String Ascii List Bool Lia.
From Mdm Require Import Numbers Gradation Certificate Text Decimals Rows Csv GradationFile NumberTexts CsvFields.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Decimals of files -------------------------------------------------------------------------------- *)

Definition short_decimal (x : Q) : Prop :=
  0 <= Qnum x /\ is_decimal x /\ Qred x = x /\ is_short (show_decimal x) = true.

Lemma string_length_text w : forall n, string_length w n = n + text_length w.
Proof. induction w as [|ch w IH]; intro n; simpl; [lia|]. rewrite IH. lia. Qed.

Lemma numeral_no_point w n length : numeral w n length -> has "." w = false.
Proof.
  unfold has. induction 1 as [|ch d w n length E D N IH]; [reflexivity|]. cbn [some]. rewrite IH.
  destruct (Ascii.eqb_spec "." ch) as [<-|]; [discriminate E | reflexivity].
Qed.

Lemma digit_no_sign ch d : digit ch = Some d -> Ascii.eqb ch "+" = false /\ Ascii.eqb ch "-" = false.
Proof.
  intro E. destruct (Ascii.eqb_spec ch "+") as [->|]; [discriminate E|].
  destruct (Ascii.eqb_spec ch "-") as [->|]; [discriminate E | auto].
Qed.

Lemma unsigned w n length rest : numeral w n length -> 1 <= length -> signed (w ++ rest) = (1, w ++ rest).
Proof.
  intros N L. destruct N as [|ch d w n length E D N]; [lia|]. simpl. destruct (digit_no_sign ch d E) as (-> & ->).
  reflexivity.
Qed.

Lemma times_power_of_ten x value places :
  0 <= places -> Qred x = x -> value * Zpos (Qden x) = Qnum x * 10 ^ places ->
  times (of_integer value) (power_of_ten (- places)) = x.
Proof.
  intros P R E. unfold times. rewrite <- R. apply Qred_complete. unfold power_of_ten.
  destruct (Z.leb_spec 0 (- places)) as [L|L].
  - assert (places = 0) as -> by lia. unfold of_integer, Qeq. cbn [Qmult Qnum Qden]. simpl Z.opp. simpl (10 ^ 0) in *. lia.
  - rewrite Z.opp_involutive. unfold of_integer, Qeq. cbn [Qmult Qnum Qden]. rewrite Pos.mul_1_l, Z.mul_1_r.
    rewrite Z2Pos.id by (apply Z.pow_pos_nonneg; lia). exact E.
Qed.

Theorem read_decimal_shown x : short_decimal x -> read_decimal "." (show_decimal x) = Ok x.
Proof.
  intros (P & D & R & B). destruct (show_decimal_form x P D) as (whole & n & L & N & Z0 & H).
  pose proof (numeral_text_length _ _ _ N) as T. unfold is_short in B. apply Z.leb_le in B. rewrite string_length_text in B.
  destruct H as [(V & S)|(w & m & places & F & Lp & M & V & S)]; unfold read_decimal.
  - rewrite S in *. rewrite (numeral_no_point _ _ _ N) in B. pose proof (unsigned _ _ _ "" N L) as U. rewrite append_empty in U. rewrite U.
    pose proof (file_digits_read _ _ _ N "" 0 0 ltac:(lia)) as Dg. rewrite append_empty in Dg. rewrite Dg.
    cbn [file_digits exponent_of]. replace (0 + n) with n by lia.
    rewrite (proj2 (Z.ltb_ge n 1)), (proj2 (Z.ltb_ge _ n)) by lia. change (most_exponent <? Z.abs 0) with false. cbv iota.
    f_equal. replace (0 - (n - n)) with (- 0) by lia. apply times_power_of_ten; [lia | exact R|].
    change (10 ^ 0) with 1. lia.
  - rewrite S in *. rewrite (unsigned _ _ _ _ N L).
    rewrite text_length_append in B. cbn [text_length] in B. rewrite (numeral_text_length _ _ _ F) in B.
    assert (n + places <= most_digits_of_file) by (destruct (has "." _); lia).
    rewrite (file_digits_read _ _ _ N (String "." w) 0 0) by lia. cbn [file_digits]. change (digit ".") with (@None Z).
    cbv iota beta. change (Ascii.eqb "." ".") with true. cbv iota.
    pose proof (file_digits_read _ _ _ F "" (0 * 10 ^ n + whole) (0 + n) ltac:(lia)) as Dg. rewrite append_empty in Dg.
    rewrite Dg.
    cbn [file_digits exponent_of].
    rewrite (proj2 (Z.ltb_ge (0 + n + places) 1)), (proj2 (Z.ltb_ge _ (0 + n + places))) by lia.
    change (most_exponent <? Z.abs 0) with false. cbv iota. f_equal.
    replace (0 - (0 + n + places - (0 + n))) with (- places) by lia. apply times_power_of_ten; [lia | exact R|].
    rewrite <- V. ring.
Qed.

Lemma read_decimal_negative point w x :
  signed w = (1, w) -> read_decimal point w = Ok x -> read_decimal point (String "-" w) = Ok (Qopp x).
Proof.
  intro S. unfold read_decimal. rewrite S. change (signed (String "-" w)) with (-1, w). cbv iota beta.
  destruct (file_digits w 0 0) as ((whole, n), rest).
  destruct (match rest with
            | String ch places => if Ascii.eqb ch point then file_digits places whole n else (whole, n, rest)
            | EmptyString => (whole, n, rest)
            end) as ((value, all), rest').
  destruct (exponent_of rest') as [exponent|]; [|discriminate]. destruct (all <? 1); [discriminate|].
  destruct (most_digits_of_file <? all); [discriminate|]. destruct (most_exponent <? Z.abs exponent); [discriminate|].
  intro E. assert (x = times (of_integer (1 * value)) (power_of_ten (exponent - (all - n)))) as -> by congruence.
  f_equal. unfold times. rewrite <- Qred_opp. apply Qred_complete. unfold of_integer.
  unfold Qeq. destruct (power_of_ten (exponent - (all - n))) as (p, d). cbn [Qmult Qnum Qden Qopp]. ring.
Qed.

Lemma shown_no_sign x : 0 <= Qnum x -> is_decimal x -> signed (show_decimal x) = (1, show_decimal x).
Proof.
  intros P D. destruct (show_decimal_form x P D) as (whole & n & L & N & _ & [(_ & ->)|(w & m & places & _ & _ & _ & _ & ->)]).
  - pose proof (unsigned _ _ _ "" N L) as U. rewrite append_empty in U. exact U.
  - exact (unsigned _ _ _ _ N L).
Qed.

(* ---- Characters of decimals ---------------------------------------------------------------------------- *)

(* Digits and a point. *)
Definition of_number (ch : ascii) : bool := is_digit ch || Ascii.eqb ch ".".

Lemma digit_is_digit ch d : digit ch = Some d -> of_number ch = true.
Proof.
  intro E. destruct ch as [[] [] [] [] [] [] [] []]; try discriminate E; reflexivity.
Qed.

Lemma numeral_of_number w n length : numeral w n length -> every of_number w = true.
Proof. induction 1; simpl; [reflexivity|]. erewrite digit_is_digit by eassumption. assumption. Qed.

Lemma every_append such u v : every such (u ++ v) = every such u && every such v.
Proof. induction u as [|ch u IH]; simpl; [reflexivity|]. rewrite IH, andb_assoc. reflexivity. Qed.

Lemma decimal_of_number x : 0 <= Qnum x -> is_decimal x ->
  every of_number (show_decimal x) = true /\ show_decimal x <> "".
Proof.
  intros P D. destruct (show_decimal_form x P D) as (whole & n & L & N & _ & H).
  pose proof (numeral_of_number _ _ _ N) as E.
  assert (show_integer whole <> "") as Ne by (intro S; rewrite S in N; inversion N; lia).
  destruct H as [(_ & ->)|(w & m & places & F & _ & _ & _ & ->)]; [auto|]. split.
  - rewrite every_append, E. simpl. exact (numeral_of_number _ _ _ F).
  - destruct (show_integer whole); [contradiction | discriminate].
Qed.

Lemma every_implies (such other : ascii -> bool) w :
  (forall ch, such ch = true -> other ch = true) -> every such w = true -> every other w = true.
Proof.
  intro I. induction w as [|ch w IH]; simpl; [trivial|]. rewrite !andb_true_iff. intros (C & W). auto.
Qed.

Lemma without_first_none such w : every (fun ch => negb (such ch)) w = true -> without_first such w = w.
Proof. destruct w as [|ch w]; simpl; [trivial|]. destruct (such ch); [discriminate | reflexivity]. Qed.

Lemma every_onto such u : forall v, every such (onto u v) = every such u && every such v.
Proof.
  induction u as [|ch u IH]; intro v; simpl; [reflexivity|]. rewrite IH. simpl.
  destruct (such ch), (every such u); reflexivity.
Qed.

Lemma some_none such w : every (fun ch => negb (such ch)) w = true -> some such w = false.
Proof. induction w as [|ch w IH]; simpl; [reflexivity|]. destruct (such ch); [discriminate | exact IH]. Qed.

(* A field without blanks, quotes and commas stands for itself. *)
Definition plain_character (ch : ascii) : bool := negb (is_blank ch) && negb (Ascii.eqb ch quote) && negb (Ascii.eqb "," ch).

Lemma plain_field w : every plain_character w = true -> w <> "" -> field_of "," w w.
Proof.
  intros E N. rewrite <- (append_empty w) at 1. change (w ++ "") with ("" ++ w ++ "").
  assert (every (fun ch => negb (is_blank ch)) w = true) as B.
  { revert E. apply every_implies. intro ch. unfold plain_character. rewrite !andb_true_iff. tauto. }
  apply bare_field; trivial; try reflexivity.
  - apply some_none. revert E. apply every_implies. intro ch. unfold plain_character. rewrite !andb_true_iff. tauto.
  - apply without_first_none, B.
  - apply without_first_none. unfold reversed. rewrite every_onto, B. reflexivity.
  - intros rest ->. discriminate E.
Qed.

Lemma plain_fields ws : ws <> [] -> (forall w, In w ws -> every plain_character w = true /\ w <> "") ->
  fields_of "," (joined "," ws) = Some ws.
Proof.
  intros N P. apply fields_read; [reflexivity | reflexivity|].
  induction ws as [|w ws IH]; [contradiction|]. destruct (P w (or_introl eq_refl)) as (E & Ne).
  pose proof (plain_field w E Ne) as F. destruct ws as [|v ws].
  - apply last_field, F.
  - change (joined "," (w :: v :: ws)) with (w ++ String "," (joined "," (v :: ws))). apply one_more_field; [exact F|].
    apply IH; [discriminate | intros x I; apply P; right; exact I].
Qed.

(* What canonical CSV has in a field: numbers with a sign, and names. *)
Definition of_field (ch : ascii) : bool := of_number ch || Ascii.eqb ch "-" || between "a" "z" ch || Ascii.eqb ch "_".
Definition field_text (w : string) : Prop := every of_field w = true /\ w <> "".

Lemma of_field_plain ch : of_field ch = true -> plain_character ch = true.
Proof. destruct ch as [[] [] [] [] [] [] [] []]; try reflexivity; discriminate. Qed.

Lemma number_of_field ch : of_number ch = true -> of_field ch = true.
Proof. unfold of_field. intros ->. reflexivity. Qed.

Lemma decimal_field x : short_decimal x -> field_text (show_decimal x).
Proof.
  intros (P & D & _). destruct (decimal_of_number x P D) as (E & N). split; [|exact N].
  exact (every_implies _ _ _ number_of_field E).
Qed.

Lemma texts_fields ws : ws <> [] -> (forall w, In w ws -> field_text w) -> fields_of "," (joined "," ws) = Some ws.
Proof.
  intros N P. apply plain_fields; [exact N|]. intros w I. destruct (P w I) as (E & Ne). split; [|exact Ne].
  exact (every_implies _ _ _ of_field_plain E).
Qed.

(* ---- Lines of a text ----------------------------------------------------------------------------------- *)

Fixpoint text_with (ls : list string) : string :=
  match ls with l :: ls => l ++ String line_feed (text_with ls) | [] => "" end.

Lemma onto_onto u : forall v w, onto (onto u w) v = onto w (u ++ v).
Proof. induction u as [|ch u IH]; intros v w; simpl; [reflexivity|]. rewrite IH. reflexivity. Qed.

Lemma text_of_lines_with ls : text_of_lines ls = text_with ls.
Proof.
  unfold text_of_lines, reversed.
  enough (forall d, onto (fold_left (fun done l => String line_feed (onto l done)) ls d) "" = onto d (text_with ls)) as H
    by exact (H "").
  induction ls as [|l ls IH]; intro d; simpl; [reflexivity|]. rewrite IH. simpl. apply onto_onto.
Qed.

Definition in_line (ch : ascii) : bool := negb (Ascii.eqb ch line_feed) && negb (Ascii.eqb ch carriage_return).

Lemma line_characters l : forall rest current line st, every in_line l = true ->
  read_lines (l ++ rest) current line st = read_lines rest (onto l current) line st.
Proof.
  induction l as [|ch l IH]; intros rest current line st E; [reflexivity|]. simpl in E. apply andb_prop in E as (C & E).
  change (String ch l ++ rest) with (String ch (l ++ rest)). cbn [read_lines onto].
  unfold in_line in C. destruct (Ascii.eqb ch line_feed); [discriminate C|]. apply IH, E.
Qed.

Lemma line_read l rest line st st' : every in_line l = true -> read_line st l line = Ok st' ->
  read_lines (l ++ String line_feed rest) "" line st = read_lines rest "" (line + 1) st'.
Proof.
  intros E R. rewrite line_characters by exact E. cbn [read_lines]. rewrite Ascii.eqb_refl.
  assert (every in_line (onto l "") = true) as O by (rewrite every_onto, E; reflexivity).
  assert (match onto l "" with
          | String last before => if Ascii.eqb last carriage_return then before else onto l ""
          | EmptyString => onto l "" end = onto l "") as ->.
  { destruct (onto l "") as [|last before]; [reflexivity|]. simpl in O. apply andb_prop in O as (C & _).
    unfold in_line in C. apply andb_prop in C as (_ & C).
    destruct (Ascii.eqb last carriage_return); [discriminate C | reflexivity]. }
  unfold reversed. rewrite onto_reversed. simpl onto. rewrite R. reflexivity.
Qed.

(* What a line of canonical CSV may hold. *)
Definition of_csv (ch : ascii) : bool := of_field ch || Ascii.eqb ch ",".

Lemma every_joined (such : ascii -> bool) ws : such ","%char = true -> (forall w, In w ws -> every such w = true) ->
  every such (joined "," ws) = true.
Proof.
  intro C. induction ws as [|w ws IH]; intro P; [reflexivity|]. destruct ws as [|v ws]; [apply P; left; reflexivity|].
  change (joined "," (w :: v :: ws)) with (w ++ String "," (joined "," (v :: ws))). rewrite every_append.
  change (every such (String "," (joined "," (v :: ws)))) with (such ","%char && every such (joined "," (v :: ws))).
  rewrite C, (P w (or_introl eq_refl)), IH; [reflexivity|]. intros x I. apply P. right. exact I.
Qed.

Lemma texts_of_csv ws : (forall w, In w ws -> field_text w) -> every of_csv (joined "," ws) = true.
Proof.
  intro P. apply every_joined; [reflexivity|]. intros w I. destruct (P w I) as (E & _).
  eapply every_implies, E. intros ch C. unfold of_csv. rewrite C. reflexivity.
Qed.

Lemma of_csv_in_line ch : of_csv ch = true -> in_line ch = true.
Proof. destruct ch as [[] [] [] [] [] [] [] []]; try reflexivity; discriminate. Qed.

Lemma text_checked w : every (fun ch => of_csv ch || Ascii.eqb ch line_feed) w = true -> forall line, check_text w 0 line = Ok tt.
Proof.
  induction w as [|ch w IH]; intros E line; [reflexivity|]. simpl every in E. apply andb_prop in E as (C & E).
  cbn [check_text].
  destruct (between " " "~" ch || Ascii.eqb ch tab) eqn:B; [apply IH, E|].
  destruct (Ascii.eqb ch line_feed) eqn:F; [apply IH, E|].
  exfalso. revert B C. clear. destruct ch as [[] [] [] [] [] [] [] []]; discriminate.
Qed.

Lemma text_with_every such ls : such line_feed = true -> (forall l, In l ls -> every such l = true) -> every such (text_with ls) = true.
Proof.
  intros F. induction ls as [|l ls IH]; intro P; [reflexivity|]. cbn [text_with]. rewrite every_append.
  change (every such (String line_feed (text_with ls))) with (such line_feed && every such (text_with ls)).
  rewrite F, (P l (or_introl eq_refl)), IH; [reflexivity|]. intros x I. apply P. right. exact I.
Qed.

(* ---- Lists --------------------------------------------------------------------------------------------- *)

Lemma map_onto_rev {A B} (g : A -> B) l : forall done, map_onto g l done = (rev (map g l) ++ done)%list.
Proof. induction l as [|x l IH]; intro done; simpl; [reflexivity|]. rewrite IH, <- app_assoc. reflexivity. Qed.

Lemma rev'_is_rev {A} (l : list A) : rev' l = rev l.
Proof. unfold rev'. rewrite rev_append_rev, app_nil_r. reflexivity. Qed.

Lemma map_all_is_map {A B} (g : A -> B) l : map_all g l = map g l.
Proof. unfold map_all. rewrite rev'_is_rev, map_onto_rev, app_nil_r, rev_involutive. reflexivity. Qed.

Lemma size_length {A} (l : list A) : forall n, fold_left (fun n _ => n + 1) l n = n + Z.of_nat (List.length l).
Proof. induction l as [|x l IH]; intro n; cbn [fold_left List.length]; [lia|]. rewrite IH. lia. Qed.

(* ---- Numbers ------------------------------------------------------------------------------------------- *)

(* Points that canonical CSV may have been written with so far. *)
Definition known (point : option ascii) : Prop := point = None \/ point = Some "."%char.

Lemma number_text_read point w x : known point -> read_decimal "." w = Ok x ->
  exists point', known point' /\ read_number "," point w = Ok (x, point').
Proof.
  intros K R. unfold read_number, point_for. change (Ascii.eqb "," ";") with false. cbn [andb].
  destruct (negb (has "," w || has "." w)).
  - exists point. split; [exact K|]. cbn [bind]. rewrite R. reflexivity.
  - exists (Some "."%char). split; [right; reflexivity|].
    destruct K as [-> | ->]; change (Ascii.eqb "." ".") with true; cbn [demand_form bind]; rewrite R; reflexivity.
Qed.

Lemma number_read point x : known point -> short_decimal x ->
  exists point', known point' /\ read_number "," point (show_decimal x) = Ok (x, point').
Proof. intros K S. apply number_text_read; [exact K | exact (read_decimal_shown x S)]. Qed.

(* ---- Rows ---------------------------------------------------------------------------------------------- *)

(* Fields that are read as a row, whatever its line. *)
Record row_read (h : header) (fields : list string) (e : Z -> entry) : Prop := {
  row_has_fields : fields <> [];
  row_texts : forall w, In w fields -> field_text w;
  row_entry : forall point line, known point ->
    exists point', known point' /\ read_entry h "," point fields line = Ok (e line, point') }.

Lemma joined_head ch w ws : exists rest, joined "," (String ch w :: ws) = String ch rest.
Proof. destruct ws; simpl; eauto. Qed.

Lemma row_line_read h st begins fields e line : row_read h fields e ->
  delimiter_of st = ","%char -> header_found st = Some (h, begins) -> known (point_of st) -> count_of st < most_rows ->
  exists point, known point /\
    read_line st (joined "," fields) line =
      Ok (State "," (Some (h, begins)) point (e line :: entries st) (count_of st + 1)).
Proof.
  intros [N T R] D H K C. destruct (R _ line K) as (point & K' & E). exists point. split; [exact K'|].
  pose proof (texts_fields fields N T) as F.
  assert (exists ch w, of_field ch = true /\ joined "," fields = String ch w) as (ch & w & Ch & J).
  { destruct fields as [|[|ch w] ws]; [contradiction | |].
    - destruct (T "" (or_introl eq_refl)) as (_ & B). contradiction.
    - destruct (T _ (or_introl eq_refl)) as (B & _). simpl in B. apply andb_prop in B as (B & _).
      destruct (joined_head ch w ws) as (rest & J). eauto. }
  unfold read_line. rewrite J in *.
  assert (is_blank ch = false /\ Ascii.eqb ch "#" = false) as (B & Co).
  { destruct ch as [[] [] [] [] [] [] [] []]; try discriminate Ch; split; reflexivity. }
  simpl without_first. rewrite B, Co, H, D, F. unfold read_row_line, demand_at, on_line.
  rewrite (proj2 (Z.ltb_lt _ _) C), D, E. reflexivity.
Qed.

Section Rows.
Context {A : Type} (h : header) (fields : A -> list string) (entry_of : A -> Z -> entry).

Fixpoint entries_from (xs : list A) (line : Z) : list entry :=
  match xs with x :: xs => entry_of x line :: entries_from xs (line + 1) | [] => [] end.

Definition rows_text (xs : list A) : string := text_with (map (fun x => joined "," (fields x)) xs).

Lemma rows_read begins xs : forall st line,
  (forall x, In x xs -> row_read h (fields x) (entry_of x)) ->
  delimiter_of st = ","%char -> header_found st = Some (h, begins) -> known (point_of st) ->
  count_of st + Z.of_nat (List.length xs) <= most_rows ->
  exists point, read_lines (rows_text xs) "" line st =
    Ok (State "," (Some (h, begins)) point (rev (entries_from xs line) ++ entries st)%list
          (count_of st + Z.of_nat (List.length xs))).
Proof.
  induction xs as [|x xs IH]; intros st line P D H K C.
  - exists (point_of st). cbn. destruct st as [d hs p es n]. cbn in *. subst. do 2 f_equal. lia.
  - cbn [List.length] in C. pose proof (P x (or_introl eq_refl)) as Px.
    destruct (row_line_read h st begins _ _ line Px D H K) as (point & K' & R); [lia|].
    unfold rows_text. cbn [map text_with].
    rewrite (line_read _ _ _ _ _ (every_implies _ _ _ of_csv_in_line (texts_of_csv _ (row_texts _ _ _ Px))) R).
    edestruct (IH (State "," (Some (h, begins)) point (entry_of x line :: entries st) (count_of st + 1)) (line + 1)) as (point' & E);
      [intros y I; apply P; right; exact I | reflexivity | reflexivity | exact K' | cbn [count_of]; lia|].
    exists point'. unfold rows_text in E. rewrite E. cbn [entries count_of entries_from rev List.length].
    rewrite <- app_assoc. do 2 f_equal. lia.
Qed.

(* A header and rows: what is read is the gradation of the rows. *)
Lemma csv_read top xs :
  every of_csv top = true -> (exists rest, top = String "s" rest) ->
  read_line start top 1 = Ok (State "," (Some (h, 1)) None [] 0) ->
  (forall x, In x xs -> row_read h (fields x) (entry_of x)) -> Z.of_nat (List.length xs) <= most_rows ->
  match quantity_of h with Limits => 1 | _ => 2 end <= Z.of_nat (List.length xs) ->
  text_length (text_with (top :: map (fun x => joined "," (fields x)) xs)) <= most_text ->
  read_gradation (text_with (top :: map (fun x => joined "," (fields x)) xs)) =
    gradation_of_entries (unit_of h) (quantity_of h) (has_tolerance h) (has_factor h) 1 (entries_from xs 2).
Proof.
  intros Tc (rest & Ts) Tr P C M Le. set (text := text_with (top :: map (fun x => joined "," (fields x)) xs)) in *.
  unfold read_gradation. rewrite string_length_text, (proj2 (Z.leb_le _ most_text)) by lia. cbn [demand_form bind].
  assert (check_text text 0 1 = Ok tt) as ->.
  { apply text_checked, text_with_every; [reflexivity|].
    intros l I. assert (every of_csv l = true) as E.
    { destruct I as [<-|I]; [exact Tc|]. apply in_map_iff in I as (x & <- & I). apply texts_of_csv, (P x I). }
    eapply every_implies, E. intros ch ->. reflexivity. }
  cbn [bind].
  assert (exists w, text = String "s" w) as (w & T) by (unfold text; cbn [text_with]; rewrite Ts; simpl; eauto).
  assert (without_mark text = text) as -> by (rewrite T; reflexivity).
  assert (forall x y : result reading, match without_first is_space text with
          | String ch _ => if Ascii.eqb ch "{" then x else y | EmptyString => y end = y) as -> by (intros; rewrite T; reflexivity).
  unfold read_csv, text. cbn [text_with].
  rewrite (line_read _ _ _ _ _ (every_implies _ _ _ of_csv_in_line Tc) Tr).
  destruct (rows_read 1 xs (State "," (Some (h, 1)) None [] 0) 2 P) as (point & E);
    [reflexivity | reflexivity | left; reflexivity | cbn [count_of]; lia|].
  unfold rows_text in E. change (1 + 1) with 2. rewrite E. cbn [bind header_found count_of entries]. unfold demand_at.
  rewrite (proj2 (Z.leb_le _ _)) by (cbn [Z.add]; exact M). cbn [bind].
  rewrite app_nil_r, rev'_is_rev, rev_involutive. reflexivity.
Qed.

End Rows.
