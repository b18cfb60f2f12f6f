(* A certificate of an exact match: the problem in integers, and its check (certificate-format.md, 2 and 3).

   b is the degree of the masses' powers here: that of the law x^(a/b) times the root d of the gradation. For x^(a/b) is
   Y^(a/(b d)) for the opening's power Y = x^d. *)

From Coq Require Import ZArith QArith List Bool String FMapPositive.
From Mdm Require Import Numbers Gradation Certificate Question Chain.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* Units in which openings, masses and factors are integers. *)
Record units := Units { of_openings : Z; of_masses : Z; of_factors : Z }.

Definition units_of (rs : list row) : units :=
  Units (common_denominator (map opening rs)) (common_denominator (map retained rs))
        (common_denominator (map factor rs)).

(* Class j to the power b, without its floor. *)
Definition in_integers (u : units) (a b : Z) (j : class) : bounds :=
  let C := in_units (c j) (of_factors u) ^ b in
  Bounds (C * in_units (lower j) (of_openings u) ^ a) (C * in_units (upper j) (of_openings u) ^ a)
         (in_units (mass j) (of_masses u) ^ b) 0.

(* A scale, to the power b, in the integers' unit of scales. *)
Definition in_scale_units (u : units) (a b : Z) (S : Q) : ratio :=
  (Qnum S * (of_factors u ^ b * of_openings u ^ a), Zpos (Qden S) * of_masses u ^ b).

(* [common] as a multiple of the divisor too; limit 4. *)
Definition include (common divisor : Z) : result Z :=
  if common mod divisor =? 0 then Ok common else
  let common := Z.lcm common divisor in
  demand_form (bits common <=? power_bits) too_long ;; Ok common.

Fixpoint include_all (divisors : list Z) (common : Z) : result Z :=
  match divisors with
  | [] => Ok common
  | d :: divisors => let* common := include common d in include_all divisors common
  end.

(* For solids, where the law is x^3: the factors of the classes with mass, and W = sum of m_j / c_j in integers over a
   common multiple of the factors. *)
Definition with_mass (js : list class) : list class := filter (fun j => negb (equal (mass j) 0)) js.
Definition integer_factor (u : units) (j : class) : Z := in_units (c j) (of_factors u).
Definition solids_of_unit_scale (u : units) (js : list class) (common : Z) : Z :=
  sum (map (fun j => in_units (mass j) (of_masses u) * (common / integer_factor u j)) js).

(* The scale at which the sum of x^3 is the given one, to the power b, in the integers' unit of scales; limit 3, for k
   classes. *)
Definition scale_of_volume (u : units) (b k W common : Z) (volume : Q) : result ratio :=
  let s := fraction (Qnum volume * common) (Zpos (Qden volume) * W) in
  demand_form (k * (b * bits_of s) <=? work_of_scales) too_long ;;
  Ok (Qnum s ^ b * of_openings u ^ 3, Zpos (Qden s) ^ b).

(* What the question demands of scales: the witness's is at least [enough]; every match has one of at least
   [start], and one above [excluded]. 0 where nothing is demanded. *)
Record scales := Scales { enough : ratio; start : ratio; excluded : ratio }.

Definition scales_of (u : units) (b : Z) (js : list class) (s : solids) : result scales :=
  match s with
  | Anything => Ok (Scales (0, 1) (0, 1) (0, 1))
  | _ =>
    let k := size js in
    let js := with_mass js in
    let* common := include_all (map (integer_factor u) js) 1 in
    let W := solids_of_unit_scale u js common in
    let* enough := scale_of_volume u b k W common (volume_enough s) in
    match s with
    | Volume _ _ _ =>
      let* below := scale_of_volume u b k W common (volume_below s) in Ok (Scales enough (0, 1) below)
    | _ => Ok (Scales enough enough (0, 1))
    end
  end.

(* The least count q with q^b B >= S, for S > 0. *)
Definition from_start (b : Z) (S : ratio) (j : bounds) : Z :=
  let (n, d) := S in Numbers.root b ((n * m j - 1) / (d * F j)) + 1.

(* The floors: what every match has in class j. *)
Definition with_floor (b R : Z) (s : scales) (z : ratio) (j : bounds) : bounds :=
  let set floor := Bounds (f j) (F j) (m j) floor in
  let floor := Z.max 1 R in
  let floor := if fst (start s) =? 0 then floor else Z.max floor (from_start b (start s) j) in
  let floor := Z.max (above b (excluded s) (set floor)) (above b z (set floor)) in
  set floor.

Definition longest_scale (ss : list ratio) : Z := longest (fun '(n, d) => Z.max (bits n) (bits d)) ss 0.

(* Class by class: the witness's counts, 0 where it has no line. *)
Fixpoint counts (j : Z) (js : list bounds) (ws : list witness_line) : option (list Z) :=
  match js, ws with
  | [], [] => Some []
  | [], _ => None
  | c :: js, [] => if m c =? 0 then option_map (cons 0) (counts (j + 1) js []) else None
  | c :: js, w :: ws' =>
    if m c =? 0 then option_map (cons 0) (counts (j + 1) js ws)
    else if index w =? j then option_map (cons (count w)) (counts (j + 1) js ws') else None
  end.

Fixpoint all_fit (b R : Z) (S : ratio) (js : list bounds) (qs : list Z) : bool :=
  match js, qs with
  | [], [] => true
  | j :: js, q :: qs => fits b R S j q && all_fit b R S js qs
  | _, _ => false
  end.

(* The sizes: class j holds q particles of the size T^(1/(a d)), T = S m^b / (q c)^b. *)
Fixpoint check_sizes (u : units) (a b d : Z) (S : ratio) (js : list class) (ws : list witness_line) : result unit :=
  match js, ws with
  | j :: js, w :: ws =>
    let (n, e) := S in
    let T := (n * in_units (mass j) (of_masses u) ^ b,
              count w ^ b * e * (integer_factor u j ^ b * of_openings u ^ a)) in
    check_size a d j w T ;; check_sizes u a b d S js ws
  | _, _ => Ok tt
  end.

(* Of the classes [js] between rows, whose openings are to the power d. *)
Definition check_exact (cert : certificate) (d : Z) (rs : list row) (js : list class) (scale : Q) (z : option Q)
  (chain : option (list Z)) : result unit :=
  let q := asked cert in
  let a := Certificate.a q in
  let b := Certificate.b q * d in
  let u := units_of rs in
  let S := in_scale_units u a b scale in
  let z' := match z with Some z => in_scale_units u a b z | None => (0, 1) end in
  let* ss := scales_of u b js (solids_of q) in
  demand_form ((size rs - 1) * longest_scale [S; enough ss; z'; excluded ss] <=? work_of_scales) too_long ;;
  let bs := map (fun j => with_floor b (min_per_class q) ss z' (in_integers u a b j)) js in
  check_pi (solids_of q) ;;
  match found (claimed cert), bound_of (claimed cert), counts 1 bs (witness cert) with
  | Some N, Some B, Some qs =>
    demand (fst (enough ss) * snd S <=? fst S * snd (enough ss)) "scale: the volume of the solids" ;;
    demand (all_fit b (min_per_class q) S bs qs) "q >= R, q^b A < S <= q^b B" ;;
    demand (sum qs =? N) "sum of q = N" ;;
    demand (at_least q <=? N) "N >= M" ;;
    check_sizes u a b d S (with_mass js) (witness cert) ;;
    match chain with
    | Some chain => check_chain b B (B =? N) bs chain
    | None => demand (claims_least q (claimed cert)) "N = M without a chain"
    end ;;
    match z with
    | Some _ => check_above b (at_least q) z' bs
    | None => Ok tt
    end
  | _, _, _ => Refused "witness: one line a class with mass"
  end.
