(* The gradation as its file gives it: rational numbers, not yet the reals of Spec.v. *)

From Coq Require Import ZArith QArith List Bool.
From Mdm Require Import Numbers.
Import ListNotations.
Open Scope Z_scope.

(* A line of a gradation: opening, mass m_j retained on it, and the factor c_j of the class above it. The tolerance, in
   percent, is 0 where the file has none. *)
Record row := Row { opening : Q; retained : Q; factor : Q; tolerance : Q }.

(* Rows ascend. The opening x_j of a row is known by its power Y_j = x_j^root, which is what the row has as [opening]: an
   opening of 2^0.5 mm is 2 with the root 2. The root is 1 unless sizes are phi with fractions. *)
Record gradation := Gradation { rows : list row; root : Z; has_tolerances : bool }.

(* Class j: the sizes x with lower < x^root <= upper, and what the gradation says of them. *)
Record class := Class { lower : Q; upper : Q; mass : Q; c : Q }.

Fixpoint classes (rs : list row) : list class :=
  match rs with
  | x :: ((y :: _) as rest) => Class (opening x) (opening y) (retained x) (factor x) :: classes rest
  | _ => []
  end.

Fixpoint ascending (rs : list row) : bool :=
  match rs with
  | x :: ((y :: _) as rest) => less (opening x) (opening y) && ascending rest
  | _ => true
  end.

Definition last_row (rs : list row) : row := last rs (Row 0 0 1 0).

Definition most_root : Z := 1000.

(* What section 4 of certificate-format.md demands of the numbers of a gradation file. *)
Definition well_formed (G : gradation) : bool :=
  (1 <=? root G) && (root G <=? most_root) && (2 <=? size (rows G)) && ascending (rows G) &&
  forallb (fun r => at_most 0 (opening r) && at_most 0 (retained r) && less 0 (factor r) &&
                    at_most 0 (tolerance r)) (rows G) &&
  equal (retained (last_row (rows G))) 0 && existsb (fun r => less 0 (retained r)) (rows G).

Definition reduced (G : gradation) : gradation :=
  Gradation (map (fun r => Row (Qred (opening r)) (Qred (retained r)) (Qred (factor r)) (Qred (tolerance r)))
                 (rows G)) (root G) (has_tolerances G).
