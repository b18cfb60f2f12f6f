(* Openings of sieves from their names (certificate-format.md, sections 4 and 5). *)

From Coq Require Import ZArith QArith List Bool String Ascii.
From Mdm Require Import Numbers Certificate Text Decimals.
Import ListNotations.
Open Scope string_scope.
Open Scope Q_scope.

(* ---- The tables: opening in mm, and name ----------------------------------------------------------- *)

Definition table : Type := list (Q * string).

Definition astm_inches : table :=
  [(125, "5"); (106, "4.24"); (100, "4"); (90, "3-1/2"); (75, "3"); (63, "2-1/2"); (53, "2.12"); (50, "2");
   (45, "1-3/4"); (37.5, "1-1/2"); (31.5, "1-1/4"); (26.5, "1.06"); (25, "1"); (22.4, "7/8"); (19, "3/4");
   (16, "5/8"); (13.2, "0.530"); (12.5, "1/2"); (11.2, "7/16"); (9.5, "3/8"); (8, "5/16"); (6.7, "0.265");
   (6.3, "1/4")].

Definition astm_numbers : table :=
  [(5.6, "3-1/2"); (4.75, "4"); (4, "5"); (3.35, "6"); (2.8, "7"); (2.36, "8"); (2, "10"); (1.7, "12"); (1.4, "14");
   (1.18, "16"); (1, "18"); (0.85, "20"); (0.71, "25"); (0.6, "30"); (0.5, "35"); (0.425, "40"); (0.355, "45");
   (0.3, "50"); (0.25, "60"); (0.212, "70"); (0.18, "80"); (0.15, "100"); (0.125, "120"); (0.106, "140");
   (0.09, "170"); (0.075, "200"); (0.063, "230"); (0.053, "270"); (0.045, "325"); (0.038, "400"); (0.032, "450");
   (0.025, "500"); (0.02, "635")].

Definition tyler_numbers : table :=
  [(8, "2-1/2"); (6.7, "3"); (5.6, "3-1/2"); (4.75, "4"); (4, "5"); (3.35, "6"); (2.8, "7"); (2.36, "8"); (2, "9");
   (1.7, "10"); (1.4, "12"); (1.18, "14"); (1, "16"); (0.85, "20"); (0.71, "24"); (0.6, "28"); (0.5, "32");
   (0.425, "35"); (0.355, "42"); (0.3, "48"); (0.25, "60"); (0.212, "65"); (0.18, "80"); (0.15, "100");
   (0.125, "115"); (0.106, "150"); (0.09, "170"); (0.075, "200"); (0.063, "250"); (0.053, "270"); (0.045, "325");
   (0.038, "400")].

(* ---- Names ----------------------------------------------------------------------------------------- *)

(* Without blanks, which between two digits become a hyphen, and with u for the micro sign and the Greek mu; what is
   done is in reverse. *)
Fixpoint squeezed (w : string) (gap : bool) (done : string) : string :=
  match w with
  | EmptyString => reversed done
  | String ch w =>
    if is_blank ch then squeezed w true done
    else
      squeezed w false
        match done with
        | String last before =>
          if (Ascii.eqb last "194" && Ascii.eqb ch "181") || (Ascii.eqb last "206" && Ascii.eqb ch "188")
          then String "u" before
          else if gap && is_digit last && is_digit ch then String ch (String "-" done)
          else String ch done
        | EmptyString => String ch done
        end
  end.

Fixpoint with_in (endings : list string) (w : string) : string :=
  match endings with
  | ending :: endings =>
    match before_suffix ending w with Some before => before ++ "in" | None => with_in endings w end
  | [] => w
  end.

Definition normal_name (field : string) : string :=
  with_in [String quote ""; "inches"; "inch"; "in."] (squeezed (lower_case field) false "").

Inductive sieve_kind := Length (unit_in_mm : Q) | Of_table (openings : table).

(* By what is before and behind the number or name in a normal name; the first that fits is meant. *)
Definition sieve_kinds : list (string * string * sieve_kind) :=
  [("", "mm", Length 1); ("", "um", Length 0.001); ("", "m", Length 1000); ("no.", "", Of_table astm_numbers);
   ("no", "", Of_table astm_numbers); ("#", "", Of_table astm_numbers); ("tyler", "mesh", Of_table tyler_numbers);
   ("tyler", "", Of_table tyler_numbers); ("", "in", Of_table astm_inches)].

Definition between_marks (before after name : string) : option string :=
  match after_prefix before name with Some rest => before_suffix after rest | None => None end.

Fixpoint kind_of_name (name : string) (kinds : list (string * string * sieve_kind)) : option (string * sieve_kind) :=
  match kinds with
  | (before, after, kind) :: kinds =>
    match between_marks before after name with
    | Some middle => Some (middle, kind)
    | None => kind_of_name name kinds
    end
  | [] => None
  end.

(* Only a length in mm, um or m holds a number; the other names have texts of the tables. *)
Definition is_length (name : string) : bool :=
  match before_suffix "m" name with Some _ => true | None => false end.

Definition unknown_sieve (name : string) : string :=
  quoted name ++ " is no known sieve: write its opening, such as 0.075 mm".

(* The opening in mm of a sieve's normal name, where a length is written with the decimal [point]. *)
Definition sieve_opening (name : string) (point : ascii) : result Q :=
  match kind_of_name name sieve_kinds with
  | Some (middle, Length unit_in_mm) => let* x := read_decimal point middle in Ok (times x unit_in_mm)
  | Some (middle, Of_table openings) =>
    match find (fun entry => String.eqb (snd entry) middle) openings with
    | Some (opening, _) => Ok (Qred opening)
    | None => Malformed (unknown_sieve name)
    end
  | None => Malformed (unknown_sieve name)
  end.
