(* The leaves of windows of the mass: what every match has there contradicts itself (certificate-format.md, section 6;
   Theorem 20). *)

From Coq Require Import ZArith QArith List Bool String Ascii FMapPositive.
From Mdm Require Import Numbers Certificate Leaf.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- Bounds on shares ---------------------------------------------------------------------------- *)

(* Of a share, or of what passes, in units of shares. *)
Record bounds := Bounds { lowest : Z; highest : Z }.
Definition narrowed (b : bounds) (lo hi : Z) : bounds := Bounds (Z.max (lowest b) lo) (Z.min (highest b) hi).

(* Class by class, from the finest one, [a, b] and [L, U] by what passes the class below: [G] and [before]. All passes the
   coarsest one. *)
Fixpoint upwards (pr : problem) (G : Z) (before : bounds) (cs : list limits) : list (bounds * bounds) :=
  match cs with
  | [] => []
  | c :: cs =>
    let G := G + g c in
    let own := narrowed (Bounds (retained_lo c) (retained_hi c)) (g c - half_total pr) (g c + half_total pr) in
    let lines :=
      match cs with
      | [] => Bounds (share_unit pr) (share_unit pr)
      | _ => narrowed (Bounds (passing_lo c) (passing_hi c)) (G - half_total pr) (G + half_total pr)
      end in
    let passing := narrowed lines (lowest before + lowest own) (highest before + highest own) in
    (own, passing) :: upwards pr G passing cs
  end.

(* [L, U] by what passes the class above. *)
Fixpoint downwards (js : list (bounds * bounds)) : list (bounds * bounds) :=
  match js with
  | [] => []
  | (own, passing) :: js =>
    match downwards js with
    | [] => [(own, passing)]
    | ((next, above) :: _) as js => (own, narrowed passing (lowest above - highest next) (highest above - lowest next)) ::
      js
    end
  end.

(* [l, h]. *)
Fixpoint differences (before : bounds) (js : list (bounds * bounds)) : list bounds :=
  match js with
  | [] => []
  | (own, passing) :: js =>
    narrowed own (lowest passing - highest before) (highest passing - lowest before) :: differences passing js
  end.

Definition bounds_of_shares (pr : problem) : list bounds :=
  differences (Bounds 0 0) (downwards (upwards pr 0 (Bounds 0 0) (classes_of pr))).

(* ---- A class in a window ------------------------------------------------------------------------- *)

(* The ends s and S in units of mass, as fractions; a numerator that is not positive is no end. *)
Record ends := Ends { s_num : Z; s_den : Z; S_num : Z; S_den : Z }.
Definition ends_of (pr : problem) (e : force) : ends :=
  let in_mass x := times x (of_integer (mass_unit pr)) in
  let s := in_mass (above e) in
  let u := match up_to_mass e with Some u => in_mass u | None => 0%Q end in
  Ends (Qnum s) (Zpos (Qden s)) (Qnum u) (Zpos (Qden u)).

(* Shares in a window are integers, or reals, of which [units] are the whole. *)
Definition units (pr : problem) (w : ends) : Z := share_unit pr * (Z.max 1 (s_num w) * Z.max 1 (S_num w)).

(* Of a class in a window: the bounds l and h on its share, g, the shares f / S and F / s of one particle (0: no bound), and
   its least and greatest count. *)
Record view := View { l : Z; h : Z; target : Z; low_one : Z; high_one : Z; fewest : Z; greatest : option Z }.

Definition least_count_of (l high_one forced : Z) : Z :=
  Z.max (Z.max 0 forced) (if 0 <? l then if 0 <? high_one then l / high_one + 1 else 1 else 0).
Definition greatest_count_of (h low_one : Z) (forced : option Z) : option Z :=
  let own := if h <=? 0 then Some 0 else if 0 <? low_one then Some ((h - 1) / low_one) else None in
  match own, forced with
  | Some n, Some u => Some (Z.min n u)
  | Some n, None => Some n
  | None, _ => forced
  end.

Definition view_of (pr : problem) (w : ends) (e : force) (j : positive) (c : limits) (b : bounds) : view :=
  let s := Z.max 1 (s_num w) in
  let u := Z.max 1 (S_num w) in
  let l := lowest b * (s * u) in
  let h := highest b * (s * u) in
  let low_one := if 0 <? S_num w then f c * S_den w * share_unit pr * s else 0 in
  let high_one := if 0 <? s_num w then F c * s_den w * share_unit pr * u else 0 in
  View l h (g c * (s * u)) low_one high_one
    (least_count_of l high_one (least_of e j c)) (greatest_count_of h low_one (of_range j j (at_most_v e))).

Definition is_empty (v : view) : bool := match greatest v with Some n => n <? fewest v | None => false end.
Definition has_count (v : view) (q : Z) : bool :=
  (fewest v <=? q) && match greatest v with Some n => q <=? n | None => true end.

(* ---- The greatest value of a class --------------------------------------------------------------- *)

(* What a class adds to a sum: of a share, of a particle, and less of what the share is more than its target. *)
Record weights := Weights { per_share : Z; per_count : Z; per_excess : Z }.

Definition value_at (v : view) (w : weights) (q y : Z) : Z :=
  per_count w * q + per_share w * y - per_excess w * Z.max 0 (y - target v).

(* The values of q particles with the least and the greatest share, and the target between them; and whether the class has
   such a share, or near an open end others with the same value. *)
Definition points (v : view) (w : weights) (q : Z) : list (Z * bool) :=
  if q =? 0 then [(0, true)] else
  let low := Z.max (l v) (q * low_one v) in
  let high := if 0 <? high_one v then Z.min (h v) (q * high_one v) else h v in
  let is_flat :=
    (per_share w =? 0) && ((per_excess w =? 0) || (high <=? target v)) ||
    (per_share w =? per_excess w) && (target v <=? low) in
  [(value_at v w q low, (q * low_one v <? l v) || (low <? high) && is_flat);
   (value_at v w q high, negb (0 <? high_one v) || (h v <? q * high_one v))] ++
  (if (low <? target v) && (target v <? high) then [(value_at v w q (target v), true)] else []).

(* The last count that has less than a share, and the next one. *)
Definition around (share of_one : Z) : list Z :=
  if 0 <? of_one then [share / of_one; share / of_one + 1] else [].
Definition candidates (v : view) (w : weights) : list Z :=
  filter (has_count v)
    (fewest v :: match greatest v with Some n => [n] | None => [] end ++ [1] ++ around (h v) (high_one v) ++ around (l v)
      (low_one v) ++
     if 0 <? per_excess w then around (target v) (high_one v) ++ around (target v) (low_one v) else []).

Definition better (x y : Z * bool) : Z * bool :=
  if fst x <? fst y then y else if fst y <? fst x then x else (fst x, snd x || snd y).
Definition best (ps : list (Z * bool)) : option (Z * bool) :=
  match ps with
  | [] => None
  | p :: ps => Some (fold_left better ps p)
  end.

(* None where more particles always add more. *)
Definition greatest_value (v : view) (w : weights) : option (Z * bool) :=
  match greatest v with
  | None => if 0 <? per_count w then None else best (flat_map (points v w) (candidates v w))
  | Some _ => best (flat_map (points v w) (candidates v w))
  end.

(* ---- Conditions ---------------------------------------------------------------------------------- *)

(* A condition on shares y and counts q: so often a sum of shares, of counts, the excess over all g, and the sum of y/c less
   w/S; at least the right sides, which are that of shares (in units of shares) and that of counts. *)
Record terms := Terms {
  on_shares : Z; on_counts : Z; on_excess : Z; on_volume : Z; right_of_shares : Z; right_of_counts : Z }.

Definition condition_of_all (pr : problem) (ch : ascii) : option terms :=
  if (ch =? "t")%char then Some (Terms 1 0 0 0 (share_unit pr) 0) else
  if (ch =? "T")%char then Some (Terms (-1) 0 0 0 (- share_unit pr) 0) else
  if (ch =? "E")%char then Some (Terms 0 0 1 0 (- half_total pr) 0) else
  if (ch =? "w")%char then Some (Terms 0 0 0 1 0 0) else
  if (ch =? "n")%char then Some (Terms 0 1 0 0 0 (least_count pr)) else
  if (ch =? "N")%char then option_map (fun B => Terms 0 (-1) 0 0 0 (1 - B)) (bound pr) else
  None.

(* On what passes a class. *)
Definition condition_of_passing (c : limits) (ch : ascii) : option terms :=
  if (ch =? "p")%char then Some (Terms 1 0 0 0 (passing_lo c) 0) else
  if (ch =? "P")%char then Some (Terms (-1) 0 0 0 (- passing_hi c) 0) else
  None.

(* On the particles of the classes i to j. *)
Definition condition_of_counts (e : force) (i j : positive) (ch : ascii) : option terms :=
  if (ch =? "s")%char then Some (Terms 0 1 0 0 0 (least_between e i j)) else
  if (ch =? "S")%char then option_map (fun u => Terms 0 (-1) 0 0 0 (- u)) (of_range i j (at_most_v e)) else
  None.

(* A sum of conditions: what it has at the sums of shares and counts up to single classes, and at those of all. *)
Record tally := Tally { up_to_class : PositiveMap.t (Z * Z); of_sample : terms }.
Definition nothing_said : tally := Tally (PositiveMap.empty (Z * Z)) (Terms 0 0 0 0 0 0).

Definition pair_at (s : PositiveMap.t (Z * Z)) (j : positive) : Z * Z :=
  match PositiveMap.find j s with Some x => x | None => (0, 0) end.
Definition add_pair (j : positive) (k : Z) (x : terms) (s : PositiveMap.t (Z * Z)) : PositiveMap.t (Z * Z) :=
  let (shares, counts) := pair_at s j in
  PositiveMap.add j (shares + k * on_shares x, counts + k * on_counts x) s.
Definition add_terms (k : Z) (x y : terms) : terms :=
  Terms (on_shares x + k * on_shares y) (on_counts x + k * on_counts y) (on_excess x + k * on_excess y)
    (on_volume x + k * on_volume y) (right_of_shares x + k * right_of_shares y) (right_of_counts x + k * right_of_counts y).
Definition right_alone (x : terms) : terms := Terms 0 0 0 0 (right_of_shares x) (right_of_counts x).

Definition add_condition (pr : problem) (t : table) (e : force) (x : tally) (k : multiple) : option tally :=
  let m := times_m k in
  if m <=? 0 then None else
  match of_class k, up_to k with
  | Zpos i, Zpos j =>
    match PositiveMap.find j t with
    | Some c =>
      if (j <? i)%positive then None else
      if (i =? j)%positive then
        option_map (fun y => Tally (add_pair j m y (up_to_class x)) (add_terms m (of_sample x) (right_alone y)))
          (condition_of_passing c (letter k))
      else
        option_map (fun y =>
            let up_to_j := add_pair j m y (up_to_class x) in
            Tally (if (i =? 1)%positive then up_to_j else add_pair (Pos.pred i) (- m) y up_to_j)
              (add_terms m (of_sample x) (right_alone y)))
          (condition_of_counts e i j (letter k))
    | None => None
    end
  | _, _ => option_map (fun y => Tally (up_to_class x) (add_terms m (of_sample x) y)) (condition_of_all pr (letter k))
  end.

Fixpoint add_conditions (pr : problem) (t : table) (e : force) (ks : list multiple) (x : tally) : option tally :=
  match ks with
  | [] => Some x
  | k :: ks =>
    match add_condition pr t e x k with
    | Some x => add_conditions pr t e ks x
    | None => None
    end
  end.

(* ---- The leaf ------------------------------------------------------------------------------------ *)

Fixpoint views (pr : problem) (w : ends) (e : force) (j : positive) (cs : list limits) (bs : list bounds) : list (limits *
  view) :=
  match cs, bs with
  | c :: cs, b :: bs => (c, view_of pr w e j c b) :: views pr w e (Pos.succ j) cs bs
  | _, _ => []
  end.

(* The sum of the greatest values of the classes from j on, and whether all have theirs; before them what the sum has at
   the shares and at the counts of each: a share is part of all that passes from its class on.
   Values are of the weights times
   the unit of shares, shares in a window's units. *)
Record greatest_sum := Greatest { at_shares : Z; at_counts : Z; sum_of_all : Z; all_have : bool }.
Fixpoint greatest_of_all (pr : problem) (D : Z) (x : tally) (j : positive) (vs : list (limits * view)) : option
  greatest_sum :=
  match vs with
  | [] => Some (Greatest (on_shares (of_sample x)) (on_counts (of_sample x)) 0 true)
  | (c, v) :: vs =>
    match greatest_of_all pr D x (Pos.succ j) vs with
    | Some r =>
      let (shares, counts) := pair_at (up_to_class x) j in
      let shares := at_shares r + shares in
      let counts := at_counts r + counts in
      let su := share_unit pr in
      match greatest_value v (Weights (su * shares + on_volume (of_sample x) * per_factor c) (counts * (D * su)) (on_excess
        (of_sample x) * su)) with
      | Some (value, has) => Some (Greatest shares counts (sum_of_all r + value) (all_have r && has))
      | None => None
      end
    | None => None
    end
  end.

(* The right side in units of values, times the denominator of w. *)
Definition right_side (pr : problem) (w : ends) (x : terms) : Z :=
  let su := share_unit pr in
  let D := units pr w in
  (D * right_of_shares x + D * su * right_of_counts x) * Zpos (Qden (volume pr)) +
  (if 0 <? S_num w then on_volume x * Qnum (volume pr) * (S_den w * mass_unit pr * (su * su) * Z.max 1 (s_num w)) else 0).

Definition rules_out (pr : problem) (t : table) (shares : list bounds) (e : force) (ks : list multiple) : bool :=
  match add_conditions pr t e ks nothing_said with
  | None => false
  | Some x =>
    let w := ends_of pr e in
    let vs := views pr w e 1 (classes_of pr) shares in
    existsb (fun '(_, v) => is_empty v) vs ||
    match greatest_of_all pr (units pr w) x 1 vs with
    | None => false
    | Some r =>
      let value := sum_of_all r * Zpos (Qden (volume pr)) in
      let right := right_side pr w (of_sample x) in
      (value <? right) || (value =? right) && negb (all_have r)
    end
  end.
