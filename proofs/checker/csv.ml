(* Gradations in CSV (section 4). *)

open Text
open Gradation

(** The fields of a line; none at all if a quote is not closed or something follows it. *)
let split line delimiter =
  let length = String.length line in
  let rec fields place found =
    let begins = skip is_blank line place in
    let quotes = begins < length && line.[begins] = '"' in
    let field = Buffer.create 20 in
    let rec quoted_end place =
      if place >= length then None
      else if line.[place] <> '"' then (Buffer.add_char field line.[place]; quoted_end (place + 1))
      else if place + 1 < length && line.[place + 1] = '"' then (Buffer.add_char field '"'; quoted_end (place + 2))
      else Some (place + 1)
    in
    match if quotes then quoted_end (begins + 1) else Some begins with
    | None -> [||]
    | Some rest ->
        let ends = skip (fun c -> c <> delimiter) line rest in
        let bare = trimmed (String.sub line rest (ends - rest)) in
        if quotes && bare <> "" then [||]
        else
          let found = (if quotes then Buffer.contents field else bare) :: found in
          if ends < length then fields (ends + 1) found else Array.of_list (List.rev found)
  in
  fields 0 []

let first_names = [ "size_mm"; "size_um"; "size_m"; "size_in"; "size_phi"; "sieve" ]

let second_names =
  [ "mass"; "retained_g"; "retained_percent"; "retained_fraction"; "cumulative_retained_percent";
    "passing_percent"; "passing_fraction" ]

let other_names = [ "tolerance_percent"; "factor" ]

let demand_header fields place =
  for i = 0 to max (Array.length fields) 2 - 1 do
    let allowed = if i = 0 then first_names else if i = 1 then second_names else other_names in
    let name = if i < Array.length fields then fields.(i) else "" in
    let same = List.filter (String.equal name) (Array.to_list fields) in
    if (not (List.mem name allowed)) || List.length same > 1 then
      malformed place
        (Printf.sprintf
           "%s as the name of column %d: begin with a header such as size_mm,mass (AGS4: give mdm solve --proof's CSV)"
           (quoted name) (i + 1))
  done

(** `#200`, `# 3-1/2` begins a row of a table of sieves, where any other # begins a comment. *)
let is_sieve_number field =
  starts_with "#" field
  && skip (fun c -> is_digit c || String.contains "-/. " c) field 1 = String.length field
  && skip (fun c -> not (is_digit c)) field 1 < String.length field

type state = {
  mutable header : string array;
  mutable rows : row list;  (** the last first *)
  mutable count : int;
  mutable delimiter : char;
  mutable point : char option;  (** of the numbers so far *)
}

(** The point that a number is written with: where the delimiter is a semicolon, it may be a comma. *)
let point state number place =
  if not (String.contains number ',' || String.contains number '.') then '.'
  else begin
    let point = if state.delimiter = ';' && String.contains number ',' then ',' else '.' in
    demand_form
      (match state.point with None -> true | Some before -> before = point)
      place "decimal commas and decimal points in one file: write all numbers with the same";
    state.point <- Some point;
    point
  end

let number state field place = read_decimal field (point state field place) place

let size state field place =
  let kind = state.header.(0) in
  if String.lowercase_ascii field = "pan" then Q.zero
  else if kind = "sieve" then
    (* Only a length in mm, um or m is a number; the other names have texts of the tables. *)
    let name = Sieve.normal_name field in
    Sieve.opening name (if ends_with "m" name then point state name place else '.') place
  else
    let value = number state field place in
    match kind with
    | "size_phi" -> Sieve.phi_opening value place
    | "size_in" -> Q.mul value (Q.of_ints 127 5)
    | _ -> value

let read_row state fields place =
  if Array.length fields <> Array.length state.header then
    malformed place
      (Printf.sprintf "%d fields below a header of %d: complete the row or quote the delimiter" (Array.length fields)
         (Array.length state.header));
  demand_form (state.count < most_rows) place "more than 1048576 rows: give fewer sieves";
  let size = size state fields.(0) place in
  let row = ref { (empty_row place) with size; mass = number state fields.(1) place } in
  for i = 2 to Array.length fields - 1 do
    let value = number state fields.(i) place in
    row := if state.header.(i) = "factor" then { !row with factor = value } else { !row with tolerance = value }
  done;
  state.rows <- !row :: state.rows;
  state.count <- state.count + 1

let read_line state line place =
  let bare = trimmed line in
  let has_header = state.header <> [||] in
  let comment = starts_with "#" bare in
  if bare <> "" && not (comment && not (has_header && state.header.(0) = "sieve")) then begin
    if (not has_header) && String.contains line ';' then state.delimiter <- ';';
    let fields = split line state.delimiter in
    let is_row () = Array.length fields = Array.length state.header && is_sieve_number fields.(0) in
    if (not comment) || is_row () then begin
      demand_form (fields <> [||]) place "a quoted field does not end before the delimiter: close its quotes";
      if has_header then read_row state fields place
      else begin
        demand_header fields place;
        state.header <- fields
      end
    end
  end

(** Turns what passes, ascending by size, into masses. Where it descends a mass becomes negative: with the last
    of them full and the first not negative, none is out of bounds otherwise. *)
let passing_to_masses rows full has_factors =
  let finest = List.hd rows in
  let rec masses = function
    | row :: (coarser :: _ as rest) -> { row with mass = Q.sub coarser.mass row.mass } :: masses rest
    | [ row ] ->
        demand_form (Q.equal row.mass full) row.place
          "the largest sieve retains something: add one that retains nothing";
        [ { row with mass = Q.zero } ]
    | [] -> []
  in
  demand_form (not (Q.lt finest.mass Q.zero)) finest.place
    "less than nothing passes here: correct it";
  if Q.equal finest.mass Q.zero then masses rows
  else begin
    demand_form
      (Q.lt Q.zero finest.size && not has_factors)
      finest.place "something passes the finest sieve: add a row of the pan where nothing does";
    masses (empty_row finest.place :: rows)
  end

let read text begins =
  let state = { header = [||]; rows = []; count = 0; delimiter = ','; point = None } in
  let rec lines place =
    if place < String.length text then begin
      let ends = skip (fun c -> c <> '\n') text place in
      let line = String.sub text place (ends - place) in
      let has_cr = ends < String.length text && ends_with "\r" line in
      read_line state (if has_cr then String.sub line 0 (String.length line - 1) else line) place;
      lines (ends + 1)
    end
  in
  lines begins;
  demand_form (state.count >= 2) begins "fewer than two rows below a header: give at least two sieves";
  let rows = List.stable_sort (fun x y -> Q.compare x.size y.size) (List.rev state.rows) in
  let kind = state.header.(1) and has name = Array.mem name state.header in
  let full = Q.of_int (if kind = "passing_fraction" then 1 else 100) in
  let rows =
    if starts_with "cumulative_" kind then
      List.rev (List.rev_map (fun row -> { row with mass = Q.sub full row.mass }) rows)
    else rows
  in
  let is_passing = starts_with "passing_" kind || starts_with "cumulative_" kind in
  complete (if is_passing then passing_to_masses rows full (has "factor") else rows) (has "tolerance_percent")
