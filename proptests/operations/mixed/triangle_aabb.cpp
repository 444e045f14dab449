// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/triangle_aabb.h"

#include "proptests/closest_laws.h"
#include "robust/mixed/segment_aabb.h"
#include "robust/mixed/sphere_triangle.h"
#include "robust/polyhedra/segment_triangle.h"

namespace touchstone::proptests::triangle_aabb_tests {
namespace {

using Row = rows::triangle_aabb;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;
constexpr Aabb3d cube{{0, 0, 0}, {2, 2, 2}};

/// Over the ground, its edges parallel to axes.
Triangle3d level(double z) { return {{0, 0, z}, {4, 0, z}, {0, 4, z}}; }
/// x + y + z = sum.
Triangle3d slanted(double sum) { return {{sum, 0, 0}, {0, sum, 0}, {0, 0, sum}}; }
/// An edge across x = y, where x + y = sum.
Triangle3d across_edge(double sum) { return {{sum, 0, 1}, {0, sum, 1}, {5, 5, 3}}; }

bool flat(const Aabb3d& b) { return b.min.x == b.max.x || b.min.y == b.max.y || b.min.z == b.max.z; }

std::vector<Segment3d> edges(const Aabb3d& box) {
  const auto& [p, q] = box;
  std::vector<Segment3d> all;
  for (const double x : {p.x, q.x}) {
    for (const double y : {p.y, q.y}) all.push_back({{x, y, p.z}, {x, y, q.z}});
    for (const double z : {p.z, q.z}) all.push_back({{x, p.y, z}, {x, q.y, z}});
  }
  for (const double y : {p.y, q.y})
    for (const double z : {p.z, q.z}) all.push_back({{p.x, y, z}, {q.x, y, z}});
  return all;
}
std::vector<Segment3d> edges(const Triangle3d& t) { return {{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}; }

constexpr Worked<Row> worked;

using Exactly = Vector3<Rational>;
Exactly rational(const Point3d& p) { return {exact(p.x), exact(p.y), exact(p.z)}; }
Exactly magnitudes(const Exactly& v) { return {abs(v.x), abs(v.y), abs(v.z)}; }
Rational sum(const Exactly& v) { return Rational(v.x + v.y + v.z); }

/// Both comparisons of the formula along an axis, in double and exactly, and the bound of the contract.
class Projected {
 public:
  Projected(const Triangle3d& t, const Aabb3d& box) : t_(t), box_(box) {
    const auto largest = [](double a, double b, double c, double d, double e) {
      return Rational(std::max({size(a), size(b), size(c)}) + std::max(size(d), size(e)));
    };
    const auto& [a, b, c] = t;
    const auto& [min, max] = box;
    sizes_ = {largest(a.x, b.x, c.x, min.x, max.x), largest(a.y, b.y, c.y, min.y, max.y),
              largest(a.z, b.z, c.z, min.z, max.z)};
  }

  void along(const Vector3d& computed, const Exactly& n, const Exactly& terms) {
    const auto& [min, max] = box_;
    const Vector3d h{(max.x - min.x) / 2, (max.y - min.y) / 2, (max.z - min.z) / 2};
    const Point3d middle{(min.x + max.x) / 2, (min.y + max.y) / 2, (min.z + max.z) / 2};
    const Exactly low = rational(min), high = rational(max), center = Rational(1, 2) * (low + high),
                  half = Rational(1, 2) * (high - low);
    const Rational reach = dot(magnitudes(n), half);
    std::vector<Rational> heights;
    for (const Point3d& p : {t_.a, t_.b, t_.c}) {
      heights.push_back(dot(n, rational(p) - center));
      certain = certain && finite(dot(computed, p - middle), dot(computed, h));
    }
    const auto [least, greatest] = std::minmax_element(heights.begin(), heights.end());
    const Rational u = unit(), below = *least - reach, above = *greatest + reach,
                   bound =
                       (18 + 73 * u) * u * dot(terms, sizes_) + power_of_two(-1071) * (sum(terms) + sum(sizes_) + 1);
    certain = certain && abs(below) > bound && abs(above) > bound;
    separated = separated || sgn(below) > 0 || sgn(above) < 0;
  }

  bool certain = true, separated = false;

 private:
  const Triangle3d& t_;
  const Aabb3d& box_;
  Exactly sizes_;
};

}  // namespace

LAW("triangle_aabb: the order of the corners does not matter", t, box) {
  return ask(asked) == ask(Row::Question{{t.b, t.c, t.a}, box}) &&
         ask(asked) == ask(Row::Question{{t.c, t.b, t.a}, box});
}

ROBUST_LAW("triangle_aabb: they meet exactly if an edge of one meets the other", t, box) {
  bool meet = false;
  for (const Segment3d& edge : edges(t))
    meet = meet || robust::segment_aabb(edge, box).relation == PassageRelation::hit;
  for (const Segment3d& edge : edges(box))
    meet = meet || robust::segment_triangle_relation(edge, t) != SegmentTriangleRelation::none;
  return (ask(asked) != disjoint) == meet;
}

LAW("triangle_aabb: a box that grows never loses contact, and one that touched overlaps", t, box) {
  const auto less = [](double x) { return catalogue::moved_by_ulps(x, -1); };
  const auto more = [](double x) { return catalogue::moved_by_ulps(x, 1); };
  const auto& [min, max] = box;
  if (std::max({max.x, max.y, max.z, -min.x, -min.y, -min.z}) == greatest) return true;
  const Aabb3d larger{{less(min.x), less(min.y), less(min.z)}, {more(max.x), more(max.y), more(max.z)}};
  return ask(asked) == disjoint || ask(Row::Question{t, larger}) == overlapping;
}

LAW("triangle_aabb: a part of a triangle has no more contact than the whole", t, box) {
  return ask(Row::Question{{t.a, t.b, t.b}, box}) <= ask(asked) &&
         ask(Row::Question{{t.c, t.c, t.c}, box}) <= ask(asked);
}

LAW("triangle_aabb: a flat box does not overlap; a corner inside a box overlaps it", t, box) {
  const auto& [min, max] = box;
  const auto within = [](double low, double x, double high) { return low < x && x < high; };
  const bool inside = within(min.x, t.b.x, max.x) && within(min.y, t.b.y, max.y) && within(min.z, t.b.z, max.z);
  return (!flat(box) || ask(asked) != overlapping) && (!inside || ask(asked) == overlapping);
}

ROBUST_LAW("triangle_aabb: a box of one point has the contact of a ball of radius 0", t, box) {
  return ask(Row::Question{t, {box.max, box.max}}) == robust::sphere_triangle({box.max, 0}, t);
}

TEST_CASE("triangle_aabb: p. 45's box and a triangle worked by hand") {
  worked({level(3), cube}, disjoint, 1);
  worked({level(2), cube}, touching, 0);                  // in the plane of a face
  worked({level(1), cube}, overlapping, 1, "algorithm");  // its edges are parallel to axes
  // The corner (2, 2, 2), x + y + z = 6; 3 d = 1.
  worked({slanted(7), cube}, disjoint, Rational(1, 3));
  worked({slanted(6), cube}, touching, 0);
  worked({slanted(5), cube}, overlapping, Rational(1, 3));
  // The edge x = y = 2; 2 d = 1.
  worked({across_edge(5), cube}, disjoint, Rational(1, 2));
  worked({across_edge(4), cube}, touching, 0);
  worked({across_edge(3), cube}, overlapping, Rational(1, 2));
  // A corner on a face, and one in the middle of the box.
  worked({{{2, 1, 1}, {4, 0.5, 0.25}, {5, 3, 2}}, cube}, touching, 0);
  worked({{{1, 1, 1}, {5, 1.5, 4}, {6, 3, 5}}, cube}, overlapping, 1);
  // Within the box; and around it, through its middle.
  worked({{{1, 1, 0.5}, {1.5, 1.25, 1}, {0.5, 1.5, 1.5}}, cube}, overlapping, Rational(5, 6));  // 2 (2 - y) + z = 5 / 2
  worked({slanted(3), {{0, 0, 0}, {1, 1, 1}}}, touching, 0);
  worked({slanted(3), {{0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}}}, overlapping, Rational(1, 2));
}

TEST_CASE("triangle_aabb: a triangle without area is a segment or a point") {
  worked({{{3, 1, 1}, {1, 3, 1}, {3, 1, 1}}, cube}, touching, 0);  // x + y = 4
  worked({{{4, 1, 1}, {1, 4, 1}, {2, 3, 1}}, cube}, disjoint, Rational(1, 2));
  worked({{{3, 0, 1}, {0, 3, 1}, {1, 2, 1}}, cube}, overlapping, Rational(1, 2), "algorithm");
  worked({{{-1, 1, 1}, {3, 1, 1}, {0, 1, 1}}, cube}, overlapping, 1, "algorithm");
  worked({{{1, 1, 0.5}, {1, 1, 0.5}, {1, 1, 0.5}}, cube}, overlapping, Rational(1, 2), "algorithm");
  worked({{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}, cube}, touching, 0);
  worked({{{2, 2, 4}, {2, 2, 4}, {2, 2, 4}}, cube}, disjoint, 2);
}

TEST_CASE("triangle_aabb: a flat box only touches; the formula sees an overlap where a triangle goes through it") {
  const Aabb3d square{{0, 0, 1}, {2, 2, 1}}, line{{0, 1, 1}, {2, 1, 1}};
  const Triangle3d through{{1, 1, -1}, {1.5, 2, 4}, {0.5, 0.25, 3}};
  worked({through, square}, touching, 0, "algorithm");
  worked({level(1), square}, touching, 0);
  worked({level(3), square}, disjoint, 2);
  worked({{{1, 3, 1}, {3, 1, 1}, {3, 3, 1}}, square}, touching, 0);               // corner to edge, in one plane
  worked({{{1, 4, 1}, {4, 1, 1}, {3, 3, 1}}, square}, disjoint, Rational(1, 2));  // x + y = 5
  // In one plane with a line, which ends before the edge x + y = 4.
  worked({{{1, 3, 1}, {4, 0, 1}, {4, 3, 1}}, line}, disjoint, Rational(1, 2));
  worked({{{1, 3, 3}, {4, 0, 0}, {4, 3, 3}}, line}, disjoint, Rational(1, 2));
  worked({{{1, 0, 0}, {2, 1, 1}, {5, 1, 1}}, line}, touching, 0);
  worked({{{2, 1, 1}, {2, 1, 1}, {2, 1, 1}}, {{2, 1, 1}, {2, 1, 1}}}, touching, 0);
}

TEST_CASE("triangle_aabb: rounding, huge, subnormal and negative zero") {
  // The center is 2^53 + 1/2, of which the half is lost: the box seems to begin at 0.
  worked({{{0.5, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{1, 0, 0}, {0x1p54, 1, 1}}}, disjoint, Rational(1, 2), "rounding");
  const Aabb3d least{{0, 0, 0}, {tiny, tiny, tiny}};
  worked({{{2 * tiny, 0, 0}, {2 * tiny, 1, 0}, {2 * tiny, 0, 1}}, least}, disjoint, exact(tiny));
  worked({{{tiny, 0, 0}, {tiny, 1, 0}, {tiny, 0, 1}}, least}, touching, 0, "rounding");  // half of it is 0
  worked({slanted(tiny), least}, overlapping, Rational(exact(tiny) / 3), "rounding");
  const Aabb3d large{{-huge, -huge, -huge}, {huge, huge, huge}};
  worked({{{1, 0, -greatest}, {0, 1, greatest}, {2, 3, 1}}, large}, overlapping,
         Rational(exact(huge) - Rational(1, 2)));
  worked({{{-0.0, 0, -1}, {0, -0.0, -0.0}, {-1, 0, -1}}, {{-0.0, 0.0, -0.0}, {1, 1, 1}}}, touching, 0);
}

CONTRACT("triangle_aabb: the formula in double is that in exact arithmetic where its contract says so", t, box) {
  const Vector3d axes[]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Vector3d displacements[]{t.b - t.a, t.c - t.b, t.a - t.c};
  const Exactly a = rational(t.a), b = rational(t.b), c = rational(t.c);
  const Exactly exact_ways[]{b - a, c - b, a - c};
  Projected shapes(t, box);
  for (const Vector3d& axis : axes) {
    const Exactly e = rational({axis.x, axis.y, axis.z});
    shapes.along(axis, e, e);
    for (std::size_t i = 0; i < 3; ++i) {
      const Exactly n = cross(e, exact_ways[i]);
      shapes.along(cross(axis, displacements[i]), n, magnitudes(n));
    }
  }
  const Exactly v = magnitudes(exact_ways[0]), w = magnitudes(exact_ways[1]);
  shapes.along(cross(displacements[0], displacements[1]), cross(exact_ways[0], exact_ways[1]),
               {Rational(v.y * w.z + v.z * w.y), Rational(v.z * w.x + v.x * w.z), Rational(v.x * w.y + v.y * w.x)});
  if (!shapes.certain) return true;
  const Contact expected = shapes.separated ? disjoint : overlapping;
  return answer == expected && truth.answer == (expected == overlapping && flat(box) ? touching : expected);
}

}  // namespace touchstone::proptests::triangle_aabb_tests
