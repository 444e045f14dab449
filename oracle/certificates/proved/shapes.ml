(* SPDX-License-Identifier: Apache-2.0 *)
(* How the shapes of an input, and the parts of an answer and of a certificate, are read. *)
open Source

(* A kind of certificate: for which word of the truth, which fields truth and certificate have, and its formula of
   the values of these fields. *)
type kind = {
  word : string;
  answers : string list;
  kind : string;
  facts : string list;
  formula : place list -> place list -> number Proved.cond;
}

type operation = {
  name : string;
  inputs : string list;
  field : string; (* of the truth, that holds the word; "": it has none *)
  kinds : place list -> kind list; (* of the values of the inputs *)
  unproved : string list; (* kinds that have no proof yet *)
  outwards : string list; (* fields of the truth, lists of pairs, that are rounded outwards *)
  by_contract : bool; (* what is rounded depends on more than the truth, and is not looked at *)
  defaults : (string * Json.t) list; (* of inputs that may be left out *)
}

let kind word answers kind facts formula = { word; answers; kind; facts; formula }
let operation ?(unproved = []) name inputs field kinds =
  { name; inputs; field; kinds; unproved; outwards = []; by_contract = false; defaults = [] }
let rounded_outwards fields operation = { operation with outwards = fields }
let rounded_by_contract operation = { operation with by_contract = true }
let with_defaults defaults operation = { operation with defaults }

(* The input with what it leaves out. *)
let completed operation (what, value) = match value with
  | Json.Object given ->
      (what, Json.Object (given @ List.filter (fun (name, _) -> not (List.mem_assoc name given)) operation.defaults))
  | _ -> (what, value)

let pair read place = match exactly 2 place with [ a; b ] -> (read a, read b) | _ -> assert false
let single read place = match exactly 1 place with [ a ] -> read a | _ -> assert false
let point = pair given
let segment = pair point
let exact_point = pair exact
let one = single exact
let index = single place_in_list
let indices place = List.map place_in_list (items place)
let exact_list place = List.map exact (items place)
let given_coordinates place = List.map given (items place)
let in_space place = List.map given (exactly 3 place)
let exact_in_space place = List.map exact (exactly 3 place)
let two_members one other read_one read_other place = match members [ one; other ] place with
  | [ a; b ] -> (read_one a, read_other b)
  | _ -> assert false
let ray read = two_members "origin" "direction" read read
let ball = two_members "center" "radius" given_coordinates given
let box = two_members "min" "max" given_coordinates given_coordinates
let obb = two_members "center" "half_axes" in_space (fun axes -> List.map in_space (exactly 3 axes))
let plane = two_members "normal" "offset" in_space given
let around_segment = two_members "segment" "radius" (fun ends -> List.map in_space (exactly 2 ends)) given

(* Vectors of space as Coq's triples *)
let triple read place = match exactly 3 place with
  | [ x; y; z ] -> ((read x, read y), read z)
  | _ -> assert false

let vector = triple given
let exact_vector = triple exact
let body = two_members "mass" "velocity" given vector

let moving_body place = match members [ "position"; "velocity"; "angular_velocity" ] place with
  | [ position; velocity; turn ] -> ((vector position, vector velocity), vector turn)
  | _ -> assert false
