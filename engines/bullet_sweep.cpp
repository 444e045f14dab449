// SPDX-License-Identifier: Apache-2.0
// Bullet as peer, in single precision: its sweep along three axes.
#include <bullet/BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <touchstone/program/engine_main.h>

#include <memory>

#include "bullet_boxes.h"
#include "programs.h"

namespace touchstone {
namespace {

using namespace bullet_boxes;

/// bt32BitAxisSweep3 over a world from -64 to 64.
class Sweep {
 public:
  static constexpr float end = 64;

  Index insert(const Box& box) {
    const std::size_t index = proxies_.size();
    proxies_.push_back(sweep_->createProxy(vector(box.min), vector(box.max), 0, tagged(index),
                                           btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter, nullptr));
    return static_cast<Index>(index);
  }
  void move(Index body, const Box& box) { sweep_->setAabb(proxies_[body], vector(box.min), vector(box.max), nullptr); }
  void remove(Index body) { sweep_->destroyProxy(proxies_[body], nullptr); }

  std::vector<IndexPair> pairs() const {
    sweep_->calculateOverlappingPairs(nullptr);
    std::vector<IndexPair> found;
    const btBroadphasePairArray& list = sweep_->getOverlappingPairCache()->getOverlappingPairArray();
    for (int k = 0; k < list.size(); ++k)
      found.push_back({index_of(list[k].m_pProxy0->m_clientObject), index_of(list[k].m_pProxy1->m_clientObject)});
    return found;
  }
  std::vector<Index> in_box(const Box& box) const {
    Found found;
    sweep_->aabbTest(vector(box.min), vector(box.max), found);
    return found.list;
  }
  std::vector<Index> at_point(const Point3<float>& point) const { return in_box({point, point}); }
  /// Not asked.
  std::vector<Index> along_ray(const Ray3<float>&) const { return {}; }

 private:
  struct Found : btBroadphaseAabbCallback {
    bool process(const btBroadphaseProxy* proxy) override {
      list.push_back(index_of(proxy->m_clientObject));
      return true;
    }
    std::vector<Index> list;
  };

  static constexpr unsigned most = 1024;
  std::unique_ptr<bt32BitAxisSweep3> sweep_ =
      std::make_unique<bt32BitAxisSweep3>(btVector3(-end, -end, -end), btVector3(end, end, end), most);
  std::vector<btBroadphaseProxy*> proxies_;
};

/// Positions are integers, so that it may list more than what meets. The world's size is documented as such: boxes
/// beyond it are not asked, nor are rays.
struct BulletSweep {
  static constexpr const char* name = "Bullet 3.24 (bt32BitAxisSweep3)";
  using number = float;

  std::optional<Replies> broad_phase(const std::vector<Box>& boxes, const std::vector<Command<float>>& commands) {
    const auto held = [](const Box& box) { return within(box, Sweep::end); };
    if (programs::has<AlongRay<float>>(commands) || !programs::all_boxes(boxes, commands, held)) return std::nullopt;
    return replies(Sweep(), boxes, commands);
  }
};

}  // namespace
}  // namespace touchstone

TOUCHSTONE_ENGINE_MAIN(touchstone::BulletSweep)
