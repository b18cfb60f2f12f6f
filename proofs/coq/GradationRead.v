(* A gradation is read as it is printed, in canonical CSV: masses with sizes in mm, um, m or phi. What was in inches or had
   names of sieves is printed, and read, in mm. *)

From Coq Require Import ZArith QArith Qreduction Qcanon String Ascii List Bool Lia.
From Mdm Require Import Numbers Gradation Certificate Text Decimals Rows Csv GradationFile NumberTexts CsvFields CsvRead.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Sizes --------------------------------------------------------------------------------------------- *)

Definition printed_unit (unit : size_unit) : size_unit :=
  match unit with Inches | SieveNames => Millimetres | _ => unit end.

(* What the size of an opening, known by its power x = opening^d, is read as where it was printed: none for a pan. *)
Definition size_said (unit : size_unit) (d : Z) (x : Q) : option Q :=
  match unit with
  | Phi => if equal x 0 then None else Some (fraction (- exponent_of_two x) d)
  | _ => Some x
  end.

(* A size that can be printed in this unit. *)
Definition plain_size (unit : size_unit) (d : Z) (x : Q) : Prop :=
  match unit with
  | Phi => x = 0%Q \/ exists n, x = power_of_two n /\ short_decimal (fraction (Z.abs n) d)
  | Inches | SieveNames => False
  | _ => short_decimal x
  end.

Lemma exponent_of_power n : exponent_of_two (power_of_two n) = n.
Proof.
  unfold exponent_of_two, power_of_two. destruct (Z.leb_spec 0 n) as [L|L]; cbn [of_integer Qnum Qden].
  - change (1 =? 1) with true. cbv iota. apply Z.log2_pow2, L.
  - rewrite Z2Pos.id by (apply Z.pow_pos_nonneg; lia).
    assert (2 ^ 1 <= 2 ^ (- n)) as P by (apply Z.pow_le_mono_r; lia). change (2 ^ 1) with 2 in P.
    rewrite (proj2 (Z.eqb_neq _ _)) by lia. rewrite Z.log2_pow2 by lia. apply Z.opp_involutive.
Qed.

Lemma power_not_zero n : equal (power_of_two n) 0 = false.
Proof.
  apply Z.eqb_neq. unfold power_of_two. destruct (Z.leb_spec 0 n); cbn [of_integer Qnum Qden]; [|lia].
  pose proof (Z.pow_pos_nonneg 2 n). lia.
Qed.

Lemma fraction_opposite n d : fraction (- n) d = Qopp (fraction n d).
Proof. unfold fraction. rewrite <- Qred_opp. reflexivity. Qed.

(* The text of a phi that is no pan. *)
Lemma phi_shown d n : show_size Phi d (power_of_two n) =
  let magnitude := show_decimal (fraction (Z.abs n) d) in if 0 <? n then String "-" magnitude else magnitude.
Proof. unfold show_size. rewrite power_not_zero, exponent_of_power. reflexivity. Qed.

Lemma size_text unit d x : plain_size unit d x -> field_text (show_size unit d x).
Proof.
  destruct unit; try contradiction; try apply decimal_field. intros [->|(n & -> & S)]; [split; [reflexivity | discriminate]|].
  rewrite phi_shown. destruct (decimal_field _ S) as (E & N). cbv zeta. destruct (0 <? n); [|split; assumption].
  split; [exact E | discriminate].
Qed.

Lemma no_pan w : every of_number w = true -> String.eqb (lower_case w) "pan" = false.
Proof.
  destruct w as [|ch w]; [reflexivity|]. simpl every. intro E. apply andb_prop in E as (C & _).
  destruct ch as [[] [] [] [] [] [] [] []]; try discriminate C; reflexivity.
Qed.

Lemma phi_read d n : short_decimal (fraction (Z.abs n) d) ->
  read_decimal "." (show_size Phi d (power_of_two n)) = Ok (fraction (- n) d).
Proof.
  intro S. rewrite phi_shown. cbv zeta. pose proof (read_decimal_shown _ S) as R.
  destruct (Z.ltb_spec 0 n) as [L|L]; [|rewrite R; do 2 f_equal; lia]. rewrite Z.abs_eq in * by lia.
  rewrite fraction_opposite. apply read_decimal_negative; [|exact R]. destruct S as (P & D & _). apply shown_no_sign; assumption.
Qed.

Lemma size_read unit d point x : known point -> plain_size unit d x ->
  exists point', known point' /\ read_size unit "," point (show_size unit d x) = Ok (size_said unit d x, point').
Proof.
  intros K S. assert (forall y, short_decimal y -> String.eqb (lower_case (show_decimal y)) "pan" = false) as N.
  { intros y (P & D & _). apply no_pan, (decimal_of_number y P D). }
  destruct unit; try contradiction.
  1, 2, 3: destruct (number_read point x K S) as (point' & K' & R); exists point'; split; [exact K'|];
    unfold read_size; cbn [show_size size_said]; rewrite N, R by exact S; reflexivity.
  destruct S as [->|(n & -> & S)]; [exists point; split; [exact K | reflexivity]|].
  destruct (number_text_read point _ _ K (phi_read d n S)) as (point' & K' & R). exists point'. split; [exact K'|].
  unfold read_size, size_said. rewrite R, power_not_zero, exponent_of_power.
  assert (String.eqb (lower_case (show_size Phi d (power_of_two n))) "pan" = false) as ->; [|reflexivity].
  rewrite phi_shown. cbv zeta. destruct (0 <? n); [reflexivity | apply N, S].
Qed.

Lemma opening_said unit d x : 1 <= d -> plain_size unit d x -> opening_of unit d (size_said unit d x) = x.
Proof.
  intros D S. destruct unit; try contradiction; try reflexivity.
  destruct S as [->|(n & -> & _)]; [reflexivity|]. unfold size_said. rewrite power_not_zero, exponent_of_power.
  unfold opening_of, phi_opening. f_equal. unfold fraction.
  pose proof (Qred_correct (- n # Z.to_pos d)) as E. set (phi := Qred (- n # Z.to_pos d)) in *. unfold Qeq in E.
  cbn [Qnum Qden] in E. rewrite Z2Pos.id in E by lia.
  assert (Z.gcd (Qnum phi) (Zpos (Qden phi)) = 1) as G.
  { apply Qred_iff. unfold phi. apply Qred_involutive. }
  assert (Z.divide (Zpos (Qden phi)) d) as (k & K).
  { apply Z.gauss with (Qnum phi); [|rewrite Z.gcd_comm; exact G]. exists (- n). exact E. }
  rewrite K, Z.div_mul by lia. rewrite K in E. nia.
Qed.

(* ---- Rows ---------------------------------------------------------------------------------------------- *)

Definition columns (has_tolerance has_factor : bool) : list further :=
  ((if has_tolerance then [Tolerance] else []) ++ (if has_factor then [Factor] else []))%list.

Definition plain_row (unit : size_unit) (d : Z) (has_tolerance has_factor : bool) (r : row) : Prop :=
  plain_size unit d (opening r) /\ short_decimal (retained r) /\
  (if has_tolerance then short_decimal (tolerance r) else tolerance r = 0%Q) /\
  (if has_factor then short_decimal (factor r) else factor r = 1%Q).

Definition entry_of (unit : size_unit) (d : Z) (r : row) (line : Z) : entry :=
  Entry (size_said unit d (opening r)) (retained r) 0 (factor r) (tolerance r) line.

Definition row_fields (unit : size_unit) (d : Z) (has_tolerance has_factor : bool) (r : row) : list string :=
  ([show_size unit d (opening r); show_decimal (retained r)] ++
   (if has_tolerance then [show_decimal (tolerance r)] else []) ++ (if has_factor then [show_decimal (factor r)] else []))%list.

Lemma mass_row_read unit d t c r : plain_row unit d t c r ->
  row_read (Header unit Masses (columns t c)) (row_fields unit d t c r) (entry_of unit d r).
Proof.
  intros (Px & Pm & Pt & Pc). split; [discriminate| |].
  - intro w. unfold row_fields. rewrite !in_app_iff. intros [[<-|[<-|[]]]|[I|I]].
    + apply size_text, Px.
    + apply decimal_field, Pm.
    + destruct t; [|destruct I]. destruct I as [<-|[]]. apply decimal_field, Pt.
    + destruct c; [|destruct I]. destruct I as [<-|[]]. apply decimal_field, Pc.
  - intros point line K. destruct (size_read unit d point _ K Px) as (p1 & K1 & R1).
    destruct (number_read p1 _ K1 Pm) as (p2 & K2 & R2). unfold read_entry, row_fields, columns, entry_of.
    cbn [app unit_of further_of]. rewrite R1. cbn [bind]. rewrite R2. cbn [bind].
    destruct t, c; cbn [app].
    + destruct (number_read p2 _ K2 Pt) as (p3 & K3 & R3). destruct (number_read p3 _ K3 Pc) as (p4 & K4 & R4).
      exists p4. split; [exact K4|]. cbn [read_further]. rewrite R3. cbn [bind read_further]. rewrite R4. reflexivity.
    + destruct (number_read p2 _ K2 Pt) as (p3 & K3 & R3). exists p3. split; [exact K3|].
      cbn [read_further]. rewrite R3, Pc. reflexivity.
    + destruct (number_read p2 _ K2 Pc) as (p3 & K3 & R3). exists p3. split; [exact K3|].
      cbn [read_further]. rewrite R3, Pt. reflexivity.
    + exists p2. split; [exact K2|]. cbn [read_further]. rewrite Pt, Pc. reflexivity.
Qed.

(* ---- From rows to the gradation ------------------------------------------------------------------------ *)

Section Placed.
Variables (unit : size_unit) (d : Z).

Fixpoint placed (rs : list row) (line : Z) : list placed_row :=
  match rs with r :: rs => (r, entry_of unit d r line) :: placed rs (line + 1) | [] => [] end.

Lemma rows_placed rs : 1 <= d -> (forall r, In r rs -> plain_size unit d (opening r)) -> forall line,
  map (row_of unit d) (entries_from (entry_of unit d) rs line) = placed rs line.
Proof.
  intro D. induction rs as [|r rs IH]; intros P line; [reflexivity|]. cbn [entries_from map placed].
  rewrite IH by (intros x I; apply P; right; exact I). f_equal. unfold row_of, entry_of.
  cbn [size_of value_of factor_of tolerance_of].
  rewrite opening_said by (trivial; apply P; left; reflexivity). destruct r. reflexivity.
Qed.

Lemma placed_rows rs : forall line, map fst (placed rs line) = rs.
Proof. induction rs as [|r rs IH]; intro line; simpl; [reflexivity|]. rewrite IH. reflexivity. Qed.

Lemma placed_sorted rs : forall line, ascending rs = true -> is_sorted finer (placed rs line) = true.
Proof.
  induction rs as [|r [|r' rs] IH]; intros line A; [reflexivity | reflexivity|].
  cbn [ascending] in A. apply andb_prop in A as (L & A). specialize (IH (line + 1) A).
  change (less (opening r) (opening r') && is_sorted finer (placed (r' :: rs) (line + 1)) = true).
  rewrite L, IH. reflexivity.
Qed.

Definition proper_row (r : row) : bool :=
  at_most 0 (opening r) && at_most 0 (retained r) && less 0 (factor r) && at_most 0 (tolerance r).

Lemma rows_checked rs : forall line before, forallb proper_row rs = true -> ascending rs = true ->
  match before, rs with Some x, r :: _ => less x (opening r) = true | _, _ => True end ->
  check_rows before (placed rs line) = Ok tt.
Proof.
  induction rs as [|r rs IH]; intros line before P A B; [reflexivity|].
  simpl forallb in P. apply andb_prop in P as (Pr & P). unfold proper_row in Pr. rewrite !andb_true_iff in Pr.
  destruct Pr as (((P1 & P2) & P3) & P4). cbn [placed check_rows]. unfold demand_at. rewrite P1, P2, P3, P4.
  assert ((match before with Some x => less x (opening r) | None => true end) = true) as -> by (destruct before; auto).
  cbn [bind andb]. apply IH; [exact P | destruct rs; [reflexivity | apply andb_prop in A; apply A]|].
  destruct rs as [|r' rs]; [trivial|]. cbn [ascending] in A. apply andb_prop in A. apply A.
Qed.

Lemma entries_read t c rs line begins :
  file_root unit (entries_from (entry_of unit d) rs line) = Ok d -> well_formed (Gradation rs d t) = true ->
  (forall r, In r rs -> plain_size unit d (opening r)) ->
  gradation_of_entries unit Masses t c begins (entries_from (entry_of unit d) rs line) =
    Ok (Reading (Gradation rs d t) unit c false None None).
Proof.
  intros F W S. pose proof W as W'. unfold well_formed in W'. cbn [rows root] in W'. rewrite !andb_true_iff in W'.
  destruct W' as ((((((D & _) & _) & A) & P) & L) & _). change (forallb proper_row rs = true) in P. apply Z.leb_le in D.
  unfold gradation_of_entries. rewrite F. cbn [bind]. rewrite !map_all_is_map, rows_placed by assumption.
  unfold sorted. rewrite placed_sorted by exact A. rewrite rows_checked by (trivial || exact I). cbn [bind].
  rewrite placed_rows. cbn [rows]. unfold demand_at. rewrite L, W. reflexivity.
Qed.

End Placed.

(* ---- The whole file ------------------------------------------------------------------------------------ *)

(* What is read of the canonical file: sizes are in the unit that they were printed in, a pan that was implied is a row, and
   shares that did not sum to 100 are masses. *)
Definition printed (R : reading) : reading :=
  Reading (gradation_of R) (printed_unit (sizes_in R)) (has_factors R) false None None.

(* Masses, with or without factors and tolerances, of numbers that a reader takes: decimals of at most 1000 digits. The root
   is the one that belongs to the sizes; and the file is no longer than a file may be. *)
Record canonical (R : reading) : Prop := {
  canonical_limits : limits R = None;
  canonical_well_formed : well_formed (gradation_of R) = true;
  canonical_rows : forall r, In r (rows (gradation_of R)) ->
    plain_row (printed_unit (sizes_in R)) (root (gradation_of R)) (has_tolerances (gradation_of R)) (has_factors R) r;
  canonical_root : file_root (printed_unit (sizes_in R))
    (entries_from (entry_of (printed_unit (sizes_in R)) (root (gradation_of R))) (rows (gradation_of R)) 2) = Ok (root (gradation_of R));
  canonical_count : Z.of_nat (List.length (rows (gradation_of R))) <= most_rows;
  canonical_length : text_length (text_of_lines (gradation_lines R)) <= most_text }.

Definition header_line (unit : size_unit) (t c : bool) : string :=
  joined "," ([size_column unit; "mass"] ++ (if t then ["tolerance_percent"] else []) ++ (if c then ["factor"] else [])).

Lemma header_read unit t c :
  every of_csv (header_line unit t c) = true /\ (exists rest, header_line unit t c = String "s" rest) /\
  read_line start (header_line unit t c) 1 = Ok (State "," (Some (Header (printed_unit unit) Masses (columns t c), 1)) None [] 0).
Proof.
  destruct unit, t, c; (split; [reflexivity|]); (split; [eexists; reflexivity | reflexivity]).
Qed.

Lemma size_printed unit d x : show_size (printed_unit unit) d x = show_size unit d x.
Proof. destruct unit; reflexivity. Qed.

Theorem gradation_read R : canonical R -> read_gradation (text_of_lines (gradation_lines R)) = Ok (printed R).
Proof.
  intros [L W P F C Le]. destruct R as [[rs d t] unit c pan sum lim]. unfold printed.
  cbn [sizes_in limits gradation_of has_factors root rows has_tolerances] in *. subst lim.
  assert (gradation_lines (Reading (Gradation rs d t) unit c pan sum None) =
          header_line unit t c :: map (fun r => joined "," (row_fields (printed_unit unit) d t c r)) rs) as G.
  { unfold gradation_lines. cbn [limits sizes_in gradation_of rows has_tolerances has_factors]. rewrite map_all_is_map.
    f_equal. apply map_ext. intro r. unfold row_fields. rewrite size_printed. reflexivity. }
  rewrite G, text_of_lines_with in *. destruct (header_read unit t c) as (Hc & Hs & Hr).
  pose proof W as W'. unfold well_formed in W'. rewrite !andb_true_iff in W'. destruct W' as (((((_ & Two) & _) & _) & _) & _).
  apply Z.leb_le in Two. unfold size in Two. rewrite size_length in Two. cbn [rows Z.add] in Two.
  rewrite (csv_read (Header (printed_unit unit) Masses (columns t c)) _ (entry_of (printed_unit unit) d)); trivial.
  - cbn [unit_of quantity_of].
    assert (has_tolerance (Header (printed_unit unit) Masses (columns t c)) = t /\
            has_factor (Header (printed_unit unit) Masses (columns t c)) = c) as (-> & ->) by (destruct t, c; split; reflexivity).
    apply entries_read; trivial. intros r I. apply (P r I).
  - intros r I. apply mass_row_read, P, I.
Qed.
