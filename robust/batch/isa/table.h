// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/beside.h"
#include "robust/batch/isa/close.h"
#include "robust/batch/isa/close_shapes.h"
#include "robust/batch/isa/close_triangles.h"
#include "robust/batch/isa/join_pairs.h"
#include "robust/batch/isa/kernels.h"
#include "robust/batch/isa/linear.h"
#include "robust/batch/isa/obbs.h"
#include "robust/batch/isa/round_solids.h"
#include "robust/batch/isa/triangles.h"

namespace touchstone::robust::batch::isa {
namespace {

constexpr Filters filters_of_this_unit{.orientation = filter<Orientation>,
                                       .point_on_segment = filter<PointOnSegment>,
                                       .segment_segment = filter<SegmentSegment>,
                                       .point_plane = filter<PointPlane>,
                                       .boxes_in_plane = filter<Boxes<2>>,
                                       .boxes_in_space = filter<Boxes<3>>,
                                       .spheres_in_plane = filter<Spheres<2>>,
                                       .spheres_in_space = filter<Spheres<3>>,
                                       .sphere_and_box_in_plane = filter<SphereBox<2>>,
                                       .sphere_and_box_in_space = filter<SphereBox<3>>,
                                       .ray_and_box_in_plane = filter<RayBox<2>>,
                                       .ray_and_box_in_space = filter<RayBox<3>>,
                                       .segment_triangle = filter<SegmentTriangle>,
                                       .ray_triangle = filter<RayTriangle>,
                                       .triangle_triangle = filter<TriangleTriangle>,
                                       .sphere_obb = filter<SphereObb>,
                                       .capsule_capsule = filter<CapsuleCapsule>,
                                       .obb_obb = filter<ObbObb>,
                                       .point_in_ring = filter_beside<RingByLines>,
                                       .point_in_convex_ring = filter_beside<ConvexRingByLines>,
                                       .point_in_convex_solid = filter_beside<ConvexSolidByPlanes>,
                                       .point_in_solid = filter_beside<SolidByPlanes>,
                                       .close_orientation = close_stage<CloseOrientation>,
                                       .close_point_on_segment = close_stage<ClosePointOnSegment>,
                                       .close_segment_segment = close_stage<CloseSegmentSegment>,
                                       .close_point_plane = close_stage<ClosePointPlane>,
                                       .close_boxes_in_plane = close_stage<CloseBoxes<2>>,
                                       .close_boxes_in_space = close_stage<CloseBoxes<3>>,
                                       .close_spheres_in_plane = close_stage<CloseSpheres<2>>,
                                       .close_spheres_in_space = close_stage<CloseSpheres<3>>,
                                       .close_sphere_and_box_in_plane = close_stage<CloseSphereBox<2>>,
                                       .close_sphere_and_box_in_space = close_stage<CloseSphereBox<3>>,
                                       .close_ray_and_box_in_plane = close_stage<CloseRayBox<2>>,
                                       .close_ray_and_box_in_space = close_stage<CloseRayBox<3>>,
                                       .close_segment_triangle = close_stage<CloseSegmentTriangle>,
                                       .close_ray_triangle = close_stage<CloseRayTriangle>,
                                       .close_triangle_triangle = close_stage<CloseTriangleTriangle>,
                                       .close_point_in_ring = close_stage<CloseBeside<Ring>>,
                                       .close_point_in_convex_solid = close_stage<CloseBeside<ConvexSolid>>,
                                       .close_point_in_solid = close_stage<CloseBeside<Solid>>,
                                       .join_pairs = join_pairs};

}  // namespace
}  // namespace touchstone::robust::batch::isa
