(* A sample file, read (certificate-format.md, section 12): sizes, or their powers, each with its number of particles. *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Certificate Text Decimals Rows.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* So many particles of one size: a row of the file. The size is known by its power, see [power_of_sizes]. *)
Record particles := Particles { size_of_each : Q; how_many : Z }.

(* All rows, and which power of the sizes they have, in the unit of the gradation. *)
Record sample_file := SampleFile { power_of_sizes : Z; rows_of_sample : list particles }.

Definition most_line : Z := 2 ^ 20.
Definition most_quantity_digits : Z := 1000.
Definition most_power_of_sizes : Z := 1000000.

(* ---- Lines and fields ------------------------------------------------------------------------------ *)

(* What lies between two line feeds is a line, and a field of it between two commas. The field that is being read is in
   reverse, and so are the line and the lines that are done. *)
Fixpoint split_fields (w field : string) (l : line) (done : lines) : lines :=
  match w with
  | EmptyString => rev' (rev' (reversed field :: l) :: done)
  | String ch w =>
    if Ascii.eqb ch line_feed then split_fields w "" [] (rev' (reversed field :: l) :: done)
    else if Ascii.eqb ch "," then split_fields w "" (reversed field :: l) done
    else split_fields w (String ch field) l done
  end.

(* The bytes of a line, with a comma behind each field. *)
Definition length_of_line (l : line) : Z := fold_left (fun n field => string_length field (n + 1)) l 0.

(* ---- The header ------------------------------------------------------------------------------------- *)

Definition unit_in_mm (w : string) : option Q :=
  if String.eqb w "mm" then Some (of_integer 1)
  else if String.eqb w "um" then Some (Qmake 1 1000)
  else if String.eqb w "m" then Some (of_integer 1000)
  else if String.eqb w "in" then Some (Qmake 127 5)
  else None.

(* The unit of a gradation's openings. *)
Definition gradation_in_mm (unit : size_unit) : Q :=
  match unit with Micrometres => Qmake 1 1000 | Metres => of_integer 1000 | _ => of_integer 1 end.

Definition no_header : string :=
  "no header of a sample that can be checked: mdm verify --proof writes one beside the certificate".
Definition not_of_sizes : string := "ranges of sizes: this checker takes sizes alone: use mdm-check".

(* The unit in mm, the power N, and whether rows have quantities. *)
Record header := Header { in_mm : Q; power_N : Z; has_quantities : bool }.

Definition read_size_column (w : string) : result (Q * Z) :=
  match after_prefix "size_" w with
  | None => Malformed no_header
  | Some w =>
    let (unit, power) := at_mark "^" w in
    match unit_in_mm unit, power with
    | Some mm, None => Ok (mm, 1)
    | Some mm, Some digits =>
      match whole most_digits digits with
      | Some N => demand_form ((2 <=? N) && (N <=? most_power_of_sizes)) "no power from 2 to 1000000: choose another" ;; Ok (mm, N)
      | None => Malformed no_header
      end
    | None, _ => Malformed no_header
    end
  end.

Definition read_header (l : line) : result header :=
  match l with
  | size :: rest =>
    demand_form (match after_prefix "size_lo_" size with None => true | Some _ => false end) not_of_sizes ;;
    let* (mm, N) := read_size_column size in
    match rest with
    | [] => Ok (Header mm N false)
    | [quantity] => demand_form (String.eqb quantity "quantity") no_header ;; Ok (Header mm N true)
    | _ => Malformed no_header
    end
  | [] => Malformed no_header
  end.

(* ---- Rows ------------------------------------------------------------------------------------------- *)

Definition positive_size (line : Z) (x : Q) : result Q :=
  demand_at line (less 0 x) "a size is not above 0: give the sizes of particles" ;; Ok x.

(* A power is an integer or p/q, as in certificates; a size is a decimal, as in gradations. [factor] is of its unit. *)
Definition read_size (h : header) (factor : Q) (line : Z) (w : string) : result Q :=
  if power_N h =? 1 then
    match read_decimal "." w with
    | Ok x => positive_size line (times x factor)
    | Refused what | Malformed what => wrong line what
    end
  else
    match rational w with
    | Some x => positive_size line (times x factor)
    | None => wrong line (quoted w ++ " is no power of a size: write it like 75, or 3/2")
    end.

Definition read_quantity (line : Z) (w : string) : result Z :=
  match whole most_quantity_digits w with
  | Some n => demand_at line (1 <=? n) "a quantity is 0: leave the row out" ;; Ok n
  | None => wrong line (quoted w ++ " is no quantity: write an integer of at most 1000 digits")
  end.

Definition read_row (h : header) (factor : Q) (line : Z) (l : Certificate.line) : result particles :=
  demand_at line (length_of_line l <=? most_line + 1) "longer than 1 MiB: give a sample, a row a line" ;;
  match has_quantities h, l with
  | false, [size] => let* x := read_size h factor line size in Ok (Particles x 1)
  | true, [size; quantity] =>
    let* x := read_size h factor line size in
    let* n := read_quantity line quantity in
    Ok (Particles x n)
  | _, _ => wrong line "the row has not as many fields as the header: give each of them, and no more"
  end.

(* The lines after the header; behind the last line feed is nothing. *)
Fixpoint read_rows (h : header) (factor : Q) (line : Z) (ls : lines) (done : list particles) : result (list particles) :=
  match ls with
  | [] | [[]] => wrong line no_header
  | [rest :: more] =>
    demand_at line (String.eqb rest "" && match more with [] => true | _ => false end)
      "the last line has no end: add it, the file may be cut off" ;;
    demand_at line (match done with [] => false | _ => true end) "there are no particles: give a row of some" ;;
    Ok (rev' done)
  | l :: ls => let* r := read_row h factor line l in read_rows h factor (line + 1) ls (r :: done)
  end.

(* [unit] is that of the gradation. What is wrong begins with the number of its line. *)
Definition read_sample (unit : size_unit) (file : string) : result sample_file :=
  match split_fields file "" [] [] with
  | l :: ls =>
    match (demand_form (length_of_line l <=? most_line + 1) no_header ;; read_header l) with
    | Ok h =>
      let factor := power (over (in_mm h) (gradation_in_mm unit)) (power_N h) in
      let* rows := read_rows h factor 2 ls [] in Ok (SampleFile (power_N h) rows)
    | Refused what | Malformed what => wrong 1 what
    end
  | [] => wrong 1 no_header
  end.
