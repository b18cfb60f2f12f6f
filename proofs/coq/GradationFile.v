(* A gradation file, read and printed (certificate-format.md, section 4). *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Gradation Certificate Text Decimals Rows Csv Json.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

Definition most_text : Z := 2 ^ 26.

Definition read_gradation (file : string) : result reading :=
  demand_form (string_length file 0 <=? most_text) "1: longer than 64 MiB: give the file that was meant" ;;
  check_text file 0 1 ;;
  let w := without_mark file in
  match without_first is_space w with
  | String ch _ => if Ascii.eqb ch "{" then read_json w else read_csv w
  | EmptyString => read_csv w
  end.

(* ---- Canonical CSV --------------------------------------------------------------------------------- *)

(* n where the opening is 2^n. *)
Definition exponent_of_two (opening : Q) : Z :=
  if Zpos (Qden opening) =? 1 then Z.log2 (Qnum opening) else - Z.log2 (Zpos (Qden opening)).

Definition show_size (unit : size_unit) (d : Z) (opening : Q) : string :=
  match unit with
  | Phi =>
    if equal opening 0 then "pan" else
    let n := exponent_of_two opening in
    let magnitude := show_decimal (fraction (Z.abs n) d) in
    if 0 <? n then String "-" magnitude else magnitude
  | _ => show_decimal opening
  end.

Definition size_column (unit : size_unit) : string :=
  match unit with
  | Millimetres | Inches | SieveNames => "size_mm"
  | Micrometres => "size_um"
  | Metres => "size_m"
  | Phi => "size_phi"
  end.

(* Any digits that a reader would not take. *)
Definition is_short (field : string) : bool :=
  let '(all, points) :=
    (string_length field 0, if has "." field then 1 else 0) in
  all - points <=? most_digits_of_file.

Definition show_row (R : reading) (r : row) : string :=
  joined "," ([show_size (sizes_in R) (root (gradation_of R)) (opening r); show_decimal (retained r)] ++
    (if has_tolerances (gradation_of R) then [show_decimal (tolerance r)] else []) ++
    (if has_factors R then [show_decimal (factor r)] else [])).

Definition show_limits (R : reading) (l : Q * Q * Q) : string :=
  let '(x, least, most) := l in joined "," [show_size (sizes_in R) 1 x; show_decimal least; show_decimal most].

Definition gradation_lines (R : reading) : list string :=
  match limits R with
  | Some ls =>
    joined "," [size_column (sizes_in R); "passing_min_percent"; "passing_max_percent"] :: map_all (show_limits R) ls
  | None =>
    joined "," ([size_column (sizes_in R); "mass"] ++
      (if has_tolerances (gradation_of R) then ["tolerance_percent"] else []) ++
      (if has_factors R then ["factor"] else [])) :: map_all (show_row R) (rows (gradation_of R))
  end.
