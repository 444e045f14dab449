(* SPDX-License-Identifier: Apache-2.0 *)
(* The kinds of certificates of what segments, rays and triangles have in common with a triangle: which field is which
   number of a formula. *)
open Proved
open Shapes
open Source

let corners place = List.map in_space (exactly 3 place)
let lists places = List.map exact_list places

(* Lists of so many numbers, one after the other *)
let rec groups (what, _ as place) count numbers =
  if numbers = [] then []
  else if List.length numbers < count then Numbers.refuse what (Printf.sprintf "%d numbers each" count)
  else
    let inner = List.filteri (fun i _ -> i < count) numbers and rest = List.filteri (fun i _ -> i >= count) numbers in
    inner :: groups place count rest

let segment_triangle = operation "segment_triangle" [ "segment"; "triangle" ] "relation" (function
  | [ s; triangle ] ->
      let a, b = pair in_space s in
      let check = check_segment_triangle a b (corners triangle) in
      let common word answers common_of =
        kind word answers "common_part" [ "on_segment"; "weights"; "before"; "after" ] (fun answers facts ->
          match lists facts with
          | [ t; weights; before; after ] -> check (common_of answers) (Common_part (t, weights, before, after))
          | _ -> assert false) in
      [ kind "none" [] "separating_plane" [ "normal"; "offset" ] (fun _ facts -> match facts with
          | [ normal; offset ] -> check No_point (Plane_separates (exact_in_space normal, one offset))
          | _ -> assert false);
        common "point" [ "t"; "point" ] (function
          | [ t; p ] -> Common_point (exact t, exact_in_space p)
          | _ -> assert false);
        common "segment" [ "overlap" ] (function
          | [ ends ] -> let p, q = pair exact_in_space ends in Common_segment (p, q)
          | _ -> assert false) ]
  | _ -> assert false)

let ray_triangle = operation "ray_triangle" [ "ray"; "triangle" ] "relation" (function
  | [ r; triangle ] ->
      let origin, direction = ray in_space r in
      let check = check_ray_triangle origin direction (corners triangle) in
      let common word answers common_of =
        kind word answers "common_part" [ "on_ray"; "weights"; "before"; "after" ] (fun answers facts ->
          match lists facts with
          | [ t; weights; before; after ] -> check (common_of answers) (Ray_part (t, weights, before, after))
          | _ -> assert false) in
      let within (what, _ as place) = match word place with
        | "inside" -> true
        | "boundary" -> false
        | _ -> Numbers.refuse what "inside or boundary" in
      [ kind "none" [] "separating_plane" [ "plane"; "until" ] (fun _ facts -> match facts with
          | [ plane; until ] -> (match exact_list plane with
              | [ x; y; z; offset ] -> check Ray_misses (Plane_until ([ x; y; z ], offset, one until))
              | _ -> Numbers.refuse (fst plane) "four numbers")
          | _ -> assert false);
        common "point" [ "t"; "point"; "location" ] (function
          | [ t; p; location ] -> Ray_hits (exact t, exact_in_space p, within location)
          | _ -> assert false);
        common "segment" [ "t"; "point" ] (function
          | [ t; p ] -> Ray_enters (exact t, exact_in_space p)
          | _ -> assert false) ]
  | _ -> assert false)

let triangle_triangle = operation "triangle_triangle" [ "a"; "b" ] "relation" (function
  | [ a; b ] ->
      let dimension (word, common) =
        kind word [] "dimension" [ "planes"; "on_a"; "on_b" ] (fun _ facts -> match facts with
          | [ planes; on_a; on_b ] ->
              let plane = function [ x; y; z; offset ] -> ([ x; y; z ], offset) | _ -> assert false in
              let weights place = groups place 3 (exact_list place) in
              check_triangle_triangle (corners a) (corners b) common
                (List.map plane (groups planes 4 (exact_list planes))) (weights on_a) (weights on_b)
          | _ -> assert false) in
      List.map dimension
        [ ("none", Common_none); ("point", Common_one); ("segment", Common_line); ("area", Common_area) ]
  | _ -> assert false)

let operations = [ segment_triangle; ray_triangle; triangle_triangle ]
