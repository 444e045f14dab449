(* SPDX-License-Identifier: Apache-2.0 *)
(* The kinds of certificates of rays and segments through solids, and of shapes that move: which field is which number
   of a formula. *)
open Proved
open Shapes
open Source

let positive = [ ("receding", Receding); ("too_late", Too_late); ("no_root", No_root) ]

(* The first zero of a polynomial c + b t + a t^2. *)
let zero_kinds check =
  let never (name, of_name) =
    kind "never" [] name [ "polynomial" ] (fun _ facts -> check None of_name (exact_in_space (List.hd facts))) in
  let hit name of_name =
    kind "hit" [ "t" ] name [ "polynomial" ] (fun answers facts ->
      check (Some (surd (List.hd answers))) of_name (exact_in_space (List.hd facts))) in
  hit "start" Start :: hit "first_root" First_root :: List.map never positive

let swept_sphere_sphere =
  operation "swept_sphere_sphere" [ "a"; "b"; "velocity_a"; "velocity_b" ] "relation" (function
    | [ a; b; v; w ] ->
        let (c, r), (d, s) = (ball a, ball b) in
        zero_kinds (check_swept_sphere_sphere c r (given_coordinates v) d s (given_coordinates w))
    | _ -> assert false)

let swept_sphere_plane = operation "swept_sphere_plane" [ "sphere"; "velocity"; "plane" ] "relation" (function
  | [ sphere; v; level ] ->
      let (c, r), (normal, offset) = (ball sphere, plane level) in
      zero_kinds (check_swept_sphere_plane c r (given_coordinates v) normal offset)
  | _ -> assert false)

let swept_capsule_plane = operation "swept_capsule_plane" [ "capsule"; "velocity"; "plane" ] "relation" (function
  | [ solid; v; level ] ->
      let (points, r), (normal, offset) = (around_segment solid, plane level) in
      zero_kinds (check_swept_capsule_plane points r (given_coordinates v) normal offset)
  | _ -> assert false)

let side place =
  let q = exact place in
  if Whole.equal q.Proved.qnum q.qden then Over
  else if Whole.equal (Whole.neg q.qnum) q.qden then Under
  else if Whole.sign q.qnum = 0 then Level
  else Numbers.refuse (fst place) "-1, 0 or 1"

let swept_sphere_aabb = operation "swept_sphere_aabb" [ "sphere"; "velocity"; "aabb" ] "relation" (function
  | [ sphere; v; aabb ] ->
      let (c, r), (low, high) = (ball sphere, box aabb) in
      let check = check_swept_sphere_aabb c r (given_coordinates v) low high in
      let time answers = Some (surd (List.hd answers)) in
      [ kind "hit" [ "t" ] "start" [ "point" ] (fun answers facts ->
          check (time answers) (Touching_at_start (exact_list (List.hd facts))));
        kind "hit" [ "t" ] "first_contact" [ "sides" ] (fun answers facts ->
          check (time answers) (On_sides (List.map side (exactly 3 (List.hd facts)))));
        kind "never" [] "separating_axis" [ "normal" ] (fun _ facts ->
          check None (Never_near (exact_list (List.hd facts)))) ]
  | _ -> assert false)

let passage read proves =
  kind "hit" [ "first"; "last" ] "passage" [] (fun answers _ -> match answers with
    | [ first; last ] -> proves (Some (read first, read last))
    | _ -> assert false)

let through_box check =
  [ passage exact (fun times -> check times Passage);
    kind "none" [] "separating_plane" [ "normal" ] (fun _ facts ->
      check None (Beyond_box (exact_list (List.hd facts)))) ]

let through_ball check =
  passage surd (fun times -> check times None)
  :: List.map (fun (name, of_name) -> kind "none" [] name [] (fun _ _ -> check None (Some of_name))) positive

let course name read solid kinds check =
  operation (name ^ "_" ^ solid) [ name; solid ] "relation" (function
    | [ line; shape ] -> kinds (check (read given_coordinates line) shape)
    | _ -> assert false)

let of_box check (start, way) shape = let low, high = box shape in check start way low high
let of_ball check (start, way) shape = let center, radius = ball shape in check start way center radius

let swept_aabb_aabb = operation "swept_aabb_aabb" [ "a"; "b"; "velocity" ] "relation" (function
  | [ a; b; v ] ->
      let (low_a, high_a), (low_b, high_b) = (box a, box b) in
      let check = check_swept_aabb_aabb low_a high_a low_b high_b (given_coordinates v) in
      let time answers = Some (exact (List.hd answers)) in
      [ kind "hit" [ "t" ] "start" [ "point" ] (fun answers facts ->
          check (time answers) (Start_in_both (exact_list (List.hd facts))));
        kind "hit" [ "t" ] "first_contact" [ "point"; "normal" ] (fun answers facts -> match facts with
          | [ p; normal ] -> check (time answers) (First_contact (exact_list p, exact_list normal))
          | _ -> assert false);
        kind "never" [] "separating_axis" [ "normal" ] (fun _ facts ->
          check None (Never_in_both (exact_list (List.hd facts)))) ]
  | _ -> assert false)

let operations =
  [ swept_sphere_sphere; swept_sphere_plane; swept_capsule_plane; swept_sphere_aabb;
    course "ray" ray "aabb" through_box (of_box check_ray_aabb);
    course "segment" pair "aabb" through_box (of_box check_segment_aabb);
    course "ray" ray "sphere" through_ball (of_ball check_ray_sphere);
    course "segment" pair "sphere" through_ball (of_ball check_segment_sphere); swept_aabb_aabb ]
