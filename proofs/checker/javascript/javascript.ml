(* mdm-check-verified in JavaScript: the function mdmCheckVerified of the names and bytes of a gradation and of its
   certificate. It gives an object with the exit code and the texts that the program prints: code, output, error.

   Names and bytes come as Uint8Array, so that none is lost: a name from JavaScript is encoded as UTF-8 first. What is
   printed is a JavaScript string: bytes that are no UTF-8 are escaped in it. *)

open Js_of_ocaml

(* A byte takes up to some 350 bytes of memory, and JavaScript ends where there is none left. *)
let most_megabytes = 4
let remedy = "use mdm-check"

let verdict gradation certificate =
  if String.length (snd gradation) + String.length (snd certificate) > most_megabytes lsl 20 then
    Verdict.failure (fst certificate) ("more than this program can hold: " ^ remedy)
  else Verdict.judge ~remedy gradation certificate

let file name bytes = Typed_array.String.(of_uint8Array name, of_uint8Array bytes)

let check gradation_name gradation certificate_name certificate =
  let verdict = verdict (file gradation_name gradation) (file certificate_name certificate) in
  let text = Js.string in
  Js.Unsafe.(
    obj
      [| ("code", inject verdict.code);
         ("output", inject (text verdict.output));
         ("error", inject (text verdict.error)) |])

let () = Js.export "mdmCheckVerified" (Js.wrap_callback check)
