(* SPDX-License-Identifier: Apache-2.0 *)
(* The kinds of certificates of points and lines of the plane: which field is which number of a formula. *)
open Proved
open Shapes
open Source

let separating_line = function
  | [ normal; offset ] -> Separating_line (exact_point normal, one offset)
  | _ -> assert false

let supporting_line = function
  | [ normal; offset ] -> Supporting_line (exact_point normal, one offset)
  | _ -> assert false

let orientation = operation "orientation" [ "p0"; "p1"; "p" ] "side" (function
  | [ p0; p1; p ] ->
      let check side _ facts = check_orientation (point p0) (point p1) (point p) side (one (List.hd facts)) in
      [ kind "left" [] "determinant" [ "determinant" ] (check Left);
        kind "right" [] "determinant" [ "determinant" ] (check Right);
        kind "on" [] "determinant" [ "determinant" ] (check On) ]
  | _ -> assert false)

let point_on_segment = operation "point_on_segment" [ "point"; "segment" ] "relation" (function
  | [ p; s ] ->
      let check = check_point_on_segment (point p) (segment s) in
      [ kind "off" [] "separating_line" [ "normal"; "offset" ] (fun _ facts -> check Off (separating_line facts));
        kind "on" [ "t" ] "weights" [ "weights" ] (fun answers facts ->
          let first, second = exact_point (List.hd facts) in
          check (At_parameter (exact (List.hd answers))) (Weights (first, second))) ]
  | _ -> assert false)

let overlap = pair exact_point

let segment_segment = operation "segment_segment" [ "a"; "b" ] "relation" (function
  | [ a; b ] ->
      let check = check_segment_segment (segment a) (segment b) in
      let meeting facts_of = fun answers facts -> match answers with
        | [ ta; tb; p ] -> check (Point (exact ta, exact tb, exact_point p)) (facts_of facts)
        | _ -> assert false in
      let point_answers = [ "ta"; "tb"; "point" ] in
      [ kind "disjoint" [] "separating_line" [ "normal"; "offset" ] (fun _ facts ->
        check Apart (separating_line facts));
        kind "point" point_answers "transversal" [ "determinant" ]
          (meeting (fun facts -> Transversal (one (List.hd facts))));
        kind "point" point_answers "single_point" [] (meeting (fun _ -> Single_point));
        kind "point" point_answers "supporting_line" [ "normal"; "offset" ] (meeting supporting_line);
        kind "overlap" [ "overlap" ] "overlap" [ "on_a"; "on_b" ] (fun answers facts -> match facts with
          | [ on_a; on_b ] ->
              let p, q = overlap (List.hd answers) in
              check (Overlap (p, q)) (Overlap_facts (exact_point on_a, exact_point on_b))
          | _ -> assert false) ]
  | _ -> assert false)

let line_line = operation "line_line" [ "a"; "b" ] "relation" (function
  | [ a; b ] ->
      let check = check_line_line (segment a) (segment b) in
      [ kind "crossing" [ "ta"; "tb"; "point" ] "transversal" [ "determinant" ] (fun answers facts ->
          match answers with
          | [ ta; tb; p ] ->
              check (Crossing (exact ta, exact tb, exact_point p)) (Transversal (one (List.hd facts)))
          | _ -> assert false);
        kind "parallel" [] "level_lines" [ "normal" ] (fun _ facts ->
          check Parallel (Level_lines (exact_point (List.hd facts))));
        kind "same" [] "same_line" [ "on_a" ] (fun _ facts -> check Same (Same_line (exact_point (List.hd facts)))) ]
  | _ -> assert false)

let ray_segment = operation "ray_segment" [ "ray"; "segment" ] "relation" (function
  | [ r; s ] ->
      let origin, direction = ray point r in
      let check = check_ray_segment origin direction (segment s) in
      let meeting facts_of = fun answers facts -> match answers with
        | [ t; p ] -> check (Hit_point (exact t, exact_point p)) (facts_of facts)
        | _ -> assert false in
      [ kind "none" [] "separating_line" [ "normal"; "offset" ] (fun _ facts -> match facts with
          | [ normal; offset ] -> check Missed (Ray_separating_line (exact_point normal, one offset))
          | _ -> assert false);
        kind "point" [ "t"; "point" ] "transversal" [ "on_segment"; "determinant" ] (meeting (function
          | [ u; determinant ] -> Ray_transversal (one u, one determinant)
          | _ -> assert false));
        kind "point" [ "t"; "point" ] "single_point" [] (meeting (fun _ -> Ray_single_point));
        kind "point" [ "t"; "point" ] "supporting_line" [ "on_segment"; "normal"; "offset" ] (meeting (function
          | [ u; normal; offset ] -> Ray_supporting_line (one u, exact_point normal, one offset)
          | _ -> assert false));
        kind "overlap" [ "t"; "overlap" ] "overlap" [ "on_ray"; "on_segment" ] (fun answers facts ->
          match (answers, facts) with
          | [ t; common ], [ on_ray; on_segment ] ->
              let p, q = overlap common in
              check (Hit_overlap (exact t, p, q)) (Ray_overlap_facts (exact_point on_ray, exact_point on_segment))
          | _ -> assert false) ]
  | _ -> assert false)

let operations = [ orientation; point_on_segment; segment_segment; line_line; ray_segment ]
