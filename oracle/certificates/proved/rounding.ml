(* SPDX-License-Identifier: Apache-2.0 *)
(* Whether [rounded] is [truth] with each number rounded: to the nearest double or, in fields of pairs that are rounded
   outwards, the first down and the second up. Words are the same in both. *)
open Proved
open Source

(* m 2^e with 53 binary digits, or fewer and the least exponent *)
let double (what, value) = match value with
  | Json.Text "inf" -> Infinity
  | Json.Text "-inf" -> Minus_infinity
  | Json.Number text ->
      let value = float_of_string text in
      let power = if value = 0. then -1074 else max (snd (Float.frexp value) - 53) (-1074) in
      Finite (Whole.of_float (Float.ldexp value (-power)), Whole.of_int power)
  | _ -> Numbers.refuse what "a number, \"inf\" or \"-inf\""

let expect what holds rule = if not holds then Numbers.refuse what rule
let nearest truth rounded = expect (fst rounded) (decide (rounds_to_nearest (surd truth) (double rounded)))
  "the double nearest to the truth"

(* Numbers begin with a digit, a sign or "sqrt(". *)
let is_word text = text <> "" && text.[0] >= 'a' && text.[0] <= 'z' && not (String.starts_with ~prefix:"sqrt(" text)

let outward truth rounded = match exactly 2 truth, exactly 2 rounded with
  | [ low; high ], [ below; above ] ->
      let rule = "the nearest double that is not farther in" in
      expect (fst below) (decide (rounds_down (surd low) (double below))) rule;
      expect (fst above) (decide (rounds_up (surd high) (double above))) rule
  | _ -> assert false

let each check (what, _) truths roundeds =
  if List.compare_lengths truths roundeds <> 0 then Numbers.refuse what "as many elements as the truth has";
  List.iter2 check truths roundeds

let rec same_shape (truth : place) (rounded : place) = match truth, rounded with
  | (_, Json.Object fields), _ ->
      let names = List.map fst fields in
      each same_shape rounded (members names truth) (members names rounded)
  | (_, Json.List _), _ -> each same_shape rounded (items truth) (items rounded)
  | (_, Json.Text text), (what, value) when is_word text -> expect what (value = Json.Text text) "the word of the truth"
  | _ -> nearest truth rounded

let check outwards truth rounded =
  let names = List.map fst (object_of truth) in
  let field truth rounded (name : string) =
    if List.mem name outwards then each outward rounded (items truth) (items rounded) else same_shape truth rounded in
  List.iter2 (fun (truth, rounded) name -> field truth rounded name)
    (List.combine (members names truth) (members names rounded)) names
