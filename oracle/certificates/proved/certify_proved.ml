(* SPDX-License-Identifier: Apache-2.0 *)
(* Checks certificates with the formulas that Coq has proved.

   usage: certify_proved [--verdicts] [FILE...]    (standard input without a FILE, or where FILE is -)

   Each line is one claim, as for certify.py; "rounded", which test vectors have, has to be the truth in doubles. Prints
   every line that is not accepted with its reason, and then how many there were; with --verdicts one word for each
   line instead: accepted, refused, "not proved: OPERATION KIND", or "no certificate" for a test vector of an input
   that is refused. Exit code: 0 all are accepted, 1 some are not, 2 a file cannot be read. Nothing in this program is
   proved but the formulas and how they are decided: it must say truthfully which number stands where in a line. *)
let refuse = Numbers.refuse

let by_name =
  let table = Hashtbl.create 64 in
  List.iter (fun (operation : Shapes.operation) -> Hashtbl.replace table operation.name operation) Operations.all;
  table

type verdict = Accepted | Refused of string | Not_proved of string | No_certificate

let judge (claim : (string * Json.t) list) =
  let get name = match List.assoc_opt name claim with
    | Some value -> (name, value)
    | None -> refuse "claim" ("field " ^ name ^ " is missing") in
  let input = get "input" and truth = get "truth" and certificate = get "certificate" in
  let name = Source.word (get "op") in
  let kind = Source.word (Source.member ("certificate", Source.object_of certificate) "kind") in
  let not_proved = Not_proved (name ^ " " ^ kind) in
  let is_cut = function _, Json.Object members -> List.mem_assoc "cut" members | _ -> false in
  match Hashtbl.find_opt by_name name with
  | None -> not_proved
  | Some _ when List.exists is_cut (Source.object_of input) -> Not_proved (name ^ " with faces of more than three corners")
  | Some operation ->
      let inputs = Source.members operation.inputs (Shapes.completed operation input) in
      let word =
        if operation.field = "" then ""
        else Source.word (Source.member ("truth", Source.object_of truth) operation.field) in
      let fits (found : Shapes.kind) = found.word = word && found.kind = kind in
      match List.find_opt fits (operation.kinds inputs) with
      | None when List.mem kind operation.unproved -> not_proved
      | None -> Refused "certificate: no such kind for this truth"
      | Some found ->
          let own = if operation.field = "" then [] else [ operation.field ] in
          let answers = Source.members (found.answers @ own) truth in
          let facts = Source.members (found.facts @ [ "kind" ]) certificate in
          let first count list = List.filteri (fun i _ -> i < count) list in
          let answers = first (List.length found.answers) answers and facts = first (List.length found.facts) facts in
          if Proved.decide (found.formula answers facts) then begin
            let rounded = if operation.by_contract then None else List.assoc_opt "rounded" claim in
            Option.iter (fun rounded -> Rounding.check operation.outwards truth ("rounded", rounded)) rounded;
            Accepted
          end
          else Refused "the proved formula does not hold"

(* The claim with the values of the files that its input names, in the folder of the claims. *)
let with_named_files folder claim =
  let read = function
    | "input", Json.Object given -> ("input", Json.Object (List.map (Named_file.value folder) given))
    | other -> other in
  List.map read claim

let verdict_on folder text =
  try
    let claim = with_named_files folder (Source.object_of ("claim", Json.parse text)) in
    let has name = List.mem_assoc name claim in
    if has "refused" && not (has "truth" || has "certificate") then No_certificate
    else
      match List.assoc_opt "refused" claim with
      | Some (Json.Object _) -> Refused "claim: a truth or refused, not both"
      | _ -> judge claim
  with
  | Json.Malformed -> Refused "not JSON"
  | Numbers.Refused why -> Refused why

let each_line channel act =
  try
    while true do
      act (input_line channel)
    done
  with End_of_file -> ()

let () =
  let verdicts, files = List.partition (( = ) "--verdicts") (List.tl (Array.to_list Sys.argv)) in
  let verdicts = verdicts <> [] and files = if files = [] then [ "-" ] else files in
  let accepted = ref 0 and refused = ref 0 and not_proved = ref 0 and without = ref 0 in
  let count file number verdict =
    let counter, word, why = match verdict with
      | Accepted -> (accepted, "accepted", None)
      | No_certificate -> (without, "no certificate", None)
      | Refused why -> (refused, "refused", Some why)
      | Not_proved what -> (not_proved, "not proved: " ^ what, Some ("not proved: " ^ what)) in
    incr counter;
    if verdicts then print_endline word
    else Option.iter (fun why -> Printf.printf "%s:%d: %s\n" file number why) why in
  let check file =
    let channel = if file = "-" then stdin else open_in_bin file in
    let number = ref 0 in
    each_line channel (fun text ->
        incr number;
        if String.trim text <> "" then count file !number (verdict_on (Filename.dirname file) text)) in
  (try List.iter check files
   with Sys_error why ->
     prerr_endline why;
     exit 2);
  if not verdicts then
    Printf.printf "%d certificates, %d refused, %d not proved; %d refused inputs, which have none\n"
      (!accepted + !refused + !not_proved) !refused !not_proved !without;
  exit (if !refused + !not_proved = 0 then 0 else 1)
