(* SPDX-License-Identifier: Apache-2.0 *)
(* The kinds of certificates of boxes, slabs and balls around points, and of oriented boxes: which field is which number
   of a formula. *)
open Proved
open Shapes
open Source

let points read place = List.map read (items place)

let extreme_points answer check =
  [ kind "" [ answer ] "extreme_points" [ "least"; "greatest" ] (fun answers facts -> match facts with
      | [ least; greatest ] -> check (List.hd answers) (indices least) (indices greatest)
      | _ -> assert false) ]

let aabb_of_points = operation "aabb_of_points" [ "points" ] "" (function
  | [ everything ] ->
      extreme_points "aabb" (fun aabb ->
        let low, high = two_members "min" "max" exact_list exact_list aabb in
        check_aabb_of_points (points given_coordinates everything) low high)
  | _ -> assert false)

let kdop_of_points = rounded_outwards [ "slabs" ] (operation "kdop_of_points" [ "points"; "normals" ] "" (function
  | [ everything; normals ] ->
      extreme_points "slabs" (fun slabs ->
        check_kdop_of_points (points in_space everything) (points in_space normals) (points exact_point slabs))
  | _ -> assert false))

(* The radius is the least around the center that is rounded. *)
let bounding_sphere =
  rounded_by_contract @@ with_defaults [ ("method", Json.Text "smallest") ] (operation ~unproved:[ "lower_bound" ] "bounding_sphere"
    [ "points"; "method" ] "" (function
    | [ everything; method_ ] ->
        let check how answers =
          let center, radius = two_members "center" "radius" exact_in_space surd (List.hd answers) in
          check_bounding_sphere (points in_space everything) how center radius in
        let farthest how =
          [ kind "" [ "sphere" ] "farthest_point" [ "point" ] (fun answers facts ->
              check how answers (Farthest_point (index (List.hd facts)))) ] in
        (match word method_ with
        | "box" -> farthest Around_box
        | "centroid" -> farthest Around_mean
        | "smallest" ->
            [ kind "" [ "sphere" ] "support" [ "points"; "weights" ] (fun answers facts -> match facts with
                | [ places; weights ] -> check Smallest answers (Support (indices places, exact_list weights))
                | _ -> assert false) ]
        | "ritter" -> []
        | _ -> Numbers.refuse "method" "one of box, centroid, ritter, smallest")
    | _ -> assert false))

let point_in_obb = operation "point_in_obb" [ "obb"; "point" ] "location" (function
  | [ solid; p ] ->
      let center, axes = obb solid in
      let check = check_point_in_obb center axes (in_space p) in
      let of_coefficients word location =
        kind word [] "coefficients" [ "coefficients" ] (fun _ facts ->
          check location (Coefficients (exact_list (List.hd facts)))) in
      [ of_coefficients "inside" Inside; of_coefficients "boundary" Boundary;
        kind "outside" [] "separating_plane" [ "normal" ] (fun _ facts ->
          check Outside (Beyond_plane (exact_list (List.hd facts)))) ]
  | _ -> assert false)

let obb_obb = operation "obb_obb" [ "a"; "b" ] "contact" (function
  | [ a; b ] ->
      let (center_a, axes_a), (center_b, axes_b) = (obb a, obb b) in
      let check = check_obb_obb center_a axes_a center_b axes_b in
      [ kind "disjoint" [] "separating_axis" [ "normal" ] (fun _ facts ->
          check Disjoint (Apart_along (exact_list (List.hd facts))));
        kind "touching" [] "supporting_axis" [ "on_a"; "on_b"; "normal" ] (fun _ facts -> match facts with
          | [ on_a; on_b; normal ] ->
              check Touching (Touch_along (exact_list on_a, exact_list on_b, exact_list normal))
          | _ -> assert false);
        kind "overlapping" [] "common_interior_point" [ "on_a"; "on_b" ] (fun _ facts -> match facts with
          | [ on_a; on_b ] -> check Overlapping (Common_inside (exact_list on_a, exact_list on_b))
          | _ -> assert false) ]
  | _ -> assert false)

let aabb_obb = operation "aabb_obb" [ "aabb"; "obb" ] "contact" (function
  | [ aabb; solid ] ->
      let low, high = two_members "min" "max" in_space in_space aabb and center, axes = obb solid in
      let check = check_aabb_obb low high center axes in
      [ kind "disjoint" [] "separating_axis" [ "normal" ] (fun _ facts ->
          check Disjoint (Past_aabb (exact_list (List.hd facts))));
        kind "touching" [] "supporting_axis" [ "coefficients"; "normal" ] (fun _ facts -> match facts with
          | [ u; normal ] -> check Touching (Touched_aabb (exact_list u, exact_list normal))
          | _ -> assert false);
        kind "touching" [] "flat_axis" [ "coefficients"; "axis" ] (fun _ facts -> match facts with
          | [ u; axis ] -> check Touching (Flat_aabb (exact_list u, index axis))
          | _ -> assert false);
        kind "overlapping" [] "common_interior_point" [ "coefficients" ] (fun _ facts ->
          check Overlapping (Inside_aabb (exact_list (List.hd facts)))) ]
  | _ -> assert false)

let triangle_obb = operation "triangle_obb" [ "triangle"; "obb" ] "contact" (function
  | [ triangle; solid ] ->
      let center, axes = obb solid in
      let check = check_triangle_obb (List.map given_coordinates (exactly 3 triangle)) center axes in
      [ kind "disjoint" [] "separating_axis" [ "normal" ] (fun _ facts ->
          check Disjoint (Below_along (exact_list (List.hd facts))));
        kind "touching" [] "supporting_axis" [ "on_a"; "on_b"; "normal" ] (fun _ facts -> match facts with
          | [ u; v; normal ] -> check Touching (Corners_touch (exact_list u, exact_list v, exact_list normal))
          | _ -> assert false);
        kind "overlapping" [] "common_interior_point" [ "on_a"; "on_b" ] (fun _ facts -> match facts with
          | [ u; v ] -> check Overlapping (Corners_inside (exact_list u, exact_list v))
          | _ -> assert false) ]
  | _ -> assert false)

let operations = [ aabb_of_points; kdop_of_points; bounding_sphere; point_in_obb; obb_obb; aabb_obb; triangle_obb ]
