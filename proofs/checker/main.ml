(* mdm-check-verified: mdm-check once more. What it says of two files is in verdict.ml; here files are read and lines are
   printed. *)

let help =
  Printf.sprintf
    {|%s GRADATION CERTIFICATE [GRADATION CERTIFICATE]...
%s GRADATION SAMPLE CERTIFICATE
%s SPECIFICATION STOCKPILE STOCKPILE ... CERTIFICATE
%s --samples GRADATION SAMPLE CERTIFICATE [GRADATION SAMPLE CERTIFICATE]...
%s --print GRADATION [CERTIFICATE]

Checks the proof that a number of particles is the smallest that matches a gradation exactly or
within a tolerance, or the proof of bounds on the smallest, by the program that is extracted from
its proof of correctness in Coq.
GRADATION is the gradation file (CSV or JSON) and CERTIFICATE what mdm solve --proof wrote;
one of them may be - for standard input. Of several pairs each has its verdict, in a line.
Certificates by the law of a table or of a sum are malformed for this program: use mdm-check.

With a SAMPLE, CERTIFICATE is what mdm verify --proof or mdm published --proof wrote of it, and
says whether the sample matches. This program takes sizes, or powers of them, whose masses are
rational by the law; ranges of sizes and other laws are malformed for it: use mdm-check.

With STOCKPILES, CERTIFICATE is what mdm blend --proof wrote of them, in their order, and SPECIFICATION
has the limits of what passes. More than two files are those of one blend where the last one begins as
such a certificate does.

Example:
  mdm solve sand.csv --proof sand.proof
  %s sand.csv sand.proof

Exits with 0 (accepted), 1 (refused: the certificate does not prove its claim) or
2 (malformed: a file cannot be read, or the command is wrong); the worst of several pairs.

  --samples   several samples, each with its gradation and certificate: each has its verdict
  --print     the gradation as it is read, as CSV in its only form, before the verdict
  -h, --help  this text
  --version   the versions of this program and of OCaml
|}
    Program.name Program.name Program.name Program.name Program.name Program.name

exception Failure_of of string * string

let fail who what = raise (Failure_of (who, what))

(** Reads a file in pieces, so that a device without end ends at the limit. *)
let read_input path most_megabytes =
  let name = if path = "-" then "standard input" else path in
  let text = Buffer.create 65536 and piece = Bytes.create 65536 in
  let rec pieces channel =
    let got = input channel piece 0 (Bytes.length piece) in
    Buffer.add_subbytes text piece 0 got;
    if Buffer.length text > most_megabytes lsl 20 then
      fail name (Printf.sprintf "longer than %d MiB: give the file that was meant" most_megabytes);
    if got > 0 then pieces channel
  in
  (try
     let channel = if path = "-" then stdin else open_in_bin path in
     Fun.protect ~finally:(fun () -> close_in_noerr channel) (fun () -> pieces channel)
   with Sys_error what -> fail name ("cannot be read (" ^ what ^ "): give a file that is there"));
  (name, Buffer.contents text)

(** A file that is read once, where it is wanted: as a gradation or a sample, or as a certificate. *)
type file = { text : (string * string) Lazy.t; certificate : (string * string) Lazy.t }

let file_of path = { text = lazy (read_input path 64); certificate = lazy (read_input path 256) }
let text file = Lazy.force file.text
let certificate_of file = Lazy.force file.certificate

(** The most characters of a row: five fields of 1000 digits each have fewer. The readers' time grows with the square of
    a row's length. *)
let longest_row = 16384

(** A gradation or a specification; JSON is one line, and comments may be long. *)
let table file =
  let name, content = text file in
  let is_too_long line = String.length line > longest_row && line.[0] <> '#' in
  let is_json = String.contains (String.sub content 0 (min 16 (String.length content))) '{' in
  if (not is_json) && List.exists is_too_long (String.split_on_char '\n' content) then
    fail name (Printf.sprintf "a line is longer than %d characters, and no row of a gradation is: give a gradation" longest_row);
  (name, content)
let remedy = "raise its limits (ulimit -s), or use mdm-check"

(** Prints a verdict, [before] before its line, and gives its code. *)
let say ?(before = "") (verdict : Verdict.t) =
  if verdict.output <> "" then print_string (before ^ verdict.output);
  flush stdout;
  prerr_string verdict.error;
  flush stderr;
  verdict.code

let check ?before gradation certificate =
  say ?before (Verdict.judge ~remedy gradation (certificate_of certificate))

(** A sample is held as a whole. *)
let check_sample gradation sample certificate =
  say (Verdict.judge_sample ~remedy (table gradation) (text sample) (certificate_of certificate))

(** The specification, the stockpiles and the certificate of a blend. *)
let check_blend specification stockpiles certificate =
  say (Verdict.judge_blend ~remedy (table specification) (List.map table stockpiles) (certificate_of certificate))

let print gradation certificate =
  match (Verdict.print ~remedy gradation, certificate) with
  | { code = 0; output = csv; _ }, Some certificate -> check ~before:csv gradation certificate
  | printed, _ -> say printed

(** The code of a work, 2 where a file cannot be read. *)
let code_of work =
  try work () with Failure_of (who, what) -> say (Verdict.failure who what)

let rec check_all worst = function
  | gradation :: certificate :: rest ->
      check_all (max worst (code_of (fun () -> check (table gradation) certificate))) rest
  | _ -> worst

let rec check_samples worst = function
  | gradation :: sample :: certificate :: rest ->
      check_samples (max worst (code_of (fun () -> check_sample gradation sample certificate))) rest
  | _ -> worst

(** Whether more than two files are those of one blend, whose certificate is the last. *)
let is_blend files =
  List.length files > 2
  &&
  match certificate_of (List.nth files (List.length files - 1)) with
  | _, text -> String.starts_with ~prefix:"mdm-certificate blend" text
  | exception Failure_of _ -> false

let check_files files =
  if is_blend files then
    match (files, List.rev (List.tl files)) with
    | specification :: _, certificate :: stockpiles -> check_blend specification (List.rev stockpiles) certificate
    | _ -> 2
  else if List.length files = 3 then check_samples 0 files
  else check_all 0 files

let see_help = ": see " ^ Program.name ^ " --help"

let demand_arguments arguments is_right =
  let is_option argument = String.length argument > 1 && argument.[0] = '-' in
  Option.iter
    (fun argument -> fail Program.name ("no option '" ^ argument ^ "'" ^ see_help))
    (List.find_opt is_option arguments);
  if (not is_right) || List.length (List.filter (String.equal "-") arguments) > 1 then
    fail Program.name ("give a gradation and a certificate, a sample between them, the files of a blend, or several pairs" ^ see_help)

let run arguments =
  match arguments with
  | [ "-h" ] | [ "--help" ] -> print_string help; 0
  | [ "--version" ] ->
      Printf.printf "%s %s (OCaml %s)\n" Program.name Program.version Sys.ocaml_version;
      0
  | "--print" :: files ->
      demand_arguments files (List.length files = 1 || List.length files = 2);
      print (table (file_of (List.hd files))) (Option.map file_of (List.nth_opt files 1))
  | "--samples" :: files ->
      demand_arguments files (files <> [] && List.length files mod 3 = 0);
      check_samples 0 (List.map file_of files)
  | _ ->
      demand_arguments arguments (arguments <> []);
      let files = List.map file_of arguments in
      demand_arguments arguments (is_blend files || List.length files = 3 || List.length files mod 2 = 0);
      check_files files

(** True if a part of the text is [part]. *)
let has text part =
  let n = String.length part in
  let rec from i = i + n <= String.length text && (String.sub text i n = part || from (i + 1)) in
  from 0

let () =
  let code =
    try
      (* The extracted functions make many small lists: in large pieces of memory, quickly. *)
      Gc.set { (Gc.get ()) with allocation_policy = 2; major_heap_increment = 1 lsl 22 };
      set_binary_mode_in stdin true;
      Sys.set_signal Sys.sigpipe Sys.Signal_ignore;
      let code = code_of (fun () -> run (List.tl (Array.to_list Sys.argv))) in
      flush stdout;
      code
    with
    | Sys_error what ->
        close_out_noerr stdout;
        if not (has what "Broken pipe") then
          prerr_endline ("standard output: cannot be written: " ^ what ^ ": send it elsewhere");
        2
    | Out_of_memory ->
        prerr_endline (Program.name ^ ": out of memory: check on a larger machine");
        2
  in
  exit code
