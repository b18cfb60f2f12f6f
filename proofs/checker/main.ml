(* mdm-check-verified: mdm-check once more, around the checker that Coq has proved correct. *)

let help =
  Printf.sprintf
    {|%s GRADATION CERTIFICATE [GRADATION CERTIFICATE]...

Checks the proof that a number of particles is the least that matches a gradation exactly or
within a tolerance, by the program that is extracted from its proof of correctness in Coq.
GRADATION is the gradation file (CSV or JSON) and CERTIFICATE what mdm solve --proof wrote;
one of them may be - for standard input. Of several pairs each has its verdict, in a line.

Example:
  mdm solve sand.csv --proof sand.proof
  %s sand.csv sand.proof

Exits with 0 (accepted), 1 (refused: the certificate does not prove its claim) or
2 (malformed: a file cannot be read, or the command is wrong); the worst of several pairs.

  -h, --help  this text
  --version   the versions of this program and of OCaml
|}
    Program.name Program.name

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
   with Sys_error what ->
     let said = path ^ ": " in
     let reason = if Text.starts_with said what then Text.behind what (String.length said) else what in
     fail name ("cannot be read: " ^ reason ^ ": give a file that is there"));
  (name, Buffer.contents text)

(** The exit code. *)
let check gradation certificate =
  let gradation = read_input gradation 64 in
  let certificate = read_input certificate 256 in
  match Verdict.judge gradation certificate with
  | Accepted line -> print_endline line; 0
  | Refused line -> print_endline line; 1
  | Malformed line -> prerr_endline line; 2
  | exception (Stack_overflow | Out_of_memory) ->
      fail (fst certificate) "more than this program can hold: raise its limits (ulimit -s), or use mdm-check"

let rec check_all worst = function
  | gradation :: certificate :: rest ->
      let code =
        try check gradation certificate
        with Failure_of (who, what) ->
          prerr_endline (Text.printable who ^ ": " ^ what);
          2
      in
      check_all (max worst code) rest
  | _ -> worst

let run arguments =
  match arguments with
  | [ "-h" ] | [ "--help" ] -> print_string help; 0
  | [ "--version" ] ->
      Printf.printf "%s %s (OCaml %s)\n" Program.name Program.version Sys.ocaml_version;
      0
  | _ ->
      let is_option argument = String.length argument > 1 && argument.[0] = '-' in
      let see_help = ": see " ^ Program.name ^ " --help" in
      Option.iter
        (fun argument -> fail Program.name ("no option " ^ Text.quoted argument ^ see_help))
        (List.find_opt is_option arguments);
      let from_input = List.filter (String.equal "-") arguments in
      if arguments = [] || List.length arguments mod 2 = 1 || List.length from_input > 1 then
        fail Program.name ("give one gradation and one certificate, or several pairs" ^ see_help);
      check_all 0 arguments

let () =
  let code =
    try
      (* The extracted functions copy a word as often as it has characters: in large pieces of memory, quickly. *)
      Gc.set { (Gc.get ()) with allocation_policy = 2; major_heap_increment = 1 lsl 22; space_overhead = 200 };
      set_binary_mode_in stdin true;
      Sys.set_signal Sys.sigpipe Sys.Signal_ignore;
      let code = run (List.tl (Array.to_list Sys.argv)) in
      flush stdout;
      code
    with
    | Failure_of (who, what) ->
        prerr_endline (Text.printable who ^ ": " ^ what);
        2
    | Sys_error what ->
        prerr_endline ("standard output: cannot be written: " ^ what ^ ": send it elsewhere");
        2
  in
  exit code
