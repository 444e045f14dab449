// SPDX-License-Identifier: Apache-2.0
#include <map>
#include <set>
#include <string>
#include <utility>

#include "oracle/certificates/check_meshes.h"

namespace touchstone::certify {
namespace {

using Vertex = std::size_t;
/// How many faces run along an edge from its lesser vertex, and to it.
struct Uses {
  long forth = 0, back = 0;
  bool odd() const { return (forth + back) % 2 != 0; }
  bool turned() const { return forth - back > 1 || back - forth > 1; }
  bool crowded() const { return forth + back > 2; }
};

/// Vertices of which some pairs are joined.
class Joined {
 public:
  void join(Vertex a, Vertex b) {
    const Vertex p = root(a), q = root(b);
    up_[p] = q;
  }
  std::size_t parts() {
    std::set<Vertex> roots;
    for (const auto& [vertex, above] : std::map<Vertex, Vertex>(up_)) roots.insert(root(vertex));
    return roots.size();
  }

 private:
  Vertex root(Vertex v) {
    up_.emplace(v, v);
    while (up_[v] != v) v = up_[v];
    return v;
  }
  std::map<Vertex, Vertex> up_;
};

struct Counted {
  std::map<std::pair<Vertex, Vertex>, Uses> edges;
  Joined whole;
  std::map<Vertex, Joined> around;  // a vertex's neighbours, joined by the faces that have both
};

Counted counted(const Mesh& mesh) {
  Counted found;
  for (const auto& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex a = face[k], b = face[(k + 1) % 3], c = face[(k + 2) % 3];
      ++(a < b ? found.edges[{a, b}].forth : found.edges[{b, a}].back);
      found.whole.join(a, b), found.around[a].join(b, c);
    }
  }
  return found;
}

/// The word is false where an edge is named, which has to be one for which it is false; else true for all edges.
void expect_word(const Claim& claim, const char* word, const char* fact, bool (Uses::*defect)() const,
                 const Counted& found) {
  const std::vector<Rational> named = claim.list(fact);
  bool whole = true;
  for (const auto& [edge, uses] : found.edges) {
    if (!(uses.*defect)()) continue;
    whole = false;
    if (named == std::vector<Rational>{Rational(edge.first), Rational(edge.second)}) {
      expect(claim.truth[word] == false, std::string("truth: ") + word + " is wrong");
      return;
    }
  }
  expect(named.empty(), std::string("certificate.") + fact + ": no such edge");
  expect(whole, std::string("certificate.") + fact + ": there is one");
  expect(claim.truth[word] == true, std::string("truth: ") + word + " is wrong");
}

void expect_count(const Claim& claim, const char* name, std::size_t count) {
  expect(claim.truth[name] == count, std::string("truth: ") + name + " is wrong");
}

void check_polyhedron_complexity(const Claim& claim) {
  claim.inputs({"mesh"});
  const Mesh surface = mesh(claim.input["mesh"], "mesh");
  Counted found = counted(surface);
  claim.answers(
      {"vertices", "edges", "faces", "components", "euler", "closed", "oriented", "edge_manifold", "vertex_manifold"});
  expect(claim.kind() == "complexity", "certificate: no such kind for this truth");
  claim.facts({"open_edge", "turned_edge", "crowded_edge", "pinched_vertex"});
  const std::size_t vertices = found.around.size(), edges = found.edges.size(), faces = surface.faces.size();
  expect_count(claim, "vertices", vertices), expect_count(claim, "edges", edges), expect_count(claim, "faces", faces);
  expect_count(claim, "components", found.whole.parts());
  expect(exact_value(claim.truth["euler"], "truth.euler") == Rational(vertices) - Rational(edges) + Rational(faces),
         "truth: euler is wrong");
  expect_word(claim, "closed", "open_edge", &Uses::odd, found);
  expect_word(claim, "oriented", "turned_edge", &Uses::turned, found);
  expect_word(claim, "edge_manifold", "crowded_edge", &Uses::crowded, found);
  const std::vector<Rational> named = claim.list("pinched_vertex");
  bool whole = true, there = false;
  for (auto& [vertex, neighbours] : found.around) {
    if (neighbours.parts() == 1) continue;
    whole = false, there = there || named == std::vector<Rational>{Rational(vertex)};
  }
  expect(there || named.empty(), "certificate.pinched_vertex: no such vertex");
  expect(there || whole, "certificate.pinched_vertex: there is one");
  expect(claim.truth["vertex_manifold"] == (whole && claim.truth["edge_manifold"] == true),
         "truth: vertex_manifold is wrong");
}

}  // namespace

Checks checks_of_complexity() { return {{"polyhedron_complexity", check_polyhedron_complexity}}; }

}  // namespace touchstone::certify
