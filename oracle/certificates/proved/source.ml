(* SPDX-License-Identifier: Apache-2.0 *)
(* How the parts of a claim are read; what is no such part is refused. *)
open Numbers

type place = string * Json.t (* its path in the claim, for messages *)
type number = Proved.q

let object_of (what, value) = match value with
  | Json.Object members -> members
  | _ -> refuse what "an object"

let member (what, members) name = match List.assoc_opt name members with
  | Some value -> ((if what = "input" then name else what ^ "." ^ name), value)
  | None -> refuse what ("field " ^ name ^ " is missing")

let members names place =
  let all = object_of place in
  let found = List.map (member (fst place, all)) names in
  if List.length all <> List.length names then refuse (fst place) "an unexpected field";
  found

let items (what, value) = match value with
  | Json.List values -> List.mapi (fun i value -> (Printf.sprintf "%s[%d]" what i, value)) values
  | _ -> refuse what "a list"

let exactly count place =
  let found = items place in
  if List.length found <> count then refuse (fst place) (Printf.sprintf "a list of %d" count);
  found

let given (what, value) = Numbers.given what value
let exact (what, value) = Numbers.exact what value
let surd (what, value) = Numbers.surd what value

let rec nat k = if k = 0 then Proved.O else Proved.S (nat (k - 1))

(* An index that an exact value names. *)
let place_in_list (what, value) =
  let q = Numbers.exact what value in
  let negative = Whole.sign q.qnum < 0 and limit = Whole.of_int 1_000_000 in
  let top, rest = Whole.div_rem q.qnum q.qden in
  if negative || Whole.sign rest <> 0 || Whole.gt top limit then refuse what "an index";
  nat (Whole.to_int top)

(* An index as inputs and answers have it. *)
let natural (what, value) = match value with
  | Json.Number text when Numbers.all_digits text && String.length text <= 6 -> nat (int_of_string text)
  | _ -> refuse what "an index"

let same_length (what, _) one other =
  if List.compare_lengths one other <> 0 then refuse what "lists of one length"

let word (what, value) = match value with Json.Text text -> text | _ -> refuse what "a string"
