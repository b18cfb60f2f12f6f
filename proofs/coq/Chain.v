(* The exact match in integers, and the check of a chain (certificate-format.md, section 3; Theorem 5). *)

From Coq Require Import ZArith List Bool String FMapPositive.
From Mdm Require Import Numbers.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* A class in integers: A_j = f / m and B_j = F / m in some unit of scales, all to the power b, and the floor
   r. Where m = 0 it holds no particles. *)
Record bounds := Bounds { f : Z; F : Z; m : Z; r : Z }.

(* The least count q >= r with q^b B > L, for a class with mass. *)
Definition above (b : Z) (L : ratio) (j : bounds) : Z :=
  let (n, d) := L in Z.max (r j) (root b ((n * m j) / (d * F j)) + 1).

(* The least count of a class of any mass at scales above L. *)
Definition least (b : Z) (L : ratio) (j : bounds) : Z := if m j =? 0 then 0 else above b L j.

(* Classes by their number, from 1. *)
Definition table : Type := PositiveMap.t bounds.
Fixpoint number_from (j : positive) (js : list bounds) (t : table) : table :=
  match js with
  | [] => t
  | c :: js => number_from (Pos.succ j) js (PositiveMap.add j c t)
  end.
Definition find (j : Z) (t : table) : option bounds :=
  match j with Zpos p => PositiveMap.find p t | _ => None end.

(* The replay. A count above the claimed bound B ends it: that count is a greater bound by itself. *)
Fixpoint replay (b B : Z) (t : table) (L : ratio) (chain : list Z) : result ratio :=
  match chain with
  | [] => Ok L
  | j :: chain =>
    match find j t with
    | Some c =>
      if m c =? 0 then Refused "chain: every step is a class with mass" else
      let q := above b L c in
      if q <=? B then replay b B t (q ^ b * f c, m c) chain else Refused "chain: count(j, L) <= N"
    | None => Refused "chain: every step is a class with mass"
    end
  end.

(* The end test. *)
Definition closed (b : Z) (L : ratio) (j : bounds) : bool :=
  let (n, d) := L in (m j =? 0) || (above b L j ^ b * f j * d <=? m j * n).

(* That a chain proves the bound B: a whole chain, which ends with a match, or any prefix of one. *)
Definition check_chain (b B : Z) (whole : bool) (js : list bounds) (chain : list Z) : result unit :=
  let* L := replay b B (number_from 1 js (PositiveMap.empty bounds)) (0, 1) chain in
  demand (negb whole || forallb (closed b L) js) "chain: count(j, L)^b A <= L" ;;
  demand (sum (map (least b L) js) =? B) "chain: sum of count(j, L) = N".

(* q particles of class j, R at least, at the scale S = n/d. *)
Definition fits (b R : Z) (S : ratio) (j : bounds) (q : Z) : bool :=
  let (n, d) := S in
  if m j =? 0 then q =? 0
  else (Z.max 1 R <=? q) && (q ^ b * f j * d <? n * m j) && (n * m j <=? q ^ b * F j * d).

(* The most that class j can hold at scales up to z: q^b A < z. All A must be positive. *)
Definition most_below (b : Z) (z : ratio) (j : bounds) : Z :=
  let (n, d) := z in if m j =? 0 then 0 else root b ((n * m j - 1) / (d * f j)).

Definition check_above (b M : Z) (z : ratio) (js : list bounds) : result unit :=
  demand (forallb (fun j => (m j =? 0) || (0 <? f j)) js) "above: A > 0" ;;
  demand (sum (map (most_below b z) js) <? M) "above: sum of h < M".
