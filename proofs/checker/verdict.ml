(* Judges a certificate against a gradation: reads the gradation file, hands it and the words of the certificate
   to the checker that is proved correct (proofs/coq), and says what came of it. *)

open Text

type t = Accepted of string | Refused of string | Malformed of string

let read_gradation text =
  demand_text text;
  let begins = if starts_with "\xEF\xBB\xBF" text then 3 else 0 in
  let first = skip (fun c -> is_blank c || c = '\r' || c = '\n') text begins in
  if first < String.length text && text.[first] = '{' then Json.read text begins else Csv.read text begins

(** What lies between two line feeds is a line, and a word of it between two spaces. *)
let words_of text = List.rev (List.rev_map (String.split_on_char ' ') (String.split_on_char '\n' text))

(** The verdict repeats the question: its reader sees what was proved. *)
let accepted lines file =
  let rest_of name = function first :: rest when first = name -> Some rest | _ -> None in
  let numbers name = List.concat (List.filter_map (rest_of name) lines) in
  let rec say words numbers =
    match (String.index_opt words '#', numbers) with
    | Some i, number :: rest -> String.sub words 0 i ^ number ^ say (behind words (i + 1)) rest
    | _ -> words
  in
  let tell words = function [] -> "" | numbers -> say words numbers in
  let tolerance name words of_file =
    let of_file = if List.mem "file" (numbers name) then of_file else "" in
    tell words (List.filter (fun word -> word <> "file") (numbers name)) ^ of_file
  in
  let rec bands said = function
    | x :: lo :: hi :: rest -> bands (say "#: # to #% passing; " [ x; lo; hi ] :: said) rest
    | _ -> String.concat "" (List.rev said)
  in
  let each = String.concat ", " (List.map (fun number -> number ^ "%") (numbers "passing-each")) in
  let is_tolerant = not (List.exists (fun line -> List.hd line = "scale") lines) in
  let law = numbers "law" in
  String.concat ""
    [ (match numbers "particles" with
      | [ "none" ] -> "accepted: no sample"
      | particles -> say "accepted: N = # is the least number of particles" particles);
      tell " from # up" (numbers "at-least");
      (if numbers "particles" = [ "none" ] then " matches " else " that matches ");
      printable file;
      (if is_tolerant then " within a tolerance (" else " exactly (");
      tolerance "retained" "retained #%; " "retained as the file has it; ";
      tolerance "passing" "passing #%; " "passing as the file has it; ";
      (if each = "" then "" else "passing " ^ each ^ "; ");
      tell "total #%; " (numbers "total");
      bands [] (numbers "band");
      tell (if List.exists (fun word -> String.contains word '/') law then "law x^(#)" else "law x^#") law;
      tell "; at least # particles in each class" (numbers "min-per-class");
      tell "; solids of the cylinder # x # at void ratio #" (numbers "cylinder");
      tell "; solids of the box # x # x # at void ratio #" (numbers "box");
      tell "; solids of at least the volume #" (numbers "solids-volume");
      tell "; openings multiplied by #" (numbers "size-factor");
      tell "; classes below # left out" (numbers "cut-below");
      tell "; pan counted as size #" (numbers "pan-size");
      ")" ]

let line_of text place =
  let count = ref 1 in
  String.iteri (fun i c -> if i < place && c = '\n' then incr count) text;
  !count

let row_of (r : Gradation.row) = List.map Q.to_string [ r.size; r.mass; r.factor; r.tolerance ]

(** Each file is a name and a text. *)
let judge (gradation_name, gradation) (certificate_name, certificate) =
  match read_gradation gradation with
  | exception Text.Malformed (place, what) ->
      Malformed (Printf.sprintf "%s:%d: %s" (printable gradation_name) (line_of gradation place) what)
  | read -> (
      let lines = words_of certificate in
      match Mdm_checker.mdm_check (List.rev (List.rev_map row_of read.rows)) read.has_tolerances lines with
      | Accepted -> Accepted (accepted lines gradation_name)
      | Not_proved what -> Refused ("refused: " ^ what ^ " fails")
      | Not_readable what ->
          Malformed (Printf.sprintf "%s: %s: let mdm solve --proof write it again" (printable certificate_name) what))
