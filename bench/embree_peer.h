// SPDX-License-Identifier: Apache-2.0
#pragma once

// Embree as peer, in single precision, with its robust flag: rays on a mesh.
#include <embree3/rtcore.h>

#include <limits>

#include "geometry/polyhedra.h"
#include "geometry/rays.h"

namespace touchstone::bench {

class EmbreeMesh {
 public:
  explicit EmbreeMesh(const Meshd& mesh) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* corners = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
    for (const Point3d& p : mesh.vertices)
      for (const double x : {p.x, p.y, p.z}) *corners++ = static_cast<float>(x);
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.faces.size()));
    for (const Face& f : mesh.faces)
      for (const Index i : {f.a, f.b, f.c}) *indices++ = i;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  ~EmbreeMesh() { rtcReleaseScene(scene_), rtcReleaseDevice(device_); }
  EmbreeMesh(const EmbreeMesh&) = delete;

  /// Returns whether the ray meets a face, and finds the first one.
  bool first(const Ray3d& ray) const {
    RTCRayHit cast{};
    cast.ray = of(ray);
    cast.hit.geomID = cast.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &cast);
    return cast.hit.geomID != RTC_INVALID_GEOMETRY_ID;
  }
  /// The same of any face.
  bool any(const Ray3d& ray) const {
    RTCRay cast = of(ray);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene_, &context, &cast);
    return cast.tfar < 0;
  }

 private:
  static RTCRay of(const Ray3d& ray) {
    RTCRay made{};
    const auto& [o, v] = ray;
    made.org_x = static_cast<float>(o.x), made.org_y = static_cast<float>(o.y), made.org_z = static_cast<float>(o.z);
    made.dir_x = static_cast<float>(v.x), made.dir_y = static_cast<float>(v.y), made.dir_z = static_cast<float>(v.z);
    made.tfar = std::numeric_limits<float>::infinity();
    made.mask = ~0U;
    return made;
  }

  RTCDevice device_;
  RTCScene scene_;
};

}  // namespace touchstone::bench
