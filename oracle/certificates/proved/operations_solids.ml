(* SPDX-License-Identifier: Apache-2.0 *)
(* The kinds of certificates of solids: which field is which number of a formula. *)
open Proved
open Shapes
open Source

(* Kinds whose fact is a point, or a point and an axis. *)
let of_point word name check facts_of =
  kind word [] name [ "point" ] (fun _ facts -> check (facts_of (exact_list (List.hd facts))))

let of_point_and_axis word name check facts_of =
  kind word [] name [ "point"; "axis" ] (fun _ facts -> match facts with
    | [ x; axis ] -> check (facts_of (exact_list x) (index axis))
    | _ -> assert false)

let interior_point check = of_point "overlapping" "common_interior_point" (check Overlapping) (fun x ->
  Common_interior_point x)

let sphere_sphere = operation "sphere_sphere" [ "a"; "b" ] "contact" (function
  | [ a; b ] ->
      let (c, r), (d, s) = (ball a, ball b) in
      let check contact facts = check_sphere_sphere c r d s contact facts in
      [ kind "disjoint" [] "distance" [ "squared_distance" ] (fun _ facts ->
          check Disjoint (Distance (one (List.hd facts))));
        of_point "touching" "tangent" (check Touching) (fun x -> Tangent x);
        of_point "touching" "no_interior" (check Touching) (fun x -> No_interior x);
        interior_point check ]
  | _ -> assert false)

let aabb_aabb = operation "aabb_aabb" [ "a"; "b" ] "contact" (function
  | [ a; b ] ->
      let (low_a, high_a), (low_b, high_b) = (box a, box b) in
      let check contact facts = check_aabb_aabb low_a high_a low_b high_b contact facts in
      [ kind "disjoint" [] "separating_axis" [ "axis"; "value" ] (fun _ facts -> match facts with
          | [ axis; value ] -> check Disjoint (Separating_axis (index axis, one value))
          | _ -> assert false);
        of_point_and_axis "touching" "supporting_axis" (check Touching) (fun x axis -> Supporting_axis (x, axis));
        of_point_and_axis "touching" "flat_axis" (check Touching) (fun x axis -> Flat_axis (x, axis));
        interior_point check ]
  | _ -> assert false)

let sphere_aabb = operation "sphere_aabb" [ "sphere"; "aabb" ] "contact" (function
  | [ sphere; aabb ] ->
      let (c, r), (low, high) = (ball sphere, box aabb) in
      let check contact facts = check_sphere_aabb c r low high contact facts in
      [ of_point "disjoint" "nearest_point" (check Disjoint) (fun x -> Nearest_point x);
        of_point "touching" "tangent" (check Touching) (fun x -> Tangent x);
        of_point_and_axis "touching" "flat_axis" (check Touching) (fun x axis -> Flat_axis (x, axis));
        interior_point check ]
  | _ -> assert false)

let implicit_circle = operation "implicit_circle" [ "circle"; "point" ] "location" (function
  | [ circle; p ] ->
      let c, r = two_members "center" "radius" (fun c -> List.map given (exactly 2 c)) given circle in
      let p = List.map given (exactly 2 p) in
      let squares location = fun _ facts -> match facts with
        | [ distance; radius ] -> check_implicit_circle c r p location (one distance) (one radius)
        | _ -> assert false in
      let facts = [ "squared_distance"; "squared_radius" ] in
      [ kind "inside" [] "squares" facts (squares Inside); kind "boundary" [] "squares" facts (squares Boundary);
        kind "outside" [] "squares" facts (squares Outside) ]
  | _ -> assert false)

let closest_point_on_aabb = operation "closest_point_on_aabb" [ "point"; "aabb" ] "" (function
  | [ p; aabb ] ->
      let low, high = box aabb in
      [ kind "" [ "point" ] "multipliers" [ "lower"; "upper" ] (fun answers facts -> match facts with
          | [ lower; upper ] ->
              check_closest_point_on_aabb (given_coordinates p) low high (exact_list (List.hd answers))
                (exact_list lower) (exact_list upper)
          | _ -> assert false) ]
  | _ -> assert false)

let operations = [ sphere_sphere; aabb_aabb; sphere_aabb; implicit_circle; closest_point_on_aabb ]
