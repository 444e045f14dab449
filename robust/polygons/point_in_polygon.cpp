// SPDX-License-Identifier: Apache-2.0
#include "robust/polygons/point_in_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "robust/kernel/filters/filters.h"
#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/lines/orientation.h"
#include "robust/prepared/polygon.h"

namespace touchstone::robust {
namespace {

// Two doubles at a time, as every x86-64 has them: all edges cost less than the branches of the plain ray test.
using Lanes = double __attribute__((vector_size(16)));
using Bits = std::int64_t __attribute__((vector_size(16)));

Bits bits(const Lanes& lanes) { return reinterpret_cast<Bits>(lanes); }
Lanes magnitude(const Lanes& lanes) {
  constexpr std::int64_t all_but_sign = std::numeric_limits<std::int64_t>::max();
  return reinterpret_cast<Lanes>(bits(lanes) & Bits{all_but_sign, all_but_sign});
}
Lanes lesser(const Lanes& a, const Lanes& b) { return a < b ? a : b; }

/// Counts the crossings of the ray to +x by signs alone: with each vertex relative to the point as (x, y), an edge from
/// (x, y) to (x1, y1) crosses the ray if y and y1 differ in sign and x y1 - y x1 has the sign of y1. All edges are
/// processed alike, without branches; at the end the signs are trusted if every |x y1 - y x1| exceeds one bound.
///
/// Bound, with u, n, H and (1) to (6) as in filters.h: let sx and sy be the sums of all |x| and |y|, that of the vertex
/// before the first edge included (in a full ring it counts twice), sx + sy <= H. A NaN or an infinity stays in them,
/// and rounding is monotone, so that they are at least the extents as cross_sign there computes them for any edge. So
/// its C and A serve here: no |x y1 - y x1| beyond C sx sy + A has the wrong sign.
///
/// The sign of y is uncertain if y is 0, or so small that FTZ or DAZ changed it: then the true |y| is at most 5 n.
/// Let every vertex but the ends of a part move upwards or downwards, by less than 6 n, until its y has the sign that
/// was computed. Meanwhile each y is off by 11 n instead of 5 n (1), which costs 14 n H more in (3): A is enough for
/// that, 2 A are taken. So no determinant becomes 0, the ring never passes over the point, and the point stays in or
/// out. At the end no y is 0, and the signs tell the crossings. Proved, for any number of edges (crossings_right): each
/// determinant has the exact sign, wherever on these paths the vertices are, and the answer is the parity of the
/// crossings at their end.
struct Crossings {
  explicit Crossings(const Point2d& point) : origin_{point.x, point.y} {}

  /// The vertex before the first edge.
  Lanes started(const Point2d& vertex) {
    const Lanes at = seen(vertex);
    sum_x_[0] = std::fabs(at[0]), sum_y_[0] = std::fabs(at[1]);
    return at;
  }

  Lanes seen(const Point2d& vertex) const {
    Lanes at;
    std::memcpy(&at, &vertex, sizeof at);
    return at - origin_;
  }

  /// Two edges, from (x, y) to (x1, y1) in each lane.
  void add(const Lanes& x, const Lanes& y, const Lanes& x1, const Lanes& y1) {
    const Lanes determinant = x * y1 - y * x1;
    least_ = lesser(magnitude(determinant), least_);
    sum_x_ += magnitude(x1), sum_y_ += magnitude(y1);
    parity_ ^= (bits(y) ^ bits(y1)) & ~(bits(determinant) ^ bits(y1));
  }

  /// One edge, the same in both lanes.
  void add_one(const Lanes& x, const Lanes& y, const Lanes& x1, const Lanes& y1) {
    const std::int64_t kept = parity_[1];
    add(x, y, x1, y1);
    parity_[1] = kept;
  }

  /// The parity of all edges added.
  Perhaps<Location> location() const {
    using B = filters::Bounds<double>;
    const double sx = sum_x_[0] + sum_x_[1], sy = sum_y_[0] + sum_y_[1];
    if (!(sx + sy <= B::high())) return std::nullopt;
    const double bound = B::relative<3, 12>() * sx * sy + 2 * B::absolute();
    if (!((least_[0] < least_[1] ? least_[0] : least_[1]) > bound)) return std::nullopt;
    return (parity_[0] ^ parity_[1]) < 0 ? Location::inside : Location::outside;
  }

 private:
  Lanes origin_, sum_x_{}, sum_y_{};
  Lanes least_{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Bits parity_{};
};

/// True if FTZ and DAZ cannot have changed the sign of a difference: beyond 16 n.
bool sign_is_certain(double difference) { return !(std::fabs(difference) < 0x1p-1018); }

/// Consecutive edges: from `before` to the first of the vertices, and so on to the last. Each stage answers `boundary`
/// for them, or `inside` if the ray crosses an odd number of them, or `outside`; for full rings these are the answers
/// of the contract. An end on the ray's line counts as below it, so that parts decided by different stages fit
/// together.
struct Part {
  const Point2d *before, *first, *last;  // one past the last
  bool whole;
};

Location parity(bool odd) { return odd ? Location::inside : Location::outside; }

Perhaps<Location> by_filter(const Part& part, const Point2d& point) {
  Crossings crossings(point);
  const Lanes before = crossings.started(*part.before);
  // No bound is below 2 A, and multiplications that underflow are slow.
  if (std::fabs(before[0]) + std::fabs(before[1]) < 0x1p-400) return std::nullopt;
  Lanes x{0, before[0]}, y{0, before[1]};  // of the vertex before in lane 1
  const Point2d* at = part.first;
  for (; at + 1 < part.last; at += 2) {
    const Lanes v = crossings.seen(at[0]), w = crossings.seen(at[1]);
    const Lanes x1 = __builtin_shufflevector(v, w, 0, 2), y1 = __builtin_shufflevector(v, w, 1, 3);
    crossings.add(__builtin_shufflevector(x, x1, 1, 2), __builtin_shufflevector(y, y1, 1, 2), x1, y1);
    x = x1, y = y1;
  }
  if (at != part.last) {
    const Lanes v = crossings.seen(*at);
    const Lanes x1{v[0], v[0]}, y1{v[1], v[1]};
    crossings.add_one(Lanes{x[1], x[1]}, Lanes{y[1], y[1]}, x1, y1);
    y = y1;
  }
  if (!part.whole && !(sign_is_certain(before[1]) && sign_is_certain(y[1]))) return std::nullopt;
  return crossings.location();
}

/// Decides on integers that are multiples of one power of two, with the point at the origin.
Perhaps<Location> by_lattice(const Part& part, const Point2d& point) {
  std::uint64_t greatest = 0;  // of the magnitudes, as bits
  const auto raise = [&](double number) { greatest = std::max(greatest, std::bit_cast<std::uint64_t>(number) << 1); };
  raise(point.x), raise(point.y), raise(part.before->x), raise(part.before->y);
  for (const Point2d* v = part.first; v != part.last; ++v) raise(v->x), raise(v->y);
  const int top = std::max(1, static_cast<int>(greatest >> 53));
  if (top == 0x7ff) return std::nullopt;
  std::uint64_t lost = 0;
  const auto placed = [&](double number) {
    return kernel::placed_on_lattice(std::bit_cast<std::uint64_t>(number), top, lost);
  };
  const std::int64_t origin_x = placed(point.x), origin_y = placed(point.y);
  std::int64_t x = placed(part.before->x) - origin_x, y = placed(part.before->y) - origin_y;
  bool odd = false;
  for (const Point2d* v = part.first; v != part.last; ++v) {
    const std::int64_t x1 = placed(v->x) - origin_x, y1 = placed(v->y) - origin_y;
    const kernel::Int128 determinant = kernel::multiply(x, y1) - kernel::multiply(y, x1);
    odd ^= ((y > 0) != (y1 > 0)) & ((determinant > 0) == (y1 > 0));
    if (determinant == 0 && kernel::multiply(x, x1) + kernel::multiply(y, y1) <= 0) {
      if (lost != 0) return std::nullopt;
      return Location::boundary;  // the other edges do not matter
    }
    x = x1, y = y1;
  }
  if (lost != 0) return std::nullopt;
  return parity(odd);
}

/// Integers in the order of the doubles, whatever the control word; -0.0 is 0.
std::int64_t rank(double value) {
  const auto bits = std::bit_cast<std::int64_t>(value);
  return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
}
int compared(double a, double b) { return (rank(a) > rank(b)) - (rank(a) < rank(b)); }

/// Edge by edge. turn(a, b): 1, 0, -1 as a, b and the point turn; it is called only for edges that cross the ray's line
/// and are neither entirely left nor entirely right of the point.
template <class Turn>
Location by_turns(const Part& part, const Point2d& point, const Turn& turn) {
  bool odd = false;
  const Point2d* a = part.before;
  int ax = compared(a->x, point.x), ay = compared(a->y, point.y);
  for (const Point2d* b = part.first; b != part.last; ++b) {
    const int bx = compared(b->x, point.x), by = compared(b->y, point.y);
    if (bx == 0 && by == 0) return Location::boundary;
    if (ay == 0 && by == 0) {
      if (ax != bx) return Location::boundary;  // along the ray's line, from one side of the point to the other
    } else if ((ay > 0) != (by > 0)) {
      // If an end is on the ray's line, the edge meets the line there.
      int right = ay == 0 ? ax : by == 0 ? bx : ax == bx ? ax : 0;
      if (right == 0) {
        const int side = turn(*a, *b);
        if (side == 0) return Location::boundary;
        right = side * by;
      }
      if (right > 0) odd = !odd;
    }
    a = b, ax = bx, ay = by;
  }
  return parity(odd);
}

Location by_integers(const Part& part, const Point2d& p) {
  return by_turns(part, p, [&](const Point2d& a, const Point2d& b) {
    const auto n = kernel::integers_of(a.x, a.y, b.x, b.y, p.x, p.y).at;
    return kernel::turn(Point2<mpz_class>{n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]});
  });
}

/// The same, but edges are decided by their own filter or lattice first.
Location edge_by_edge(const Part& part, const Point2d& p) {
  return by_turns(part, p,
                  [&](const Point2d& a, const Point2d& b) { return 1 - static_cast<int>(orientation(a, b, p)); });
}

Part integer(const Polygon2d& polygon) {
  const Point2d* begin = polygon.vertices.data();
  const Point2d* end = begin + polygon.size() - validation::closed(polygon.vertices);
  return {end - 1, begin, end, true};
}

void validate(const Polygon2d& polygon, const Point2d& point) {
  bool valid = !validation::fewer_than_three(polygon.vertices) && kernel::valid(point);
  for (const Point2d& vertex : polygon.vertices) valid &= kernel::valid(vertex);
  if (!valid) validation::validate_all("polygon", polygon, "point", point);
}

/// Runs the stages for one part after another: one hard edge does not make all of them hard.
class Parts {
 public:
  /// latest: the stage that the question has come to.
  Parts(const Point2d& point, Stage latest) : point_(point), latest_(latest) {}

  Location located(const Part& part) {
    Perhaps<Location> found = std::nullopt;
    if (failures_ < 2) {  // otherwise the scale is the cause, and it would fail again
      found = by_filter(part, point_);
      failures_ += !found;
    }
    if (found) return *found;
    latest_ = std::max(latest_, Stage::lattice);
    if ((found = by_lattice(part, point_))) return *found;
    latest_ = Stage::exact;
    return edge_by_edge(part, point_);
  }
  Stage latest() const { return latest_; }

 private:
  const Point2d& point_;
  Stage latest_;
  int failures_ = 0;
};

/// Validates, and decides the ring part by part.
Decided<Location> past_filter(const Polygon2d& polygon, const Point2d& point) {
  constexpr std::ptrdiff_t edges_of_a_part = structures::RingTree::edges_of_a_part;
  if (validation::fewer_than_three(polygon.vertices)) validate(polygon, point);
  const Part ring = integer(polygon);
  if (ring.last - ring.first <= edges_of_a_part) {
    if (const auto found = by_lattice(ring, point)) return {*found, Stage::lattice};  // all finite
    validate(polygon, point);
    return {edge_by_edge(ring, point), Stage::exact};
  }
  validate(polygon, point);
  Parts parts(point, Stage::lattice);
  bool odd = false;
  for (const Point2d *first = ring.first, *last; first != ring.last; first = last) {
    last = first + std::min(edges_of_a_part, ring.last - first);
    const Location found = parts.located({first == ring.first ? ring.before : first - 1, first, last, false});
    if (found == Location::boundary) return {found, parts.latest()};
    odd ^= found == Location::inside;
  }
  return {parity(odd), parts.latest()};
}

}  // namespace

Perhaps<Location> stages::point_in_polygon::filter(const Polygon2d& polygon, const Point2d& point) {
  if (validation::fewer_than_three(polygon.vertices)) return std::nullopt;
  return by_filter(integer(polygon), point);
}

Perhaps<Location> stages::point_in_polygon::lattice(const Polygon2d& polygon, const Point2d& point) {
  return by_lattice(integer(polygon), point);
}

Location stages::point_in_polygon::exact(const Polygon2d& polygon, const Point2d& point) {
  return by_integers(integer(polygon), point);
}

Decided<Location> stages::point_in_polygon::ask(const Polygon2d& polygon, const Point2d& point) {
  if (const auto answer = filter(polygon, point)) return {*answer, Stage::filter};
  return past_filter(polygon, point);
}

Decided<Location> stages::point_in_polygon::of_prepared(const Polygon& polygon, const Point2d& point) {
  if (!kernel::valid(point)) validation::validate("point", point);
  const Point2d* const vertices = polygon.ring().vertices.data();
  const std::size_t size = polygon.ring().size();
  Parts parts(point, Stage::filter);
  const Location found = polygon.tree().located(polygon.ring(), point, [&](const auto& part) {
    const Point2d* const before = vertices + (part.first == 0 ? size : part.first) - 1;
    return parts.located({before, vertices + part.first, vertices + part.last, part.last - part.first == size});
  });
  return {found, parts.latest()};
}

Location point_in_polygon(const Polygon& polygon, const Point2d& point) {
  return stages::point_in_polygon::of_prepared(polygon, point).answer;
}

Location point_in_polygon(const Polygon2d& polygon, const Point2d& point) {
  return stages::point_in_polygon::ask(polygon, point).answer;
}

}  // namespace touchstone::robust
