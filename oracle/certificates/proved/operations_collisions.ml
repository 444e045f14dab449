(* SPDX-License-Identifier: Apache-2.0 *)
(* The kinds of certificates of bodies that bounce, collide, or are pushed back: which field is which number of a
   formula. *)
open Proved
open Shapes
open Source

let reflect_wall = operation "reflect_wall" [ "velocity"; "axis" ] "" (function
  | [ v; axis ] ->
      let axis = match word axis with
        | "x" -> Along_x
        | "y" -> Along_y
        | "z" -> Along_z
        | _ -> Numbers.refuse "axis" "x, y or z" in
      [ kind "" [ "velocity" ] "components" [ "squared_speeds" ] (fun answers facts ->
          let first, last = exact_point (List.hd facts) in
          check_reflect_wall (vector v) axis (exact_vector (List.hd answers)) first last) ]
  | _ -> assert false)

let impulse masses velocities check =
  let (m1, m2), (v1, v2) = (point masses, pair vector velocities) in
  [ kind "" [ "velocities" ] "impulse" [ "impulse"; "doubled_energies" ] (fun answers facts -> match facts with
      | [ impulse; energies ] ->
          let v, w = pair exact_vector (List.hd answers) and first, last = exact_point energies in
          check (m1, v1) (m2, v2) v w (one impulse) first last
      | _ -> assert false) ]

let elastic_collision = operation "elastic_collision" [ "masses"; "velocities"; "normal" ] "" (function
  | [ masses; velocities; n ] -> impulse masses velocities (fun a b -> check_elastic_collision a b (vector n))
  | _ -> assert false)

let restitution_collision = operation "restitution_collision" [ "masses"; "velocities"; "normal"; "e" ] "" (function
  | [ masses; velocities; n; e ] ->
      impulse masses velocities (fun a b -> check_restitution_collision a b (vector n) (given e))
  | _ -> assert false)

let penalty_force =
  operation "penalty_force" [ "point"; "velocity"; "plane"; "stiffness"; "damping" ] "" (function
    | [ p; v; level; stiffness; damping ] ->
        let normal, offset = two_members "normal" "offset" vector given level in
        let check answers =
          check_penalty_force (vector p) (vector v) normal offset (given stiffness) (given damping)
            (exact_vector (List.hd answers)) in
        [ kind "" [ "force" ] "no_contact" [] (fun answers _ -> check answers No_contact);
          kind "" [ "force" ] "foot" [ "foot"; "along" ] (fun answers facts -> match facts with
            | [ foot; along ] -> check answers (Foot_and_along (exact_vector foot, exact_vector along))
            | _ -> assert false) ]
    | _ -> assert false)

let rigid place = match members [ "mass"; "inertia"; "position"; "velocity"; "angular_velocity" ] place with
  | [ mass; inertia; position; velocity; turn ] ->
      ((given mass, triple vector inertia), ((vector position, vector velocity), vector turn))
  | _ -> assert false

let rigid_body_collision = operation "rigid_body_collision" [ "a"; "b"; "point"; "normal"; "e" ] "" (function
  | [ a; b; p; n; e ] ->
      let motion = two_members "velocity" "angular_velocity" exact_vector exact_vector in
      [ kind "" [ "a"; "b" ] "impulse_at" [ "impulse"; "doubled_energies" ] (fun answers facts ->
          match (answers, facts) with
          | [ after_a; after_b ], [ impulse; energies ] ->
              let (va, wa), (vb, wb) = (motion after_a, motion after_b) and first, last = exact_point energies in
              check_rigid_body_collision (rigid a) (rigid b) (vector p) (vector n) (given e) va wa vb wb (one impulse)
                first last
          | _ -> assert false) ]
  | _ -> assert false)

let operations =
  [ reflect_wall; elastic_collision; restitution_collision; penalty_force; rigid_body_collision ]
