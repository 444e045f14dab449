(* SPDX-License-Identifier: Apache-2.0 *)
(* All operations that have proved kinds. *)
let all =
  List.concat
    [ Operations_plane.operations; Operations_solids.operations; Operations_planes.operations;
      Operations_response.operations; Operations_collisions.operations; Operations_contacts.operations;
      Operations_motion.operations; Operations_hulls.operations; Operations_bounds.operations;
      Operations_triangles.operations; Operations_meshes.operations ]
