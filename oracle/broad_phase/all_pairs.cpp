// SPDX-License-Identifier: Apache-2.0
#include "oracle/broad_phase/all_pairs.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/wide.h"
#include "oracle/exact/shapes/whole_list.h"

namespace touchstone::oracle {
namespace {

using Ball = Sphere3<Integer>;
using Box = Aabb3<Integer>;
using Point = Point3<Integer>;

constexpr std::array axes{&Point::x, &Point::y, &Point::z};

/// Solids in integers.
template <class Solid>
struct Scaled {
  std::vector<Solid> solids;
  IntegerList numbers;
};

template <class Solid>
void validate(const std::string& field, const std::vector<Solid>& solids) {
  validation::validate_numbers(field, solids);
  for (std::size_t i = 0; i < solids.size(); ++i) {
    validation::validate(field + "[" + std::to_string(i) + "]", solids[i]);
  }
}

template <class Number>
Scaled<Ball> validated(const std::vector<Sphere3<Number>>& spheres) {
  validate("spheres", spheres);
  std::vector<Number> numbers;
  for (const auto& [c, r] : spheres) numbers.insert(numbers.end(), {c.x, c.y, c.z, r});
  Scaled<Ball> scaled{{}, integer_list(numbers)};
  const auto& n = scaled.numbers.integers;
  for (std::size_t i = 0; i < n.size(); i += 4) scaled.solids.push_back({{n[i], n[i + 1], n[i + 2]}, n[i + 3]});
  return scaled;
}

template <class Number>
Scaled<Box> validated(const std::vector<Aabb3<Number>>& boxes) {
  validate("boxes", boxes);
  std::vector<Number> numbers;
  for (const auto& [p, q] : boxes) numbers.insert(numbers.end(), {p.x, p.y, p.z, q.x, q.y, q.z});
  Scaled<Box> scaled{{}, integer_list(numbers)};
  const auto& n = scaled.numbers.integers;
  for (std::size_t i = 0; i < n.size(); i += 6) {
    scaled.solids.push_back({{n[i], n[i + 1], n[i + 2]}, {n[i + 3], n[i + 4], n[i + 5]}});
  }
  return scaled;
}

Integer squared_distance(const Ball& a, const Ball& b) {
  const Vector3<Integer> between = b.center - a.center;
  return dot(between, between);
}

/// The distance that two solids can move before they separate, to the power `degree`; negative: their distance.
Integer spare(const Ball& a, const Ball& b) {
  const Integer reach = a.radius + b.radius;
  return Integer(reach * reach - squared_distance(a, b));
}
Integer spare(const Box& a, const Box& b) {
  std::optional<Integer> least;
  for (const auto axis : axes) {
    for (const Integer& room : {Integer(a.max.*axis - b.min.*axis), Integer(b.max.*axis - a.min.*axis)}) {
      if (!least || room < *least) least = room;
    }
  }
  return *least;
}
constexpr int degree(const Ball*) { return 2; }
constexpr int degree(const Box*) { return 1; }

std::vector<Rational> actual_point(const IntegerList& numbers, const Point3<Rational>& p) {
  return {numbers.actual(p.x, 1), numbers.actual(p.y, 1), numbers.actual(p.z, 1)};
}

/// For balls that meet: the point that divides the line between the centers in the ratio of the radii.
Point3<Rational> common_point(const Ball& a, const Ball& b) {
  const Integer reach = a.radius + b.radius;
  const auto divided = [&](const Integer& p, const Integer& q) {
    return sgn(reach) == 0 ? Rational(p) : quotient(Integer(p * b.radius + q * a.radius), reach);
  };
  return {divided(a.center.x, b.center.x), divided(a.center.y, b.center.y), divided(a.center.z, b.center.z)};
}
/// For boxes that meet: the least corner of their intersection.
Point3<Rational> common_point(const Box& a, const Box& b) {
  const auto larger = [](const Integer& p, const Integer& q) { return Rational(p < q ? q : p); };
  return {larger(a.min.x, b.min.x), larger(a.min.y, b.min.y), larger(a.min.z, b.min.z)};
}

Certificate apart(const IntegerList& numbers, const IndexPair& pair, const Ball& a, const Ball& b) {
  return {"distance",
          {{"pair", {Rational(pair.i), Rational(pair.j)}},
           {"squared_distance", {numbers.actual(Rational(squared_distance(a, b)), 2)}}}};
}
Certificate apart(const IntegerList&, const IndexPair& pair, const Box& a, const Box& b) {
  std::int64_t axis = 0;
  while (a.max.*axes[static_cast<std::size_t>(axis)] >= b.min.*axes[static_cast<std::size_t>(axis)] &&
         b.max.*axes[static_cast<std::size_t>(axis)] >= a.min.*axes[static_cast<std::size_t>(axis)]) {
    ++axis;
  }
  return {"gap", {{"pair", {Rational(pair.i), Rational(pair.j)}}, {"axis", {Rational(axis)}}}};
}

Integer low(const Ball& ball, Integer Point::*axis) { return Integer(ball.center.*axis - ball.radius); }
Integer high(const Ball& ball, Integer Point::*axis) { return Integer(ball.center.*axis + ball.radius); }
const Integer& low(const Box& box, Integer Point::*axis) { return box.min.*axis; }
const Integer& high(const Box& box, Integer Point::*axis) { return box.max.*axis; }

bool before(const IndexPair& p, const IndexPair& q) { return p.i != q.i ? p.i < q.i : p.j < q.j; }
IndexPair pair_of(Index i, Index j) { return {std::min(i, j), std::max(i, j)}; }

/// All solids as intervals on an axis, sorted by their lower ends, and the number of pairs of these that meet.
struct Sweep {
  template <class Solid>
  Sweep(const std::vector<Solid>& solids, std::size_t on) : axis(on), order(solids.size()) {
    for (const Solid& solid : solids) lows.push_back(low(solid, axes[axis])), highs.push_back(high(solid, axes[axis]));
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(), [&](Index i, Index j) { return lows[i] < lows[j]; });
    for (std::size_t p = 0; p < order.size(); ++p) {
      const auto begins_beyond = [&](const Integer& end, Index i) { return end < lows[i]; };
      const auto end = std::upper_bound(order.begin(), order.end(), highs[order[p]], begins_beyond);
      meeting += static_cast<std::size_t>(end - order.begin()) - p - 1;
    }
  }

  std::size_t axis;
  std::vector<Integer> lows, highs;
  std::vector<Index> order;
  std::size_t meeting = 0;
};

/// The sweep along the axis on which the fewest pairs remain.
template <class Solid>
Sweep best_sweep(const std::vector<Solid>& solids) {
  Sweep best(solids, 0);
  for (std::size_t axis = 1; axis < 3; ++axis) {
    Sweep other(solids, axis);
    if (other.meeting < best.meeting) best = std::move(other);
  }
  return best;
}

/// The largest number of solids of which the remaining pairs that do not meet are listed: the proofs of more would be
/// longer than everything else, and checkers compare these pairs.
constexpr std::size_t listed = 100;

/// Visits the remaining pairs of the sweep.
template <class Solid>
Certificate certificate(const Scaled<Solid>& scaled) {
  const auto& [solids, numbers] = scaled;
  const Sweep sweep = best_sweep(solids);
  const auto& order = sweep.order;
  std::vector<IndexPair> left;
  for (std::size_t p = 0; p < order.size(); ++p) {
    for (std::size_t q = p + 1; q < order.size() && sweep.lows[order[q]] <= sweep.highs[order[p]]; ++q)
      left.push_back(pair_of(order[p], order[q]));
  }
  std::vector<Certificate> meet, asunder;
  std::sort(left.begin(), left.end(), before);
  for (const IndexPair& pair : left) {
    const Solid &a = solids[pair.i], &b = solids[pair.j];
    if (sgn(spare(a, b)) >= 0) {
      meet.push_back({"common_point", {{"point", actual_point(numbers, common_point(a, b))}}});
    } else if (solids.size() <= listed) {
      asunder.push_back(apart(numbers, pair, a, b));
    }
  }
  const bool compared = solids.size() > listed;
  Certificate sweeping{
      compared ? "compared_sweep" : "sweep",
      {{"axis", {Rational(static_cast<std::int64_t>(sweep.axis))}}, {"order", {order.begin(), order.end()}}},
      {{"meet", std::move(meet)}}};
  if (!compared) sweeping.parts.emplace_back("apart", std::move(asunder));
  return sweeping;
}

/// A lower bound of the distance of two solids, if one begins on an axis this far beyond the other's end.
Integer least_lack(const Integer& gap, const Ball*) { return Integer(gap * gap); }
const Integer& least_lack(const Integer& gap, const Box*) { return gap; }

template <class Solid>
Truth<std::vector<IndexPair>> truth_all_pairs(Scaled<Solid> scaled) {
  const auto& solids = scaled.solids;
  Truth<std::vector<IndexPair>> found;
  std::optional<Integer> least;
  const Sweep sweep = best_sweep(solids);
  for (std::size_t p = 0; p < solids.size(); ++p) {
    const Index i = sweep.order[p];
    for (std::size_t q = p + 1; q < solids.size(); ++q) {
      const Index j = sweep.order[q];
      const Integer gap = sweep.lows[j] - sweep.highs[i];
      if (least && sgn(gap) > 0 && least_lack(gap, &solids[i]) > *least) break;  // so are the later ones
      Integer room = spare(solids[i], solids[j]);
      if (sgn(room) >= 0) found.answer.push_back(pair_of(i, j));
      room = abs(room);
      if (!least || room < *least) least = std::move(room);
    }
  }
  std::sort(found.answer.begin(), found.answer.end(), before);
  const Solid* kind = nullptr;
  if (least && degree(kind) == 1) *least *= *least;
  if (least) found.margin = scaled.numbers.actual(Rational(*least), 2);
  found.certificate = [scaled = std::move(scaled)] { return certificate(scaled); };
  return found;
}

}  // namespace

template <Exact Number>
Truth<std::vector<IndexPair>> all_pairs(const std::vector<Sphere3<Number>>& spheres) {
  return truth_all_pairs(validated(spheres));
}
template <Exact Number>
Truth<std::vector<IndexPair>> all_pairs(const std::vector<Aabb3<Number>>& boxes) {
  return truth_all_pairs(validated(boxes));
}
template Truth<std::vector<IndexPair>> all_pairs(const std::vector<Sphere3d>&);
template Truth<std::vector<IndexPair>> all_pairs(const std::vector<Aabb3d>&);
template Truth<std::vector<IndexPair>> all_pairs(const std::vector<Sphere3<Rational>>&);
template Truth<std::vector<IndexPair>> all_pairs(const std::vector<Aabb3<Rational>>&);

}  // namespace touchstone::oracle
