(* SPDX-License-Identifier: Apache-2.0 *)
(* The kinds of certificates of meshes that are closed and convex: which field is which number of a formula. *)
open Proved
open Shapes
open Source

let face place = List.map natural (exactly 3 place)

let mesh =
  two_members "vertices" "faces" (fun place -> List.map in_space (items place)) (fun place ->
    List.map face (items place))

let point_in_convex_polyhedron = operation "point_in_convex_polyhedron" [ "mesh"; "point" ] "location" (function
  | [ solid; p ] ->
      let vertices, faces = mesh solid in
      let check = check_point_in_convex_polyhedron vertices faces (in_space p) in
      let between word location =
        kind word [] "barycentric" [ "corners"; "weights" ] (fun _ facts -> match facts with
          | [ corners; weights ] -> check location (Barycentric (indices corners, exact_list weights))
          | _ -> assert false) in
      [ between "inside" Inside; between "boundary" Boundary;
        kind "outside" [] "separating_face" [ "face" ] (fun _ facts ->
          check Outside (Separating_face (index (List.hd facts)))) ]
  | _ -> assert false)

let convex_distance = operation ~unproved:[ "irrational_root" ] "convex_distance" [ "a"; "b" ] "relation" (function
  | [ a; b ] ->
      let (va, fa), (vb, fb) = (mesh a, mesh b) in
      let check = check_convex_distance va fa vb fb in
      let distances = [ "squared_distance"; "distance" ] in
      [ kind "apart" ("on_a" :: "on_b" :: distances) "root" [ "on_a"; "on_b"; "first" ] (fun answers facts ->
          match (answers, facts) with
          | [ x; y; square; distance ], [ on_a; on_b; first ] ->
              check (Some (exact_list x, exact_list y)) (exact square) (exact distance)
                (Nearest_at (exact_list on_a, exact_list on_b, exact_list first))
          | _ -> assert false);
        kind "meeting" distances "common_point" [ "on_a"; "on_b" ] (fun answers facts -> match (answers, facts) with
          | [ square; distance ], [ on_a; on_b ] ->
              check None (exact square) (exact distance) (Meets_at (exact_list on_a, exact_list on_b))
          | _ -> assert false) ]
  | _ -> assert false)

let sphere_convex = operation "sphere_convex" [ "sphere"; "mesh" ] "contact" (function
  | [ sphere; solid ] ->
      let (c, r), (va, fa) = (Operations_hulls.ball sphere, mesh solid) in
      Operations_hulls.contacts [ "weights" ] (fun contact gap facts ->
        check_sphere_convex c r va fa contact gap (exact_list (List.hd facts)))
  | _ -> assert false)

let capsule_convex = operation "capsule_convex" [ "capsule"; "mesh" ] "contact" (function
  | [ round; solid ] ->
      let (points, r), (va, fa) = (Operations_hulls.capsule round, mesh solid) in
      Operations_hulls.contacts [ "on_a"; "on_b" ] (fun contact gap facts -> match facts with
        | [ on_a; on_b ] -> check_capsule_convex points r va fa contact gap (exact_list on_a) (exact_list on_b)
        | _ -> assert false)
  | _ -> assert false)

let operations = [ point_in_convex_polyhedron; convex_distance; sphere_convex; capsule_convex ]
