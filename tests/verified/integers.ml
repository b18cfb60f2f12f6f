(* What the functions that the extracted checker names give for small and long integers of both signs: a line each, the
   same with zarith and with ../../proofs/checker/javascript. *)

open Big_int_Z

let ten = Z.of_int 10

let rec digits x =
  if Z.lt x ten then string_of_int (Z.to_int x)
  else digits (div_big_int x ten) ^ string_of_int (Z.to_int (mod_big_int x ten))

let text x = if sign_big_int x < 0 then "-" ^ digits (minus_big_int x) else digits x

(* About the powers of two at which digits, small integers and doubles end. *)
let magnitudes =
  List.concat_map
    (fun exponent -> List.map (fun offset -> add_int_big_int offset (Z.pow (Z.of_int 2) exponent)) [ -1; 0; 1 ])
    [ 1; 4; 29; 31; 32; 53; 62; 64; 200; 201 ]

let integers = (zero_big_int :: magnitudes) @ List.map minus_big_int magnitudes

let show name values = print_endline (String.concat " " (name :: values))
let truth = string_of_bool

let of_one x =
  show "one"
    [ text (succ_big_int x); text (pred_big_int x); text (abs_big_int x); string_of_int (Z.sign x);
      text (mult_int_big_int (-3) x); text (Z.pow x 5); text (Z.pow x 0) ];
  if Z.sign x > 0 then show "digits" [ string_of_int (Z.numbits x) ]

let of_two x y =
  show "two"
    [ text (add_big_int x y); text (sub_big_int x y); text (mult_big_int x y); text (max_big_int x y);
      text (min_big_int x y); truth (eq_big_int x y); truth (le_big_int x y); truth (Z.leq x y); truth (Z.lt x y);
      string_of_int (compare_big_int x y); text (Z.gcd x y); text (Z.lcm x y) ];
  if Z.sign y <> 0 then (
    let quotient, remainder = quomod_big_int x y in
    let exact = Z.divexact (mult_big_int x y) y in
    show "division" [ text quotient; text remainder; text (div_big_int x y); text (mod_big_int x y); text exact ])

let () =
  List.iter of_one integers;
  List.iter (fun x -> List.iter (of_two x) integers) integers
