(* SPDX-License-Identifier: Apache-2.0 *)
(* Where the numbers of a formula come from: from a claim, so that it can be decided, or from names of fields, so that
   it can be printed. *)
module type S = sig
  type place (* where a value stands *)
  type number

  val members : string list -> place -> place list (* of an object with exactly these fields *)
  val coordinates : place -> place list (* of a point of the plane or of space *)
  val items : place -> place list (* of a list of any length *)
  val exactly : int -> place -> place list (* of a list of that many *)
  val given : place -> number (* a number of the input *)
  val exact : place -> number
  val surd : place -> number Proved.surd
  val index : place -> Proved.nat (* one that an exact value names *)
  val word : place -> string
  val same_length : place -> 'a list -> 'b list -> unit (* else the claim is refused *)
end
