(* The smallest match within a tolerance, in integers, and the check of a tree's leaf (certificate-format.md,
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
   t/c of at least [volume]; what is claimed is that no match has fewer than [bound] particles, or that there is none. *)
Record problem := Problem {
  classes_of : list limits;
  mass_unit : Z;
  share_unit : Z;
  half_total : Z;
  least_count : Z;
  volume : Q;
  bound : option Z }.

(* ---- Bounds in force ----------------------------------------------------------------------------- *)

(* Bounds on the particles of classes i to j together, by i and j. *)
Definition ranges : Type := PositiveMap.t (PositiveMap.t Z).
Definition of_range (i j : positive) (r : ranges) : option Z :=
  match PositiveMap.find i r with Some from_i => PositiveMap.find j from_i | None => None end.
Definition set_range (i j : positive) (v : Z) (r : ranges) : ranges :=
  let from_i := match PositiveMap.find i r with Some from_i => from_i | None => PositiveMap.empty Z end in
  PositiveMap.add i (PositiveMap.add j v from_i) r.

(* What the splits on the way to a node say of the counts, and of the mass M: it is more than [above], and at most
   [up_to_mass] where there is one. *)
Record force := Force { at_least_v : ranges; at_most_v : ranges; above : Q; up_to_mass : option Q }.
Definition nothing : force :=
  Force (PositiveMap.empty (PositiveMap.t Z)) (PositiveMap.empty (PositiveMap.t Z)) 0 None.

Definition least_of (e : force) (j : positive) (c : limits) : Z :=
  match of_range j j (at_least_v e) with Some v => Z.max (floor c) v | None => floor c end.
Definition least_between (e : force) (i j : positive) : Z :=
  match of_range i j (at_least_v e) with Some v => v | None => 0 end.

Definition below (e : force) (i j : positive) (v : Z) : force :=
  let most := match of_range i j (at_most_v e) with Some u => Z.min u (v - 1) | None => v - 1 end in
  Force (at_least_v e) (set_range i j most (at_most_v e)) (above e) (up_to_mass e).
Definition from (e : force) (i j : positive) (v : Z) : force :=
  let least := match of_range i j (at_least_v e) with Some u => Z.max u v | None => v end in
  Force (set_range i j least (at_least_v e)) (at_most_v e) (above e) (up_to_mass e).

Definition lighter (e : force) (v : Q) : force :=
  Force (at_least_v e) (at_most_v e) (above e) (Some (match up_to_mass e with Some u => smaller u v | None => v end)).
Definition heavier (e : force) (v : Q) : force :=
  Force (at_least_v e) (at_most_v e) (larger (above e) v) (up_to_mass e).

(* ---- Conditions ---------------------------------------------------------------------------------- *)

(* Coefficients of q (in units of mass), t, P and p: of one class, or of every class; and those of the sums up to this
   class, N of the counts (in units of mass) and D of t - f q. *)
Record of_one := Coefficients { on_q : Z; on_t : Z; on_P : Z; on_p : Z; on_N : Z; on_D : Z }.
Definition none : of_one := Coefficients 0 0 0 0 0 0.

(* Coefficients of M (in units of shares) and of the sum of t/c; the right side; whether > instead of >=. *)
Record of_sum := Sums { on_M : Z; on_volume : Z; constant : Z; strict : bool }.
Definition closed : of_sum := Sums 0 0 0 false.

(* Condition [ch] of class j. *)
Definition condition_on (pr : problem) (e : force) (j : positive) (c : limits) (ch : ascii)
  : option (of_one * of_sum) :=
  if (ch =? "f")%char then Some (Coefficients (- f c) 1 0 0 0 0, Sums 0 0 0 (1 <=? least_of e j c)) else
  if (ch =? "F")%char then Some (Coefficients (F c) (-1) 0 0 0 0, closed) else
  if (ch =? "q")%char then Some (Coefficients (mass_unit pr) 0 0 0 0 0, Sums 0 0 (least_of e j c) false) else
  if (ch =? "Q")%char then
    option_map (fun u => (Coefficients (- mass_unit pr) 0 0 0 0 0, Sums 0 0 (- u) false)) (of_range j j (at_most_v e)) else
  if (ch =? "r")%char then Some (Coefficients 0 1 0 0 0 0, Sums (- retained_lo c) 0 0 false) else
  if (ch =? "R")%char then Some (Coefficients 0 (-1) 0 0 0 0, Sums (retained_hi c) 0 0 false) else
  if (ch =? "p")%char then Some (Coefficients 0 0 1 0 0 0, Sums (- passing_lo c) 0 0 false) else
  if (ch =? "P")%char then Some (Coefficients 0 0 (-1) 0 0 0, Sums (passing_hi c) 0 0 false) else
  if (ch =? "e")%char then Some (Coefficients 0 (-1) 0 1 0 0, Sums (g c) 0 0 false) else
  if (ch =? "x")%char then Some (Coefficients 0 0 0 1 0 0, closed) else
  None.

(* Condition [ch] of classes i to j: what it has at the sums up to class j and, with the other sign, up to class i - 1. *)
Definition condition_between (pr : problem) (e : force) (i j : positive) (ch : ascii) : option (of_one * of_sum) :=
  if (ch =? "s")%char then
    Some (Coefficients 0 0 0 0 (mass_unit pr) 0, Sums 0 0 (least_between e i j) false) else
  if (ch =? "S")%char then
    option_map (fun u => (Coefficients 0 0 0 0 (- mass_unit pr) 0, Sums 0 0 (- u) false)) (of_range i j (at_most_v e)) else
  if (ch =? "d")%char then Some (Coefficients 0 0 0 0 0 1, Sums 0 0 0 (1 <=? least_between e i j)) else
  None.

(* Condition [ch] of the sample. *)
Definition condition_on_all (pr : problem) (ch : ascii) : option (of_one * of_sum) :=
  if (ch =? "m")%char then Some (Coefficients 0 1 0 0 0 0, Sums 0 0 0 true) else
  if (ch =? "E")%char then Some (Coefficients 0 0 0 (-1) 0 0, Sums (half_total pr) 0 0 false) else
  if (ch =? "w")%char then Some (none, Sums 0 1 0 false) else
  if (ch =? "n")%char then Some (Coefficients (mass_unit pr) 0 0 0 0 0, Sums 0 0 (least_count pr) false) else
  if (ch =? "N")%char then
    option_map (fun n => (Coefficients (- mass_unit pr) 0 0 0 0 0, Sums 0 0 (1 - n) false)) (bound pr) else
  None.

(* ---- A leaf -------------------------------------------------------------------------------------- *)

Definition add_one (k : Z) (x y : of_one) : of_one :=
  Coefficients (on_q x + k * on_q y) (on_t x + k * on_t y) (on_P x + k * on_P y) (on_p x + k * on_p y)
    (on_N x + k * on_N y) (on_D x + k * on_D y).
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

Definition add_at (j : positive) (k : Z) (one : of_one) (s : PositiveMap.t of_one) : PositiveMap.t of_one :=
  PositiveMap.add j (add_one k (of_class_j s j) one) s.
Definition add_between (i j : positive) (k : Z) (one : of_one) (s : PositiveMap.t of_one) : PositiveMap.t of_one :=
  let s := add_at j k one s in if (i =? 1)%positive then s else add_at (Pos.pred i) (- k) one s.

Definition add_multiple (pr : problem) (t : table) (e : force) (x : combination) (k : multiple) : option combination :=
  if times_m k <=? 0 then None else
  match of_class k, up_to k with
  | Zpos i, Zpos j =>
    match PositiveMap.find j t with
    | Some c =>
      if (j <? i)%positive then None else
      match (if (i =? j)%positive then condition_on pr e j c (letter k) else condition_between pr e i j (letter k)) with
      | Some (one, all) =>
        let add := if (i =? j)%positive then add_at j else add_between i j in
        Some (Combination (add (times_m k) one (single x)) (alike x) (add_sum (times_m k) (sums x) all))
      | None => None
      end
    | None => None
    end
  | _, _ =>
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

(* Whether all variables cancel in the classes from j on; if so, in sum the coefficients of P_j, P_(j+1), ..., of which
   t_j is a part, and those of N and D likewise. *)
Record carried := Carried { of_P : Z; of_N : Z; of_D : Z }.
Definition carry (one : of_one) (h : carried) : carried := Carried (of_P h + on_P one) (of_N h + on_N one) (of_D h + on_D one).

Fixpoint cancels (pr : problem) (x : combination) (j : positive) (cs : list limits) : option carried :=
  match cs with
  | [] => Some (Carried 0 0 0)
  | c :: cs =>
    match cancels pr x (Pos.succ j) cs with
    | Some h =>
      let one := of_class_j (single x) j in
      let all := alike x in
      let h := carry all (carry one h) in
      let of_q := on_q one + on_q all + of_N h - of_D h * f c in
      let of_t :=
        (on_t one + on_t all + of_P h + of_D h) * share_unit pr + on_M (sums x) + on_volume (sums x) * per_factor c in
      check ((of_q =? 0) && (of_t =? 0) && (on_p one + on_p all =? 0)) h
    | None => None
    end
  end.

(* Where nothing is said of all classes alike and of the sums, only the classes that are named can keep a variable: a leaf
   that contradicts itself in a few classes takes as long as it is, whatever the number of classes. *)
Definition says_nothing (x : of_one) : bool :=
  (on_q x =? 0) && (on_t x =? 0) && (on_P x =? 0) && (on_p x =? 0) && (on_N x =? 0) && (on_D x =? 0).
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
