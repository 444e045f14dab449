// SPDX-License-Identifier: Apache-2.0
#pragma once

// Embree as peer, in single precision: one ray and one triangle.
#include <embree3/rtcore.h>
#include <touchstone/geometry/rays.h>

#include <limits>
#include <optional>
#include <stdexcept>

#include "exactly.h"

namespace touchstone {

/// What it says of touching is not documented, and neither is a tolerance. A segment is a ray up to t = 1, if its
/// direction is exact.
class EmbreeRay {
 public:
  explicit EmbreeRay(RTCSceneFlags flags) : device_(rtcNewDevice("threads=1")), flags_(flags) {
    if (device_ == nullptr) throw std::runtime_error("no device");
  }
  ~EmbreeRay() { rtcReleaseDevice(device_); }
  EmbreeRay(const EmbreeRay&) = delete;

  using Answer = RayTriangle<float>;

  Answer ray_triangle(const Ray3<float>& ray, const Triangle3<float>& triangle) {
    const auto t = first(ray, triangle, std::numeric_limits<float>::infinity());
    if (!t) return {SegmentTriangleRelation::none, {}, {}, {}};
    return {SegmentTriangleRelation::point, *t, {}, {}};
  }
  std::optional<bool> segment_triangle(const Segment3<float>& s, const Triangle3<float>& triangle) {
    const auto displacement =
        exactly::difference(Vector3<float>{s.b.x, s.b.y, s.b.z}, Vector3<float>{s.a.x, s.a.y, s.a.z});
    if (!displacement) return std::nullopt;
    return first({s.a, *displacement}, triangle, 1).has_value();
  }

 private:
  std::optional<float> first(const Ray3<float>& ray, const Triangle3<float>& t, float most) {
    const RTCScene scene = rtcNewScene(device_);
    rtcSetSceneFlags(scene, flags_);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3));
    for (const Point3<float>& p : {t.a, t.b, t.c}) *corners++ = p.x, *corners++ = p.y, *corners++ = p.z;
    auto* indices = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), 1));
    indices[0] = 0, indices[1] = 1, indices[2] = 2;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    RTCRayHit cast{};
    cast.ray.org_x = ray.origin.x, cast.ray.org_y = ray.origin.y, cast.ray.org_z = ray.origin.z;
    cast.ray.dir_x = ray.direction.x, cast.ray.dir_y = ray.direction.y, cast.ray.dir_z = ray.direction.z;
    cast.ray.tfar = most;
    cast.ray.mask = ~0U;
    cast.hit.geomID = cast.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &cast);
    rtcReleaseScene(scene);
    if (cast.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return cast.ray.tfar;
  }

  RTCDevice device_;
  RTCSceneFlags flags_;
};

}  // namespace touchstone
