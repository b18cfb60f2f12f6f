(* A certificate as a text, in its only form (certificate-format.md, sections 1 and 6). *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Certificate Text Decimals Document.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

Definition if_some {A} (x : option A) (l : A -> line) : lines := match x with Some x => [l x] | None => [] end.
Definition if_true (holds : bool) (l : line) : lines := if holds then [l] else [].

Definition law_words (a b : Z) : line := [show_rational (Qmake a (Z.to_pos b))].

Definition cylinder_lines (s : solids) : lines :=
  match s with Cylinder d h e => [["cylinder"; show_decimal d; show_decimal h; show_decimal e]] | _ => [] end.
Definition box_lines (box : option (Q * Q * Q * Q)) : lines :=
  if_some box (fun '(x, y, z, e) => ["box"; show_decimal x; show_decimal y; show_decimal z; show_decimal e]).
Definition volume_lines (s : solids) (box : option (Q * Q * Q * Q)) : lines :=
  match s, box with Volume v _ _, None => [["solids-volume"; show_decimal v]] | _, _ => [] end.
Definition pi_lines (s : solids) : lines :=
  match s with Volume _ p r => [["pi"; show_decimal p; show_decimal r]] | _ => [] end.

Definition each_lines (es : list Q) : lines :=
  match es with [] => [] | _ => ["passing-each" :: map show_decimal es] end.

Definition tolerance_lines (t : tolerances) (band_of_file : bool) : lines :=
  (if_some (retained_each t) (fun e => ["retained"; show_decimal e]) ++
   if_true (retained_file t) ["retained"; "file"] ++
   if_some (passing_all t) (fun e => ["passing"; show_decimal e]) ++
   if_true (passing_file t) ["passing"; "file"] ++
   each_lines (passing_each t) ++
   if_some (total t) (fun e => ["total"; show_decimal e]) ++
   if band_of_file then [["band"; "file"]] else map band_line (band t))%list.

(* The lowest version that has all that is there. *)
Definition version_of (cert : certificate) : Z :=
  if is_third (proof_of cert) then 3 else if is_second (claimed cert) (proof_of cert) then 2 else 1.
Definition version_line (cert : certificate) : line := ["mdm-certificate"; show_integer (version_of cert)].

Definition question_lines (D : document) : lines :=
  let q := asked (certificate_of D) in
  (["law" :: law_words (a q) (b q)] ++
   if_some (pan_size q) (fun x => ["pan-size"; show_decimal x]) ++
   if_some (cut_below q) (fun x => ["cut-below"; show_decimal x]) ++
   if_some (size_factor q) (fun x => ["size-factor"; show_decimal x]) ++
   if_true (1 <=? min_per_class q) ["min-per-class"; show_integer (min_per_class q)] ++
   cylinder_lines (solids_of q) ++ box_lines (box_of D) ++ volume_lines (solids_of q) (box_of D) ++
   pi_lines (solids_of q) ++
   if_true (1 <=? at_least q) ["at-least"; show_integer (at_least q)] ++
   match tolerances_of q with Some t => tolerance_lines t (band_of_file D) | None => [] end)%list.

Definition claim_word (c : claim) : string :=
  match c with
  | Smallest N => show_integer N
  | Between B N => show_integer B ++ ".." ++ show_integer N
  | NoneBelow B => show_integer B ++ ".."
  | NoMatch => "none"
  end.
Definition particles_line (c : claim) : line := ["particles"; claim_word c].

Definition class_line (tolerant : bool) (w : witness_line) : line :=
  (["class"; show_integer (index w); show_integer (count w)] ++
   (if tolerant then [show_rational (together w)] else []) ++ [show_decimal (size_lo w); show_decimal (size_hi w)])%list.

Definition range_word (i j : Z) : string :=
  if i =? j then show_integer i else show_integer i ++ "-" ++ show_integer j.

Definition condition_word (m : multiple) : string :=
  String (letter m) (if of_class m =? 0 then "" else range_word (of_class m) (up_to m)).

Definition multiple_words (ms : list multiple) : line :=
  flat_map (fun m => [show_integer (times_m m); condition_word m]) ms.

Definition node_line (n : node) : line :=
  match n with
  | Split i j v => ["split"; range_word i j; show_integer v]
  | SplitMass v => ["split"; "M"; show_rational v]
  | Leaf ms => "leaf" :: multiple_words ms
  | Window ms => "window" :: multiple_words ms
  end.

Definition proof_lines (p : proof) : lines :=
  match p with
  | Exact _ above chain =>
    (if_some above (fun z => ["above"; show_rational z]) ++
     if_some chain (fun js => "chain" :: map show_integer js))%list
  | Tolerant nodes => map node_line nodes
  end.

Definition scale_lines (p : proof) : lines :=
  match p with Exact scale _ _ => [["scale"; show_rational scale]] | Tolerant _ => [] end.

Definition is_tolerant (cert : certificate) : bool :=
  match tolerances_of (asked cert) with Some _ => true | None => false end.

Definition document_lines (D : document) : lines :=
  let cert := certificate_of D in
  ([version_line cert] ++ question_lines D ++ [particles_line (claimed cert)] ++ scale_lines (proof_of cert) ++
   map (class_line (is_tolerant cert)) (witness cert) ++ proof_lines (proof_of cert) ++ [["end"]; [""]])%list.

Definition document_text (D : document) : string :=
  joined (String line_feed "") (map (joined " ") (document_lines D)).
