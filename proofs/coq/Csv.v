(* Gradations in CSV (certificate-format.md, section 4), in one pass over the text. *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Certificate Text Decimals SieveNames Rows.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Fields ---------------------------------------------------------------------------------------- *)

(* Where in a field a place is; [Closing] is behind a quote that another may follow. *)
Inductive place := Before | Bare | InQuotes | Closing | Behind.

(* The fields of a line; none at all if a quote is not closed or something follows it. The field that is being read is in
   reverse, and so are those that are done. *)
Fixpoint split (delimiter : ascii) (w : string) (at_ : place) (field : string) (done : list string)
  : option (list string) :=
  let ended :=
    match at_ with
    | Before => "" | Bare => reversed (without_first is_blank field) | _ => reversed field
    end in
  match w with
  | EmptyString => match at_ with InQuotes => None | _ => Some (rev' (ended :: done)) end
  | String ch w =>
    match at_ with
    | InQuotes =>
      if Ascii.eqb ch quote then split delimiter w Closing field done
      else split delimiter w InQuotes (String ch field) done
    | Closing =>
      if Ascii.eqb ch quote then split delimiter w InQuotes (String ch field) done
      else if Ascii.eqb ch delimiter then split delimiter w Before "" (ended :: done)
      else if is_blank ch then split delimiter w Behind field done
      else None
    | Behind =>
      if Ascii.eqb ch delimiter then split delimiter w Before "" (ended :: done)
      else if is_blank ch then split delimiter w Behind field done
      else None
    | Before =>
      if Ascii.eqb ch delimiter then split delimiter w Before "" (ended :: done)
      else if is_blank ch then split delimiter w Before "" done
      else if Ascii.eqb ch quote then split delimiter w InQuotes "" done
      else split delimiter w Bare (String ch "") done
    | Bare =>
      if Ascii.eqb ch delimiter then split delimiter w Before "" (ended :: done)
      else split delimiter w Bare (String ch field) done
    end
  end.
Definition fields_of (delimiter : ascii) (line : string) : option (list string) := split delimiter line Before "" [].

(* ---- Header -------------------------------------------------------------------------------------- *)

Definition size_units : list (string * size_unit) :=
  [("size_mm", Millimetres); ("size_um", Micrometres); ("size_m", Metres); ("size_in", Inches); ("size_phi", Phi);
   ("sieve", SieveNames)].

Definition quantities : list (string * quantity) :=
  [("mass", Masses); ("retained_g", Masses); ("retained_percent", Retained Percents);
   ("retained_fraction", Retained Fractions); ("cumulative_retained_percent", Cumulative);
   ("passing_percent", Passing Percents); ("passing_fraction", Passing Fractions)].

Inductive further := Tolerance | Factor | MostPercent.

Record header := Header { unit_of : size_unit; quantity_of : quantity; further_of : list further }.

Definition named_one {A} (names : list (string * A)) (name : string) : option A :=
  option_map snd (find (fun entry => String.eqb (fst entry) name) names).

(* At most one of each. *)
Definition further_columns (names : list string) : option (list further) :=
  match names with
  | [] => Some []
  | ["tolerance_percent"] => Some [Tolerance]
  | ["factor"] => Some [Factor]
  | ["tolerance_percent"; "factor"] => Some [Tolerance; Factor]
  | ["factor"; "tolerance_percent"] => Some [Factor; Tolerance]
  | _ => None
  end.

Definition limits_columns : list string := ["passing_min_percent"; "passing_max_percent"].

Definition header_of (names : list string) : option header :=
  match names with
  | size :: second :: others =>
    if list_eq_dec string_dec (second :: others) limits_columns
    then option_map (fun unit => Header unit Limits [MostPercent]) (named_one size_units size)
    else
      match named_one size_units size, named_one quantities second, further_columns others with
      | Some unit, Some what, Some columns => Some (Header unit what columns)
      | _, _, _ => None
      end
  | _ => None
  end.

Definition has_tolerance (h : header) : bool :=
  existsb (fun column => match column with Tolerance => true | _ => false end) (further_of h).
Definition has_factor (h : header) : bool :=
  existsb (fun column => match column with Factor => true | _ => false end) (further_of h).

(* ---- Rows ------------------------------------------------------------------------------------------ *)

(* What is known after some lines: the delimiter, the header and its line, the point that numbers were written with, and
   the rows, the last first. *)
Record state := State {
  delimiter_of : ascii; header_found : option (header * Z); point_of : option ascii; entries : list entry; count_of : Z }.

Definition start : state := State "," None None [] 0.

Definition has (mark : ascii) (w : string) : bool := some (Ascii.eqb mark) w.

(* The point that a number is written with: below a header with semicolons it may be a comma. With it, the point of the
   file after this number. *)
Definition point_for (delimiter : ascii) (known : option ascii) (w : string) : result (ascii * option ascii) :=
  if negb (has "," w || has "." w) then Ok ("."%char, known)
  else
    let point := (if Ascii.eqb delimiter ";" && has "," w then "," else ".")%char in
    demand_form (match known with Some before => Ascii.eqb before point | None => true end)
      "decimal commas and decimal points in one file: write all numbers with the same" ;;
    Ok (point, Some point).

Definition read_number (delimiter : ascii) (known : option ascii) (w : string) : result (Q * option ascii) :=
  let* (point, known) := point_for delimiter known w in
  let* x := read_decimal point w in Ok (x, known).

Definition read_size (unit : size_unit) (delimiter : ascii) (known : option ascii) (field : string)
  : result (option Q * option ascii) :=
  if String.eqb (lower_case field) "pan" then Ok (None, known) else
  match unit with
  | SieveNames =>
    let name := normal_name field in
    let* (point, known) := if is_length name then point_for delimiter known name else Ok ("."%char, known) in
    let* x := sieve_opening name point in Ok (Some x, known)
  | _ => let* (x, known) := read_number delimiter known field in Ok (Some x, known)
  end.

Fixpoint read_further (columns : list further) (fields : list string) (delimiter : ascii) (known : option ascii)
  (e : entry) : result (entry * option ascii) :=
  match columns, fields with
  | [], [] => Ok (e, known)
  | column :: columns, field :: fields =>
    let* (x, known) := read_number delimiter known field in
    let 'Entry size value most factor tolerance line := e in
    read_further columns fields delimiter known
      match column with
      | Tolerance => Entry size value most factor x line
      | Factor => Entry size value most x tolerance line
      | MostPercent => Entry size value x factor tolerance line
      end
  | _, _ => Malformed "another number of fields than in the header: complete the row or quote the delimiter"
  end.

Definition read_entry (h : header) (delimiter : ascii) (known : option ascii) (fields : list string) (line : Z)
  : result (entry * option ascii) :=
  match fields with
  | size :: value :: others =>
    let* (size, known) := read_size (unit_of h) delimiter known size in
    let* (value, known) := read_number delimiter known value in
    read_further (further_of h) others delimiter known (Entry size value 0 1 0 line)
  | _ => Malformed "another number of fields than in the header: complete the row or quote the delimiter"
  end.

(* What is wrong with a line, at its number. *)
Definition on_line {A} (line : Z) (r : result A) : result A :=
  match r with Malformed what => wrong line what | _ => r end.

Definition read_row_line (st : state) (h : header) (begins : Z) (fields : list string) (line : Z) : result state :=
  demand_at line (count_of st <? most_rows) "more than 1048576 rows: give fewer sieves" ;;
  let* (e, point) := on_line line (read_entry h (delimiter_of st) (point_of st) fields line) in
  Ok (State (delimiter_of st) (Some (h, begins)) point (e :: entries st) (count_of st + 1)).

Definition read_header_line (st : state) (w : string) (line : Z) : result state :=
  let delimiter := (if has ";" w then ";" else ",")%char in
  match fields_of delimiter w with
  | None => wrong line "a quoted field does not end before the delimiter: close its quotes"
  | Some names =>
    match header_of names with
    | Some h => Ok (State delimiter (Some (h, line)) None [] 0)
    | None =>
      wrong line (quoted (joined "," names) ++
        " as the header: begin with one such as size_mm,mass (AGS4: give mdm solve --proof's CSV)")
    end
  end.

Definition of_sieves (st : state) : bool :=
  match header_found st with Some (h, _) => match unit_of h with SieveNames => true | _ => false end | None => false end.

(* What is behind the # of a comment may be a sieve where it begins with a digit; below a header of sieves also behind
   blanks. *)
Definition may_be_sieve (below_sieves : bool) (behind : string) : bool :=
  match (if below_sieves then without_first is_blank behind else behind) with
  | String ch _ => is_digit ch
  | EmptyString => false
  end.

Definition read_comment (st : state) (behind : string) (line : Z) : result state :=
  demand_at line (negb (may_be_sieve (of_sieves st) behind))
    "a number behind #, which may be a sieve or a comment: write No. 4 for a sieve, begin a comment with a word" ;;
  Ok st.

Definition read_line (st : state) (w : string) (line : Z) : result state :=
  match without_first is_blank w with
  | EmptyString => Ok st
  | String ch behind =>
    if Ascii.eqb ch "#" then read_comment st behind line else
    match header_found st with
    | None => read_header_line st w line
    | Some (h, begins) =>
      match fields_of (delimiter_of st) w with
      | Some fields => read_row_line st h begins fields line
      | None => wrong line "a quoted field does not end before the delimiter: close its quotes"
      end
    end
  end.

(* [current] is the line that is being read, in reverse; a CR is its last if a LF follows. *)
Fixpoint read_lines (w current : string) (line : Z) (st : state) : result state :=
  match w with
  | EmptyString => read_line st (reversed current) line
  | String ch w =>
    if Ascii.eqb ch line_feed then
      let current :=
        match current with
        | String last before => if Ascii.eqb last carriage_return then before else current
        | EmptyString => current
        end in
      match read_line st (reversed current) line with Ok st => read_lines w "" (line + 1) st | failure => failure end
    else read_lines w (String ch current) line st
  end.

Definition read_csv (w : string) : result reading :=
  let* st := read_lines w "" 1 start in
  match header_found st with
  | None => wrong 1 "no header: begin with one such as size_mm,mass"
  | Some (h, line) =>
    let least := match quantity_of h with Limits => 1 | _ => 2 end in
    demand_at line (least <=? count_of st) "fewer than two rows below a header: give at least two sieves" ;;
    gradation_of_entries (unit_of h) (quantity_of h) (has_tolerance h) (has_factor h) line (rev' (entries st))
  end.
