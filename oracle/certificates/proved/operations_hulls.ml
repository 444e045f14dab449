(* SPDX-License-Identifier: Apache-2.0 *)
(* The kinds of certificates of segments, triangles and capsules, and of nearest points: which field is which number of
   a formula. *)
open Proved
open Shapes
open Source

let hull count place = List.map given_coordinates (exactly count place)
let answered = [ "squared_distance"; "distance" ]

let closest count check = function
  | [ p; points ] ->
      [ kind "" ("point" :: answered) "root" [ "weights" ] (fun answers facts -> match answers with
          | [ x; square; distance ] ->
              check (hull count points) (given_coordinates p) (exact_list x) (exact square) (exact distance)
                (exact_list (List.hd facts))
          | _ -> assert false) ]
  | _ -> assert false

let closest_point_on_segment =
  operation ~unproved:[ "irrational_root" ] "closest_point_on_segment" [ "point"; "segment" ] ""
    (closest 2 check_closest_point_on_segment)

let closest_point_on_triangle =
  operation ~unproved:[ "irrational_root" ] "closest_point_on_triangle" [ "point"; "triangle" ] ""
    (closest 3 check_closest_point_on_triangle)

let segment_segment_distance =
  operation ~unproved:[ "irrational_root" ] "segment_segment_distance" [ "a"; "b" ] "" (function
    | [ a; b ] ->
        let (a0, a1), (b0, b1) = (pair given_coordinates a, pair given_coordinates b) in
        [ kind "" ("on_a" :: "on_b" :: answered) "root" [ "on_a"; "on_b" ] (fun answers facts ->
            match (answers, facts) with
            | [ x; y; square; distance ], [ on_a; on_b ] ->
                check_segment_segment_distance a0 a1 b0 b1 (exact_list x) (exact_list y) (exact square) (exact distance)
                  (exact_list on_a) (exact_list on_b)
            | _ -> assert false) ]
    | _ -> assert false)

let contacts facts check =
  List.map
    (fun (word, contact, name, gap) -> kind word [] name facts (fun _ facts -> check contact gap facts))
    [ ("disjoint", Disjoint, "nearest_points", Nearest_points); ("touching", Touching, "tangent", Tangent_points);
      ("touching", Touching, "no_interior", Without_interior);
        ("overlapping", Overlapping, "near_points", Near_points) ]

let ball = two_members "center" "radius" in_space given
let capsule = two_members "segment" "radius" (hull 2) given

let sphere_capsule = operation "sphere_capsule" [ "sphere"; "capsule" ] "contact" (function
  | [ sphere; solid ] ->
      let (c, r), (segment, s) = (ball sphere, capsule solid) in
      contacts [ "weights" ] (fun contact gap facts ->
        check_sphere_capsule c r segment s contact gap (exact_list (List.hd facts)))
  | _ -> assert false)

let capsule_capsule = operation "capsule_capsule" [ "a"; "b" ] "contact" (function
  | [ a; b ] ->
      let (a, r), (b, s) = (capsule a, capsule b) in
      contacts [ "on_a"; "on_b" ] (fun contact gap facts -> match facts with
        | [ on_a; on_b ] -> check_capsule_capsule a r b s contact gap (exact_list on_a) (exact_list on_b)
        | _ -> assert false)
  | _ -> assert false)

let sphere_triangle = operation "sphere_triangle" [ "sphere"; "triangle" ] "contact" (function
  | [ sphere; triangle ] ->
      let c, r = ball sphere in
      contacts [ "weights" ] (fun contact gap facts ->
        check_sphere_triangle c r (hull 3 triangle) contact gap (exact_list (List.hd facts)))
  | _ -> assert false)

let capsule_triangle = operation "capsule_triangle" [ "capsule"; "triangle" ] "contact" (function
  | [ round; triangle ] ->
      let points, r = capsule round in
      contacts [ "on_a"; "on_b" ] (fun contact gap facts -> match facts with
        | [ on_a; on_b ] ->
            check_capsule_triangle points r (hull 3 triangle) contact gap (exact_list on_a) (exact_list on_b)
        | _ -> assert false)
  | _ -> assert false)

let sphere_obb = operation "sphere_obb" [ "sphere"; "obb" ] "contact" (function
  | [ sphere; solid ] ->
      let (c, r), (center, axes) = (ball sphere, obb solid) in
      contacts [ "coefficients" ] (fun contact gap facts ->
        check_sphere_obb c r center axes contact gap (exact_list (List.hd facts)))
  | _ -> assert false)

let capsule_obb = operation "capsule_obb" [ "capsule"; "obb" ] "contact" (function
  | [ round; solid ] ->
      let (points, r), (center, axes) = (capsule round, obb solid) in
      contacts [ "on_a"; "on_b" ] (fun contact gap facts -> match facts with
        | [ on_a; on_b ] ->
            check_capsule_obb points r center axes contact gap (exact_list on_a) (exact_list on_b)
        | _ -> assert false)
  | _ -> assert false)

let capsule_aabb = operation "capsule_aabb" [ "capsule"; "aabb" ] "contact" (function
  | [ round; aabb ] ->
      let (points, r), (low, high) = (capsule round, two_members "min" "max" in_space in_space aabb) in
      contacts [ "on_a"; "on_b" ] (fun contact gap facts -> match facts with
        | [ on_a; on_b ] -> check_capsule_aabb points r low high contact gap (exact_list on_a) (exact_list on_b)
        | _ -> assert false)
  | _ -> assert false)

let triangle_aabb = operation "triangle_aabb" [ "triangle"; "aabb" ] "contact" (function
  | [ triangle; aabb ] ->
      let low, high = two_members "min" "max" in_space in_space aabb in
      let check = check_triangle_aabb (hull 3 triangle) low high in
      [ kind "disjoint" [] "separating_plane" [ "normal"; "offset" ] (fun _ facts -> match facts with
          | [ normal; offset ] -> check Disjoint (Plane_between (exact_list normal, one offset))
          | _ -> assert false);
        kind "touching" [] "supporting_plane" [ "normal"; "offset"; "weights" ] (fun _ facts -> match facts with
          | [ normal; offset; weights ] ->
              check Touching (Plane_touched (exact_list weights, exact_list normal, one offset))
          | _ -> assert false);
        kind "touching" [] "flat_axis" [ "weights"; "axis" ] (fun _ facts -> match facts with
          | [ weights; axis ] -> check Touching (Box_is_flat (exact_list weights, index axis))
          | _ -> assert false);
        kind "overlapping" [] "common_interior_point" [ "weights" ] (fun _ facts ->
          check Overlapping (Weights_inside (exact_list (List.hd facts)))) ]
  | _ -> assert false)

let operations =
  [ closest_point_on_segment; closest_point_on_triangle; segment_segment_distance; sphere_capsule; capsule_capsule;
    sphere_triangle; capsule_triangle; sphere_obb; capsule_obb; capsule_aabb; triangle_aabb ]
