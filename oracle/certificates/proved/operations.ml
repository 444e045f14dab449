(* SPDX-License-Identifier: Apache-2.0 *)
(* All operations that have proved kinds. *)
module Of (Source : Source.S) = struct
  include Shapes.Of (Source)
  module Plane = Operations_plane.Of (Source)
  module Solids = Operations_solids.Of (Source)
  module Planes = Operations_planes.Of (Source)
  module Response = Operations_response.Of (Source)
  module Motion = Operations_motion.Of (Source)

  let chapters =
    [ ("plane", Plane.operations); ("solids", Solids.operations); ("planes", Planes.operations);
      ("response", Response.operations); ("motion", Motion.operations) ]

  let all = List.concat_map snd chapters
end
