// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "oracle/certificates/check_solids.h"

/// The relation of the solids within two closed meshes. The checks, and why they prove it:
///
/// A tree of planes cuts space into convex cells. Each cell carries the parts of faces in it: if the cell is cut, the
/// part in front of the plane and the part behind it. If nothing is left of any face of a solid, the cell is inside or
/// outside of it as one of its points is. So if each cell has such a point that is outside of one solid, no cell has a
/// point of both. For disjoint solids cells are closed, and a part counts though it is only on the plane. For touching
/// ones they are open: a part counts that has a point strictly on the side; faces without area do not count, because
/// they leave a cell in one piece. The planes themselves hold no set that is open, so no point is in both interiors.
namespace touchstone::certify {
namespace {

using Solids = std::array<Mesh, 2>;
using Polygon = std::vector<Triple>;
const Triple zero{0, 0, 0};

/// The indices of the vertices that faces use.
std::set<std::size_t> named(const Mesh& mesh) {
  std::set<std::size_t> found;
  for (const auto& face : mesh.faces) found.insert(face.begin(), face.end());
  return found;
}

/// The box around the vertices that faces use.
Box box_around(const Mesh& mesh) {
  Box box;
  for (const std::size_t i : named(mesh)) {
    const Triple& p = mesh.vertices[i];
    const std::vector<Rational> at{p.x, p.y, p.z};
    if (box.min.empty()) box = {at, at};
    for (std::size_t k = 0; k < 3; ++k) {
      box.min[k] = std::min(box.min[k], at[k]);
      box.max[k] = std::max(box.max[k], at[k]);
    }
  }
  return box;
}

struct HalfSpace {
  Plane plane;
  int side;  ///< 1 in front, -1 behind
  int where(const Triple& p) const { return side * sgn(plane.at(p)); }
};

struct Cell {
  std::vector<HalfSpace> bounds;
  std::array<std::vector<Polygon>, 2> pieces;  ///< convex parts of the faces of each solid in it
};

/// The part of a convex polygon in the closed half-space.
Polygon clipped(const Polygon& polygon, const HalfSpace& half) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Triple &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    if (half.where(p) >= 0) kept.push_back(p);
    if (half.where(p) * half.where(q) >= 0) continue;
    const Rational from = half.plane.at(p), to = half.plane.at(q);
    kept.push_back(along(p, Rational(from / (from - to)), q - p));
  }
  return kept;
}

/// least: 0 if cells are closed, 1 if they are open.
Cell part(const Cell& cell, const HalfSpace& half, int least) {
  Cell found{cell.bounds, {}};
  found.bounds.push_back(half);
  for (const std::size_t solid : {0, 1}) {
    for (const Polygon& piece : cell.pieces[solid]) {
      const auto counts = [&](const Triple& p) { return half.where(p) >= least; };
      if (std::any_of(piece.begin(), piece.end(), counts)) found.pieces[solid].push_back(clipped(piece, half));
    }
  }
  return found;
}

Cell all_of_space(const Solids& solids, int least) {
  Cell found;
  for (const std::size_t solid : {0, 1}) {
    for (const auto& [i, j, k] : solids[solid].faces) {
      const Triple &a = solids[solid].vertices[i], &b = solids[solid].vertices[j], &c = solids[solid].vertices[k];
      if (least == 0 || !(cross(b - a, c - a) == zero)) found.pieces[solid].push_back({a, b, c});
    }
  }
  return found;
}

void expect_partition(const Claim& claim, const Solids& solids, int least) {
  const std::vector<Rational> tree = claim.list("tree"), planes = claim.list("planes"), points = claim.list("points");
  const std::vector<Claim> outside = claim.proofs("outside");
  const auto cuts = static_cast<std::size_t>(std::count(tree.begin(), tree.end(), 2));
  expect(planes.size() == 4 * cuts && points.size() == 3 * outside.size() && tree.size() == cuts + outside.size(),
         "certificate: planes, points and proofs are not those of the tree");
  std::vector<Cell> left{all_of_space(solids, least)};
  std::size_t cut = 0, end = 0;
  for (const Rational& node : tree) {
    expect(!left.empty(), "certificate: the tree goes on after its end");
    const Cell cell = std::move(left.back());
    left.pop_back();
    if (node == 2) {
      const Plane plane{{planes[cut], planes[cut + 1], planes[cut + 2]}, Rational(-planes[cut + 3])};
      left.push_back(part(cell, {plane, -1}, least)), left.push_back(part(cell, {plane, 1}, least)), cut += 4;
      continue;
    }
    const std::size_t solid = index(node, 2);
    const Triple p{points[3 * end], points[3 * end + 1], points[3 * end + 2]};
    expect(cell.pieces[solid].empty(), "certificate: a face enters a cell");
    for (const HalfSpace& half : cell.bounds) expect(half.where(p) > 0, "certificate: a point is not in its cell");
    expect(proved_location(outside[end], solids[solid], p) == "outside", "certificate: a cell is not outside");
    ++end;
  }
  expect(left.empty(), "certificate: the tree ends too early");
}

void expect_common_point(const Claim& claim, const Solids& solids, bool inside) {
  const Triple p = triple(claim, "point");
  for (const std::size_t solid : {0, 1}) {
    const std::vector<Claim> proof = claim.proofs(solid == 0 ? "in_a" : "in_b");
    expect(proof.size() == 1, "certificate: one proof for each solid");
    const std::string location = proved_location(proof[0], solids[solid], p);
    if (inside) expect(location == "inside", "certificate: the point is not inside of both");
    else expect(location != "outside", "certificate: the point is not in both");
  }
}

/// A vertex that a face uses is inside of the other solid, or none is.
std::string proved_step(const Claim& claim, const Solids& solids) {
  const std::vector<Rational> vertex = claim.list("vertex");
  const std::vector<Claim> proof = claim.proofs("vertices");
  if (!vertex.empty()) {
    expect(vertex.size() == 2 && proof.size() == 1, "certificate: one vertex and its proof");
    const std::size_t solid = index(vertex[0], 2), i = index(vertex[1], solids[solid].vertices.size());
    expect(named(solids[solid]).count(i) == 1, "certificate: no face names the vertex");
    const std::string location = proved_location(proof[0], solids[1 - solid], solids[solid].vertices[i]);
    expect(location == "inside", "certificate: the vertex is not inside");
    return "vertex_inside";
  }
  const std::array places{named(solids[0]), named(solids[1])};
  expect(proof.size() == places[0].size() + places[1].size(), "certificate: a proof for each vertex");
  std::size_t next = 0;
  for (const std::size_t solid : {0, 1}) {
    for (const std::size_t i : places[solid]) {
      const std::string location = proved_location(proof[next++], solids[1 - solid], solids[solid].vertices[i]);
      expect(location != "inside", "certificate: a vertex is inside");
    }
  }
  return "edge_against_face";
}

bool meet(const Box& a, const Box& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a.max[k] < b.min[k] || b.max[k] < a.min[k]) return false;
  return true;
}

/// The proved relation, and the step that decides.
std::pair<std::string, std::string> proved(const Claim& claim, const Solids& solids) {
  const Box a = box_around(solids[0]), b = box_around(solids[1]);
  if (claim.kind() == "separating_axis") {
    claim.facts({"axis", "value"});
    const std::size_t axis = index(claim.single("axis"), 3);
    const Rational value = claim.single("value");
    const bool between = (a.max[axis] < value && value < b.min[axis]) || (b.max[axis] < value && value < a.min[axis]);
    expect(between, "certificate: the value is not between the boxes");
    return {"disjoint", "bounding_volumes"};
  }
  const bool disjoint = claim.kind() == "partition", touching = claim.kind() == "touching";
  expect(disjoint || touching || claim.kind() == "common_interior_point", wrong_kind);
  if (disjoint) claim.facts({"tree", "planes", "points", "outside"});
  if (touching) claim.facts({"point", "in_a", "in_b", "tree", "planes", "points", "outside", "vertex", "vertices"});
  if (!disjoint && !touching) claim.facts({"point", "in_a", "in_b", "vertex", "vertices"});
  expect(meet(a, b), "certificate: the boxes do not meet");
  if (!disjoint) expect_common_point(claim, solids, !touching);
  if (disjoint || touching) expect_partition(claim, solids, touching ? 1 : 0);
  if (disjoint) return {"disjoint", "edge_against_face"};  // a vertex inside would be common
  return {touching ? "touching" : "overlapping", proved_step(claim, solids)};
}

Mesh solid(const json& value, const std::string& what) {
  Mesh found = mesh(value, what);
  expect_even(found, what);
  return found;
}

void check_polyhedron_polyhedron(const Claim& claim) {
  claim.inputs({"a", "b"});
  Mesh a = solid(claim.input["a"], "a"), b = solid(claim.input["b"], "b");
  claim.answers({"relation", "decided_by"});
  const auto [relation, step] = proved(claim, {std::move(a), std::move(b)});
  expect(claim.word("relation") == relation, "truth: relation is wrong");
  expect(claim.word("decided_by") == step, "truth: decided_by is wrong");
}

}  // namespace

Checks checks_of_polyhedron_pairs() { return {{"polyhedron_polyhedron", check_polyhedron_polyhedron}}; }

}  // namespace touchstone::certify
