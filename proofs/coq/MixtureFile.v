(* The file of a gradation of several materials, read and printed (certificate-format.md, section 14): the CSV of one, with a
   column that names the material of each row. *)

From Coq Require Import ZArith QArith List Bool String Ascii OrderedTypeEx.
From Mdm Require Import Numbers Gradation Certificate Text Decimals Rows Csv GradationFile Mixture.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- The column ---------------------------------------------------------------------------------- *)

Definition material_column : string := "material".

(* Where a field is, with the others. *)
Fixpoint place_of (field : string) (fields : list string) : option (nat * list string) :=
  match fields with
  | f :: fields =>
    if String.eqb f field then Some (O, fields)
    else option_map (fun '(i, others) => (S i, f :: others)) (place_of field fields)
  | [] => None
  end.

(* The i-th field, with the others. *)
Fixpoint taken_out (i : nat) (fields : list string) : option (string * list string) :=
  match i, fields with
  | O, f :: fields => Some (f, fields)
  | S i, f :: fields => option_map (fun '(x, others) => (x, f :: others)) (taken_out i fields)
  | _, [] => None
  end.

Definition is_material (name : string) : bool :=
  let ends_blank w := match w with String ch _ => is_blank ch | EmptyString => true end in
  negb (ends_blank name) && negb (ends_blank (reversed name)) && (string_length name 0 <=? 100).

(* ---- Lines --------------------------------------------------------------------------------------- *)

(* The rows without the column and where it is behind the first two, and the names of the rows, the last first. *)
Record mixed_state := MixedState { rows_read : state; column : nat; names_read : list string }.

Definition read_mixed_header (w : string) (line : Z) : result mixed_state :=
  let delimiter := (if has ";" w then ";" else ",")%char in
  let wrong_columns {A} := wrong (A := A) line "beside a material there is mass or retained_g, and no tolerance: give these" in
  match fields_of delimiter w with
  | Some (size :: second :: others) =>
    match place_of material_column others with
    | Some (i, others) =>
      match header_of (size :: second :: others) with
      | Some h =>
        match quantity_of h, has_tolerance h with
        | Masses, false => Ok (MixedState (State delimiter (Some (h, line)) None [] 0) i [])
        | _, _ => wrong_columns
        end
      | None => wrong_columns
      end
    | None => wrong line "no column material: begin with a header such as size_mm,mass,material"
    end
  | _ => wrong line "no header: begin with one such as size_mm,mass,material"
  end.

Definition read_mixed_row (st : mixed_state) (h : header) (begins : Z) (w : string) (line : Z) : result mixed_state :=
  match fields_of (delimiter_of (rows_read st)) w with
  | Some (size :: value :: others) =>
    match taken_out (column st) others with
    | Some (name, others) =>
      demand_at line (is_material name) "no name of a material: give 1 to 100 bytes without spaces around them" ;;
      let* rows := read_row_line (rows_read st) h begins (size :: value :: others) line in
      Ok (MixedState rows (column st) (name :: names_read st))
    | None => wrong line "another number of fields than in the header: complete the row or quote the delimiter"
    end
  | Some _ => wrong line "another number of fields than in the header: complete the row or quote the delimiter"
  | None => wrong line "a quoted field does not end before the delimiter: close its quotes"
  end.

Definition read_mixed_line (st : mixed_state) (w : string) (line : Z) : result mixed_state :=
  match without_first is_blank w with
  | EmptyString => Ok st
  | String ch behind =>
    if Ascii.eqb ch "#" then let* _ := read_comment (rows_read st) behind line in Ok st
    else
      match header_found (rows_read st) with
      | None => read_mixed_header w line
      | Some (h, begins) => read_mixed_row st h begins w line
      end
  end.

Definition without_return (current : string) : string :=
  match current with String last before => if Ascii.eqb last carriage_return then before else current | EmptyString => current end.

(* [current] is the line that is being read, in reverse. *)
Fixpoint read_mixed_lines (w current : string) (line : Z) (st : mixed_state) : result mixed_state :=
  match w with
  | EmptyString => read_mixed_line st (reversed current) line
  | String ch w =>
    if Ascii.eqb ch line_feed then
      match read_mixed_line st (reversed (without_return current)) line with
      | Ok st => read_mixed_lines w "" (line + 1) st
      | failure => failure
      end
    else read_mixed_lines w (String ch current) line st
  end.

(* ---- Materials ----------------------------------------------------------------------------------- *)

Definition named_row : Type := string * placed_row.

(* By the bytes of the name, then by size. *)
Definition earlier (x y : named_row) : bool :=
  match String_as_OT.cmp (fst x) (fst y) with
  | Lt => true
  | Eq => finer (snd x) (snd y)
  | Gt => false
  end.

(* Rows of one name that follow each other, the last row first, as those of one material. *)
Fixpoint grouped (rs : list named_row) (done : list (string * list placed_row)) : list (string * list placed_row) :=
  match rs with
  | [] => done
  | (name, r) :: rs =>
    grouped rs match done with
      | (name', of_name) :: rest => if String.eqb name name' then (name, r :: of_name) :: rest else (name, [r]) :: done
      | [] => [(name, [r])]
      end
  end.

Fixpoint check_groups (groups : list (string * list placed_row)) : result unit :=
  match groups with
  | [] => Ok tt
  | (_, rs) :: groups =>
    check_rows None rs ;;
    demand_at (last_line rs 0) (equal (retained (last_row (map_all fst rs))) 0) nothing_retained ;;
    check_groups groups
  end.

(* What a file of several materials says. *)
Record mixed_reading := MixedReading { mixture_of : mixture; mixed_sizes : size_unit; mixed_factors : bool }.

Definition mixture_of_rows (h : header) (begins : Z) (names : list string) (es : list entry) : result mixed_reading :=
  let* d := file_root (unit_of h) es in
  let rs := sorted earlier (combine names (map_all (row_of (unit_of h) d) es)) in
  let groups := grouped (rev' rs) [] in
  check_groups groups ;;
  let M := Mixture (map_all (fun '(name, rs) => (name, map_all fst rs)) groups) d in
  demand_at begins (well_formed_mixture M) "nothing is retained of a material: give the masses of at least two sieves of each" ;;
  Ok (MixedReading M (unit_of h) (has_factor h)).

(* ---- Files --------------------------------------------------------------------------------------- *)

Definition read_mixture (file : string) : result mixed_reading :=
  let* st := read_mixed_lines (without_mark file) "" 1 (MixedState start O []) in
  match header_found (rows_read st) with
  | None => wrong 1 "no header: begin with one such as size_mm,mass,material"
  | Some (h, begins) => mixture_of_rows h begins (rev' (names_read st)) (rev' (entries (rows_read st)))
  end.

(* The first line that is neither empty nor a comment. *)
Fixpoint first_line (w current : string) : string :=
  match w with
  | EmptyString => reversed current
  | String ch w =>
    if Ascii.eqb ch line_feed then
      let l := reversed (without_return current) in
      match without_first is_blank l with
      | EmptyString => first_line w ""
      | String mark _ => if Ascii.eqb mark "#" then first_line w "" else l
      end
    else first_line w (String ch current)
  end.

Definition names_materials (file : string) : bool :=
  let header := first_line (without_mark file) "" in
  match fields_of (if has ";" header then ";" else ",")%char header with
  | Some (_ :: _ :: others) => existsb (String.eqb material_column) others
  | _ => false
  end.

(* A gradation of one material, or of several. *)
Inductive any_gradation := One (R : reading) | Several (M : mixed_reading).

Definition read_any_gradation (file : string) : result any_gradation :=
  match read_gradation file with
  | Ok R => Ok (One R)
  | Refused what | Malformed what =>
    if (string_length file 0 <=? most_text) && names_materials file
    then check_text file 0 1 ;; let* M := read_mixture file in Ok (Several M)
    else Malformed what
  end.

(* ---- Canonical CSV ------------------------------------------------------------------------------- *)

(* A field in quotes, those in it doubled. *)
Fixpoint doubled_quotes (w : string) : string :=
  match w with
  | String ch w => if Ascii.eqb ch quote then String ch (String ch (doubled_quotes w)) else String ch (doubled_quotes w)
  | EmptyString => ""
  end.
Definition quoted_field (w : string) : string := String quote (doubled_quotes w ++ String quote "").

Definition mixed_numbers (M : mixed_reading) (r : row) : list string :=
  [show_size (mixed_sizes M) (mixture_root (mixture_of M)) (opening r); show_decimal (retained r)] ++
  (if mixed_factors M then [show_decimal (factor r)] else []).

Definition mixed_rows (M : mixed_reading) : list (list string * string) :=
  flat_map (fun '(name, rs) => map (fun r => (mixed_numbers M r, name)) rs) (materials (mixture_of M)).

Definition mixture_lines (M : mixed_reading) : list string :=
  joined "," ([size_column (mixed_sizes M); "mass"] ++ (if mixed_factors M then ["factor"] else []) ++ [material_column]) ::
  map_all (fun '(numbers, name) => joined "," (numbers ++ [quoted_field name])) (mixed_rows M).
