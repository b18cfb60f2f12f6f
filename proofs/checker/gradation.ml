(* What both formats of a gradation file demand of their rows (section 4). *)

open Text

(** A row of a CSV file or an element of the arrays of a JSON file, and its place in the file. *)
type row = { size : Q.t; mass : Q.t; factor : Q.t; tolerance : Q.t; place : int }

(** Openings ascending, masses of which the last is 0, factors and, where the file has some, tolerances. *)
type t = { rows : row list; has_tolerances : bool }

let empty_row place = { size = Q.zero; mass = Q.zero; factor = Q.one; tolerance = Q.zero; place }
let most_rows = 1 lsl 20

let demand_row before row =
  let positive x = Q.lt Q.zero x and negative x = Q.lt x Q.zero in
  demand_form (not (negative row.size)) row.place "a negative size: give the opening of the sieve";
  demand_form
    (match before with None -> true | Some finer -> Q.lt finer.size row.size)
    row.place "a size that is there twice or out of order: give each sieve once, sorted";
  demand_form (not (negative row.mass)) row.place
    "a negative mass, or more passes than the next sieve lets through: correct it";
  demand_form
    (positive row.factor && not (negative row.tolerance))
    row.place "a factor or tolerance is too small: give positive factors, tolerances from 0 up"

(** Of at least one row. *)
let complete rows has_tolerances =
  let largest = List.fold_left (fun before row -> demand_row before row; Some row) None rows in
  (match largest with
  | Some row ->
      demand_form (Q.equal row.mass Q.zero) row.place
        "the largest sieve retains something: add one that retains nothing"
  | None -> ());
  demand_form
    (List.exists (fun row -> Q.lt Q.zero row.mass) rows)
    (List.hd rows).place "nothing is retained anywhere: give the masses";
  { rows; has_tolerances }
