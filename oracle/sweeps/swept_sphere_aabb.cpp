// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_sphere_aabb.h"

#include <array>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/numbers/common_scale.h"
#include "oracle/exact/numbers/nearest_in_interval.h"
#include "oracle/exact/numbers/parabola.h"
#include "oracle/sweeps/swept_aabb_aabb.h"

namespace touchstone::oracle {
namespace {

/// One coordinate of the center and of its velocity, and the box's interval, in units of the scale.
struct CenterOnAxis {
  Integer at, velocity, min, max;

  int side(const Surd& t) const {
    const Surd place = Surd(Rational(at)) + t * Surd(Rational(velocity));
    return place < Surd(Rational(min)) ? -1 : Surd(Rational(max)) < place ? 1 : 0;
  }
};

struct BallNearBox {
  std::array<CenterOnAxis, 3> axes;
  Integer radius;

  /// From the nearest point of the box to the center at t.
  std::vector<Rational> displacement(const Rational& t) const {
    std::vector<Rational> result;
    for (const auto& [at, velocity, min, max] : axes) {
      const Rational place(at + t * velocity);
      result.emplace_back(place - nearest_in_interval(place, Rational(min), Rational(max)).x);
    }
    return result;
  }
};

/// A face, an edge or a corner, if one, two or three coordinates are at a side of the box; otherwise all of the box.
struct Feature {
  static constexpr int count = 27;

  std::array<int, 3> sides{};  ///< -1 and 1; 0 where the feature leads along the axis
  Parabola gap;                ///< the squared distance of the center from its plane or line, less r^2

  Feature(const BallNearBox& q, int number) : gap{Integer(-q.radius * q.radius), 0, 0} {
    for (std::size_t k = 0; k < 3; ++k, number /= 3) {
      const auto& [at, velocity, min, max] = q.axes[k];
      sides[k] = number % 3 - 1;
      if (sides[k] == 0) continue;
      const Integer from(at - (sides[k] < 0 ? min : max));
      gap.start += from * from, gap.half += from * velocity, gap.square += velocity * velocity;
    }
  }

  /// At t the center is over the feature, not past an end of it.
  bool over(const BallNearBox& q, const Surd& t) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (sides[k] == 0 && q.axes[k].side(t) != 0) return false;
    return true;
  }
};

/// The first contact; and where the center is nearest to the box.
struct Sweep {
  FirstContact<Surd> first{HitRelation::never, std::nullopt};
  std::vector<Rational> nearest;
  Rational square;

  explicit Sweep(const BallNearBox& q) {
    look_at(q, Rational(0)), look_at(q, Rational(1));
    for (int number = 0; number < Feature::count; ++number) {
      const Feature feature(q, number);
      const Parabola& f = feature.gap;
      if (sgn(f.half) < 0 && sgn(f.half_slope_at_end()) > 0) look_at(q, quotient(Integer(-f.half), f.square));
      FirstContact<Surd> entry = f.contact();
      if (!entry.t || (first.t && *first.t <= *entry.t) || !feature.over(q, *entry.t)) continue;
      first = std::move(entry);
    }
  }

 private:
  void look_at(const BallNearBox& q, const Rational& t) {
    std::vector<Rational> n = q.displacement(t);
    Rational found(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (nearest.empty() || found < square) nearest = std::move(n), square = std::move(found);
  }
};

template <class Number>
Certificate certificate_of_sweep(const CommonScale<Number, 13>& n, const BallNearBox& q, const Sweep& sweep) {
  if (!sweep.first.t) return {"separating_axis", {{"normal", sweep.nearest}}};
  const Surd& t = *sweep.first.t;
  std::vector<Rational> point, sides;
  for (const CenterOnAxis& axis : q.axes) {
    sides.emplace_back(axis.side(t));
    point.push_back(n.actual(Rational(nearest_in_interval(axis.at, axis.min, axis.max).x), 1));
  }
  if (sgn(t) == 0) return {"start", {{"point", std::move(point)}}};
  return {"first_contact", {{"sides", std::move(sides)}}};
}

template <class Number>
Truth<FirstContact<Surd>> truth_swept_sphere_aabb(const Sphere3<Number>& sphere, const Vector3<Number>& v,
                                                  const Aabb3<Number>& aabb) {
  validation::validate_all("sphere", sphere, "velocity", v, "aabb", aabb);
  const auto& [c, radius] = sphere;
  const auto& [min, max] = aabb;
  const CommonScale<Number, 13> n({c.x, v.x, min.x, max.x, c.y, v.y, min.y, max.y, c.z, v.z, min.z, max.z, radius});
  BallNearBox q{{}, n.integer(12)};
  for (std::size_t k = 0; k < 3; ++k)
    q.axes[k] = {n.integer(4 * k), n.integer(4 * k + 1), n.integer(4 * k + 2), n.integer(4 * k + 3)};
  Sweep sweep(q);
  Truth<FirstContact<Surd>> truth{sweep.first, n.actual(Rational(abs(sweep.square - q.radius * q.radius)), 2)};
  if (sgn(sweep.square) == 0) {
    const Rational depth = *swept_aabb_aabb(Aabb3<Number>{c, c}, aabb, v).margin;
    *truth.margin += depth * depth;
  }
  truth.certificate = [n, q = std::move(q), sweep = std::move(sweep)] { return certificate_of_sweep(n, q, sweep); };
  return truth;
}

}  // namespace

template <Exact Number>
Truth<FirstContact<Surd>> swept_sphere_aabb(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                            const Aabb3<Number>& aabb) {
  return truth_swept_sphere_aabb(sphere, velocity, aabb);
}
template Truth<FirstContact<Surd>> swept_sphere_aabb(const Sphere3d&, const Vector3d&, const Aabb3d&);
template Truth<FirstContact<Surd>> swept_sphere_aabb(const Sphere3<Rational>&, const Vector3<Rational>&,
                                                     const Aabb3<Rational>&);

}  // namespace touchstone::oracle
