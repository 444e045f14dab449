(* SPDX-License-Identifier: Apache-2.0 *)
(* Integers of any size, for the extracted code: Zarith's, and how Coq takes one apart. *)
include Z

let of_positive odd even one p =
  if Z.equal p Z.one then one () else if Z.is_odd p then odd (Z.shift_right p 1) else even (Z.shift_right p 1)

let of_sign zero positive negative z =
  match Z.sign z with 0 -> zero () | 1 -> positive z | _ -> negative (Z.neg z)
