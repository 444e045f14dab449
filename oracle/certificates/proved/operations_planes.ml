(* SPDX-License-Identifier: Apache-2.0 *)
(* The kinds of certificates of planes, and of solids between planes: which field is which number of a formula. *)
open Proved
open Shapes
open Source

(* One fact, and one formula for each of three words. *)
let three words name fact check =
  List.map (fun (word, value) -> kind word [] name [ fact ] (fun _ facts -> check value (one (List.hd facts)))) words

let elevations = [ ("above", Above); ("on", Level_with); ("below", Below) ]

let explicit_line = operation "explicit_line" [ "slope"; "intercept"; "point" ] "side" (function
  | [ slope; intercept; p ] ->
      three elevations "height" "height" (check_explicit_line (given slope) (given intercept) (point p))
  | _ -> assert false)

let point_ground_plane = operation "point_ground_plane" [ "point" ] "side" (function
  | [ p ] -> three elevations "height" "height" (check_point_ground_plane (in_space p))
  | _ -> assert false)

let point_plane = operation ~unproved:[ "irrational_root" ] "point_plane" [ "plane"; "point" ] "side" (function
  | [ level; p ] ->
      let normal, offset = plane level in
      let root (word, side) =
        kind word [ "signed_distance" ] "root" [] (fun answers _ ->
          check_point_plane normal offset (in_space p) side (exact (List.hd answers))) in
      List.map root [ ("front", Front); ("on", On_plane); ("back", Back) ]
  | _ -> assert false)

let line_plane check =
  let heights word answers relation =
    kind word answers "heights" [ "heights" ] (fun answers facts ->
      let first, second = exact_point (List.hd facts) in
      check (relation answers) first second) in
  [ heights "none" [] (fun _ -> Misses_plane); heights "inside" [] (fun _ -> Inside_plane);
    heights "point" [ "t"; "point" ] (function
      | [ t; p ] -> Crosses_plane (exact t, exact_in_space p)
      | _ -> assert false) ]

let ray_plane = operation "ray_plane" [ "ray"; "plane" ] "relation" (function
  | [ r; level ] ->
      let (origin, direction), (normal, offset) = (ray in_space r, plane level) in
      line_plane (check_ray_plane origin direction normal offset)
  | _ -> assert false)

let segment_plane = operation "segment_plane" [ "segment"; "plane" ] "relation" (function
  | [ s; level ] ->
      let (a, b), (normal, offset) = (pair in_space s, plane level) in
      line_plane (check_segment_plane a b normal offset)
  | _ -> assert false)

let of_point word name check facts_of =
  kind word [] name [ "point" ] (fun _ facts -> check (facts_of (exact_in_space (List.hd facts))))

let sphere_plane = operation "sphere_plane" [ "sphere"; "plane" ] "contact" (function
  | [ sphere; level ] ->
      let center, radius = two_members "center" "radius" in_space given sphere and normal, offset = plane level in
      let check = check_sphere_plane center radius normal offset in
      [ of_point "disjoint" "nearest_point" (check Disjoint) (fun x -> Nearest_in_half_space x);
        of_point "touching" "tangent" (check Touching) (fun x -> Tangent_to_plane x);
        of_point "overlapping" "common_interior_point" (check Overlapping) (fun x -> Common_point_inside x) ]
  | _ -> assert false)

let aabb_plane = operation "aabb_plane" [ "aabb"; "plane" ] "contact" (function
  | [ aabb; level ] ->
      let low, high = two_members "min" "max" in_space in_space aabb and normal, offset = plane level in
      let check = check_aabb_plane low high normal offset in
      [ of_point "disjoint" "lowest_point" (check Disjoint) (fun x -> Lowest_point x);
        of_point "touching" "lowest_point" (check Touching) (fun x -> Lowest_point x);
        kind "touching" [] "flat_axis" [ "point"; "axis" ] (fun _ facts -> match facts with
          | [ x; axis ] -> check Touching (Flat_box (exact_in_space x, index axis))
          | _ -> assert false);
        of_point "overlapping" "common_interior_point" (check Overlapping) (fun x -> Common_point_inside x) ]
  | _ -> assert false)

let obb_plane = operation "obb_plane" [ "obb"; "plane" ] "contact" (function
  | [ solid; level ] ->
      let (center, axes), (normal, offset) = (obb solid, plane level) in
      let of_coefficients word contact name facts_of =
        kind word [] name [ "coefficients" ] (fun _ facts ->
          check_obb_plane center axes normal offset contact (facts_of (exact_in_space (List.hd facts)))) in
      [ of_coefficients "disjoint" Disjoint "lowest_point" (fun u -> Lowest_point u);
        of_coefficients "touching" Touching "lowest_point" (fun u -> Lowest_point u);
        of_coefficients "overlapping" Overlapping "common_interior_point" (fun u -> Common_point_inside u) ]
  | _ -> assert false)

let capsule_plane = operation "capsule_plane" [ "capsule"; "plane" ] "contact" (function
  | [ capsule; level ] ->
      let (points, radius), (normal, offset) = (around_segment capsule, plane level) in
      let of_weights word contact name facts_of =
        kind word [] name [ "weights"; "point" ] (fun _ facts -> match facts with
          | [ weights; x ] ->
              check_capsule_plane points radius normal offset contact (facts_of (exact_in_space x)) (exact_list weights)
          | _ -> assert false) in
      [ of_weights "disjoint" Disjoint "nearest_point" (fun x -> Nearest_in_half_space x);
        of_weights "touching" Touching "tangent" (fun x -> Tangent_to_plane x);
        of_weights "overlapping" Overlapping "common_interior_point" (fun x -> Common_point_inside x) ]
  | _ -> assert false)

let kdop place = match members [ "normals"; "slabs" ] place with
  | [ normals; slabs ] ->
      let normals = List.map in_space (items normals) and slabs = List.map point (items slabs) in
      same_length place normals slabs;
      List.combine normals slabs
  | _ -> assert false

let point_in_kdop = operation "point_in_kdop" [ "kdop"; "point" ] "location" (function
  | [ solid; p ] ->
      let check = check_point_in_kdop (kdop solid) (in_space p) in
      let of_slab word location name facts_of =
        kind word [] name [ "slab"; "value" ] (fun _ facts -> match facts with
          | [ slab; value ] -> check location (facts_of (index slab) (one value))
          | _ -> assert false) in
      [ kind "inside" [] "values" [ "values" ] (fun _ facts ->
          check Inside (All_values (exact_list (List.hd facts))));
        of_slab "boundary" Boundary "end_of_slab" (fun k v -> End_of_slab (k, v));
        of_slab "outside" Outside "beyond_slab" (fun k v -> Beyond_slab (k, v)) ]
  | _ -> assert false)

let kdop_kdop = operation "kdop_kdop" [ "a"; "b" ] "contact" (function
  | [ a; b ] ->
      let check = check_kdop_kdop (kdop a) (kdop b) in
      [ kind "disjoint" [] "separating_slab" [ "slab"; "value" ] (fun _ facts -> match facts with
          | [ slab; value ] -> check Disjoint (Separating_slab (index slab, one value))
          | _ -> assert false);
        kind "touching" [] "touching_slab" [ "slab"; "values" ] (fun _ facts -> match facts with
          | [ slab; v ] -> check Touching (Touching_slab (index slab, exact_list v))
          | _ -> assert false);
        kind "overlapping" [] "common_values" [ "values" ] (fun _ facts ->
          check Overlapping (Common_values (exact_list (List.hd facts)))) ]
  | _ -> assert false)

let operations =
  [ explicit_line; point_ground_plane; point_plane; ray_plane; segment_plane; sphere_plane; aabb_plane; obb_plane;
    capsule_plane; point_in_kdop; kdop_kdop ]
