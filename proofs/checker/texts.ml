(* Texts as OCaml has them, and as the extracted functions do: lists of characters. *)

let characters text =
  let rec before place found = if place < 0 then found else before (place - 1) (text.[place] :: found) in
  before (String.length text - 1) []

let text_of characters =
  let out = Buffer.create 1000 in
  List.iter (Buffer.add_char out) characters;
  Buffer.contents out

let printable text = text_of (Mdm_checker.printable (characters text))
