(* mdm-check-verified in JavaScript: the function mdmCheckVerified of the names and bytes of a gradation and of its
   certificate, or of a specification, stockpiles and the certificate of a blend. It gives an object with the exit code and the
   texts that the program prints: code, output, error.

   Names and bytes come as Uint8Array, so that none is lost: a name from JavaScript is encoded as UTF-8 first. What is
   printed is a JavaScript string: bytes that are no UTF-8 are escaped in it. *)

open Js_of_ocaml

(* A byte takes up to some 350 bytes of memory, and JavaScript ends where there is none left. *)
let most_megabytes = 4
let remedy = "use mdm-check"

let verdict first between certificate =
  let bytes = List.fold_left (fun sum (_, text) -> sum + String.length text) 0 (first :: certificate :: between) in
  if bytes > most_megabytes lsl 20 then Verdict.failure (fst certificate) ("more than this program can hold: " ^ remedy)
  else if between = [] then Verdict.judge ~remedy first certificate
  else Verdict.judge_blend ~remedy first between certificate

(** The files of names and bytes in turns. *)
let rec files_of = function
  | name :: bytes :: rest -> Typed_array.String.(of_uint8Array name, of_uint8Array bytes) :: files_of rest
  | _ -> []

(** What a function of JavaScript was given. *)
let list_of arguments =
  Js.Unsafe.(List.init (get arguments (Js.string "length")) (fun i -> get arguments i))

let check arguments =
  let verdict =
    match files_of (list_of arguments) with
    | first :: (_ :: _ as others) ->
        let certificate, between = List.(hd (rev others), rev (tl (rev others))) in
        verdict first between certificate
    | _ -> Verdict.failure "mdmCheckVerified" "give the names and bytes of a gradation and a certificate"
  in
  let text = Js.string in
  Js.Unsafe.(
    obj
      [| ("code", inject verdict.code);
         ("output", inject (text verdict.output));
         ("error", inject (text verdict.error)) |])

let () = Js.export "mdmCheckVerified" (Js.Unsafe.callback_with_arguments check)
