(* The root of a file of phi depends on which sizes there are, not on their order or how often one is there. *)

From Coq Require Import ZArith QArith Qabs List Bool Lia.
From Mdm Require Import Numbers Gradation Certificate Text Rows CsvRead.
Import ListNotations.
Open Scope Z_scope.

Definition has_phi (es : list entry) (phi : Q) : Prop := exists e, In e es /\ size_of e = Some phi.

Lemma at_most_Qle x y : at_most x y = true <-> Qle x y.
Proof. apply Z.leb_le. Qed.

Lemma larger_least x y z : Qle x z -> Qle y z -> Qle (larger x y) z.
Proof. unfold larger. destruct (less x y); auto. Qed.

Lemma larger_bounds x y : Qle x (larger x y) /\ Qle y (larger x y).
Proof.
  unfold larger. destruct (less x y) eqn:E; unfold less in E.
  - apply Z.ltb_lt in E. split; [|apply Qle_refl]. unfold Qle. lia.
  - apply Z.ltb_ge in E. split; [apply Qle_refl | exact E].
Qed.

Lemma positive_lcm d p : 1 <= d -> 1 <= Z.lcm d (Zpos p).
Proof.
  intro D. pose proof (Z.lcm_nonneg d (Zpos p)). assert (Z.lcm d (Zpos p) <> 0); [|lia].
  intro E. apply Z.lcm_eq_0 in E. lia.
Qed.

(* What is known of the root and the greatest magnitude that are found. *)
Lemma root_found es : forall d g d' g', 1 <= d -> phi_root es d g = Ok (d', g') ->
  1 <= d' /\ (d' = d \/ d' <= most_root) /\ Z.divide d d' /\ Qle g g' /\
  (forall phi, has_phi es phi -> at_most (Qred (Qabs phi)) most_phi = true /\ Z.divide (Zpos (Qden phi)) d' /\ Qle (Qred (Qabs phi)) g') /\
  (forall m, Z.divide d m -> (forall phi, has_phi es phi -> Z.divide (Zpos (Qden phi)) m) -> Z.divide d' m).
Proof.
  induction es as [|e es IH]; intros d g d' g' D E.
  - injection E as <- <-. split; [exact D|]. split; [left; reflexivity|]. split; [apply Z.divide_refl|].
    split; [apply Qle_refl|]. split; [intros phi (e & [] & _) | intros m Dm _; exact Dm].
  - cbn [phi_root] in E. destruct (size_of e) as [phi|] eqn:S.
    + unfold demand_at in E. destruct (at_most (Qred (Qabs phi)) most_phi) eqn:M; [|discriminate E]. cbn [bind] in E.
      destruct (Z.leb_spec (Z.lcm d (Zpos (Qden phi))) most_root) as [L|L]; [|discriminate E]. cbn [bind] in E.
      pose proof (positive_lcm d (Qden phi) D) as D1.
      destruct (IH _ _ _ _ D1 E) as (P & B & Dv & G & Each & Least).
      destruct (larger_bounds g (Qred (Qabs phi))) as (G1 & G2).
      split; [exact P|]. split; [right; destruct B as [-> |]; assumption|].
      split; [exact (Z.divide_trans _ _ _ (Z.divide_lcm_l d _) Dv)|]. split; [exact (Qle_trans _ _ _ G1 G)|]. split.
      * intros x (e' & [->|I] & Sx); [|apply Each; exists e'; auto]. rewrite S in Sx. injection Sx as <-.
        split; [exact M|]. split; [exact (Z.divide_trans _ _ _ (Z.divide_lcm_r d _) Dv) | exact (Qle_trans _ _ _ G2 G)].
      * intros m Dm All. apply Least.
        -- apply Z.lcm_least; [exact Dm | apply All; exists e; split; [left; reflexivity | exact S]].
        -- intros x (e' & I & Sx). apply All. exists e'. split; [right; exact I | exact Sx].
    + destruct (IH _ _ _ _ D E) as (P & B & Dv & G & Each & Least).
      split; [exact P|]. split; [exact B|]. split; [exact Dv|]. split; [exact G|]. split.
      * intros x (e' & [->|I] & Sx); [congruence|]. apply Each. exists e'. auto.
      * intros m Dm All. apply Least; [exact Dm|]. intros x (e' & I & Sx). apply All. exists e'. split; [right; exact I | exact Sx].
Qed.

(* A root is found where all denominators divide one that is no greater than may be. *)
Lemma root_finds es root most : forall d g, 1 <= d -> Z.divide d root -> 1 <= root <= most_root -> Qle g most ->
  (forall phi, has_phi es phi -> at_most (Qred (Qabs phi)) most_phi = true /\ Z.divide (Zpos (Qden phi)) root /\ Qle (Qred (Qabs phi)) most) ->
  exists d' g', phi_root es d g = Ok (d', g') /\ Z.divide d' root /\ Qle g' most.
Proof.
  induction es as [|e es IH]; intros d g D Dv R G All; [exists d, g; auto|]. cbn [phi_root].
  assert (forall phi, has_phi es phi -> has_phi (e :: es) phi) as Tail
    by (intros x (e' & I & S); exists e'; split; [right; exact I | exact S]).
  destruct (size_of e) as [phi|] eqn:S; [|apply IH; auto].
  destruct (All phi) as (M & Dp & L); [exists e; split; [left; reflexivity | exact S]|].
  pose proof (positive_lcm d (Qden phi) D) as D1.
  assert (Z.divide (Z.lcm d (Zpos (Qden phi))) root) as Dl by (apply Z.lcm_least; assumption).
  pose proof (Z.divide_pos_le _ root ltac:(lia) Dl) as Le.
  unfold demand_at. rewrite M. cbn [bind]. rewrite (proj2 (Z.leb_le _ most_root)) by lia. cbn [bind].
  apply IH; auto. apply larger_least; assumption.
Qed.

Lemma size_is_length {A} (l : list A) : size l = Z.of_nat (List.length l).
Proof. unfold size. rewrite size_length. lia. Qed.

Lemma file_root_same unit es es' d : file_root unit es = Ok d ->
  (forall phi, has_phi es phi <-> has_phi es' phi) -> size es' <= size es -> file_root unit es' = Ok d.
Proof.
  unfold file_root. destruct unit; trivial. intros E Same L. destruct (phi_root es 1 0) as [(d1, g1)| |] eqn:F; try discriminate E.
  destruct (root_found _ _ _ _ _ (Z.le_refl 1) F) as (P & B & _ & G & Each & Least). cbn [bind] in E.
  destruct (at_most (times (of_integer (size es * d1)) g1) (of_integer (2 ^ 28))) eqn:M; [|discriminate E].
  cbn [demand_form bind] in E. injection E as ->.
  destruct (root_finds es' d g1 1 0) as (d2 & g2 & F2 & Dv & G2);
    [lia | apply Z.divide_1_l | unfold most_root in *; lia | exact G | intros phi H; apply Each, Same, H|].
  destruct (root_found _ _ _ _ _ (Z.le_refl 1) F2) as (P2 & _ & _ & G0 & Each2 & _). rewrite F2. cbn [bind].
  assert (d2 = d) as ->.
  { apply Z.divide_antisym_nonneg; [lia | lia | exact Dv|]. apply Least; [apply Z.divide_1_l|].
    intros phi H. apply Each2, Same, H. }
  assert (at_most (times (of_integer (size es' * d)) g2) (of_integer (2 ^ 28)) = true) as ->; [|reflexivity].
  apply at_most_Qle. apply at_most_Qle in M. unfold times in *. rewrite Qred_correct in *.
  apply Qle_trans with (of_integer (size es * d) * g1)%Q; [|exact M].
  apply Qle_trans with (of_integer (size es * d) * g2)%Q.
  - apply Qmult_le_compat_r; [|exact G0]. unfold Qle, of_integer. cbn [Qnum Qden]. nia.
  - rewrite !(Qmult_comm (of_integer (size es * d))). apply Qmult_le_compat_r; [exact G2|].
    unfold Qle, of_integer. cbn [Qnum Qden]. rewrite size_is_length. nia.
Qed.
