(* The line that a verdict prints: it names the whole question, so that its reader sees what was proved. *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Gradation Certificate Question Text Decimals Rows GradationFile Mixture MixtureFile Document.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* ---- What a line says -------------------------------------------------------------------------------- *)

(* A part of what is between its brackets. [PassingEach] has each percentage with the opening that it is meant for, a phi
   or a length. Openings and lengths are those of the file, but for solids. *)
Inductive part :=
| RetainedWithin (e : Q)
| RetainedAsInFile
| PassingWithin (e : Q)
| PassingAsInFile
| PassingEach (each : list (Q * Q))
| TotalWithin (e : Q)
| BandAt (x least most : Q)
| BandOfFile
| Law (a b : Z)
| SizesIn (unit : size_unit)
| FactorsOfFile
| OfMaterials (names : list string)
| PanImplied
| SumsTo (share : share_unit) (total : Q)
| MiddleOfLimits
| PanCountedAs (x : Q)
| LeftOutBelow (x : Q)
| OpeningsTimes (k : Q)
| AtLeastInEachClass (r : Z)
| CylinderFilled (diameter height void_ratio : Q)
| BoxFilled (x y z void_ratio : Q)
| VolumeOfSolids (v : Q).

(* What an accepted certificate's line says. *)
Record statement := Statement {
  file_name : string; unit_of : size_unit; claim_of : claim; or_more : Z; is_exact : bool; parts : list part }.

(* ---- The question as parts -------------------------------------------------------------------------- *)

Definition if_some {A} (x : option A) (p : A -> part) : list part := match x with Some x => [p x] | None => [] end.
Definition if_true (holds : bool) (p : part) : list part := if holds then [p] else [].

(* The openings of the file that are left, but for the finest: those that a class's upper one is. *)
Definition upper_openings (G : gradation) (q : question) : list Q :=
  let d := root G in
  match (let* rs := apply_pan_size d (pan_size q) (rows G) in apply_cut_below d (cut_below q) rs) with
  | Ok rs => map opening (tl rs)
  | _ => []
  end.

(* An opening as the file has it: a phi, or a length. It is known by its power. *)
Definition as_in_file (unit : size_unit) (root : Z) (y : Q) : Q :=
  match unit with Phi => fraction (- exponent_of_two y) root | _ => y end.

Definition tolerance_parts (unit : size_unit) (G : gradation) (q : question) (t : tolerances) (band_of_file : bool)
  : list part :=
  if_some (retained_each t) RetainedWithin ++
  if_true (retained_file t) RetainedAsInFile ++
  if_some (passing_all t) PassingWithin ++
  if_true (passing_file t) PassingAsInFile ++
  match passing_each t with
  | [] => []
  | es => [PassingEach (combine es (map_all (as_in_file unit (root G)) (upper_openings G q)))]
  end ++
  if_some (total t) TotalWithin ++
  if band_of_file then [BandOfFile] else rev' (map_onto (fun '(x, least, most) => BandAt x least most) (band t) []).

Definition solid_parts (s : solids) (box : option (Q * Q * Q * Q)) : list part :=
  match s, box with
  | Anything, _ => []
  | Cylinder d h e, _ => [CylinderFilled d h e]
  | Volume _ _ _, Some (x, y, z, e) => [BoxFilled x y z e]
  | Volume v _ _, None => [VolumeOfSolids v]
  end.

(* What is said of the gradation file. *)
Definition file_parts (R : reading) : list part :=
  [SizesIn (sizes_in R)] ++
  if_true (has_factors R) FactorsOfFile ++
  if_true (implied_pan R) PanImplied ++
  if_some (sum_to R) (fun '(share, total) => SumsTo share total) ++
  if_some (limits R) (fun _ => MiddleOfLimits).

(* The same of several materials. *)
Definition mixed_parts (M : mixed_reading) : list part :=
  [SizesIn (mixed_sizes M)] ++ if_true (mixed_factors M) FactorsOfFile ++ [OfMaterials (map fst (materials (mixture_of M)))].

(* With what is said of the file; openings are those of G. *)
Definition parts_with (unit : size_unit) (G : gradation) (of_file : list part) (D : document) : list part :=
  let q := asked (certificate_of D) in
  match tolerances_of q with
  | Some t => tolerance_parts unit G q t (band_of_file D)
  | None => []
  end ++
  [Law (a q) (b q)] ++ of_file ++
  if_some (pan_size q) PanCountedAs ++
  if_some (cut_below q) LeftOutBelow ++
  if_some (size_factor q) OpeningsTimes ++
  if_true (1 <=? min_per_class q) (AtLeastInEachClass (min_per_class q)) ++
  solid_parts (solids_of q) (box_of D).

Definition parts_of (R : reading) : document -> list part := parts_with (sizes_in R) (reduced (gradation_of R)) (file_parts R).

Definition statement_with (name : string) (unit : size_unit) (parts : list part) (D : document) : statement :=
  let q := asked (certificate_of D) in
  Statement name unit (claimed (certificate_of D)) (at_least q) match tolerances_of q with Some _ => false | None => true end parts.

Definition statement_of (name : string) (R : reading) (D : document) : statement :=
  statement_with name (sizes_in R) (parts_of R D) D.

(* No line of a tolerance is about openings of a gradation of several materials. *)
Definition statement_of_mixture (name : string) (M : mixed_reading) (D : document) : statement :=
  statement_with name (mixed_sizes M) (parts_with (mixed_sizes M) (Gradation [] 1 false) (mixed_parts M) D) D.

(* ---- As a text -------------------------------------------------------------------------------------- *)

Definition unit_name (unit : size_unit) : string :=
  match unit with Micrometres => "um" | Metres => "m" | _ => "mm" end.

Definition sizes_phrase (unit : size_unit) : string :=
  match unit with
  | Millimetres => "sizes in mm"
  | Micrometres => "sizes in um"
  | Metres => "sizes in m"
  | Inches => "sizes in mm, from inches"
  | SieveNames => "sizes in mm, from sieve names"
  | Phi => "sizes in phi"
  end.

Definition of_total : string := "% of the total mass".

Definition opening_phrase (unit : size_unit) (x : Q) : string :=
  match unit with
  | Phi => "phi " ++ (if less x 0 then String "-" (show_decimal (Qopp x)) else show_decimal x)
  | _ => show_decimal x ++ " " ++ unit_name unit
  end.

Definition each_phrase (unit : size_unit) (each : list (Q * Q)) : string :=
  match map_all (fun '(e, x) => (show_decimal e ++ "%", " at " ++ opening_phrase unit x)) each with
  | [] => ""
  | (percent, at_) :: rest =>
    joined ", " ((percent ++ " of the total mass" ++ at_) :: map_all (fun '(percent, at_) => percent ++ at_) rest)
  end.

Definition of_file : string := " of the file".

Definition phrase (unit : size_unit) (p : part) : string :=
  let u := " " ++ unit_name unit in
  let d := show_decimal in
  match p with
  | RetainedWithin e => "retained within " ++ d e ++ of_total
  | RetainedAsInFile => "retained within the file's tolerances"
  | PassingWithin e => "passing within " ++ d e ++ of_total
  | PassingAsInFile => "passing within the file's tolerances"
  | PassingEach each => "passing within " ++ each_phrase unit each ++ of_file
  | TotalWithin e => "total deviation within " ++ d e ++ of_total
  | BandAt x least most => d least ++ " to " ++ d most ++ of_total ++ " passing " ++ d x ++ u ++ of_file
  | BandOfFile => "passing within the file's limits"
  | Law a b =>
    "mass law x^" ++ if b =? 1 then show_integer a else "(" ++ show_integer a ++ "/" ++ show_integer b ++ ")"
  | SizesIn unit => sizes_phrase unit
  | FactorsOfFile => "factors from the file"
  | OfMaterials names => "classes of the materials " ++ joined ", " (map_all in_quotes names)
  | PanImplied => "a pan implied below the finest sieve"
  | SumsTo Percents total => "percents sum to " ++ d total
  | SumsTo Fractions total => "fractions sum to " ++ d total
  | MiddleOfLimits => "masses from the middle of the file's limits"
  | PanCountedAs x => "the pan counted as " ++ d x ++ u ++ of_file
  | LeftOutBelow x => "classes below " ++ d x ++ u ++ of_file ++ " left out"
  | OpeningsTimes k => "openings" ++ of_file ++ " multiplied by " ++ d k
  | AtLeastInEachClass r => "at least " ++ show_integer r ++ " particles in each class with mass"
  | CylinderFilled diameter height e =>
    "solids of a cylinder of diameter " ++ d diameter ++ u ++ " and height " ++ d height ++ u ++ " at void ratio " ++ d e
  | BoxFilled x y z e =>
    "solids of a box of " ++ d x ++ " x " ++ d y ++ " x " ++ d z ++ u ++ " at void ratio " ++ d e
  | VolumeOfSolids v => "solids of at least " ++ d v ++ u ++ "^3"
  end.

Definition or_more_phrase (n : Z) : string := if 0 <? n then ", " ++ show_integer n ++ " or more," else "".

Definition accepted_line (s : statement) : string :=
  let or_more := or_more_phrase (or_more s) in
  "accepted: " ++
  match claim_of s with
  | Smallest N => "N = " ++ show_integer N ++ " is the smallest number of particles" ++ or_more ++ " that matches "
  | Between _ _ => "the smallest number of particles" ++ or_more ++ " that matches "
  | NoneBelow B => "no number of particles below " ++ show_integer B ++ or_more ++ " matches "
  | NoMatch => "no number of particles" ++ or_more ++ " matches "
  end ++
  in_quotes (file_name s) ++ (if is_exact s then " exactly" else " within a tolerance") ++
  match claim_of s with
  | Between B N => " is between " ++ show_integer B ++ " and " ++ show_integer N
  | _ => ""
  end ++ " (" ++
  joined "; " (map_all (phrase (unit_of s)) (parts s)) ++ ")".

Definition refused_line (name : string) : string :=
  "refused: the certificate does not prove its claim about " ++ in_quotes name.

(* ---- What a line can say ----------------------------------------------------------------------------- *)

(* A number whose text is that of no other number. *)
Definition plain (x : Q) : bool := match decimal (show_decimal x) with Some y => same_number x y | None => false end.
Definition plain_integer (n : Z) : bool := match whole most_digits (show_integer n) with Some m => n =? m | None => false end.
Definition plain_opening (unit : size_unit) (x : Q) : bool :=
  match unit with Phi => if less x 0 then plain (Qopp x) else plain x | _ => plain x end.

Definition same_unit (u v : size_unit) : bool := String.eqb (sizes_phrase u) (sizes_phrase v).

Definition plain_part (unit : size_unit) (p : part) : bool :=
  match p with
  | RetainedWithin x | PassingWithin x | TotalWithin x | SumsTo _ x | PanCountedAs x | LeftOutBelow x | OpeningsTimes x
  | VolumeOfSolids x => plain x
  | PassingEach [] | OfMaterials [] => false
  | PassingEach each => forallb (fun '(e, x) => plain e && plain_opening unit x) each
  | BandAt x least most => plain x && plain least && plain most
  | Law a b => plain_integer a && plain_integer b
  | SizesIn u => same_unit u unit
  | AtLeastInEachClass r => plain_integer r
  | CylinderFilled diameter height e => plain diameter && plain height && plain e
  | BoxFilled x y z e => plain x && plain y && plain z && plain e
  | RetainedAsInFile | PassingAsInFile | BandOfFile | FactorsOfFile | OfMaterials _ | PanImplied | MiddleOfLimits => true
  end.

(* Statements of which each has a line of its own. *)
Definition plain_statement (s : statement) : bool :=
  match claim_of s with
  | Smallest N | NoneBelow N => plain_integer N
  | Between B N => plain_integer B && plain_integer N
  | NoMatch => true
  end && (plain_integer (or_more s) && (0 <=? or_more s)) &&
  forallb (plain_part (unit_of s)) (parts s) && existsb (fun p => match p with SizesIn _ => true | _ => false end) (parts s).
