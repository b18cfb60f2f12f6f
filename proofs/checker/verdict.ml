(* What is said of a gradation and a certificate, with a sample between them or not, and of a specification, stockpiles and the
   certificate of a blend: the functions of their names and bytes that are extracted from Coq (proofs/coq, Judge.v, SampleLine.v and
   BlendLine.v). *)

open Texts

(** The exit code, and the whole lines for standard output and standard error. *)
type t = { code : int; output : string; error : string }

let line characters = text_of characters ^ "\n"

(** The message of a file, as all programs of the project have it. *)
let failure name what = { code = 2; output = ""; error = printable name ^ ": " ^ what ^ "\n" }

(** What the extracted functions can do with the memory that is there. *)
let within_memory name remedy work =
  try work ()
  with Stack_overflow | Out_of_memory -> failure name ("more than this program can hold: " ^ remedy)

let file (name, text) = { Mdm_checker.name = characters name; bytes = characters text }

let verdict_of : Mdm_checker.judgement -> t = function
  | Proved accepted -> { code = 0; output = line accepted; error = "" }
  | Unproved (refused, reason) -> { code = 1; output = line refused; error = line reason }
  | Unreadable message -> { code = 2; output = ""; error = line message }

(** Of two files, each a name and its bytes. *)
let judge ~remedy gradation certificate =
  within_memory (fst certificate) remedy (fun () ->
      verdict_of (Mdm_checker.judge (file gradation) (file certificate)))

(** Of a sample between them. *)
let judge_sample ~remedy gradation sample certificate =
  within_memory (fst sample) remedy (fun () ->
      verdict_of (Mdm_checker.judge_sample (file gradation) (file sample) (file certificate)))

(** Of a specification, stockpiles and the certificate of a blend. *)
let judge_blend ~remedy specification stockpiles certificate =
  within_memory (fst certificate) remedy (fun () ->
      verdict_of (Mdm_checker.judge_blend (file specification) (List.map file stockpiles) (file certificate)))

(** The gradation as it is read, in canonical CSV. *)
let print ~remedy gradation =
  within_memory (fst gradation) remedy (fun () ->
      match Mdm_checker.print_gradation (file gradation) with
      | Ok csv -> { code = 0; output = text_of csv; error = "" }
      | Refused message | Malformed message -> { code = 2; output = ""; error = line message })
