(* SPDX-License-Identifier: Apache-2.0 *)
(* Prints the proved formulas as Python, one file a chapter: the definitions that were proved, with names of fields in
   the place of numbers. A formula over a list of any length has no such text and is left out.

   usage: print_python FOLDER *)
open Proved

exception Of_any_length

let dimension = ref 2 (* of the points whose text is printed *)
let axis = ref 0 (* that a certificate names *)
let asked_dimension = ref false
let asked_axis = ref false

module From_names = struct
  type place = string
  type number = string

  let element place k = Printf.sprintf "%s[%d]" place k
  let members names place = List.map (fun name -> Printf.sprintf "%s['%s']" place name) names
  let exactly count place = List.init count (element place)
  let coordinates place =
    asked_dimension := true;
    exactly !dimension place
  let items _ = raise Of_any_length
  let given place = place
  let exact place = place
  let surd place = Surd (element place 0, element place 1, element place 2)
  let index _ =
    asked_axis := true;
    let rec nat k = if k = 0 then O else S (nat (k - 1)) in
    nat !axis
  let word place = place
  let same_length _ _ _ = ()
end

module Table = Operations.Of (From_names)

let rec is_sum = function Add _ | Sub _ -> true | _ -> false

let rec term = function
  | Leaf name -> name
  | Num z -> Whole.to_string z
  | Add (s, Num z) when Whole.sign z = 0 -> term s
  | Add (s, t) -> term s ^ " + " ^ term t
  | Sub (s, t) -> term s ^ " - " ^ (if is_sum t then "(" ^ term t ^ ")" else term t)
  | Mul (s, t) -> factor s ^ " * " ^ (match t with Mul _ -> "(" ^ term t ^ ")" | _ -> factor t)
  | Max (s, t) -> "max(" ^ term s ^ ", " ^ term t ^ ")"

and factor t = if is_sum t then "(" ^ term t ^ ")" else term t

(* The conditions that all have to hold; one that always holds is left out. *)
let rec conjuncts = function
  | And (c, d) -> conjuncts c @ conjuncts d
  | Yes -> []
  | c -> [ c ]

let rec cond = function
  | Le (s, t) -> term s ^ " <= " ^ term t
  | Lt0 (s, t) -> term s ^ " < " ^ term t
  | Eq0 (s, t) -> term s ^ " == " ^ term t
  | Yes -> "True"
  | No -> "False"
  | And _ as c -> "(" ^ all_of c ^ ")"
  | Or (c, d) -> "(" ^ cond c ^ " or " ^ cond d ^ ")"
  | Not c -> "not (" ^ all_of c ^ ")"

and all_of c = match conjuncts c with [] -> "True" | parts -> String.concat " and " (List.map cond parts)

let widest = 119

(* Breaks a line at spaces. *)
let wrapped indent text =
  let line = Buffer.create 120 and lines = ref [] in
  List.iter
    (fun piece ->
      if Buffer.length line > 0 && Buffer.length line + 1 + String.length piece > widest - indent then begin
        lines := Buffer.contents line :: !lines;
        Buffer.clear line
      end;
      if Buffer.length line > 0 then Buffer.add_char line ' ';
      Buffer.add_string line piece)
    (String.split_on_char ' ' text);
  String.concat "" (List.rev_map (fun l -> String.make indent ' ' ^ l ^ "\n") (Buffer.contents line :: !lines))

(* (key, text) of a kind in the current dimension and with the current axis *)
let printed (operation : Table.operation) k =
  asked_dimension := false;
  asked_axis := false;
  let inputs = From_names.members operation.inputs "i" in
  let kind = List.nth (operation.kinds inputs) k in
  let formula = kind.formula (From_names.members kind.answers "t") (From_names.members kind.facts "c") in
  let optional asked value = if asked then string_of_int value else "None" in
  let key = Printf.sprintf "(%S, %S, %S, %s, %s)" operation.name kind.word kind.kind
      (optional !asked_dimension !dimension) (optional !asked_axis !axis) in
  (key, all_of formula)

let print_kind out operation k =
  let seen = Hashtbl.create 8 in
  List.iter (fun n ->
      for a = 0 to n - 1 do
        dimension := n;
        axis := a;
        let key, text = printed operation k in
        if not (Hashtbl.mem seen key) then begin
          Hashtbl.add seen key ();
          Printf.fprintf out "    %s: lambda i, t, c: (\n%s    ),\n" key (wrapped 8 text)
        end
      done)
    [ 2; 3 ]

let head = {|# SPDX-License-Identifier: Apache-2.0
"""The formulas that Coq has proved, printed by print_python.ml: do not edit.

(operation, word of the truth, kind, dimension, axis of the certificate), None where it is asked for none, and the
condition on i, t, c: input, truth and certificate, with their numbers as fractions. A number p + q sqrt(r) is
(p, q, r).
"""

|}

let print_chapter folder (chapter, operations) =
  let out = open_out (Filename.concat folder ("printed_" ^ chapter ^ ".py")) in
  Printf.fprintf out "%sFORMULAS = {\n" head;
  List.iter (fun (operation : Table.operation) ->
      match List.length (operation.kinds (From_names.members operation.inputs "i")) with
      | exception Of_any_length -> ()
      | count ->
          for k = 0 to count - 1 do
            try print_kind out operation k with Of_any_length -> ()
          done)
    operations;
  output_string out "}\n";
  close_out out

let () = List.iter (print_chapter Sys.argv.(1)) Table.chapters
