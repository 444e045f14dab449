// SPDX-License-Identifier: Apache-2.0
// Included by one unit for each instruction set, with TOUCHSTONE_LANES of its own.
#pragma once

#include "robust/batch/isa/vectors.h"

/// Filters of triangles in space: the model of kernels.h. Their answers are proved by machine from this text
/// (robust/proofs/lane_volumes.v, lane_triangle_lines.v, lane_triangle_triangle.v).
///
/// One of the points is the origin of the others. The volumes that decide are determinants of three displacements, or,
/// by the identity of five points, sums of four of these.
///
/// Let X, Y, Z be the greatest magnitudes of the displacements' coordinates. A determinant has six products, each at
/// most X Y Z and off by 8 v of it: three differences, a product, a difference, a product and two sums. That is 48 v X
/// Y Z. A sum of two determinants is at most 12 X Y Z, and the last difference cannot make a sign wrong: four
/// determinants and two sums are off by 4 * 48 + 2 * 12 = 216 v. C = 256 v serves all.
///
/// The direction (x, y, z) of a ray may be of another size. With S = |x| Y Z + |y| Z X + |z| X Y, a determinant that
/// has it is at most 2 S, and off by 16 v S; the sum of three by 3 * 16 + 4 = 52 v. C = 64 v.
///
/// Only displacements and directions below 2^330 are decided, so nothing overflows. A product that underflows is off by
/// 2^-1075, times a third coordinate by 2^-745; 2^-700 pays for all of them. An infinite or NaN coordinate makes a
/// displacement infinite or NaN. greater() may lose a NaN, but each displacement is in a value that has to be certain.
namespace touchstone::robust::batch::isa {
namespace {

constexpr double most = 0x1p330, for_underflow = 0x1p-700;

/// The bound of all volumes whose displacements are at most `sizes`.
Lanes bound_of(const InSpace& sizes) {
  return multiply_add(sizes.x * sizes.y * sizes.z, same(256 * v), same(for_underflow));
}
Mask moderate(const InSpace& sizes) { return above(same(most), greatest(sizes)); }

/// Places the crossing of a line with a triangle's plane: inside the triangle if the line has all three edges on one
/// side; outside if it has two of them on different sides.
struct Edges {
  Mask inside, outside;
  Edges(Lanes ab, Lanes bc, Lanes ca, Lanes bound) {
    const Lanes least = lesser(lesser(ab, bc), ca), greatest = greater(greater(ab, bc), ca), other = same(0) - bound;
    inside = above(least, bound) | above(other, greatest);
    outside = above(greatest, bound) & above(other, least);
  }
};

/// The filter stage: stages::segment_triangle::decision::filter.
struct SegmentTriangle {
  static constexpr std::size_t columns = 15;
  static constexpr std::uint8_t set = 1, clear = 0;  // point, none
  static Verdict of(const Lanes* n) {
    const InSpace p(n), line = InSpace(n + 3) - p, a = InSpace(n + 6) - p, b = InSpace(n + 9) - p,
                        c = InSpace(n + 12) - p;
    const InSpace sizes = greater(greater(magnitudes(line), magnitudes(a)), greater(magnitudes(b), magnitudes(c)));
    const InSpace beside = cross(line, a), facing = cross(b, c);
    const Lanes ab = dot(beside, b), ac = dot(beside, c), bc = dot(facing, line), height = dot(facing, a);
    const Lanes beyond = (ab + bc) - (ac + height), bound = bound_of(sizes);
    const Edges edges(ab, bc, same(0) - ac, bound);
    const Mask certain = moderate(sizes) & above(magnitude(height), bound) & above(magnitude(beyond), bound);
    const Mask apart = negative(height) ^ negative(beyond);
    return {certain & (apart | edges.inside | edges.outside), edges.inside & ~apart};
  }
};

/// The filter stage: stages::ray_triangle::decision::filter.
struct RayTriangle {
  static constexpr std::size_t columns = 15;
  static constexpr std::uint8_t set = 1, clear = 0;  // point, none
  static Verdict of(const Lanes* n) {
    const InSpace p(n), way(n + 3), a = InSpace(n + 6) - p, b = InSpace(n + 9) - p, c = InSpace(n + 12) - p;
    const InSpace sizes = greater(greater(magnitudes(a), magnitudes(b)), magnitudes(c)), ways = magnitudes(way);
    const InSpace beside = cross(way, a), facing = cross(b, c);
    const Lanes ab = dot(beside, b), ac = dot(beside, c), bc = dot(facing, way), height = dot(facing, a);
    const Lanes rise = (ab + bc) - ac;
    const Lanes size = ways.x * (sizes.y * sizes.z) + (ways.y * sizes.z + ways.z * sizes.y) * sizes.x;
    const Lanes bound = multiply_add(size, same(64 * v), same(for_underflow));
    const Edges edges(ab, bc, same(0) - ac, bound);
    const Mask certain =
        moderate(greater(sizes, ways)) & above(magnitude(height), bound_of(sizes)) & above(magnitude(rise), bound);
    const Mask apart = negative(height) ^ negative(rise);
    return {certain & (apart | edges.inside | edges.outside), edges.inside & ~apart};
  }
};

/// If all corners of one are certainly on one side of the other's plane, the triangles have nothing in common. If all
/// fifteen volumes of four corners are certain, the triangles meet if an edge of one crosses the other, and then in a
/// segment. An edge crosses if its ends are on different sides of the plane and all edges of the other are on one side
/// of its line. The sides of all pairs of edges serve both.
///
/// The origin o is the first corner of a; p and q are its others. The volume of a pair of edges is a determinant if one
/// of these is op or qo.
struct TriangleTriangle {
  static constexpr std::size_t columns = 18;
  static constexpr std::uint8_t set = 2, clear = 0;  // segment, none
  static Verdict of(const Lanes* n) {
    const InSpace o(n), p = InSpace(n + 3) - o, q = InSpace(n + 6) - o;
    const InSpace b[] = {InSpace(n + 9) - o, InSpace(n + 12) - o, InSpace(n + 15) - o};
    const InSpace sizes_of_a = greater(magnitudes(p), magnitudes(q));
    const InSpace sizes_of_b = greater(greater(magnitudes(b[0]), magnitudes(b[1])), magnitudes(b[2]));
    const InSpace sizes = greater(sizes_of_a, sizes_of_b), normal = cross(p, q);
    const Lanes bound = bound_of(sizes), at_a[] = {dot(normal, b[0]), dot(normal, b[1]), dot(normal, b[2])};
    const Mask decidable = moderate(sizes);
    const Corners of_b(at_a, bound);
    if ((decidable & of_b.apart & all_lanes) == all_lanes) return {all_lanes, 0};
    const InSpace moments[] = {cross(b[0], b[1]), cross(b[1], b[2]), cross(b[2], b[0])};
    Lanes sides[3][3];  // of edge i of a and edge j of b
    for (std::size_t j = 0; j < 3; ++j) {
      const Lanes with_p = dot(moments[j], p), with_q = dot(moments[j], q);
      sides[0][j] = with_p, sides[2][j] = same(0) - with_q;
      sides[1][j] = (with_q - with_p) + (at_a[(j + 1) % 3] - at_a[j]);
    }
    const Lanes with_o = dot(moments[0], b[2]);
    const Lanes at_b[] = {with_o, (with_o - sides[0][0]) - (sides[0][1] + sides[0][2]),
                          (with_o + sides[2][0]) + (sides[2][1] + sides[2][2])};
    const Corners of_a(at_b, bound);
    Mask below[3][3];
    Lanes least = magnitude(sides[0][0]);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        below[i][j] = negative(sides[i][j]), least = lesser(least, magnitude(sides[i][j]));
    Mask crosses = 0;
    for (std::size_t k = 0; k < 3; ++k)
      crosses |= (of_a.differ(k, (k + 1) % 3) & ~differ(below[k][0], below[k][1], below[k][2])) |
                 (of_b.differ(k, (k + 1) % 3) & ~differ(below[0][k], below[1][k], below[2][k]));
    const Mask apart = of_a.apart | of_b.apart, certain = of_a.certain & of_b.certain & above(least, bound);
    return {decidable & (apart | certain), crosses & ~apart};
  }

 private:
  static Mask differ(Mask x, Mask y, Mask z) { return (x ^ y) | (x ^ z); }

  /// The corners of one triangle on the sides of the other's plane.
  struct Corners {
    Mask below[3], certain, apart;
    Corners(const Lanes* at, Lanes bound)
        : below{negative(at[0]), negative(at[1]), negative(at[2])},
          certain(above(magnitude(at[0]), bound) & above(magnitude(at[1]), bound) & above(magnitude(at[2]), bound)),
          apart(certain & ~TriangleTriangle::differ(below[0], below[1], below[2])) {}
    Mask differ(std::size_t i, std::size_t j) const { return below[i] ^ below[j]; }
  };
};

}  // namespace
}  // namespace touchstone::robust::batch::isa
