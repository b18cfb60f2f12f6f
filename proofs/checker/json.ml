(* Gradations in JSON (section 4), in one pass, with every number from its text. *)

open Text
open Gradation

type input = { text : string; mutable place : int; mutable depth : int }

let fail input what = malformed input.place what
let demand_here input holds what = demand_form holds input.place what

(** The next character that is no white space; NUL, which no gradation holds, at the end. *)
let peek input =
  input.place <- skip (fun c -> is_blank c || c = '\r' || c = '\n') input.text input.place;
  if input.place < String.length input.text then input.text.[input.place] else '\000'

let next input =
  if input.place >= String.length input.text then '\000'
  else begin
    input.place <- input.place + 1;
    input.text.[input.place - 1]
  end

let take input c =
  let yes = peek input = c in
  if yes then input.place <- input.place + 1;
  yes

let rest input most = String.sub input.text input.place (min most (String.length input.text - input.place))

let demand input c =
  if not (take input c) then
    fail input (Printf.sprintf "%s in the JSON, where '%c' belongs: put it there" (quoted (rest input 81)) c)

(** Calls element at each element of an array, or of what else has commas between two brackets. *)
let sequence input opens closes element =
  input.depth <- input.depth + 1;
  demand_here input (input.depth <= 64) "JSON nested more than 64 deep: flatten it";
  demand input opens;
  if not (take input closes) then begin
    element ();
    while take input ',' do element () done;
    demand input closes
  end;
  input.depth <- input.depth - 1

let hexadecimal c =
  match c with
  | '0' .. '9' -> Some (Char.code c - Char.code '0')
  | 'a' .. 'f' -> Some (Char.code c - Char.code 'a' + 10)
  | 'A' .. 'F' -> Some (Char.code c - Char.code 'A' + 10)
  | _ -> None

let code_unit input =
  let unit = ref 0 in
  for i = 0 to 3 do
    match hexadecimal (if input.place + i < String.length input.text then input.text.[input.place + i] else ' ') with
    | Some value -> unit := (16 * !unit) + value
    | None -> fail input "\\u needs four hexadecimal digits: write them"
  done;
  input.place <- input.place + 4;
  !unit

let escape input out =
  match next input with
  | ('"' | '\\' | '/') as c -> Buffer.add_char out c
  | 'b' -> Buffer.add_char out '\b'
  | 'f' -> Buffer.add_char out '\012'
  | 'n' -> Buffer.add_char out '\n'
  | 'r' -> Buffer.add_char out '\r'
  | 't' -> Buffer.add_char out '\t'
  | 'u' ->
      let high = code_unit input in
      let is_pair = high >= 0xD800 && high < 0xDC00 && next input = '\\' && next input = 'u' in
      let low = if is_pair then code_unit input else 0 in
      let is_low = low >= 0xDC00 && low < 0xE000 in
      let code = if is_low then 0x10000 + ((high - 0xD800) * 0x400) + (low - 0xDC00) else high in
      demand_here input (code < 0xD800 || code >= 0xE000) "half a surrogate pair: write the character itself";
      Buffer.add_utf_8_uchar out (Uchar.of_int code)
  | _ -> fail input "an unknown escape in a string of the JSON: write \\\\ for a backslash"

let string input =
  demand input '"';
  let out = Buffer.create 20 in
  let rec go () =
    let c = next input in
    demand_here input (Char.code c >= 0x20) "a string of the JSON is not closed: close it";
    if c = '\\' then (escape input out; go ()) else if c <> '"' then (Buffer.add_char out c; go ())
  in
  go ();
  Buffer.contents out

(** Calls member at each key, before its value. *)
let json_object input member =
  let keys = Hashtbl.create 10 in
  sequence input '{' '}' (fun () ->
      let key = string input in
      if Hashtbl.mem keys key then fail input ("key " ^ quoted key ^ " is twice in an object: drop one");
      Hashtbl.add keys key ();
      demand input ':';
      member key)

(** The text of a number as JSON writes it. *)
let number input =
  ignore (peek input);
  let d = split_decimal input.text input.place '.' in
  if
    d.sign = "+" || d.whole = ""
    || (String.length d.whole > 1 && d.whole.[0] = '0')
    || (d.point = "") <> (d.fraction = "")
    || (d.e = "") <> (d.exponent = "")
  then fail input (quoted (rest input 81) ^ " is no value of JSON: write a string or a number");
  let written = String.sub input.text input.place (d.behind - input.place) in
  input.place <- d.behind;
  written

let rec skip_value input =
  let word text =
    String.iter
      (fun c -> demand_here input (next input = c) "an unknown word in the JSON: write true, false or null")
      text
  in
  match peek input with
  | '{' -> json_object input (fun _ -> skip_value input)
  | '[' -> sequence input '[' ']' (fun () -> skip_value input)
  | '"' -> ignore (string input)
  | 't' -> word "true"
  | 'f' -> word "false"
  | 'n' -> word "null"
  | _ -> ignore (number input)

let range = Q.of_bigint (Z.shift_left Z.one 1024)

(** A string that holds a decimal, or a number. *)
let decimal input =
  if peek input = '"' then
    let text = string input in
    read_decimal text '.' input.place
  else
    let place = input.place in
    let value = read_decimal (number input) '.' place in
    demand_form
      (Q.lt value range && Q.lt (Q.neg range) value)
      place "beyond the range of JSON numbers: write it as a string";
    value

(** The decimals of an array, and the place behind each. *)
let decimals input =
  let found = ref [] and count = ref 0 in
  sequence input '[' ']' (fun () ->
      demand_here input (!count < most_rows) "more than 1048576 numbers: give fewer sieves";
      incr count;
      let value = decimal input in
      found := (value, input.place) :: !found);
  Array.of_list (List.rev !found)

let read text begins =
  let input = { text; place = begins; depth = 0 } in
  let columns = Hashtbl.create 4 and unit = ref Q.one in
  json_object input (fun key ->
      match key with
      | "sizes" | "masses" | "factors" | "tolerances_percent" -> Hashtbl.add columns key (decimals input)
      | "unit" ->
          let name = string input in
          demand_here input (List.mem name [ "mm"; "um"; "m"; "in" ]) "an unknown unit: write mm, um, m or in";
          if name = "in" then unit := Q.of_ints 127 5
      | "id" when peek input <> '"' -> ignore (number input)
      | _ -> skip_value input);
  demand_here input (peek input = '\000') "something follows the JSON object: give one object";
  let column key = match Hashtbl.find_opt columns key with Some values -> values | None -> [||] in
  let longest = Hashtbl.fold (fun _ values length -> max length (Array.length values)) columns 0 in
  List.iter
    (fun key ->
      let values = column key and is_optional = key <> "masses" && key <> "sizes" in
      if (Array.length values <> longest || longest < 2) && not (is_optional && not (Hashtbl.mem columns key)) then
        fail input ("\"" ^ key ^ "\" has not one number for each of at least two sizes: give them"))
    [ "factors"; "masses"; "sizes"; "tolerances_percent" ];
  let value key i default = if Hashtbl.mem columns key then fst (column key).(i) else default in
  let row i =
    let size, place = (column "sizes").(i) in
    { size = Q.mul size !unit; mass = value "masses" i Q.zero; place;
      factor = value "factors" i Q.one; tolerance = value "tolerances_percent" i Q.zero }
  in
  let rows = List.rev (List.rev_map row (List.init longest Fun.id)) in
  let descends = match rows with first :: second :: _ -> Q.lt second.size first.size | _ -> false in
  complete (if descends then List.rev rows else rows) (Hashtbl.mem columns "tolerances_percent")
