(* The texts of files and messages, and the decimals in them. In comments, sections are those of
   proofs/certificate-format.md. *)

(** A file that is not what it should be: the place in its text where that shows, and the reason. *)
exception Malformed of int * string

(** A certificate that is well formed, and does not prove its claim. *)
exception Refused of string

let malformed place what = raise (Malformed (place, what))
let demand_form holds place what = if not holds then malformed place what

(** The code point that begins at a place of the text and its length in bytes: 0 if it is no valid UTF-8. *)
let character text place =
  let byte i = if place + i < String.length text then Char.code text.[place + i] else 0 in
  let lead = byte 0 in
  if lead < 0x80 then (lead, 1)
  else
    let bytes = if lead >= 0xF0 then 4 else if lead >= 0xE0 then 3 else 2 in
    let code = ref (lead land (0x7F lsr bytes)) in
    let valid = ref (lead >= 0xC2 && lead <= 0xF4) in
    for i = 1 to bytes - 1 do
      valid := !valid && byte i land 0xC0 = 0x80;
      code := (!code lsl 6) lor (byte i land 0x3F)
    done;
    let overlong = !code < [| 0; 0; 0x80; 0x800; 0x10000 |].(bytes) in
    let surrogate = !code >= 0xD800 && !code <= 0xDFFF in
    if !valid && (not overlong) && (not surrogate) && !code <= 0x10FFFF then (!code, bytes) else (0, 0)

let is_control code = code < 0x20 || (code >= 0x7F && code < 0xA0)

(** Invisible characters, line separators and marks of the direction of writing could make a message lie. *)
let misleads code =
  (code >= 0x200B && code <= 0x200F)
  || (code >= 0x2028 && code <= 0x202E)
  || (code >= 0x2060 && code <= 0x2069)
  || code = 0xFEFF

(** The text cut to so many characters; what is no plain character is escaped as \xNN. *)
let printable ?(most_characters = max_int) text =
  let out = Buffer.create 100 in
  let rec go place characters =
    if place < String.length text then begin
      let code, bytes = character text place in
      let raw = String.sub text place (max bytes 1) in
      let plain = bytes > 0 && (not (is_control code)) && not (misleads code) in
      let characters = characters + if plain then 1 else 4 * String.length raw in
      if characters > most_characters then Buffer.add_string out "..."
      else begin
        if plain then Buffer.add_string out raw
        else String.iter (fun c -> Buffer.add_string out (Printf.sprintf "\\x%02X" (Char.code c))) raw;
        go (place + String.length raw) characters
      end
    end
  in
  go 0 0;
  Buffer.contents out

let quoted text = "'" ^ printable ~most_characters:80 text ^ "'"

(** Demands valid UTF-8 without control characters other than tab, CR and LF. *)
let demand_text text =
  let rec go place =
    if place < String.length text then begin
      let code, bytes = character text place in
      let space = code = 0x09 || code = 0x0A || code = 0x0D in
      demand_form (bytes > 0) place "not valid UTF-8: save the file as UTF-8 text";
      demand_form (space || not (is_control code)) place "a control character: give a text file without them";
      go (place + bytes)
    end
  in
  go 0

let is_digit c = c >= '0' && c <= '9'
let behind text n = String.sub text n (String.length text - n)

let starts_with prefix text =
  String.length text >= String.length prefix && String.sub text 0 (String.length prefix) = prefix

let ends_with suffix text =
  let rest = String.length text - String.length suffix in
  rest >= 0 && behind text rest = suffix

(** The first place from `place` on whose character is (not) in the set, at most `last`. *)
let rec skip set ?(last = max_int) text place =
  if place < min last (String.length text) && set text.[place] then skip set ~last text (place + 1) else place

let is_blank c = c = ' ' || c = '\t'

(** Without spaces and tabs at its ends. *)
let trimmed text =
  let rec last n = if n > 0 && is_blank text.[n - 1] then last (n - 1) else n in
  let first = skip is_blank text 0 and last = last (String.length text) in
  if first >= last then "" else String.sub text first (last - first)

(** The parts of `[+-]? D* [. D*] [(e|E) [+-]? D*]`, of which each may be empty, and the place behind them. *)
type decimal = {
  sign : string; whole : string; point : string; fraction : string;
  e : string; exponent_sign : string; exponent : string; behind : int;
}

let split_decimal text place point =
  let place = ref place in
  let take set most =
    let begins = !place in
    place := skip set ~last:(if most = max_int then most else begins + most) text begins;
    String.sub text begins (!place - begins)
  in
  let is_sign c = c = '+' || c = '-' in
  let sign = take is_sign 1 in
  let whole = take is_digit max_int in
  let point = take (Char.equal point) 1 in
  let fraction = take is_digit (if point = "" then 0 else max_int) in
  let e = take (fun c -> c = 'e' || c = 'E') 1 in
  let exponent_sign = take is_sign (String.length e) in
  let exponent = take is_digit (if e = "" then 0 else max_int) in
  { sign; whole; point; fraction; e; exponent_sign; exponent; behind = !place }

let ten_to n =
  let power = Q.of_bigint (Z.pow (Z.of_int 10) (abs n)) in
  if n < 0 then Q.inv power else power

(** The exact value of a decimal of section 4, whose point is the character `point`. *)
let read_decimal text point place =
  let d = split_decimal text 0 point in
  let digits = d.whole ^ d.fraction in
  if digits = "" || d.behind < String.length text || (d.e = "") <> (d.exponent = "") then
    malformed place (quoted text ^ " is not a number: write a decimal such as 0.075");
  if String.length digits > 1000 then malformed place (quoted text ^ " has more than 1000 digits: shorten it");
  let exponent = ref 0 in
  String.iter (fun c -> exponent := min ((10 * !exponent) + Char.code c - Char.code '0') 401) d.exponent;
  if !exponent > 400 then malformed place (quoted text ^ " has an exponent beyond 400: choose another unit");
  let shift = (if d.exponent_sign = "-" then - !exponent else !exponent) - String.length d.fraction in
  let value = Q.mul (Q.of_bigint (Z.of_string digits)) (ten_to shift) in
  if d.sign = "-" then Q.neg value else value
