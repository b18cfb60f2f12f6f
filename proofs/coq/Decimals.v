(* Decimals, as gradation files write them and as they are printed (certificate-format.md, sections 1 and 4). *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Certificate Text.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Reading ------------------------------------------------------------------------------------- *)

Definition most_digits_of_file : Z := 1000.
Definition most_exponent : Z := 400.

(* As [digits] of Certificate.v; the value takes no part in more than the most digits, so that long texts take no time. *)
Fixpoint file_digits (w : string) (value n : Z) : Z * Z * string :=
  match w with
  | EmptyString => (value, n, w)
  | String ch rest =>
    match digit ch with
    | Some d => file_digits rest (if n <? most_digits_of_file then 10 * value + d else value) (n + 1)
    | None => (value, n, w)
    end
  end.

(* The value of digits of an exponent, one more than the most at the most, how many there are, and what follows. *)
Fixpoint exponent_digits (w : string) (value n : Z) : Z * Z * string :=
  match w with
  | EmptyString => (value, n, w)
  | String ch rest =>
    match digit ch with
    | Some d => exponent_digits rest (Z.min (10 * value + d) (most_exponent + 1)) (n + 1)
    | None => (value, n, w)
    end
  end.

(* -1 after a minus, and what follows the sign. *)
Definition signed (w : string) : Z * string :=
  match w with
  | String ch rest => if Ascii.eqb ch "+" then (1, rest) else if Ascii.eqb ch "-" then (-1, rest) else (1, w)
  | EmptyString => (1, w)
  end.

Definition power_of_ten (n : Z) : Q := if 0 <=? n then of_integer (10 ^ n) else Qmake 1 (Z.to_pos (10 ^ (- n))).

Definition exponent_of (w : string) : option Z :=
  match w with
  | EmptyString => Some 0
  | String ch rest =>
    let (sign, w) := signed rest in
    let '(value, n, rest) := exponent_digits w 0 0 in
    if (Ascii.eqb ch "e" || Ascii.eqb ch "E") && (1 <=? n) && String.eqb rest "" then Some (sign * value) else None
  end.

Definition no_number (w : string) : string := quoted w ++ " is not a number: write a decimal such as 0.075".

(* The exact value of a decimal, whose point is the character [point]. *)
Definition read_decimal (point : ascii) (w : string) : result Q :=
  let (sign, unsigned) := signed w in
  let '(whole, n, rest) := file_digits unsigned 0 0 in
  let '(value, all, rest) :=
    match rest with
    | String ch places => if Ascii.eqb ch point then file_digits places whole n else (whole, n, rest)
    | EmptyString => (whole, n, rest)
    end in
  (* Messages are made where they are needed: the program that is extracted is strict. *)
  match exponent_of rest with
  | Some exponent =>
    if all <? 1 then Malformed (no_number w)
    else if most_digits_of_file <? all then Malformed (quoted w ++ " has more than 1000 digits: shorten it")
    else if most_exponent <? Z.abs exponent then
      Malformed (quoted w ++ " has an exponent beyond 400: choose another unit")
    else Ok (times (of_integer (sign * value)) (power_of_ten (exponent - (all - n))))
  | None => Malformed (no_number w)
  end.

(* ---- Printing ------------------------------------------------------------------------------------ *)

(* The digits of remainder / denominator < 1, by long division; at most [fuel] of them. *)
Fixpoint fraction_digits (fuel : nat) (remainder denominator : Z) : string :=
  if remainder =? 0 then "" else
  match fuel with
  | O => ""
  | S fuel =>
    let (d, remainder) := Z.div_eucl (10 * remainder) denominator in
    String (digit_of d) (fraction_digits fuel remainder denominator)
  end.

(* x >= 0 whose denominator divides a power of ten: an integer, or an integer, a point and digits whose last is not 0. *)
Definition show_decimal (x : Q) : string :=
  let denominator := Zpos (Qden x) in
  let (whole, remainder) := Z.div_eucl (Qnum x) denominator in
  let integral := show_integer whole in
  if remainder =? 0 then integral
  else integral ++ "." ++ fraction_digits (Z.to_nat (Z.log2 denominator)) remainder denominator.

(* x >= 0 as an integer or p/q. *)
Definition show_rational (x : Q) : string :=
  if Zpos (Qden x) =? 1 then show_integer (Qnum x)
  else show_integer (Qnum x) ++ "/" ++ show_integer (Zpos (Qden x)).
