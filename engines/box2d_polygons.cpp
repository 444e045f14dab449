// SPDX-License-Identifier: Apache-2.0
// Box2D as peer, in single precision: polygons, which have a skin.
#include <box2d/b2_time_of_impact.h>
#include <box2d/box2d.h>
#include <touchstone/program/engine_main.h>

#include <stdexcept>

#include "exactly.h"

using namespace touchstone;

/// Documented: a polygon has a skin, b2_polygonRadius = 2 b2_linearSlop = 0.01, so that two of them may be 0.02 apart
/// where they are taken to meet: that is the tolerance. Boxes without extent on an axis, and those that it cannot hold
/// exactly, are left out. The times at which it stops, by its documentation before they penetrate, are not given.
struct Box2dPolygons {
  static constexpr const char* name = "Box2D 2.4.1 (polygons)";
  static constexpr double tolerance = 0.02;
  using number = float;

  std::optional<bool> sphere_aabb(const Circle2<float>& sphere, const Aabb2<float>& aabb) {
    const auto box = Rectangle::of(aabb);
    if (!box) return std::nullopt;
    b2CircleShape circle;
    circle.m_radius = sphere.radius;
    b2Manifold manifold;
    const b2Vec2 center(sphere.center.x, sphere.center.y);
    b2CollidePolygonAndCircle(&manifold, &box->shape, at(box->center), &circle, at(center));
    return manifold.pointCount > 0;
  }
  std::optional<bool> aabb_aabb(const Aabb2<float>& a, const Aabb2<float>& b) {
    const auto first = Rectangle::of(a), second = Rectangle::of(b);
    if (!first || !second) return std::nullopt;
    b2Manifold manifold;
    b2CollidePolygons(&manifold, &first->shape, at(first->center), &second->shape, at(second->center));
    return manifold.pointCount > 0;
  }
  /// b2TimeOfImpact, which "may miss some intermediate, non-tunneling collisions".
  std::optional<FirstContact<float>> swept_aabb_aabb(const Aabb2<float>& a, const Aabb2<float>& b,
                                                     const Vector2<float>& velocity) {
    const auto first = Rectangle::of(a), second = Rectangle::of(b);
    if (!first || !second) return std::nullopt;
    const auto x = exactly::sum(first->center.x, velocity.x), y = exactly::sum(first->center.y, velocity.y);
    if (!x || !y) return std::nullopt;
    b2TOIInput input;
    input.proxyA.Set(&first->shape, 0);
    input.proxyB.Set(&second->shape, 0);
    input.sweepA = sweep(first->center, b2Vec2(*x, *y));
    input.sweepB = sweep(second->center, second->center);
    input.tMax = 1;
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    if (output.state == b2TOIOutput::e_failed) throw std::runtime_error("b2TOIOutput::e_failed");
    const bool hit = output.state != b2TOIOutput::e_separated;
    return FirstContact<float>{hit ? HitRelation::hit : HitRelation::never, {}};
  }

 private:
  struct Rectangle {
    b2PolygonShape shape;
    b2Vec2 center;

    static std::optional<Rectangle> of(const Aabb2<float>& aabb) {
      const auto x = exactly::middle_and_half(aabb.min.x, aabb.max.x),
                 y = exactly::middle_and_half(aabb.min.y, aabb.max.y);
      if (!x || !y || x->second == 0 || y->second == 0) return std::nullopt;
      Rectangle made;
      made.shape.SetAsBox(x->second, y->second);
      made.center = b2Vec2(x->first, y->first);
      return made;
    }
  };

  static b2Transform at(const b2Vec2& p) { return b2Transform(p, b2Rot(0)); }
  static b2Sweep sweep(const b2Vec2& start, const b2Vec2& end) {
    b2Sweep moving;
    moving.localCenter = b2Vec2(0, 0);
    moving.c0 = start;
    moving.c = end;
    moving.a0 = moving.a = 0;
    moving.alpha0 = 0;
    return moving;
  }
};

TOUCHSTONE_ENGINE_MAIN(Box2dPolygons)
