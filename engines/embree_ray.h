// SPDX-License-Identifier: Apache-2.0
#pragma once

// Embree as peer, in single precision: one ray and a list of triangles.
#include <embree3/rtcore.h>
#include <touchstone/geometry/rays.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "exactly.h"
#include "mesh_hits.h"

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
    const auto hit = first(ray, as_mesh(triangle), infinity);
    if (!hit) return {SegmentTriangleRelation::none, {}, {}, {}};
    return {SegmentTriangleRelation::point, hit->t, {}, {}};
  }
  /// Numbers of rays beyond 1.844e18 are left out: an assertion of Debian's build (Ray::valid) ends the process.
  std::optional<RayMesh<float>> ray_mesh(const Ray3<float>& ray, const Mesh<float>& mesh) {
    const auto& [p, v] = ray;
    for (const float x : {p.x, p.y, p.z, v.x, v.y, v.z})
      if (!(std::abs(x) <= 1.844e18F)) return std::nullopt;
    const auto hit = first(ray, mesh, infinity);
    if (!hit) return mesh_hits::none<float>();
    return mesh_hits::answer(ray, mesh, hit->t, ray.origin + hit->t * ray.direction, hit->face);
  }
  std::optional<bool> segment_triangle(const Segment3<float>& s, const Triangle3<float>& triangle) {
    const auto displacement =
        exactly::difference(Vector3<float>{s.b.x, s.b.y, s.b.z}, Vector3<float>{s.a.x, s.a.y, s.a.z});
    if (!displacement) return std::nullopt;
    return first({s.a, *displacement}, as_mesh(triangle), 1).has_value();
  }

 private:
  struct Hit {
    float t;
    Index face;
  };
  static constexpr float infinity = std::numeric_limits<float>::infinity();

  static Mesh<float> as_mesh(const Triangle3<float>& t) { return {{t.a, t.b, t.c}, {{0, 1, 2}}}; }

  std::optional<Hit> first(const Ray3<float>& ray, const Mesh<float>& mesh, float most) {
    if (mesh.faces.empty()) return std::nullopt;
    const RTCScene scene = rtcNewScene(device_);
    rtcSetSceneFlags(scene, flags_);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                3 * sizeof(float), mesh.vertices.size()));
    for (const Point3<float>& p : mesh.vertices) *corners++ = p.x, *corners++ = p.y, *corners++ = p.z;
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(unsigned), mesh.faces.size()));
    for (const Face& face : mesh.faces) *indices++ = face.a, *indices++ = face.b, *indices++ = face.c;
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
    return Hit{cast.ray.tfar, cast.hit.primID};
  }

  RTCDevice device_;
  RTCSceneFlags flags_;
};

}  // namespace touchstone
