(* An envelope is read as it is printed: its limits in canonical CSV, and with them the masses in their middle. *)

From Coq Require Import ZArith QArith String Ascii List Bool Lia.
From Mdm Require Import Numbers Gradation Certificate Text Decimals Rows Csv GradationFile NumberTexts CsvRead GradationRead.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Rows ---------------------------------------------------------------------------------------------- *)

Definition short_limit (unit : size_unit) (l : Q * Q * Q) : Prop :=
  let '(x, least, most) := l in plain_size unit 1 x /\ short_decimal least /\ short_decimal most.

Definition limit_entry (unit : size_unit) (l : Q * Q * Q) (line : Z) : entry :=
  let '(x, least, most) := l in Entry (size_said unit 1 x) least most 1 0 line.

Definition limit_fields (unit : size_unit) (l : Q * Q * Q) : list string :=
  let '(x, least, most) := l in [show_size unit 1 x; show_decimal least; show_decimal most].

Lemma limit_row_read unit l : short_limit unit l ->
  row_read (Header unit Limits [MostPercent]) (limit_fields unit l) (limit_entry unit l).
Proof.
  destruct l as ((x, least), most). intros (Px & Pl & Pm). split; [discriminate| |].
  - intros w [<-|[<-|[<-|[]]]]; [apply size_text, Px | apply decimal_field, Pl | apply decimal_field, Pm].
  - intros point line K. destruct (size_read unit 1 point _ K Px) as (p1 & K1 & R1).
    destruct (number_read p1 _ K1 Pl) as (p2 & K2 & R2). destruct (number_read p2 _ K2 Pm) as (p3 & K3 & R3).
    exists p3. split; [exact K3|]. unfold read_entry, limit_fields, limit_entry. cbn [unit_of further_of].
    rewrite R1. cbn [bind]. rewrite R2. cbn [bind read_further]. rewrite R3. reflexivity.
Qed.

(* ---- The whole file ------------------------------------------------------------------------------------ *)

(* What is read of the canonical file: a pan is implied again where it was. *)
Definition printed_envelope (R : reading) : reading :=
  Reading (gradation_of R) (printed_unit (sizes_in R)) (has_factors R) (implied_pan R) None (limits R).

(* What the rows of an envelope make; they stand from the second line of a file on. *)
Definition envelope_of (unit : size_unit) (ls : list (Q * Q * Q)) : result reading :=
  gradation_of_entries unit Limits false false 1 (entries_from (limit_entry unit) ls 2).

(* An envelope of numbers that a reader takes, whose gradation is what its limits make. *)
Record canonical_envelope (R : reading) (ls : list (Q * Q * Q)) : Prop := {
  envelope_limits : limits R = Some ls;
  envelope_rows : forall l, In l ls -> short_limit (printed_unit (sizes_in R)) l;
  envelope_gradation : envelope_of (printed_unit (sizes_in R)) ls = Ok (printed_envelope R);
  envelope_count : Z.of_nat (List.length ls) <= most_rows;
  envelope_length : text_length (text_of_lines (gradation_lines R)) <= most_text }.

Definition envelope_header (unit : size_unit) : string :=
  joined "," [size_column unit; "passing_min_percent"; "passing_max_percent"].

Lemma envelope_header_read unit :
  every of_csv (envelope_header unit) = true /\ (exists rest, envelope_header unit = String "s" rest) /\
  read_line start (envelope_header unit) 1 =
    Ok (State "," (Some (Header (printed_unit unit) Limits [MostPercent], 1)) None [] 0).
Proof. destruct unit; (split; [reflexivity|]); (split; [eexists; reflexivity | reflexivity]). Qed.

Theorem envelope_read R ls :
  canonical_envelope R ls -> read_gradation (text_of_lines (gradation_lines R)) = Ok (printed_envelope R).
Proof.
  intros [L P E C Le].
  assert (gradation_lines R =
          envelope_header (sizes_in R) :: map (fun l => joined "," (limit_fields (printed_unit (sizes_in R)) l)) ls) as G.
  { unfold gradation_lines. rewrite L, map_all_is_map. f_equal. apply map_ext. intros ((x, least), most).
    unfold limit_fields. rewrite size_printed. reflexivity. }
  rewrite G, text_of_lines_with in *. destruct (envelope_header_read (sizes_in R)) as (Hc & Hs & Hr).
  rewrite (csv_read (Header (printed_unit (sizes_in R)) Limits [MostPercent]) _ (limit_entry (printed_unit (sizes_in R)))); trivial.
  - intros l I. apply limit_row_read, P, I.
  - cbn [quantity_of]. destruct ls; [|cbn [List.length]; lia]. exfalso. clear - E. destruct (printed_unit (sizes_in R)); discriminate E.
Qed.
