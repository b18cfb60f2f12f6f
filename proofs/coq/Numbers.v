(* What the checker computes with: verdicts, integer powers and roots, fractions.

   Numbers are the standard library's binary integers Z and fractions Q; nothing is rounded. *)

From Coq Require Import ZArith QArith List String.
Import ListNotations.
Open Scope Z_scope.

(* ---- Verdicts ------------------------------------------------------------------------------------ *)

(* What a check comes to. [Refused]: well formed, but this is not shown. [Malformed]: the text is no
   certificate, or checking it would take hours or gigabytes. *)
Inductive result (A : Type) := Ok (a : A) | Refused (what : string) | Malformed (what : string).
Arguments Ok {A}.
Arguments Refused {A}.
Arguments Malformed {A}.

Definition bind {A B} (r : result A) (next : A -> result B) : result B :=
  match r with
  | Ok a => next a
  | Refused what => Refused what
  | Malformed what => Malformed what
  end.
Notation "'let*' x := r 'in' next" := (bind r (fun x => next)) (at level 200, x pattern, right associativity).

Definition demand (holds : bool) (what : string) : result unit := if holds then Ok tt else Refused what.
Definition demand_form (holds : bool) (what : string) : result unit := if holds then Ok tt else Malformed what.
Notation "r ;; next" := (bind r (fun _ => next)) (at level 199, right associativity).

(* ---- Integers ------------------------------------------------------------------------------------ *)

(* The number of bits, 1 for 0. *)
Definition bits (n : Z) : Z := Z.log2 (Z.abs n) + 1.

Definition sum : list Z -> Z := fold_right Z.add 0.
Definition longest {A} (length : A -> Z) (l : list A) (n : Z) : Z :=
  fold_left (fun n x => Z.max n (length x)) l n.
Definition size {A} (l : list A) : Z := fold_left (fun n _ => n + 1) l 0.

(* n / d, rounded up. *)
Definition quotient_up (n d : Z) : Z := (n + d - 1) / d.

(* The digits of a root, from the i-th binary digit down: the greatest r' = r + a sum of smaller powers of 2
   with r'^b <= n. *)
Fixpoint root_digits (b n r : Z) (i : nat) : Z :=
  match i with
  | O => r
  | S i => let r' := r + 2 ^ Z.of_nat i in root_digits b n (if r' ^ b <=? n then r' else r) i
  end.

(* floor(root_b(n)) for n >= 0. *)
Definition root (b n : Z) : Z := if b =? 1 then n else root_digits b n 0 (Z.to_nat (Z.log2 n / b + 1)).

(* ---- Fractions ----------------------------------------------------------------------------------- *)

(* A fraction that need not be in lowest terms, so that no step of a chain pays for a gcd. *)
Definition ratio : Type := Z * Z.

Definition fraction (numerator denominator : Z) : Q := Qred (Qmake numerator (Z.to_pos denominator)).
Definition add (x y : Q) : Q := Qred (x + y).
Definition subtract (x y : Q) : Q := Qred (x - y).
Definition times (x y : Q) : Q := Qred (x * y).
Definition over (x y : Q) : Q := Qred (x / y).
Definition of_integer (n : Z) : Q := Qmake n 1.
Definition power (x : Q) (n : Z) : Q := Qmake (Qnum x ^ n) (Z.to_pos (Zpos (Qden x) ^ n)).

Definition less (x y : Q) : bool := Qnum x * Zpos (Qden y) <? Qnum y * Zpos (Qden x).
Definition at_most (x y : Q) : bool := Qnum x * Zpos (Qden y) <=? Qnum y * Zpos (Qden x).
Definition equal (x y : Q) : bool := Qnum x * Zpos (Qden y) =? Qnum y * Zpos (Qden x).
Definition larger (x y : Q) : Q := if less x y then y else x.
Definition smaller (x y : Q) : Q := if less y x then y else x.

Definition bits_of (x : Q) : Z := Z.max (bits (Qnum x)) (bits (Zpos (Qden x))).

Definition common_denominator (xs : list Q) : Z :=
  fold_left (fun common x => Z.lcm common (Zpos (Qden x))) xs 1.

(* x * unit, an integer if the unit is a multiple of the denominator. *)
Definition in_units (x : Q) (unit : Z) : Z := Qnum x * (unit / Zpos (Qden x)).
