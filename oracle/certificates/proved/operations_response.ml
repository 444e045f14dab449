(* SPDX-License-Identifier: Apache-2.0 *)
(* The kinds of certificates of bodies: which field is which number of a formula. *)
open Proved
open Shapes
open Source

let bodies place = List.map body (items place)

let decomposition check =
  [ kind "" [ "velocity" ] "decomposition" [ "along"; "across" ] (fun answers facts -> match facts with
      | [ along; across ] -> check (exact_vector (List.hd answers)) (exact_vector along) (exact_vector across)
      | _ -> assert false) ]

let reflect_plane = operation "reflect_plane" [ "velocity"; "normal" ] "" (function
  | [ v; n ] -> decomposition (check_reflect_plane (vector v) (vector n))
  | _ -> assert false)

let damped_reflection = operation "damped_reflection" [ "velocity"; "normal"; "k" ] "" (function
  | [ v; n; k ] -> decomposition (check_damped_reflection (vector v) (vector n) (given k))
  | _ -> assert false)

let momentum = operation "momentum" [ "bodies" ] "" (function
  | [ l ] ->
      [ kind "" [ "momentum" ] "sum" [] (fun answers _ -> check_momentum (bodies l) (exact_vector (List.hd answers))) ]
  | _ -> assert false)

let kinetic_energy = operation "kinetic_energy" [ "bodies" ] "" (function
  | [ l ] ->
      [ kind "" [ "energy" ] "centre" [ "mass"; "velocity"; "doubled_energies" ] (fun answers facts -> match facts with
          | [ mass; velocity; energies ] ->
              let of_centre, seen = exact_point energies in
              check_kinetic_energy (bodies l) (exact (List.hd answers)) (one mass) (exact_vector velocity) of_centre
                seen
          | _ -> assert false) ]
  | _ -> assert false)

let inelastic_collision = operation "inelastic_collision" [ "masses"; "velocities" ] "" (function
  | [ masses; velocities ] ->
      let (m1, m2), (v1, v2) = (point masses, pair vector velocities) in
      [ kind "" [ "velocity" ] "momentum" [ "momentum" ] (fun answers facts ->
          check_inelastic_collision (m1, v1) (m2, v2) (exact_vector (List.hd answers)) (exact_vector (List.hd facts))) ]
  | _ -> assert false)

let contact_state = operation "contact_state" [ "a"; "b"; "point"; "normal" ] "state" (function
  | [ a; b; p; n ] ->
      let check = check_contact_state (moving_body a) (moving_body b) (vector p) (vector n) in
      let velocities (word, state) =
        kind word [] "point_velocities" [ "of_a"; "of_b" ] (fun _ facts -> match facts with
          | [ of_a; of_b ] -> check state (exact_vector of_a) (exact_vector of_b)
          | _ -> assert false) in
      List.map velocities [ ("separating", Separating); ("resting", Resting); ("colliding", Colliding) ]
  | _ -> assert false)

let operations =
  [ reflect_plane; damped_reflection; momentum; kinetic_energy; inelastic_collision; contact_state ]
