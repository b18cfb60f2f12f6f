(* Openings of sieves from their names, and from phi (section 4). *)

open Text

(* The tables of section 5: opening in mm, and name. *)
let astm_inches =
  "125 5 | 106 4.24 | 100 4 | 90 3-1/2 | 75 3 | 63 2-1/2 | 53 2.12 | 50 2 | 45 1-3/4 | 37.5 1-1/2 | 31.5 1-1/4 | \
   26.5 1.06 | 25 1 | 22.4 7/8 | 19 3/4 | 16 5/8 | 13.2 0.530 | 12.5 1/2 | 11.2 7/16 | 9.5 3/8 | 8 5/16 | \
   6.7 0.265 | 6.3 1/4"

let astm_numbers =
  "5.6 3-1/2 | 4.75 4 | 4 5 | 3.35 6 | 2.8 7 | 2.36 8 | 2 10 | 1.7 12 | 1.4 14 | 1.18 16 | 1 18 | 0.85 20 | \
   0.71 25 | 0.6 30 | 0.5 35 | 0.425 40 | 0.355 45 | 0.3 50 | 0.25 60 | 0.212 70 | 0.18 80 | 0.15 100 | \
   0.125 120 | 0.106 140 | 0.09 170 | 0.075 200 | 0.063 230 | 0.053 270 | 0.045 325 | 0.038 400 | 0.032 450 | \
   0.025 500 | 0.02 635"

let tyler_numbers =
  "8 2-1/2 | 6.7 3 | 5.6 3-1/2 | 4.75 4 | 4 5 | 3.35 6 | 2.8 7 | 2.36 8 | 2 9 | 1.7 10 | 1.4 12 | 1.18 14 | \
   1 16 | 0.85 20 | 0.71 24 | 0.6 28 | 0.5 32 | 0.425 35 | 0.355 42 | 0.3 48 | 0.25 60 | 0.212 65 | 0.18 80 | \
   0.15 100 | 0.125 115 | 0.106 150 | 0.09 170 | 0.075 200 | 0.063 250 | 0.053 270 | 0.045 325 | 0.038 400"

(** The name of a sieve after the changes of section 4. *)
let normal_name field =
  let out = Buffer.create 20 in
  let gap = ref false in
  let last () = if Buffer.length out = 0 then ' ' else Buffer.nth out (Buffer.length out - 1) in
  let add c =
    match (last (), c) with
    | '\xC2', '\xB5' | '\xCE', '\xBC' ->
        Buffer.truncate out (Buffer.length out - 1);
        Buffer.add_char out 'u'
    | _ -> Buffer.add_char out c
  in
  String.iter
    (fun c ->
      if is_blank c then gap := true
      else begin
        if !gap && is_digit (last ()) && is_digit c then add '-';
        gap := false;
        add c
      end)
    (String.lowercase_ascii field);
  let name = Buffer.contents out in
  let ending = List.find_opt (fun ending -> ends_with ending name) [ "\""; "inches"; "inch"; "in." ] in
  match ending with
  | Some ending -> String.sub name 0 (String.length name - String.length ending) ^ "in"
  | None -> name

type kind = Length of Q.t  (** the unit in mm *) | Table of string

let kinds =
  [ ("", "mm", Length Q.one);
    ("", "um", Length (ten_to (-3)));
    ("", "m", Length (ten_to 3));
    ("no.", "", Table astm_numbers);
    ("no", "", Table astm_numbers);
    ("#", "", Table astm_numbers);
    ("tyler", "mesh", Table tyler_numbers);
    ("tyler", "", Table tyler_numbers);
    ("", "in", Table astm_inches) ]

(** The opening in mm of a sieve's normal name, where a length is written with the decimal `point`. *)
let opening name point place =
  let unknown () = malformed place (quoted name ^ " is no known sieve: write its opening, such as 0.075 mm") in
  let of_entry rest entry =
    match String.split_on_char ' ' (String.trim entry) with
    | [ mm; sieve ] when sieve = rest -> Some (read_decimal mm '.' place)
    | _ -> None
  in
  match List.find_opt (fun (before, after, _) -> starts_with before name && ends_with after name) kinds with
  | None -> unknown ()
  | Some (before, after, kind) -> (
      let length = String.length name - String.length before - String.length after in
      let rest = String.sub name (String.length before) length in
      match kind with
      | Length mm -> Q.mul (read_decimal rest point place) mm
      | Table table -> (
          match List.find_map (of_entry rest) (String.split_on_char '|' table) with
          | Some mm -> mm
          | None -> unknown ()))

(** v within 2^-1001 and 2^1001, rounded to 15 significant digits. *)
let rounded_to_15_digits v =
  let places = 330 and ten = Z.of_int 10 in
  let scaled = Q.mul v (ten_to places) in
  let digits = Z.fdiv (Q.num scaled) (Q.den scaled) in
  let tail = String.length (Z.to_string digits) - 15 in
  let rounded = Z.div (Z.add digits (Z.mul (Z.of_int 5) (Z.pow ten (tail - 1)))) (Z.pow ten tail) in
  Q.mul (Q.of_bigint rounded) (ten_to (tail - places))

(** 2^-phi (mm): exact for an integer, else the nearest decimal of 15 significant digits. *)
let phi_opening phi place =
  demand_form (Q.leq (Q.abs phi) (Q.of_int 1000)) place "a phi beyond 1000: no grain has this size";
  let whole = Z.to_int (Z.fdiv (Q.num phi) (Q.den phi)) in
  let magnitude = Q.of_bigint (Z.shift_left Z.one (abs whole)) in
  let size = if whole < 0 then magnitude else Q.inv magnitude in
  if Q.equal phi (Q.of_int whole) then size
  else
    (* 2^-phi = 2^g * size / 2 with 0 < g < 1, and 2^g = exp(g ln 2) in units of 2^-bits from the series
       ln 2 = sum 2 / ((2n+1) 3^(2n+1)) and exp y = sum y^n / n!, 0 < y < 0.7. Fewer than 2 * bits truncations,
       each of them worth less than 8 units in the end: the value lies in [sum, sum + 16 * bits]. It is
       irrational, so that the two ends round alike when there are enough bits. *)
    let g = Q.sub (Q.of_int (1 + whole)) phi in
    let by n term = Z.div term (Z.of_int n) in
    let rec attempt bits =
      let one = Z.shift_left Z.one bits in
      let rec ln2 n term sum = if Z.sign term = 0 then sum else ln2 (n + 2) (by 9 term) (Z.add sum (by n term)) in
      let y = Z.div (Z.mul (ln2 1 (by 3 (Z.shift_left one 1)) Z.zero) (Q.num g)) (Q.den g) in
      let rec exp n term sum =
        if Z.sign term = 0 then sum else exp (n + 1) (by n (Z.shift_right (Z.mul term y) bits)) (Z.add sum term)
      in
      let sum = exp 1 one Z.zero in
      let rounded n = rounded_to_15_digits (Q.mul size (Q.make n (Z.shift_left one 1))) in
      let least = rounded sum in
      if Q.equal least (rounded (Z.add sum (Z.of_int (16 * bits)))) then least else attempt (2 * bits)
    in
    attempt 128
