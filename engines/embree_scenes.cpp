// SPDX-License-Identifier: Apache-2.0
// Embree as peer, in single precision, with the flag of robust rays: a scene of boxes that come, move and go.
#include <embree3/rtcore.h>
#include <touchstone/program/engine_main.h>

#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <stdexcept>

#include "programs.h"

namespace touchstone {
namespace {

using Box = Aabb3<float>;

RTCDevice device() {
  static const RTCDevice made = rtcNewDevice("threads=1");
  if (made == nullptr) throw std::runtime_error("no device");
  return made;
}

struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Scene = std::unique_ptr<RTCSceneTy, ReleaseScene>;
Scene made_scene(RTCSceneFlags flags) {
  Scene scene(rtcNewScene(device()));
  rtcSetSceneFlags(scene.get(), flags);
  return scene;
}

/// Casts a ray without an end.
void cast(RTCScene scene, const Ray3<float>& ray, RTCIntersectContext& context) {
  RTCRayHit made{};
  made.ray.org_x = ray.origin.x, made.ray.org_y = ray.origin.y, made.ray.org_z = ray.origin.z;
  made.ray.dir_x = ray.direction.x, made.ray.dir_y = ray.direction.y, made.ray.dir_z = ray.direction.z;
  made.ray.tfar = std::numeric_limits<float>::infinity();
  made.ray.mask = ~0U;
  made.hit.geomID = made.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &context, &made);
}

/// User geometries of one box each, in a scene of the flag `dynamic`.
class Boxes {
 public:
  Index insert(const Box& box) {
    const auto index = static_cast<Index>(boxes_->size());
    boxes_->push_back(box);
    attach(*scene_, boxes_->back(), index);
    return index;
  }
  void move(Index body, const Box& box) {
    (*boxes_)[body] = box;
    const RTCGeometry geometry = rtcGetGeometry(scene_.get(), body);
    rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcSetGeometryUserPrimitiveCount(geometry, 1);
    rtcCommitGeometry(geometry);
  }
  void remove(Index body) { rtcDetachGeometry(scene_.get(), body); }

  std::vector<IndexPair> pairs() const {
    std::vector<IndexPair> both_ways, found;
    collide(*scene_, both_ways);
    for (const IndexPair& pair : both_ways)
      if (pair.i < pair.j) found.push_back(pair);
    return found;
  }
  std::vector<Index> in_box(const Box& box) const {
    const Scene query = made_scene(RTC_SCENE_FLAG_ROBUST);
    attach(*query, box, 0);
    rtcCommitScene(query.get());
    std::vector<IndexPair> pairs;
    collide(*query, pairs);
    std::vector<Index> found;
    for (const IndexPair& pair : pairs) found.push_back(pair.i);
    return found;
  }
  std::vector<Index> at_point(const Point3<float>& point) const { return in_box({point, point}); }
  /// It calls back for each box that its ray may meet; nothing is taken for a hit, so that it goes on.
  std::vector<Index> along_ray(const Ray3<float>& ray) const {
    rtcCommitScene(scene_.get());
    Met met;
    rtcInitIntersectContext(&met.context);
    cast(scene_.get(), ray, met.context);
    return programs::in_order(ray, met.list, {boxes_->begin(), boxes_->end()});
  }

 private:
  struct Met {
    RTCIntersectContext context;  // first: Embree hands back its address
    std::vector<Index> list;
  };

  static void attach(RTCSceneTy& scene, const Box& box, Index index) {
    const RTCGeometry geometry = rtcNewGeometry(device(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, 1);
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcSetGeometryUserData(geometry, const_cast<Box*>(&box));
    rtcSetGeometryIntersectFunction(geometry, [](const RTCIntersectFunctionNArguments* asked) {
      if (asked->valid[0] != 0) reinterpret_cast<Met*>(asked->context)->list.push_back(asked->geomID);
    });
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(&scene, geometry, index);
    rtcReleaseGeometry(geometry);
  }
  static void bounds(const RTCBoundsFunctionArguments* asked) {
    const auto& [min, max] = *static_cast<const Box*>(asked->geometryUserPtr);
    RTCBounds& made = *asked->bounds_o;
    made.lower_x = min.x, made.lower_y = min.y, made.lower_z = min.z;
    made.upper_x = max.x, made.upper_y = max.y, made.upper_z = max.z;
  }
  void collide(RTCSceneTy& other, std::vector<IndexPair>& found) const {
    rtcCommitScene(scene_.get());
    const auto add = [](void* list, RTCCollision* collisions, unsigned count) {
      for (unsigned k = 0; k < count; ++k)
        static_cast<std::vector<IndexPair>*>(list)->push_back({collisions[k].geomID0, collisions[k].geomID1});
    };
    rtcCollide(scene_.get(), &other, add, &found);
  }

  // At addresses that stay.
  std::unique_ptr<std::deque<Box>> boxes_ = std::make_unique<std::deque<Box>>();
  Scene scene_ = made_scene(RTC_SCENE_FLAG_DYNAMIC | RTC_SCENE_FLAG_ROBUST);
};

/// Nothing is documented of touching. Numbers beyond 1.844e18 are invalid, by its documentation: not asked.
struct EmbreeScenes {
  static constexpr const char* name = "Embree 3.13.5 (scenes of boxes, robust flag)";
  using number = float;

  std::optional<Replies> broad_phase(const std::vector<Box>& boxes, const std::vector<Command<float>>& commands) {
    const auto valid = [](const Box& box) { return held(box.min) && held(box.max); };
    if (!programs::all_boxes(boxes, commands, valid)) return std::nullopt;
    return replies(Boxes(), boxes, commands);
  }

 private:
  static bool held(const Point3<float>& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < 1.844e18F;
  }
};

}  // namespace
}  // namespace touchstone

TOUCHSTONE_ENGINE_MAIN(touchstone::EmbreeScenes)
