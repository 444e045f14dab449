(* SPDX-License-Identifier: Apache-2.0 *)
(* The kinds of certificates of bodies in several contacts: which field is which number of a formula. *)
open Proved
open Shapes
open Source

let point_body = two_members "inverse_mass" "velocity" given in_space

let contact place = match members [ "a"; "b"; "normal" ] place with
  | [ a; b; normal ] -> ((natural a, natural b), in_space normal)
  | _ -> assert false

let simultaneous_collisions = operation "simultaneous_collisions" [ "bodies"; "contacts"; "e" ] "relation" (function
  | [ bodies; contacts; e ] ->
      let each read place = List.map read (items place) in
      let check = check_simultaneous_collisions (each point_body bodies) (each contact contacts) (given e) in
      [ kind "possible" [ "velocities" ] "pushes" [ "impulses" ] (fun answers facts ->
          check (Some (each exact_in_space (List.hd answers))) (Impulses_push (exact_list (List.hd facts))));
        kind "impossible" [] "contradiction" [ "weights" ] (fun _ facts ->
          check None (Weights_contradict (exact_list (List.hd facts)))) ]
  | _ -> assert false)

let operations = [ simultaneous_collisions ]
