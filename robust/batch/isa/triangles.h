// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/kernels.h"

/// Filters of triangles in space: the model and the constants of kernels.h. The sides of planes, and with them the
/// filters' answers, are proved by machine from this text (robust/proofs/lane_faces.v, lane_triangles.v,
/// lane_triangle_triangle.v).
namespace touchstone::robust::batch::isa {
namespace {

struct InSpace {
  Lanes x, y, z;
  explicit InSpace(const Lanes* c) : x(c[0]), y(c[1]), z(c[2]) {}
  InSpace(Lanes x, Lanes y, Lanes z) : x(x), y(y), z(z) {}
  friend InSpace operator-(const InSpace& a, const InSpace& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};

/// The lanes whose value is certainly positive, and certainly negative.
struct Certain {
  Mask positive, negative;
  Mask known() const { return positive | negative; }
};
Mask alike(const Certain& s, const Certain& t) { return (s.positive & t.positive) | (s.negative & t.negative); }

/// The plane through three points, and the side of it on which others lie: positive if a, b, c are seen
/// counter-clockwise.
///
/// The bound is that of point_in_convex_solid, with its C: eight roundings of six products, the last of them shared.
/// The sums of the magnitudes of the normal's terms are 2^-1000 too large, which covers underflow in the normal. The
/// terms are at least the value, and so is every partial sum of them: if anything in the value overflows, so does the
/// bound. An infinite or NaN coordinate makes a difference infinite or NaN, and every difference is in the terms.
class FacePlane {
 public:
  FacePlane(const InSpace& a, const InSpace& b, const InSpace& c) : origin_(a), normal_(a), terms_(a) {
    const InSpace s = b - a, t = c - a;
    const auto coordinate = [](Lanes p, Lanes q, Lanes r, Lanes w, Lanes& sum) {
      const Lanes first = p * q, second = r * w;
      sum = magnitude(first) + magnitude(second) + same(tiny);
      return first - second;
    };
    normal_.x = coordinate(s.y, t.z, s.z, t.y, terms_.x);
    normal_.y = coordinate(s.z, t.x, s.x, t.z, terms_.y);
    normal_.z = coordinate(s.x, t.y, s.y, t.x, terms_.z);
  }

  Certain side(const InSpace& p) const { return leading(p - origin_); }

  /// The same for a displacement: the side to which it leads.
  Certain leading(const InSpace& d) const {
    const Lanes value = normal_.x * d.x + normal_.y * d.y + normal_.z * d.z;
    const Lanes terms = terms_.x * magnitude(d.x) + terms_.y * magnitude(d.y) + terms_.z * magnitude(d.z);
    const Lanes bound = multiply_add(terms, same(8 * v), same(tiny));
    const Mask known = above(magnitude(value), bound), below = negative(value);
    return {known & ~below, known & below};
  }

 private:
  InSpace origin_, normal_, terms_;
};

/// Places the crossing of a line with a triangle's plane: inside the triangle if the line has all three edges on one
/// side; outside if it has two of them on different sides.
struct Edges {
  Mask inside, outside;
  Edges(const Certain& ab, const Certain& bc, const Certain& ca)
      : inside((ab.positive & bc.positive & ca.positive) | (ab.negative & bc.negative & ca.negative)),
        outside((ab.positive | bc.positive | ca.positive) & (ab.negative | bc.negative | ca.negative)) {}
};

/// The filter stage: stages::segment_triangle::decision::filter.
struct SegmentTriangle {
  static constexpr std::size_t columns = 15;
  static constexpr std::uint8_t set = 1, clear = 0;  // point, none
  static Verdict of(const Lanes* n) {
    const InSpace p(n), q(n + 3), a(n + 6), b(n + 9), c(n + 12);
    const FacePlane plane(a, b, c);
    const Certain at_p = plane.side(p), at_q = plane.side(q);
    const Edges edges(FacePlane(p, q, a).side(b), FacePlane(p, q, b).side(c), FacePlane(p, q, c).side(a));
    const Mask certain = at_p.known() & at_q.known(), apart = alike(at_p, at_q);
    return {certain & (apart | edges.inside | edges.outside), edges.inside & ~apart};
  }
};

/// The filter stage: stages::ray_triangle::decision::filter.
struct RayTriangle {
  static constexpr std::size_t columns = 15;
  static constexpr std::uint8_t set = 1, clear = 0;  // point, none
  static Verdict of(const Lanes* n) {
    const InSpace p(n), way(n + 3), a(n + 6), b(n + 9), c(n + 12);
    const FacePlane plane(a, b, c);
    const Certain at_origin = plane.side(p), rise = plane.leading(way);
    const Edges edges(FacePlane(p, a, b).leading(way), FacePlane(p, b, c).leading(way),
                      FacePlane(p, c, a).leading(way));
    const Mask certain = at_origin.known() & rise.known(), apart = alike(at_origin, rise);
    return {certain & (apart | edges.inside | edges.outside), edges.inside & ~apart};
  }
};

/// If all corners of one are certainly on one side of the other's plane, the triangles have nothing in common. If each
/// plane certainly has corners of the other triangle on both sides and none on itself, the triangles meet if an edge of
/// one crosses the other, and then in a segment. An edge crosses if its ends are on different sides of the plane and
/// all edges of the other are on one side of its line. The sides of all pairs of edges serve both.
struct TriangleTriangle {
  static constexpr std::size_t columns = 18;
  static constexpr std::uint8_t set = 2, clear = 0;  // segment, none
  static Verdict of(const Lanes* n) {
    const InSpace a[] = {InSpace(n), InSpace(n + 3), InSpace(n + 6)};
    const InSpace b[] = {InSpace(n + 9), InSpace(n + 12), InSpace(n + 15)};
    const FacePlane of_a(a[0], a[1], a[2]), of_b(b[0], b[1], b[2]);
    const Certain at_a[] = {of_a.side(b[0]), of_a.side(b[1]), of_a.side(b[2])};
    const Certain at_b[] = {of_b.side(a[0]), of_b.side(a[1]), of_b.side(a[2])};
    const Mask apart =
        (alike(at_a[0], at_a[1]) & alike(at_a[0], at_a[2])) | (alike(at_b[0], at_b[1]) & alike(at_b[0], at_b[2]));
    const Mask certain =
        at_a[0].known() & at_a[1].known() & at_a[2].known() & at_b[0].known() & at_b[1].known() & at_b[2].known();
    if ((certain & ~apart) == 0) return {apart, 0};
    Certain sides[3][3];  // for edge i of a and edge j of b
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) sides[i][j] = FacePlane(a[i], a[(i + 1) % 3], b[j]).side(b[(j + 1) % 3]);
    Mask crosses = 0, passes = all_lanes;
    for (std::size_t k = 0; k < 3; ++k) {
      const Edges a_edge(sides[k][0], sides[k][1], sides[k][2]), b_edge(sides[0][k], sides[1][k], sides[2][k]);
      const Mask a_beside = alike(at_b[k], at_b[(k + 1) % 3]), b_beside = alike(at_a[k], at_a[(k + 1) % 3]);
      crosses |= (a_edge.inside & ~a_beside) | (b_edge.inside & ~b_beside);
      passes &= (a_edge.outside | a_beside) & (b_edge.outside | b_beside);
    }
    return {apart | (certain & (crosses | passes)), crosses & ~apart};
  }
};

}  // namespace
}  // namespace touchstone::robust::batch::isa
