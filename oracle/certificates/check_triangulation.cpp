// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <utility>

#include "oracle/certificates/check_rings.h"

/// A simple polygon cut into convex pieces. The checks, and why they prove it:
///
/// Every piece is a convex ring, counter-clockwise and of positive area, so its winding number is 1 for each point
/// inside and 0 for those outside. Each edge of the polygon, taken counter-clockwise, is an edge of exactly one piece,
/// and every other edge of a piece is, reversed, an edge of exactly one other piece. So the edges of all pieces
/// together are those of the polygon and pairs that cancel, and for any point off all edges the winding numbers of the
/// pieces add up to that of the polygon. That is 1 inside it and 0 outside, because it is simple and counter-clockwise.
/// Hence each point inside is in exactly one piece and each point outside in none: the pieces are the polygon, no two
/// interiors meet, and every diagonal is inside. (The areas then add up; this is also checked.)
namespace touchstone::certify {
namespace {

using Piece = std::vector<std::size_t>;
using Edge = std::pair<std::size_t, std::size_t>;

std::vector<Piece> pieces(const Claim& claim, const char* name, const Ring& ring) {
  claim.answers({name});
  const std::string what = std::string("truth.") + name;
  const json& listed = claim.truth[name];
  expect(listed.is_array(), what + ": a list");
  std::vector<Piece> found;
  for (const json& list : listed) {
    expect(list.is_array() && list.size() >= 3, what + ": a list of at least three in each place");
    Piece piece;
    for (const json& index : list) {
      expect(index.is_number_unsigned() && index.get<std::uint64_t>() < ring.size(), what + ": not an index");
      piece.push_back(index.get<std::size_t>());
    }
    expect(std::set<std::size_t>(piece.begin(), piece.end()).size() == piece.size(),
           "truth: a vertex twice in a piece");
    found.push_back(std::move(piece));
  }
  return found;
}

/// Requires that every vertex is on the left of every edge or on it, and some vertex is not on it. So each edge lies on
/// the boundary of the convex hull, in its direction, and because no vertex repeats the ring makes one turn.
void expect_convex(const Ring& ring, const Piece& piece) {
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Ends e{ring[piece[i]], ring[piece[(i + 1) % piece.size()]]};
    bool off = false;
    for (const std::size_t p : piece) {
      const int where = side(e, ring[p]);
      expect(where >= 0, "truth: a piece is not convex and counter-clockwise");
      off = off || where > 0;
    }
    expect(off, "truth: a piece has no area");
  }
}

Rational doubled_area(const Ring& ring, const Piece& piece) {
  Rational sum;
  for (std::size_t i = 1; i + 1 < piece.size(); ++i)
    sum += cross(ring[piece[i]] - ring[piece[0]], ring[piece[i + 1]] - ring[piece[0]]);
  return sum;
}

Piece all_of(const Ring& ring) {
  Piece all;
  for (std::size_t i = 0; i < ring.size(); ++i) all.push_back(i);
  return all;
}

void expect_matched(const std::vector<Piece>& pieces, const Piece& polygon) {
  std::set<Edge> edges;
  for (const Piece& piece : pieces) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      expect(edges.insert({piece[i], piece[(i + 1) % piece.size()]}).second,
             "truth: two pieces on the same side of an edge");
    }
  }
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    expect(edges.erase({polygon[i], polygon[(i + 1) % polygon.size()]}) == 1,
           "truth: an edge of the polygon is in no piece");
  }
  for (const Edge& e : edges)
    expect(edges.count({e.second, e.first}) == 1, "truth: a piece on one side of an edge only");
}

/// Returns the pieces, proved to make up the polygon.
std::vector<Piece> proved(const Claim& claim, const char* name, const Ring& ring) {
  expect_simple(ring, "polygon");
  const std::vector<Piece> found = pieces(claim, name, ring);
  claim.expect_kind("pieces");
  claim.facts({"doubled_area"});
  Rational sum;
  for (const Piece& piece : found) expect_convex(ring, piece), sum += doubled_area(ring, piece);
  Piece polygon = all_of(ring);
  Rational whole = doubled_area(ring, polygon);
  if (sgn(whole) < 0) std::reverse(polygon.begin(), polygon.end()), whole = -whole;
  expect_matched(found, polygon);
  expect(claim.single("doubled_area") == whole && sum == whole, "certificate: the doubled area is wrong");
  return found;
}

void check_triangulate_polygon(const Claim& claim) {
  claim.inputs({"polygon"});
  const Ring ring = polygon(claim.input["polygon"], "polygon");
  for (const Piece& piece : proved(claim, "triangles", ring)) expect(piece.size() == 3, "truth: not a triangle");
}

/// A cut removes a reflex angle at no more than two vertices, so r of them need r / 2 + 1 pieces; 2 r + 1 are fewer
/// than four times that.
void check_convex_partition(const Claim& claim) {
  claim.inputs({"polygon"});
  const Ring ring = polygon(claim.input["polygon"], "polygon");
  const std::vector<Piece> found = proved(claim, "pieces", ring);
  const int direction = sgn(doubled_area(ring, all_of(ring)));
  std::size_t reflex = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    reflex += side(edge(ring, i), ring[(i + 2) % ring.size()]) * direction < 0;
  }
  expect(found.size() <= 2 * reflex + 1, "truth: more pieces than four times the least number");
}

}  // namespace

Checks checks_of_triangulation() {
  return {{"triangulate_polygon", check_triangulate_polygon}, {"convex_partition", check_convex_partition}};
}

}  // namespace touchstone::certify
