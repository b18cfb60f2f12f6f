(* The functions of zarith's module Z that Extract.v names, with the integers of JavaScript (BigInt). js_of_ocaml puts the
   text of such a function into the script. *)

open Js_of_ocaml.Js.Unsafe

type t

let of_int : int -> t = pure_js_expr "(function (x) { return BigInt(x) })"
let to_int : t -> int = pure_js_expr "(function (x) { return Number(x) })"
let zero = of_int 0

let divexact : t -> t -> t = pure_js_expr "(function (x, y) { return x / y })"
let add : t -> t -> t = pure_js_expr "(function (x, y) { return x + y })"
let sub : t -> t -> t = pure_js_expr "(function (x, y) { return x - y })"
let mul : t -> t -> t = pure_js_expr "(function (x, y) { return x * y })"
let leq : t -> t -> bool = pure_js_expr "(function (x, y) { return Number(x <= y) })"
let lt : t -> t -> bool = pure_js_expr "(function (x, y) { return Number(x < y) })"
let equal : t -> t -> bool = pure_js_expr "(function (x, y) { return Number(x === y) })"
let compare : t -> t -> int = pure_js_expr "(function (x, y) { return (x > y) - (x < y) })"
let sign x = compare x zero
let neg x = sub zero x
let abs x = if lt x zero then neg x else x

let rec pow x n =
  if n = 0 then of_int 1
  else
    let of_half = pow (mul x x) (n / 2) in
    if n land 1 = 0 then of_half else mul of_half x

(** Of x > 0: the number of its binary digits. *)
let numbits : t -> int =
  pure_js_expr
    "(function (x) { var h = x.toString(16); return 4 * h.length - Math.clz32(parseInt(h[0], 16)) + 28 })"

(** It has the sign of x. *)
let remainder : t -> t -> t = pure_js_expr "(function (x, y) { return x % y })"

let gcd x y =
  let rec of_both x y = if equal y zero then x else of_both y (remainder x y) in
  of_both (abs x) (abs y)

let lcm x y = if equal x zero || equal y zero then zero else abs (mul (divexact x (gcd x y)) y)
