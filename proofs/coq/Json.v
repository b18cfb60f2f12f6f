(* Gradations in JSON (certificate-format.md, section 4), in one pass over the text, every number from its digits. *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Certificate Text Decimals Rows.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Tokens ---------------------------------------------------------------------------------------- *)

(* One of { } [ ] : and comma; a string without its escapes; anything else between those. *)
Inductive token := Mark (ch : ascii) | Quoted (w : string) | Plain (w : string).

(* Where in the text a place is. Strings and words are in reverse. A string may end in the first half of a surrogate pair
   (0: it does not), and four digits of \u have [digits] to come after the value. *)
Inductive place :=
| Between
| InWord (w : string)
| InString (w : string) (high : Z)
| Escape (w : string) (high : Z)
| Unicode (w : string) (high value : Z) (digits : nat).

Definition hexadecimal_digit (ch : ascii) : option Z :=
  if is_digit ch then Some (code ch - 48)
  else if between "a" "f" ch then Some (code ch - 87)
  else if between "A" "F" ch then Some (code ch - 55)
  else None.

(* The bytes of a code point in UTF-8, in reverse, before what is done. *)
Definition with_code_point (n : Z) (done : string) : string :=
  let tail (n : Z) := of_code (128 + n mod 64) in
  if n <? 128 then String (of_code n) done
  else if n <? 2048 then String (tail n) (String (of_code (192 + n / 64)) done)
  else if n <? 65536 then
    String (tail n) (String (tail (n / 64)) (String (of_code (224 + n / 4096)) done))
  else
    String (tail n) (String (tail (n / 64)) (String (tail (n / 4096)) (String (of_code (240 + n / 262144)) done))).

Definition escaped_character (ch : ascii) : option ascii :=
  if Ascii.eqb ch quote || Ascii.eqb ch backslash || Ascii.eqb ch "/" then Some ch
  else if Ascii.eqb ch "b" then Some "008"%char
  else if Ascii.eqb ch "f" then Some "012"%char
  else if Ascii.eqb ch "n" then Some line_feed
  else if Ascii.eqb ch "r" then Some carriage_return
  else if Ascii.eqb ch "t" then Some tab
  else None.

Definition half_a_pair : string := "half a surrogate pair: write the character itself".

(* The string after all four digits of \u. *)
Definition after_unicode (w : string) (high value : Z) : result place :=
  let within lo hi := (lo <=? value) && (value <=? hi) in
  if high =? 0 then
    if within 55296 56319 then Ok (InString w value)
    else demand_form (negb (within 56320 57343)) half_a_pair ;; Ok (InString (with_code_point value w) 0)
  else
    demand_form (within 56320 57343) half_a_pair ;;
    Ok (InString (with_code_point (65536 + (high - 55296) * 1024 + (value - 56320)) w) 0).

Definition is_mark (ch : ascii) : bool := one_of ch "{}[]:,".

(* A character of the text: the place behind it, and the tokens that it ends. *)
Definition next_place (at_ : place) (ch : ascii) : result (place * list token) :=
  match at_ with
  | Between =>
    if is_space ch then Ok (Between, [])
    else if is_mark ch then Ok (Between, [Mark ch])
    else if Ascii.eqb ch quote then Ok (InString "" 0, [])
    else Ok (InWord (String ch ""), [])
  | InWord w =>
    if is_space ch then Ok (Between, [Plain (reversed w)])
    else if is_mark ch then Ok (Between, [Plain (reversed w); Mark ch])
    else if Ascii.eqb ch quote then Malformed "a string of the JSON begins within a word: put a comma before it"
    else Ok (InWord (String ch w), [])
  | InString w high =>
    demand_form (32 <=? code ch) "a string of the JSON is not closed: close it" ;;
    if Ascii.eqb ch backslash then Ok (Escape w high, [])
    else
      demand_form (high =? 0) half_a_pair ;;
      Ok (if Ascii.eqb ch quote then (Between, [Quoted (reversed w)]) else (InString (String ch w) 0, []))
  | Escape w high =>
    if Ascii.eqb ch "u" then Ok (Unicode w high 0 3, [])
    else
      demand_form (high =? 0) half_a_pair ;;
      match escaped_character ch with
      | Some ch => Ok (InString (String ch w) 0, [])
      | None => Malformed "an unknown escape in a string of the JSON: write \\ for a backslash"
      end
  | Unicode w high value digits =>
    match hexadecimal_digit ch with
    | None => Malformed "\u needs four hexadecimal digits: write them"
    | Some d =>
      match digits with
      | S digits => Ok (Unicode w high (16 * value + d) digits, [])
      | O => let* at_ := after_unicode w high (16 * value + d) in Ok (at_, [])
      end
    end
  end.

(* ---- Numbers ---------------------------------------------------------------------------------------- *)

Fixpoint without_digits (w : string) : string :=
  match w with String ch rest => if is_digit ch then without_digits rest else w | EmptyString => w end.

(* What follows one digit or more. *)
Definition behind_digits (w : string) : option string :=
  match w with String ch rest => if is_digit ch then Some (without_digits rest) else None | EmptyString => None end.

Definition is_exponent (w : string) : bool :=
  match w with
  | EmptyString => true
  | String ch rest =>
    (Ascii.eqb ch "e" || Ascii.eqb ch "E") &&
    match behind_digits (snd (signed rest)) with Some w => String.eqb w "" | None => false end
  end.

(* -? (0 | 1..9 D* ) [. D+] [(e|E) [+-]? D+] *)
Definition is_json_number (w : string) : bool :=
  let unsigned := match w with String ch rest => if Ascii.eqb ch "-" then rest else w | EmptyString => w end in
  match behind_digits unsigned with
  | None => false
  | Some rest =>
    (match unsigned with
     | String zero (String ch _) => negb (Ascii.eqb zero "0" && is_digit ch)
     | _ => true
     end) &&
    match rest with
    | String ch places =>
      if Ascii.eqb ch "." then match behind_digits places with Some w => is_exponent w | None => false end
      else is_exponent rest
    | EmptyString => true
    end
  end.

Definition range : Q := of_integer (2 ^ 1024).

Definition json_number (w : string) : result Q :=
  if negb (is_json_number w) then Malformed (quoted w ++ " is no value of JSON: write a string or a number") else
  let* x := read_decimal "." w in
  demand_form (less x range && less (Qopp range) x) "beyond the range of JSON numbers: write it as a string" ;;
  Ok x.

(* ---- The object -------------------------------------------------------------------------------------- *)

Inductive column := Sizes | MassesOf | Factors | Tolerances.
Inductive member := Id | Unit | Column (which : column).

Definition members : list (string * member) :=
  [("id", Id); ("unit", Unit); ("sizes", Column Sizes); ("masses", Column MassesOf); ("factors", Column Factors);
   ("tolerances_percent", Column Tolerances)].

Definition json_units : list (string * size_unit) :=
  [("mm", Millimetres); ("um", Micrometres); ("m", Metres); ("in", Inches)].

Inductive expected :=
| Opening                           (* { *)
| KeyOrEnd                          (* after { *)
| Key                               (* after a comma *)
| Colon (of : member)
| Value (of : member)
| CommaOrEnd                        (* after a value *)
| NumberOrEnd (of : column)         (* after [ *)
| Number (of : column)
| CommaOrClose (of : column)
| Nothing.

(* The members so far; the numbers of the array that is being read, the last first, with their count. *)
Record state := State {
  next : expected; seen : list string; unit_of : size_unit; numbers_of : list Q; count_of : Z;
  sizes : option (list Q); masses : option (list Q); factors : option (list Q); tolerances : option (list Q) }.

Definition start : state := State Opening [] Millimetres [] 0 None None None None.

Definition then_ (st : state) (next : expected) : state :=
  let 'State _ seen unit numbers count sizes masses factors tolerances := st in
  State next seen unit numbers count sizes masses factors tolerances.

Definition with_key (st : state) (key : string) : result state :=
  let 'State _ seen unit numbers count sizes masses factors tolerances := st in
  match find (fun entry => String.eqb (fst entry) key) members with
  | None =>
    Malformed ("an unknown key " ++ quoted key ++ ": the keys are id, unit, sizes, masses, factors and tolerances_percent")
  | Some (_, m) =>
    demand_form (negb (existsb (String.eqb key) seen)) ("key " ++ quoted key ++ " is twice in an object: drop one") ;;
    Ok (State (Colon m) (key :: seen) unit numbers count sizes masses factors tolerances)
  end.

Definition with_unit (st : state) (name : string) : result state :=
  let 'State _ seen _ numbers count sizes masses factors tolerances := st in
  match find (fun entry => String.eqb (fst entry) name) json_units with
  | Some (_, unit) => Ok (State CommaOrEnd seen unit numbers count sizes masses factors tolerances)
  | None => Malformed "an unknown unit: write mm, um, m or in"
  end.

Definition with_number (st : state) (of : column) (x : Q) : result state :=
  let 'State _ seen unit numbers count sizes masses factors tolerances := st in
  demand_form (count <? most_rows) "more than 1048576 numbers: give fewer sieves" ;;
  Ok (State (CommaOrClose of) seen unit (x :: numbers) (count + 1) sizes masses factors tolerances).

Definition with_column (st : state) (of : column) : state :=
  let 'State _ seen unit numbers _ sizes masses factors tolerances := st in
  let found := Some (rev' numbers) in
  match of with
  | Sizes => State CommaOrEnd seen unit [] 0 found masses factors tolerances
  | MassesOf => State CommaOrEnd seen unit [] 0 sizes found factors tolerances
  | Factors => State CommaOrEnd seen unit [] 0 sizes masses found tolerances
  | Tolerances => State CommaOrEnd seen unit [] 0 sizes masses factors found
  end.

Definition is_the (mark : ascii) (t : token) : bool := match t with Mark ch => Ascii.eqb ch mark | _ => false end.

Definition missing {A} (what : string) : result A := Malformed (what ++ " is missing in the JSON: put it there").

Definition read_value (t : token) : result Q :=
  match t with
  | Quoted w => read_decimal "." w
  | Plain w => json_number w
  | Mark _ => missing "a number"
  end.

Definition read_token (st : state) (t : token) : result state :=
  match next st with
  | Opening => if is_the "{" t then Ok (then_ st KeyOrEnd) else missing "'{'"
  | KeyOrEnd =>
    match t with
    | Quoted key => with_key st key
    | _ => if is_the "}" t then Ok (then_ st Nothing) else missing "a key"
    end
  | Key => match t with Quoted key => with_key st key | _ => missing "a key" end
  | Colon of => if is_the ":" t then Ok (then_ st (Value of)) else missing "':'"
  | Value Id =>
    match t with
    | Quoted _ => Ok (then_ st CommaOrEnd)
    | Plain w => json_number w ;; Ok (then_ st CommaOrEnd)
    | Mark _ => missing "the id"
    end
  | Value Unit => match t with Quoted name => with_unit st name | _ => missing "the unit, a string," end
  | Value (Column of) => if is_the "[" t then Ok (then_ st (NumberOrEnd of)) else missing "'['"
  | CommaOrEnd =>
    if is_the "," t then Ok (then_ st Key) else if is_the "}" t then Ok (then_ st Nothing) else missing "',' or '}'"
  | NumberOrEnd of =>
    if is_the "]" t then Ok (with_column st of) else let* x := read_value t in with_number st of x
  | Number of => let* x := read_value t in with_number st of x
  | CommaOrClose of =>
    if is_the "," t then Ok (then_ st (Number of))
    else if is_the "]" t then Ok (with_column st of) else missing "',' or ']'"
  | Nothing => Malformed "something follows the JSON object: give one object"
  end.

(* A character may end two tokens. *)
Definition read_tokens (st : state) (ts : list token) : result state :=
  match ts with
  | [] => Ok st
  | [t] => read_token st t
  | t :: t' :: _ => let* st := read_token st t in read_token st t'
  end.

Definition read_character (at_ : place) (st : state) (ch : ascii) : result (place * state) :=
  let* (at_, ts) := next_place at_ ch in
  match ts with [] => Ok (at_, st) | _ => let* st := read_tokens st ts in Ok (at_, st) end.

Fixpoint read_characters (w : string) (at_ : place) (line : Z) (st : state) : result (place * state) :=
  match w with
  | EmptyString => Ok (at_, st)
  | String ch w =>
    match read_character at_ st ch with
    | Ok (at_, st) => read_characters w at_ (if Ascii.eqb ch line_feed then line + 1 else line) st
    | Refused what | Malformed what => wrong line what
    end
  end.

(* ---- The gradation ----------------------------------------------------------------------------------- *)

(* A column that is not there has none of its numbers in any row. *)
Fixpoint zipped (sizes masses : list Q) (factors tolerances : option (list Q)) (done : list entry) : option (list entry) :=
  let rest (column : option (list Q)) (default : Q) :=
    match column with
    | None => Some (default, None)
    | Some (x :: xs) => Some (x, Some xs)
    | Some [] => None
    end in
  let ended (column : option (list Q)) := match column with None | Some [] => true | _ => false end in
  match sizes, masses with
  | [], [] => if ended factors && ended tolerances then Some (rev' done) else None
  | x :: sizes, m :: masses =>
    match rest factors 1%Q, rest tolerances 0%Q with
    | Some (c, factors), Some (e, tolerances) =>
      zipped sizes masses factors tolerances (Entry (Some x) m 0 c e 1 :: done)
    | _, _ => None
    end
  | _, _ => None
  end.

Definition is_there {A} (column : option A) : bool := match column with Some _ => true | None => false end.

(* Sizes ascend or descend; in any other order they are malformed, where those of CSV are sorted. *)
Definition one_way (sizes : list Q) : bool :=
  is_sorted less sizes || is_sorted less (rev' sizes).

Definition read_json (w : string) : result reading :=
  let* (at_, st) := read_characters w Between 1 start in
  demand_at 1 (match at_, next st with Between, Nothing => true | _, _ => false end)
    "the JSON object does not end, or something follows it: give one object" ;;
  match sizes st, masses st with
  | Some xs, Some ms =>
    demand_at 1 (one_way xs) "sizes that neither ascend nor descend: sort them, each once" ;;
    match zipped xs ms (factors st) (tolerances st) [] with
    | Some es => gradation_of_entries (unit_of st) Masses (is_there (tolerances st)) (is_there (factors st)) 1 es
    | None => wrong 1 "not one number for each size in masses, factors or tolerances_percent: give them"
    end
  | _, _ => wrong 1 "no sizes or no masses: give both"
  end.
