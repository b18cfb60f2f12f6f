(* A certificate of a blend, and how its lines are read (certificate-format.md, section 11). *)

From Coq Require Import ZArith QArith List Bool String Ascii FMapPositive.
From Mdm Require Import Numbers Certificate Document Blend.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- What it says ----------------------------------------------------------------------------------- *)

(* A condition on a judged sieve: at least its lower limit, at most its upper one, below or above its target. *)
Inductive side := LowerLimit | UpperLimit | BelowTarget | AboveTarget.

(* A condition of a leaf, times a number above 0; sieves are counted from 1. *)
Record blend_multiple := BlendMultiple { multiplier : Q; side_of : side; of_sieve : Z }.

(* A split of the steps of a stockpile into at most v and more; a leaf of no blend of lower value; a leaf of no blend. *)
Inductive blend_node :=
| SplitSteps (stockpile v : Z)
| NoneBetter (ms : list blend_multiple)
| NoBlend (ms : list blend_multiple).

Record blend_certificate := BlendCertificate {
  asked_blend : blend_question;
  claimed_blend : option blend;
  blend_tree : list blend_node }.

Definition has_aim (a : aim) : bool := match a with NoAim => false | _ => true end.
Definition targets_of (a : aim) : list Q :=
  match a with Deviation ts | MaxDeviation ts | Squares ts => ts | NoAim | Cost _ => [] end.
Definition numbers_of (a : aim) : list Q := match a with NoAim => [] | Cost xs => xs | _ => targets_of a end.

(* ---- Numbers ---------------------------------------------------------------------------------------- *)

Definition most_count : Z := 1000000000.
Definition most_listed : Z := 2 ^ 20.

Definition count_from (least : Z) (w : string) : option Z :=
  match whole 10 w with Some n => check ((least <=? n) && (n <=? most_count)) n | None => None end.

(* Two rationals in order, at most the greatest, that limit something. *)
Definition limits_to (greatest : Q) (x y : string) : option (Q * Q) :=
  match rational x, rational y with
  | Some x, Some y => check (at_most x y && at_most y greatest && (less 0 x || less y greatest)) (x, y)
  | _, _ => None
  end.

(* ---- Lines of the question -------------------------------------------------------------------------- *)

Fixpoint read_share_limits (ls : lines) (done : list (Z * Q * Q)) : result (list (Z * Q * Q) * lines) :=
  match ls with
  | (w :: l) :: rest =>
    if negb (String.eqb w "share") then Ok (rev' done, ls) else
    match l with
    | [i; x; y] =>
      match count_from 1 i, limits_to (of_integer 1) x y with
      | Some i, Some (x, y) =>
        let ascends := match done with (before, _, _) :: _ => before <? i | [] => true end in
        if ascends then read_share_limits rest ((i, x, y) :: done) else Malformed "stockpiles of lines share that do not ascend"
      | _, _ => Malformed "a number of a line share"
      end
    | _ => Malformed "a line share"
    end
  | _ => Ok (rev' done, ls)
  end.

Definition read_count (name : string) (least : Z) : reader Z := fun ls =>
  match ls with
  | [w; n] :: rest =>
    match String.eqb w name, count_from least n with
    | true, Some n => Ok (n, rest)
    | _, _ => Malformed ("the line " ++ name)
    end
  | _ => Malformed ("the line " ++ name)
  end.

Definition size_of_modulus (st : standard) : Q := of_integer (size (sieves_of_modulus st)).

Definition read_modulus (name : string) (st : standard) : reader (list (standard * Q * Q)) := fun ls =>
  match ls with
  | (w :: n :: l) :: rest =>
    if negb (String.eqb w "modulus" && String.eqb n name) then Ok ([], ls) else
    match l with
    | [x; y] =>
      match limits_to (size_of_modulus st) x y with
      | Some (x, y) => Ok ([(st, x, y)], rest)
      | None => Malformed "a number of a line modulus"
      end
    | _ => Malformed "a line modulus"
    end
  | _ => Ok ([], ls)
  end.

Definition read_coarseness : reader (option (Q * Q)) := fun ls =>
  match ls with
  | (w :: l) :: rest =>
    if negb (String.eqb w "coarseness") then Ok (None, ls) else
    match l with
    | [x; y] =>
      match limits_to (of_integer 100) x y with
      | Some limits => Ok (Some limits, rest)
      | None => Malformed "a number of the line coarseness"
      end
    | _ => Malformed "the line coarseness"
    end
  | _ => Ok (None, ls)
  end.

Definition aim_named (w : string) (xs : list Q) : option aim :=
  match xs with
  | [] => if String.eqb w "none" then Some NoAim else None
  | _ =>
    if String.eqb w "cost" then Some (Cost xs)
    else if String.eqb w "deviation" then Some (Deviation xs)
    else if String.eqb w "max-deviation" then Some (MaxDeviation xs)
    else if String.eqb w "squares" then Some (Squares xs)
    else None
  end.

Definition read_aim : reader aim := fun ls =>
  match ls with
  | (w :: what :: l) :: rest =>
    match String.eqb w "minimise", all_words rational l [] with
    | true, Some xs =>
      demand_form (size xs <=? most_listed) "more numbers than there are sieves" ;;
      match aim_named what xs with
      | Some a => Ok (a, rest)
      | None => Malformed "the line minimise"
      end
    | _, _ => Malformed "the line minimise"
    end
  | _ => Malformed "the line minimise"
  end.

Definition read_claim : reader (option blend) := fun ls =>
  if is_line ["blend"; "none"] ls then Ok (None, tl ls) else
  match ls with
  | (w :: l) :: rest =>
    match String.eqb w "blend", all_words (count_from 0) l [] with
    | true, Some ns => demand_form (size ns <=? most_listed) "more stockpiles than can be" ;; Ok (Some ns, rest)
    | _, _ => Malformed "the line blend"
    end
  | _ => Malformed "the line blend"
  end.

(* ---- The tree --------------------------------------------------------------------------------------- *)

(* [targets] is whether conditions may be of targets. *)
Definition blend_side (targets : bool) (ch : ascii) : option side :=
  if Ascii.eqb ch "l" then Some LowerLimit
  else if Ascii.eqb ch "u" then Some UpperLimit
  else if targets && Ascii.eqb ch "a" then Some BelowTarget
  else if targets && Ascii.eqb ch "b" then Some AboveTarget
  else None.

Definition blend_multiple_of (targets : bool) (m w : string) : option blend_multiple :=
  match w with
  | String ch n =>
    match rational m, blend_side targets ch, whole 7 n with
    | Some m, Some sd, Some n => check (less 0 m && (1 <=? n) && (n <=? most_listed)) (BlendMultiple m sd n)
    | _, _, _ => None
    end
  | EmptyString => None
  end.

(* A different number for each condition. *)
Definition blend_key (m : blend_multiple) : positive :=
  Z.to_pos (4 * of_sieve m + match side_of m with LowerLimit => 0 | UpperLimit => 1 | BelowTarget => 2 | AboveTarget => 3 end).

(* None twice, and how many there are. *)
Fixpoint blend_multiples (targets : bool) (l : line) (seen : PositiveMap.t unit) (n : Z) (done : list blend_multiple)
  : option (list blend_multiple * Z) :=
  match l with
  | m :: w :: l =>
    match blend_multiple_of targets m w with
    | Some m =>
      if PositiveMap.mem (blend_key m) seen then None
      else blend_multiples targets l (PositiveMap.add (blend_key m) tt seen) (n + 1) (m :: done)
    | None => None
    end
  | [] => Some (rev' done, n)
  | _ => None
  end.

(* A node, how many subtrees it adds to those that are to come, and its multipliers. *)
Definition blend_node_of (has_blend targets : bool) (w : string) (l : line) : option (blend_node * Z * Z) :=
  if String.eqb w "split" then
    match l with
    | [i; v] =>
      match count_from 1 i, count_from 0 v with
      | Some i, Some v => Some (SplitSteps i v, 1, 0)
      | _, _ => None
      end
    | _ => None
    end
  else if has_blend && String.eqb w "leaf" then
    option_map (fun '(ms, n) => (NoneBetter ms, -1, n)) (blend_multiples targets l (PositiveMap.empty unit) 0 [])
  else if String.eqb w "none" then
    option_map (fun '(ms, n) => (NoBlend ms, -1, n)) (blend_multiples false l (PositiveMap.empty unit) 0 [])
  else None.

(* Nodes until every split has its two subtrees: [to_come] subtrees are still to come. [n] counts the nodes and multipliers. *)
Fixpoint read_blend_tree (has_blend targets : bool) (ls : lines) (to_come n : Z) (done : list blend_node)
  : result (list blend_node * lines) :=
  if most_nodes <? n then Malformed "too many nodes and multipliers" else
  if to_come =? 0 then Ok (rev' done, ls) else
  match ls with
  | (w :: l) :: rest =>
    match blend_node_of has_blend targets w l with
    | Some (node, more, m) => read_blend_tree has_blend targets rest (to_come + more) (n + 1 + m) (node :: done)
    | None => Malformed "a line split, leaf or none"
    end
  | _ => Malformed "a line split, leaf or none is missing"
  end.

(* ---- The whole -------------------------------------------------------------------------------------- *)

Definition read_blend_question : reader blend_question := fun ls =>
  let* (M, ls) := read_count "steps" 1 ls in
  let* (shares, ls) := read_share_limits ls [] in
  let* (K, ls) :=
    if named "at-most" ls then let* (K, ls) := read_count "at-most" 1 ls in Ok (Some K, ls) else Ok (None, ls) in
  let* (astm, ls) := read_modulus "astm" Astm ls in
  let* (en, ls) := read_modulus "en" En ls in
  let* (factor, ls) := read_coarseness ls in
  let* (aim, ls) := read_aim ls in
  Ok (BlendQuestion M shares K (astm ++ en)%list factor aim, ls).

Definition read_blend_certificate (ls : lines) : result blend_certificate :=
  demand_form (forallb (forallb is_word) ls) "a word that is longer than any number" ;;
  demand_form (is_line ["mdm-certificate"; "blend"; "1"] ls) "the line mdm-certificate blend 1 is missing" ;;
  let* (asked, ls) := read_blend_question (tl ls) in
  let* (claim, ls) := read_claim ls in
  let has_blend := match claim with Some _ => true | None => false end in
  let targets := match targets_of (aim_of asked) with [] => false | _ => true end in
  let* (nodes, ls) :=
    if has_blend && negb (has_aim (aim_of asked)) then Ok ([], ls)
    else read_blend_tree has_blend targets ls 1 0 [] in
  demand_form (is_line ["end"] ls && is_line [""] (tl ls) && match tl (tl ls) with [] => true | _ => false end)
    "the line end is missing, or something follows it" ;;
  Ok (BlendCertificate asked claim nodes).
