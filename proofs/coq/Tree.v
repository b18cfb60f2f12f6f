(* The smallest match within a tolerance, in integers, and the check of a tree (certificate-format.md,
   section 6; Theorem 14). *)

From Coq Require Import ZArith QArith List Bool String Ascii FMapPositive.
From Mdm Require Import Numbers Certificate.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- The problem --------------------------------------------------------------------------------- *)

(* A class: f and F in units of mass, the least count, and in units of shares the bounds on what is
   retained and on what passes, the gradation's share g, and 1 / c. *)
Record limits := Limits {
  f : Z; F : Z; floor : Z; retained_lo : Z; retained_hi : Z; passing_lo : Z; passing_hi : Z; g : Z; per_factor : Z }.

(* [half_total] is e/2 in units of shares; the samples have at least [least_count] particles, and a sum of
   t/c of at least [volume]; N is the claim. *)
Record problem := Problem {
  classes_of : list limits;
  mass_unit : Z;
  share_unit : Z;
  half_total : Z;
  least_count : Z;
  volume : Q;
  claim : option Z }.

(* ---- Bounds in force ----------------------------------------------------------------------------- *)

(* What the splits on the way to a node say of the counts. *)
Record force := Force { at_least_v : PositiveMap.t Z; at_most_v : PositiveMap.t Z }.
Definition nothing : force := Force (PositiveMap.empty Z) (PositiveMap.empty Z).

Definition least_of (e : force) (j : positive) (c : limits) : Z :=
  match PositiveMap.find j (at_least_v e) with Some v => Z.max (floor c) v | None => floor c end.

Definition below (e : force) (j : positive) (v : Z) : force :=
  let most := match PositiveMap.find j (at_most_v e) with Some u => Z.min u (v - 1) | None => v - 1 end in
  Force (at_least_v e) (PositiveMap.add j most (at_most_v e)).
Definition from (e : force) (j : positive) (v : Z) : force :=
  let least := match PositiveMap.find j (at_least_v e) with Some u => Z.max u v | None => v end in
  Force (PositiveMap.add j least (at_least_v e)) (at_most_v e).

(* ---- Conditions ---------------------------------------------------------------------------------- *)

(* Coefficients of q (in units of mass), t, P and p: of one class, or of every class. *)
Record of_one := Coefficients { on_q : Z; on_t : Z; on_P : Z; on_p : Z }.
Definition none : of_one := Coefficients 0 0 0 0.

(* Coefficients of M (in units of shares) and of the sum of t/c; the right side; whether > instead of >=. *)
Record of_sum := Sums { on_M : Z; on_volume : Z; constant : Z; strict : bool }.
Definition closed : of_sum := Sums 0 0 0 false.

(* Condition [ch] of class j. *)
Definition condition_on (pr : problem) (e : force) (j : positive) (c : limits) (ch : ascii)
  : option (of_one * of_sum) :=
  if (ch =? "f")%char then Some (Coefficients (- f c) 1 0 0, Sums 0 0 0 (1 <=? least_of e j c)) else
  if (ch =? "F")%char then Some (Coefficients (F c) (-1) 0 0, closed) else
  if (ch =? "q")%char then Some (Coefficients (mass_unit pr) 0 0 0, Sums 0 0 (least_of e j c) false) else
  if (ch =? "Q")%char then
    option_map (fun u => (Coefficients (- mass_unit pr) 0 0 0, Sums 0 0 (- u) false))
      (PositiveMap.find j (at_most_v e)) else
  if (ch =? "r")%char then Some (Coefficients 0 1 0 0, Sums (- retained_lo c) 0 0 false) else
  if (ch =? "R")%char then Some (Coefficients 0 (-1) 0 0, Sums (retained_hi c) 0 0 false) else
  if (ch =? "p")%char then Some (Coefficients 0 0 1 0, Sums (- passing_lo c) 0 0 false) else
  if (ch =? "P")%char then Some (Coefficients 0 0 (-1) 0, Sums (passing_hi c) 0 0 false) else
  if (ch =? "e")%char then Some (Coefficients 0 (-1) 0 1, Sums (g c) 0 0 false) else
  if (ch =? "x")%char then Some (Coefficients 0 0 0 1, closed) else
  None.

(* Condition [ch] of the sample. *)
Definition condition_on_all (pr : problem) (ch : ascii) : option (of_one * of_sum) :=
  if (ch =? "m")%char then Some (Coefficients 0 1 0 0, Sums 0 0 0 true) else
  if (ch =? "E")%char then Some (Coefficients 0 0 0 (-1), Sums (half_total pr) 0 0 false) else
  if (ch =? "w")%char then Some (none, Sums 0 1 0 false) else
  if (ch =? "n")%char then Some (Coefficients (mass_unit pr) 0 0 0, Sums 0 0 (least_count pr) false) else
  if (ch =? "N")%char then
    option_map (fun n => (Coefficients (- mass_unit pr) 0 0 0, Sums 0 0 (1 - n) false)) (claim pr) else
  None.

(* ---- A leaf -------------------------------------------------------------------------------------- *)

Definition add_one (k : Z) (x y : of_one) : of_one :=
  Coefficients (on_q x + k * on_q y) (on_t x + k * on_t y) (on_P x + k * on_P y) (on_p x + k * on_p y).
Definition add_sum (k : Z) (x y : of_sum) : of_sum :=
  Sums (on_M x + k * on_M y) (on_volume x + k * on_volume y) (constant x + k * constant y) (strict x || strict y).

(* A sum of conditions: what it says of single classes, of all alike, and of the sums. *)
Record combination := Combination { single : PositiveMap.t of_one; alike : of_one; sums : of_sum }.
Definition empty : combination := Combination (PositiveMap.empty of_one) none closed.
Definition of_class_j (s : PositiveMap.t of_one) (j : positive) : of_one :=
  match PositiveMap.find j s with Some x => x | None => none end.

Definition table : Type := PositiveMap.t limits.
Fixpoint number_from (j : positive) (cs : list limits) (t : table) : table :=
  match cs with
  | [] => t
  | c :: cs => number_from (Pos.succ j) cs (PositiveMap.add j c t)
  end.

Definition add_multiple (pr : problem) (t : table) (e : force) (x : combination) (k : multiple) : option combination :=
  if times_m k <=? 0 then None else
  match of_class k with
  | Zpos j =>
    match PositiveMap.find j t with
    | Some c =>
      match condition_on pr e j c (letter k) with
      | Some (one, all) =>
        let here := add_one (times_m k) (of_class_j (single x) j) one in
        Some (Combination (PositiveMap.add j here (single x)) (alike x) (add_sum (times_m k) (sums x) all))
      | None => None
      end
    | None => None
    end
  | _ =>
    match condition_on_all pr (letter k) with
    | Some (one, all) =>
      Some (Combination (single x) (add_one (times_m k) (alike x) one) (add_sum (times_m k) (sums x) all))
    | None => None
    end
  end.

Fixpoint add_up (pr : problem) (t : table) (e : force) (ks : list multiple) (x : combination) : option combination :=
  match ks with
  | [] => Some x
  | k :: ks =>
    match add_multiple pr t e x k with
    | Some x => add_up pr t e ks x
    | None => None
    end
  end.

(* Whether all variables cancel in the classes from j on; if so, the coefficients of P_j, P_(j+1), ..., of
   which t_j is a part, in sum. *)
Fixpoint cancels (pr : problem) (x : combination) (j : positive) (cs : list limits) : option Z :=
  match cs with
  | [] => Some 0
  | c :: cs =>
    match cancels pr x (Pos.succ j) cs with
    | Some held =>
      let one := of_class_j (single x) j in
      let all := alike x in
      let held := held + on_P one + on_P all in
      let of_t := (on_t one + on_t all + held) * share_unit pr + on_M (sums x) + on_volume (sums x) * per_factor c in
      check ((on_q one + on_q all =? 0) && (of_t =? 0) && (on_p one + on_p all =? 0)) held
    | None => None
    end
  end.

(* Where nothing is said of all classes alike and of the sums, only the classes that are named can keep a variable: a leaf
   that contradicts itself in a few classes takes as long as it is, whatever the number of classes. *)
Definition says_nothing (x : of_one) : bool :=
  (on_q x =? 0) && (on_t x =? 0) && (on_P x =? 0) && (on_p x =? 0).
Definition cancels_where_named (x : combination) : bool :=
  says_nothing (alike x) && (on_M (sums x) =? 0) && (on_volume (sums x) =? 0) &&
  forallb (fun '(_, one) => says_nothing one) (PositiveMap.elements (single x)).

(* 0 >= positive, or 0 > 0. *)
Definition contradiction (pr : problem) (x : of_sum) : bool :=
  let d := Zpos (Qden (volume pr)) in
  let right := constant x * d + on_volume x * Qnum (volume pr) in
  (0 <? right) || ((right =? 0) && strict x).

Definition refutes (pr : problem) (t : table) (e : force) (ks : list multiple) : bool :=
  match add_up pr t e ks empty with
  | Some x =>
    if cancels_where_named x then contradiction pr (sums x) else
    match cancels pr x 1 (classes_of pr) with
    | Some _ => contradiction pr (sums x)
    | None => false
    end
  | None => false
  end.

(* ---- The tree ------------------------------------------------------------------------------------ *)

(* Nodes in preorder; the bounds in force at the roots of the subtrees that are still to come. *)
Fixpoint check_nodes (pr : problem) (t : table) (nodes : list node) (to_come : list force) : result unit :=
  match nodes, to_come with
  | [], [] => Ok tt
  | Split (Zpos j) v :: nodes, e :: to_come =>
    if PositiveMap.mem j t then check_nodes pr t nodes (below e j v :: from e j v :: to_come)
    else Refused "split: a class of the gradation"
  | Leaf ks :: nodes, e :: to_come =>
    if refutes pr t e ks then check_nodes pr t nodes to_come else Refused "leaf: a contradiction"
  | _, _ => Refused "tree: two subtrees of each split"
  end.

Definition check_tree (pr : problem) (nodes : list node) : result unit :=
  check_nodes pr (number_from 1 (classes_of pr) (PositiveMap.empty limits)) nodes [nothing].
