// SPDX-License-Identifier: Apache-2.0
// Box2D's broad phase as peer, in single precision: its dynamic tree and its list of pairs.
#include <box2d/b2_broad_phase.h>
#include <touchstone/program/engine_main.h>

#include <memory>
#include <set>

#include "planar.h"

namespace touchstone {
namespace {

/// b2BroadPhase, and a list of pairs that is kept as b2ContactManager keeps its contacts: UpdatePairs adds, and a pair
/// goes when TestOverlap denies it.
class Tree {
 public:
  using Axis = programs::Axis<float>;

  Tree(Axis first, Axis second) : first_(first), second_(second) {}

  Index insert(const Aabb3<float>& box) {
    const std::size_t index = proxies_.size();
    proxies_.push_back(tree_->CreateProxy(rectangle(box), tagged(index)));
    boxes_.push_back(rectangle(box));
    return static_cast<Index>(index);
  }
  void move(Index body, const Aabb3<float>& box) {
    const b2AABB there = rectangle(box);
    tree_->MoveProxy(proxies_[body], there, there.GetCenter() - boxes_[body].GetCenter());
    boxes_[body] = there;
  }
  void remove(Index body) {
    std::erase_if(pairs_, [body](const auto& pair) { return pair.first == body || pair.second == body; });
    tree_->DestroyProxy(proxies_[body]);
  }

  std::vector<IndexPair> pairs() {
    std::erase_if(
        pairs_, [this](const auto& pair) { return !tree_->TestOverlap(proxies_[pair.first], proxies_[pair.second]); });
    Adding adding{pairs_};
    tree_->UpdatePairs(&adding);
    std::vector<IndexPair> list;
    for (const auto& [i, j] : pairs_) list.push_back({i, j});
    return list;
  }
  std::vector<Index> in_box(const Aabb3<float>& box) const {
    Listing listing{*tree_, {}};
    tree_->Query(&listing, rectangle(box));
    return listing.list;
  }
  std::vector<Index> at_point(const Point3<float>& point) const { return in_box({point, point}); }
  /// Not asked.
  std::vector<Index> along_ray(const Ray3<float>&) const { return {}; }

 private:
  using Pairs = std::set<std::pair<Index, Index>>;
  static void* tagged(std::size_t index) { return reinterpret_cast<void*>(index); }
  static Index index_of(const void* tag) { return static_cast<Index>(reinterpret_cast<std::size_t>(tag)); }
  struct Adding {
    Pairs& pairs;
    void AddPair(void* a, void* b) {
      const Index i = index_of(a), j = index_of(b);
      pairs.emplace(std::min(i, j), std::max(i, j));
    }
  };
  struct Listing {
    const b2BroadPhase& tree;
    std::vector<Index> list;
    bool QueryCallback(int32 proxy) {
      list.push_back(index_of(tree.GetUserData(proxy)));
      return true;
    }
  };
  b2AABB rectangle(const Aabb3<float>& box) const {
    b2AABB made;
    made.lowerBound = b2Vec2(box.min.*first_, box.min.*second_);
    made.upperBound = b2Vec2(box.max.*first_, box.max.*second_);
    return made;
  }

  Axis first_, second_;
  std::unique_ptr<b2BroadPhase> tree_ = std::make_unique<b2BroadPhase>();
  std::vector<int32> proxies_;
  std::vector<b2AABB> boxes_;
  Pairs pairs_;
};

/// Boxes are made fat, by its documentation: it lists more than what meets.
struct Box2dTree {
  static constexpr const char* name = "Box2D 2.4.1 (b2BroadPhase)";
  using number = float;

  /// Programs of space in which one axis decides nothing.
  std::optional<Replies> broad_phase(const std::vector<Aabb3<float>>& boxes,
                                     const std::vector<Command<float>>& commands) {
    const auto axes = programs::deciding_axes(boxes, commands);
    if (!axes) return std::nullopt;
    return replies(Tree(axes->first, axes->second), boxes, commands);
  }
};

}  // namespace
}  // namespace touchstone

TOUCHSTONE_ENGINE_MAIN(touchstone::Box2dTree)
