// SPDX-License-Identifier: Apache-2.0
#pragma once

// FCL's broad phases as peers, over doubles: programs by any of its managers.
#include <fcl/fcl.h>

#include <memory>

#include "programs.h"

namespace touchstone::fcl_manager {

/// A geometry that is no more than its box: FCL takes the box of an object that is not turned as it stands.
class BoxAlone : public fcl::CollisionGeometryd {
 public:
  explicit BoxAlone(const Aabb3d& box) { take(box); }
  void take(const Aabb3d& box) {
    this->aabb_local.min_ = fcl::Vector3d(box.min.x, box.min.y, box.min.z);
    this->aabb_local.max_ = fcl::Vector3d(box.max.x, box.max.y, box.max.z);
  }
  void computeLocalAABB() override {}
};

struct Body {
  explicit Body(const Aabb3d& box) : shape(std::make_shared<BoxAlone>(box)), object(shape) {
    object.setUserData(nullptr);  // FCL leaves it as it is
  }
  Body(const Body&) = delete;

  std::shared_ptr<BoxAlone> shape;
  fcl::CollisionObjectd object;
  Index index = 0;
};

template <class Manager>
std::unique_ptr<Manager> made() {
  return std::make_unique<Manager>();
}
/// Unit cells from -16 to 16; objects may lie outside, by its documentation.
template <>
inline std::unique_ptr<fcl::SpatialHashingCollisionManagerd<>> made() {
  return std::make_unique<fcl::SpatialHashingCollisionManagerd<>>(1.0, fcl::Vector3d(-16, -16, -16),
                                                                  fcl::Vector3d(16, 16, 16));
}

/// A manager and its objects: moved by giving an object its new box and the manager its `update` of the object.
template <class Manager>
class Structure {
 public:
  Index insert(const Aabb3d& box) {
    bodies_.push_back(std::make_unique<Body>(box));
    Body& body = *bodies_.back();
    body.index = static_cast<Index>(bodies_.size() - 1);
    body.object.setUserData(&body.index);
    manager_->registerObject(&body.object);
    manager_->setup();
    return body.index;
  }
  void move(Index index, const Aabb3d& box) {
    Body& body = *bodies_[index];
    body.shape->take(box);
    body.object.computeAABB();
    manager_->update(&body.object);
  }
  void remove(Index index) { manager_->unregisterObject(&bodies_[index]->object); }

  std::vector<IndexPair> pairs() const {
    std::vector<IndexPair> found;
    manager_->collide(&found, [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* list) {
      static_cast<std::vector<IndexPair>*>(list)->push_back({*index_of(a), *index_of(b)});
      return false;
    });
    return found;
  }
  std::vector<Index> in_box(const Aabb3d& box) const {
    Body query(box);
    std::vector<Index> found;
    manager_->collide(&query.object, &found, [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* list) {
      for (const Index* index : {index_of(a), index_of(b)})
        if (index != nullptr) static_cast<std::vector<Index>*>(list)->push_back(*index);
      return false;
    });
    return found;
  }
  std::vector<Index> at_point(const Point3d& point) const { return in_box({point, point}); }
  /// It has no rays; programs with rays are not asked.
  std::vector<Index> along_ray(const Ray3d&) const { return {}; }

 private:
  static const Index* index_of(fcl::CollisionObjectd* object) { return static_cast<Index*>(object->getUserData()); }

  // The objects outlive the manager, which points to them; those that were removed, too.
  std::vector<std::unique_ptr<Body>> bodies_;
  std::unique_ptr<Manager> manager_ = made<Manager>();
};

/// Touching boxes meet; no margin is documented, but a callback may be called for more pairs than those. FCL has no
/// rays in its managers.
template <class Manager>
struct Engine {
  std::optional<Replies> broad_phase(const std::vector<Aabb3d>& boxes, const std::vector<Commandd>& commands) {
    if (programs::has<AlongRayd>(commands)) return std::nullopt;
    return replies(Structure<Manager>(), boxes, commands);
  }
};

}  // namespace touchstone::fcl_manager
