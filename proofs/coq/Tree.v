(* The check of a tree: a split makes two cases, and none has a match (certificate-format.md, section 6; Theorems 14
   and 20). *)

From Coq Require Import ZArith List Bool String FMapPositive.
From Mdm Require Import Numbers Certificate Leaf Windows.
Import ListNotations.
Open Scope string_scope.
Open Scope Z_scope.

(* Nodes in preorder; the bounds in force at the roots of the subtrees that are still to come. *)
Fixpoint check_nodes (pr : problem) (t : table) (shares : list bounds) (nodes : list node) (to_come : list force)
  : result unit :=
  match nodes, to_come with
  | [], [] => Ok tt
  | Split (Zpos i) (Zpos j) v :: nodes, e :: to_come =>
    if (i <=? j)%positive && PositiveMap.mem j t
    then check_nodes pr t shares nodes (below e i j v :: from e i j v :: to_come)
    else Refused "split: a class of the gradation"
  | SplitMass v :: nodes, e :: to_come => check_nodes pr t shares nodes (lighter e v :: heavier e v :: to_come)
  | Leaf ks :: nodes, e :: to_come =>
    if refutes pr t e ks then check_nodes pr t shares nodes to_come else Refused "leaf: a contradiction"
  | Window ks :: nodes, e :: to_come =>
    if rules_out pr t shares e ks then check_nodes pr t shares nodes to_come
    else Refused "window: the greatest sum of all classes is a contradiction"
  | _, _ => Refused "tree: two subtrees of each split"
  end.

Definition check_tree (pr : problem) (nodes : list node) : result unit :=
  check_nodes pr (number_from 1 (classes_of pr) (PositiveMap.empty limits)) (bounds_of_shares pr) nodes [nothing].
