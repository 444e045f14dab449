(* SPDX-License-Identifier: Apache-2.0 *)
(* The kinds of certificates of shapes that move: which field is which number of a formula. *)
open Proved
open Shapes
open Source

(* The first zero of a polynomial c + b t + a t^2. *)
let zero_kinds check =
  let never name facts_of =
    kind "never" [] name [ "polynomial" ] (fun _ facts -> match exact_in_space (List.hd facts) with
      | [ c; b; a ] -> check Never (facts_of c b a)
      | _ -> assert false) in
  let hit name facts_of =
    kind "hit" [ "t" ] name [ "polynomial" ] (fun answers facts -> match exact_in_space (List.hd facts) with
      | [ c; b; a ] -> check (First_at (surd (List.hd answers))) (facts_of c b a)
      | _ -> assert false) in
  [ hit "start" (fun c b a -> Start (c, b, a)); hit "first_root" (fun c b a -> First_root (c, b, a));
    never "receding" (fun c b a -> Receding (c, b, a)); never "too_late" (fun c b a -> Too_late (c, b, a));
    never "no_root" (fun c b a -> No_root (c, b, a)) ]

let swept_sphere_sphere =
  operation "swept_sphere_sphere" [ "a"; "b"; "velocity_a"; "velocity_b" ] "relation" (function
    | [ a; b; v; w ] ->
        let (c, r), (d, s) = (ball a, ball b) in
        zero_kinds (check_swept_sphere_sphere c r (given_coordinates v) d s (given_coordinates w))
    | _ -> assert false)

let operations = [ swept_sphere_sphere ]
