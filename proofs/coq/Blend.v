(* What the verdict on a blend is about, in the words of Theorem 22: stockpiles, blends of them in steps, limits, and the value
   that is to be least. All numbers are rational. To be read before anything else about blends: all that is proved of them is
   proved about these definitions. *)

From Coq Require Import ZArith QArith Qabs Qminmax List Bool.
From Mdm Require Import Numbers Gradation Rows.
Import ListNotations.
Open Scope Q_scope.

(* ---- Stockpiles ------------------------------------------------------------------------------------- *)

(* The openings of a stockpile in mm, ascending, each with the percent of the mass that passes it. *)
Definition curve : Type := list (Q * Q).

(* [mm] is the unit of the openings, [total] the mass of all rows, and [finer] that of the rows before these. *)
Fixpoint curve_of_rows (mm total finer : Q) (rs : list row) (done : curve) : curve :=
  match rs with
  | r :: rs =>
    curve_of_rows mm total (add finer (retained r)) rs
      ((times (opening r) mm, over (times (of_integer 100) finer) total) :: done)
  | [] => rev' done
  end.
Definition curve_of (mm : Q) (rs : list row) : curve :=
  curve_of_rows mm (fold_left add (map_all retained rs) 0) 0 rs [].

(* What a stockpile tells of a size: nothing, or the percent that passes it, interpolated or not. *)
Inductive told := Unknown | Known (percent : Q) (is_interpolated : bool).

(* At s, on the line from p at x to q at y. *)
Definition linear (x p y q s : Q) : Q := add p (times (over (subtract s x) (subtract y x)) (subtract q p)).

(* [before] is the last opening that is below s, if there is one, with what passes it. *)
Fixpoint told_from (before : option (Q * Q)) (c : curve) (s : Q) : told :=
  match c with
  | [] => Known (of_integer 100) false
  | (y, q) :: c =>
    if less y s then told_from (Some (y, q)) c s
    else if equal y s then Known q false
    else
      match before with
      | None => Known 0 false
      | Some (x, p) =>
        if equal p q then Known q false
        else if equal x 0 then Unknown
        else Known (linear x p y q s) true
      end
  end.
Definition told_at (c : curve) (s : Q) : told := told_from None c s.

Definition tells (s : Q) (c : curve) : bool := match told_at c s with Known _ _ => true | Unknown => false end.
Definition percent_at (s : Q) (c : curve) : Q := match told_at c s with Known p _ => p | Unknown => 0 end.

(* ---- Questions -------------------------------------------------------------------------------------- *)

(* A fineness modulus, and its sieves in mm. *)
Inductive standard := Astm | En.
Definition sieves_of_modulus (st : standard) : list Q :=
  match st with
  | Astm => [3 # 20; 3 # 10; 3 # 5; 59 # 50; 59 # 25; 19 # 4; 19 # 2; 19 # 1; 75 # 2; 75 # 1; 150 # 1]
  | En => [1 # 8; 1 # 4; 1 # 2; 1 # 1; 2 # 1; 4 # 1]
  end.

(* The sieves of the coarseness factor in mm. *)
Definition coarse_sieve : Q := 19 # 2.
Definition fine_sieve : Q := 59 # 25.

(* What is to be least: costs have one for each stockpile, targets one for each sieve, in percent. *)
Inductive aim :=
| NoAim
| Cost (costs : list Q)
| Deviation (targets : list Q)
| MaxDeviation (targets : list Q)
| Squares (targets : list Q).

(* Stockpiles are counted from 1. *)
Record blend_question := BlendQuestion {
  steps : Z;
  share_limits : list (Z * Q * Q);
  most_stockpiles : option Z;
  modulus_limits : list (standard * Q * Q);
  coarseness_limits : option (Q * Q);
  aim_of : aim }.

(* ---- Blends ----------------------------------------------------------------------------------------- *)

(* A blend has so many steps of each stockpile. *)
Definition blend : Type := list Z.

Fixpoint weighted (ns : blend) (xs : list Q) : Q :=
  match ns, xs with
  | n :: ns, x :: xs => inject_Z n * x + weighted ns xs
  | _, _ => 0
  end.
Definition mean (M : Z) (ns : blend) (xs : list Q) : Q := weighted ns xs / inject_Z M.

(* The percent of the blend that passes s: masses add up. *)
Definition passed (M : Z) (curves : list curve) (ns : blend) (s : Q) : Q := mean M ns (map (percent_at s) curves).

(* The shares that stay on its sieves, added up. *)
Definition fineness_modulus (M : Z) (curves : list curve) (ns : blend) (st : standard) : Q :=
  fold_right (fun s sum => (100 - passed M curves ns s) / 100 + sum) 0 (sieves_of_modulus st).

(* What stays on the coarse sieve is from x to y percent of what stays on the fine one, of which it is a part. *)
Definition keeps_coarseness (M : Z) (curves : list curve) (ns : blend) (x y : Q) : Prop :=
  let coarse := 100 - passed M curves ns coarse_sieve in
  let fine := 100 - passed M curves ns fine_sieve in
  x / 100 * fine <= coarse /\ (y < 100 -> coarse <= y / 100 * fine).

Fixpoint sum_of_steps (ns : blend) : Z := match ns with n :: ns => (n + sum_of_steps ns)%Z | [] => 0%Z end.
Fixpoint used (ns : blend) : Z := match ns with n :: ns => ((if 0 <? n then 1 else 0) + used ns)%Z | [] => 0%Z end.

(* The element with this number, counted from 1. *)
Fixpoint numbered {A} (j : Z) (l : list A) : option A :=
  match l with
  | x :: l => if (j =? 1)%Z then Some x else numbered (j - 1) l
  | [] => None
  end.

(* [limits] are those of the specification: an opening in mm, and the least and most percent that may pass it. *)
Definition told_by_all (curves : list curve) (s : Q) : bool := less 0 s && forallb (tells s) curves.

Record allowed (limits : list (Q * Q * Q)) (curves : list curve) (q : blend_question) (ns : blend) : Prop := {
  of_all_stockpiles : length ns = length curves;
  steps_from_0 : Forall (fun n => (0 <= n)%Z) ns;
  steps_are_all : sum_of_steps ns = steps q;
  within_shares : forall i x y, In (i, x, y) (share_limits q) ->
    exists n, numbered i ns = Some n /\ x <= inject_Z n / inject_Z (steps q) <= y;
  few_enough : forall K, most_stockpiles q = Some K -> (used ns <= K)%Z;
  within_limits : forall s least most, In (s, least, most) limits -> told_by_all curves s = true ->
    least <= passed (steps q) curves ns s <= most;
  within_moduli : forall st x y, In (st, x, y) (modulus_limits q) ->
    x <= fineness_modulus (steps q) curves ns st <= y;
  within_coarseness : forall x y, coarseness_limits q = Some (x, y) -> keeps_coarseness (steps q) curves ns x y }.

(* ---- The value -------------------------------------------------------------------------------------- *)

(* The sieves that have targets. *)
Definition sieves_with_targets (limits : list (Q * Q * Q)) (curves : list curve) : list Q :=
  filter (told_by_all curves) (map (fun '(s, _, _) => s) limits).

Definition deviations (limits : list (Q * Q * Q)) (curves : list curve) (M : Z) (ts : list Q) (ns : blend) : list Q :=
  map (fun '(s, t) => Qabs (passed M curves ns s - t)) (combine (sieves_with_targets limits curves) ts).

Definition value (limits : list (Q * Q * Q)) (curves : list curve) (q : blend_question) (ns : blend) : Q :=
  let M := steps q in
  match aim_of q with
  | NoAim => 0
  | Cost cs => mean M ns cs
  | Deviation ts => fold_right Qplus 0 (deviations limits curves M ts ns)
  | MaxDeviation ts => fold_right Qmax 0 (deviations limits curves M ts ns)
  | Squares ts => fold_right (fun d sum => d * d + sum) 0 (deviations limits curves M ts ns)
  end.

(* ---- What is claimed -------------------------------------------------------------------------------- *)

(* Each sieve that limits something, and those of the moduli and the coarseness factor, is told of by all stockpiles; and there
   are as many costs as stockpiles, or targets as sieves. *)
Record answerable (limits : list (Q * Q * Q)) (curves : list curve) (q : blend_question) : Prop := {
  steps_positive : (1 <= steps q)%Z;
  limits_are_told : forall s least most, In (s, least, most) limits -> 0 < s -> 0 < least \/ most < 100 ->
    told_by_all curves s = true;
  moduli_are_told : forall st x y s, In (st, x, y) (modulus_limits q) -> In s (sieves_of_modulus st) ->
    told_by_all curves s = true;
  factor_is_told : coarseness_limits q <> None ->
    told_by_all curves coarse_sieve = true /\ told_by_all curves fine_sieve = true;
  aim_fits :
    match aim_of q with
    | NoAim => True
    | Cost cs => length cs = length curves
    | Deviation ts | MaxDeviation ts | Squares ts => length ts = length (sieves_with_targets limits curves)
    end }.

(* This blend is allowed, and none that is has a lower value than its v; or none is allowed. *)
Definition best_blend (limits : list (Q * Q * Q)) (curves : list curve) (q : blend_question) (claim : option blend) (v : Q) : Prop :=
  match claim with
  | Some ns =>
    allowed limits curves q ns /\ value limits curves q ns == v /\
    forall ms, allowed limits curves q ms -> v <= value limits curves q ms
  | None => forall ms, ~ allowed limits curves q ms
  end.
