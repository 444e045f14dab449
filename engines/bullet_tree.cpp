// SPDX-License-Identifier: Apache-2.0
// Bullet as peer, in single precision: its dynamic tree of boxes.
#include <bullet/BulletCollision/BroadphaseCollision/btDbvt.h>
#include <touchstone/program/engine_main.h>

#include <cmath>
#include <memory>

#include "bullet_boxes.h"
#include "exactly.h"
#include "programs.h"

namespace touchstone {
namespace {

using namespace bullet_boxes;

btDbvtVolume volume(const Box& box) { return btDbvtVolume::FromMM(vector(box.min), vector(box.max)); }

/// btDbvt with the boxes as they are: the margin of btDbvtBroadphase is not part of the tree.
class Tree {
 public:
  Index insert(const Box& box) {
    const std::size_t index = leaves_.size();
    leaves_.push_back(tree_->insert(volume(box), tagged(index)));
    boxes_.push_back(box);
    return static_cast<Index>(index);
  }
  void move(Index body, const Box& box) {
    btDbvtVolume there = volume(box);
    tree_->update(leaves_[body], there);
    boxes_[body] = box;
  }
  void remove(Index body) { tree_->remove(leaves_[body]); }

  std::vector<IndexPair> pairs() const {
    Pairs found;
    if (tree_->m_root != nullptr) tree_->collideTT(tree_->m_root, tree_->m_root, found);
    return found.list;
  }
  std::vector<Index> in_box(const Box& box) const {
    Bodies found;
    tree_->collideTV(tree_->m_root, volume(box), found);
    return found.list;
  }
  std::vector<Index> at_point(const Point3<float>& point) const { return in_box({point, point}); }
  /// To an end beyond all boxes.
  std::vector<Index> along_ray(const Ray3<float>& ray) const {
    Bodies found;
    btDbvt::rayTest(tree_->m_root, vector(ray.origin), vector(end_of(ray)), found);
    return programs::in_order(ray, found.list, boxes_);
  }

  static constexpr float farthest = 0x1p20F;
  static Point3<float> end_of(const Ray3<float>& ray) {
    const auto& [o, v] = ray;
    const auto end = [](float origin, float direction) {
      return direction == 0 ? origin : std::copysign(farthest, direction);
    };
    return {end(o.x, v.x), end(o.y, v.y), end(o.z, v.z)};
  }

 private:
  struct Pairs : btDbvt::ICollide {
    void Process(const btDbvtNode* a, const btDbvtNode* b) override {
      list.push_back({index_of(a->data), index_of(b->data)});
    }
    std::vector<IndexPair> list;
  };
  struct Bodies : btDbvt::ICollide {
    void Process(const btDbvtNode* leaf) override { list.push_back(index_of(leaf->data)); }
    std::vector<Index> list;
  };

  std::unique_ptr<btDbvt> tree_ = std::make_unique<btDbvt>();
  std::vector<btDbvtNode*> leaves_;
  std::vector<Box> boxes_;
};

/// Nothing is documented of touching. Rays are made of a direction of length 1: only axes are asked, and boxes that end
/// before the ray does.
struct BulletTree {
  static constexpr const char* name = "Bullet 3.24 (btDbvt)";
  using number = float;

  std::optional<Replies> broad_phase(const std::vector<Box>& boxes, const std::vector<Command<float>>& commands) {
    for (const Command<float>& command : commands) {
      const auto* query = std::get_if<AlongRay<float>>(&command);
      if (query != nullptr && !casts(query->ray)) return std::nullopt;
    }
    const auto held = [](const Box& box) { return within(box, Tree::farthest); };
    if (programs::has<AlongRay<float>>(commands) && !programs::all_boxes(boxes, commands, held)) return std::nullopt;
    return replies(Tree(), boxes, commands);
  }

 private:
  static bool casts(const Ray3<float>& ray) {
    const auto& [o, v] = ray;
    if ((v.x != 0) + (v.y != 0) + (v.z != 0) != 1) return false;
    const Point3<float> to = Tree::end_of(ray);
    const Vector3<float> from{o.x, o.y, o.z};
    return std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)}) < Tree::farthest &&
           exactly::difference({to.x, to.y, to.z}, from).has_value();
  }
};

}  // namespace
}  // namespace touchstone

TOUCHSTONE_ENGINE_MAIN(touchstone::BulletTree)
