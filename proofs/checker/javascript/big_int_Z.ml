(* The functions of zarith's module Big_int_Z that Coq's extraction names. *)

type big_int = Z.t

let big_int_of_int = Z.of_int
let zero_big_int = Z.zero
let unit_big_int = Z.of_int 1
let add_big_int = Z.add
let sub_big_int = Z.sub
let mult_big_int = Z.mul
let add_int_big_int n x = Z.add (Z.of_int n) x
let mult_int_big_int n x = Z.mul (Z.of_int n) x
let succ_big_int x = Z.add x unit_big_int
let pred_big_int x = Z.sub x unit_big_int
let minus_big_int = Z.neg
let abs_big_int = Z.abs
let sign_big_int = Z.sign
let eq_big_int = Z.equal
let le_big_int = Z.leq
let compare_big_int = Z.compare
let max_big_int x y = if Z.lt x y then y else x
let min_big_int x y = if Z.lt y x then y else x

(** The quotient and the remainder r with 0 <= r < |y|. *)
let quomod_big_int x y =
  let remainder = Z.remainder x y in
  let remainder = if Z.lt remainder Z.zero then Z.add remainder (Z.abs y) else remainder in
  (Z.divexact (Z.sub x remainder) y, remainder)

let div_big_int x y = fst (quomod_big_int x y)
let mod_big_int x y = snd (quomod_big_int x y)
