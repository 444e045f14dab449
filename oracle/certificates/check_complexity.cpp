// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "oracle/certificates/check_meshes.h"

namespace touchstone::certify {
namespace {

using Vertex = std::size_t;
using Face = std::array<Vertex, 3>;
using Edge = std::pair<Vertex, Vertex>;
/// The number of faces that traverse an edge from its lesser vertex, and to it.
struct Uses {
  std::int64_t forth = 0, back = 0;
  bool odd() const { return (forth + back) % 2 != 0; }
  bool turned() const { return forth - back > 1 || back - forth > 1; }
  bool crowded() const { return forth + back > 2; }
};

bool has(const Face& face, Vertex v) { return std::find(face.begin(), face.end(), v) != face.end(); }

/// Vertices, some pairs of which are joined.
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
  Vertex root(Vertex v) {
    up_.emplace(v, v);
    while (up_[v] != v) v = up_[v];
    return v;
  }

 private:
  std::map<Vertex, Vertex> up_;
};

struct Counted {
  std::map<Edge, Uses> edges;
  Joined whole;
  std::map<Vertex, Joined> around;                // a vertex's neighbours, joined by the faces that have both
  std::set<std::array<std::size_t, 3>> of_faces;  // each face with both ends of its edges

  explicit Counted(const Mesh& mesh) {
    for (std::size_t i = 0; i < mesh.named.size(); ++i) {
      const auto& face = mesh.named[i];
      const std::size_t count = face.size();
      for (std::size_t k = 0; k < count; ++k) {
        const Vertex a = face[k], b = face[(k + 1) % count], c = face[(k + count - 1) % count];
        ++(a < b ? edges[{a, b}].forth : edges[{b, a}].back);
        whole.join(a, b), around[a].join(b, c), of_faces.insert({i, std::min(a, b), std::max(a, b)});
      }
    }
  }
  /// True if both triangles share two vertices between which one of their faces has no edge.
  bool share_a_diagonal(const Mesh& mesh, std::size_t i, std::size_t j) const {
    const auto edge_of = [&](std::size_t t, Vertex a, Vertex b) {
      return of_faces.contains({mesh.face_of[t], std::min(a, b), std::max(a, b)});
    };
    const Face &s = mesh.faces[i], &t = mesh.faces[j];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vertex a = s[k], b = s[(k + 1) % 3];
      if (has(t, a) && has(t, b) && !(edge_of(i, a, b) && edge_of(j, a, b))) return true;
    }
    return false;
  }
  json first_edge(bool (Uses::*defect)() const) const {
    for (const auto& [edge, uses] : edges)
      if ((uses.*defect)()) return {edge.first, edge.second};
    return nullptr;
  }
};

std::int64_t common(const Face& s, const Face& t) {
  return std::count_if(s.begin(), s.end(), [&t](Vertex v) { return has(t, v); });
}

/// The faces of the mesh in space, each with its plane.
struct Space {
  const Mesh& mesh;
  std::vector<Plane> planes;

  explicit Space(const Mesh& of) : mesh(of) {
    for (const Face& face : mesh.faces) {
      const Triple &a = mesh.vertices[face[0]], normal = cross(mesh.vertices[face[1]] - a, mesh.vertices[face[2]] - a);
      planes.push_back({normal, Rational(-dot(normal, a))});
    }
  }
  int side(const Plane& plane, Vertex v) const { return sgn(plane.at(mesh.vertices[v])); }

  /// True if all corners of t except the common ones are on one side of the plane of face i.
  bool beside(std::size_t i, const Face& t) const {
    int side_of_t = 0;
    for (const Vertex v : t) {
      if (has(mesh.faces[i], v)) continue;
      const int here = side(planes[i], v);
      if (here == 0 || here == -side_of_t) return false;
      side_of_t = here;
    }
    return side_of_t != 0;
  }
  /// True if the plane perpendicular to the normal through the farthest corner of s has t on its other side, and one of
  /// the two has only common corners on it: these span the intersection.
  bool held_apart(const Triple& normal, const Face& s, const Face& t) const {
    const auto along = [&](Vertex v) { return dot(normal, mesh.vertices[v]); };
    const Rational top = std::max({along(s[0]), along(s[1]), along(s[2])}),
                   bottom = std::min({along(t[0]), along(t[1]), along(t[2])});
    const auto only_common = [&](const Face& f, const Face& other) {
      return std::all_of(f.begin(), f.end(), [&](Vertex v) { return along(v) != top || has(other, v); });
    };
    return top < bottom || (top == bottom && (only_common(s, t) || only_common(t, s)));
  }
  /// True if one of these planes, with the normal along an axis, does that.
  bool across_an_axis(const Face& s, const Face& t) const {
    const Triple x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    return held_apart(x, s, t) || held_apart(y, s, t) || held_apart(z, s, t) || held_apart(x, t, s) ||
           held_apart(y, t, s) || held_apart(z, t, s);
  }
};

/// Numbers of a fact, several at a time.
class Given {
 public:
  Given(const Claim& claim, const char* fact) : name_(std::string("certificate.") + fact), values_(claim.list(fact)) {}
  const Rational& next() {
    expect(used_ < values_.size(), name_ + ": more are needed");
    return values_[used_++];
  }
  Triple next_triple() {
    const Rational x = next(), y = next();
    return {x, y, next()};
  }
  void expect_used() const { expect(used_ == values_.size(), name_ + ": fewer are needed"); }

 private:
  std::string name_;
  std::vector<Rational> values_;
  std::size_t used_ = 0;
};

/// The pair of faces that the truth names, or none.
std::optional<Edge> named_pair(const Claim& claim, std::size_t faces) {
  if (!claim.truth.is_object() || !claim.truth.contains("meeting_faces")) return std::nullopt;
  const json& pair = claim.truth["meeting_faces"];
  const auto index = [faces](const json& n) { return n.is_number_unsigned() && n.get<std::uint64_t>() < faces; };
  const bool there = pair.is_array() && pair.size() == 2 && index(pair[0]) && index(pair[1]) && pair[0] < pair[1];
  expect(there, "truth: meeting_faces is wrong");
  return Edge{pair[0].get<std::size_t>(), pair[1].get<std::size_t>()};
}

/// Requires that the weights give one point of both triangles, which common corners and common edges of their faces do
/// not span.
void expect_meeting(const Space& space, const Counted& counted, std::size_t i, std::size_t j, Given& weights) {
  const Face &s = space.mesh.faces[i], &t = space.mesh.faces[j];
  const auto point = [&](const Face& f, const Face& other, bool& beyond) {
    Rational sum;
    Triple combination{0, 0, 0};
    std::int64_t positive = 0;
    for (const Vertex v : f) {
      const Rational& weight = weights.next();
      expect(sgn(weight) >= 0, "certificate: a weight is negative");
      sum += weight, combination = along(combination, weight, space.mesh.vertices[v]), positive += sgn(weight) > 0;
      beyond = beyond || (sgn(weight) > 0 && !has(other, v));
    }
    expect(sum == 1, "certificate: the weights do not sum to 1");
    beyond = beyond || (positive == 2 && common(s, t) == 2 && counted.share_a_diagonal(space.mesh, i, j));
    return combination;
  };
  bool beyond = common(s, t) == 3;
  const Triple of_s = point(s, t, beyond), of_t = point(t, s, beyond);
  expect(of_s == of_t, "certificate: the weights give two points");
  expect(beyond, "certificate: the faces share the point");
}

/// The triangles of each face.
std::vector<std::vector<std::size_t>> cuts(const Mesh& mesh) {
  std::vector<std::vector<std::size_t>> found(mesh.named.size());
  for (std::size_t t = 0; t < mesh.faces.size(); ++t) found[mesh.face_of[t]].push_back(t);
  return found;
}

/// Requires that triangles i and j of two faces have nothing in common except corners and edges of both.
void expect_apart(const Space& space, const Counted& counted, std::size_t i, std::size_t j, Given& normals) {
  const Face &s = space.mesh.faces[i], &t = space.mesh.faces[j];
  const std::string both =
      "faces " + std::to_string(space.mesh.face_of[i]) + " and " + std::to_string(space.mesh.face_of[j]);
  expect(common(s, t) < 3, "certificate: " + both + " coincide");
  expect(!counted.share_a_diagonal(space.mesh, i, j), "certificate: " + both + " share a diagonal");
  if (space.across_an_axis(s, t) || space.beside(i, t) || space.beside(j, s)) return;
  expect(space.held_apart(normals.next_triple(), s, t), "certificate.normals: " + both + " are not held apart");
}

/// For faces with areas: the first pair in the order of their indices that meets beyond what both share. If faces are
/// triangulated, `triangles` names one of each.
json first_meeting(const Claim& claim, const Space& space, const Counted& counted, Given& normals, Given& weights) {
  const Mesh& mesh = space.mesh;
  const auto triangles = cuts(mesh);
  const std::optional<Edge> named = named_pair(claim, mesh.named.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < triangles.size(); ++j) {
      if (named == Edge{i, j}) {
        std::size_t s = triangles[i][0], t = triangles[j][0];
        if (claim.input["mesh"].contains("cut")) {
          Given places(claim, "triangles");
          const Rational first = places.next(), second = places.next();
          places.expect_used();
          const auto find = [](const std::vector<std::size_t>& all, const Rational& place) {
            const auto found =
                std::find_if(all.begin(), all.end(), [&](std::size_t n) { return place == Rational(n); });
            expect(found != all.end(), "certificate.triangles: none of the face");
            return *found;
          };
          s = find(triangles[i], first), t = find(triangles[j], second);
        }
        expect_meeting(space, counted, s, t, weights);
        return {i, j};
      }
      for (const std::size_t s : triangles[i])
        for (const std::size_t t : triangles[j]) expect_apart(space, counted, s, t, normals);
    }
  }
  return nullptr;
}

json first_splitting_face(const Space& space, const Counted& counted) {
  for (std::size_t i = 0; i < space.planes.size(); ++i) {
    std::map<int, Vertex> first;
    for (const auto& [v, neighbours] : counted.around) first.emplace(space.side(space.planes[i], v), v);
    if (!first.contains(1) || !first.contains(-1)) continue;
    return {{"face", space.mesh.face_of[i]},
            {"one", std::min(first[1], first[-1])},
            {"other", std::max(first[1], first[-1])}};
  }
  return nullptr;
}

/// In the order of their first faces.
std::vector<std::vector<Face>> components(const Mesh& mesh, Counted& counted) {
  std::vector<std::vector<Face>> found;
  std::map<Vertex, std::size_t> numbers;
  for (const Face& face : mesh.faces) {
    const auto [number, added] = numbers.emplace(counted.whole.root(face[0]), found.size());
    if (added) found.emplace_back();
    found[number->second].push_back(face);
  }
  return found;
}

/// True if the ray from the point in the next direction crosses an odd number of the faces; a point outside of the box
/// of all of them is outside.
bool inside(const Mesh& mesh, const std::vector<Face>& faces, const Triple& p, Given& directions) {
  for (Rational Triple::*axis : {&Triple::x, &Triple::y, &Triple::z}) {
    bool above_some = false, below_some = false;
    for (const Face& face : faces) {
      for (const Vertex v : face) {
        above_some = above_some || mesh.vertices[v].*axis <= p.*axis;
        below_some = below_some || mesh.vertices[v].*axis >= p.*axis;
      }
    }
    if (!above_some || !below_some) return false;
  }
  const Triple direction = directions.next_triple();
  bool odd = false;
  for (const Face& f : faces) {
    const auto& v = mesh.vertices;
    odd ^= crossing({v[f[0]] - p, v[f[1]] - p, v[f[2]] - p}, direction).has_value();
  }
  return odd;
}

json nesting(const Mesh& mesh, const std::vector<std::vector<Face>>& components, Given& directions) {
  json found = json::array();
  for (std::size_t i = 0; i < components.size(); ++i) {
    for (std::size_t j = 0; j < components.size(); ++j) {
      const bool within = i != j && inside(mesh, components[i], mesh.vertices[components[j][0][0]], directions);
      if (within) found.push_back({i, j});
    }
  }
  return found;
}

std::string sign_of_volume(const Mesh& mesh) {
  Rational sum;
  for (const Face& face : mesh.faces)
    sum += dot(mesh.vertices[face[0]], cross(mesh.vertices[face[1]], mesh.vertices[face[2]]));
  return sgn(sum) > 0 ? "positive" : sgn(sum) < 0 ? "negative" : "zero";
}

void check_polyhedron_complexity(const Claim& claim) {
  claim.inputs({"mesh"});
  const Mesh surface = mesh(claim.input["mesh"], "mesh");
  claim.expect_kind("complexity");
  const bool cut = claim.input["mesh"].contains("cut");
  if (cut) claim.facts({"normals", "common_point", "directions", "triangles"});
  else claim.facts({"normals", "common_point", "directions"});
  Counted counted(surface);
  const Space space(surface);
  const auto parts = components(surface, counted);
  json pinched, flat;
  for (auto& [vertex, neighbours] : counted.around)
    if (pinched.is_null() && neighbours.parts() != 1) pinched = vertex;
  for (std::size_t i = 0; i < space.planes.size() && flat.is_null(); ++i)
    if (space.planes[i].normal == Triple{0, 0, 0}) flat = surface.face_of[i];
  const json open = counted.first_edge(&Uses::odd), turned = counted.first_edge(&Uses::turned),
             crowded = counted.first_edge(&Uses::crowded);
  Given normals(claim, "normals"), weights(claim, "common_point"), directions(claim, "directions");
  const json meeting = flat.is_null() ? first_meeting(claim, space, counted, normals, weights) : json();
  if (cut && meeting.is_null()) Given(claim, "triangles").expect_used();
  const bool embedded = flat.is_null() && meeting.is_null(), solid = embedded && open.is_null();
  const json splitting = solid ? first_splitting_face(space, counted) : json(),
             nested = solid ? nesting(surface, parts, directions) : json();
  normals.expect_used(), weights.expect_used(), directions.expect_used();
  const std::size_t vertices = counted.around.size(), edges = counted.edges.size(), faces = surface.named.size();
  const Rational euler = Rational(vertices) - Rational(edges) + Rational(faces);
  const std::vector<std::pair<const char*, json>> answers{
      {"vertices", vertices},
      {"edges", edges},
      {"faces", faces},
      {"components", parts.size()},
      {"euler", euler.get_str()},
      {"volume", open.is_null() && turned.is_null() ? sign_of_volume(surface) : "none"},
      {"closed", open.is_null()},
      {"oriented", turned.is_null()},
      {"edge_manifold", crowded.is_null()},
      {"vertex_manifold", crowded.is_null() && pinched.is_null()},
      {"embedded", embedded},
      {"convex", solid && splitting.is_null()},
      {"open_edge", open},
      {"turned_edge", turned},
      {"crowded_edge", crowded},
      {"pinched_vertex", pinched},
      {"flat_face", flat},
      {"meeting_faces", meeting},
      {"splitting_face", splitting},
      {"nesting", nested}};
  expect(claim.truth.is_object(), "truth: an object");
  std::size_t there = 0;
  for (const auto& [name, answer] : answers) {
    const auto given = claim.truth.find(name);
    const bool right = given == claim.truth.end() ? answer.is_null() : given->dump() == answer.dump();
    expect(right, std::string("truth: ") + name + " is wrong");
    there += !answer.is_null();
  }
  expect(claim.truth.size() == there, "truth: an unexpected field");
}

}  // namespace

Checks checks_of_complexity() { return {{"polyhedron_complexity", check_polyhedron_complexity}}; }

}  // namespace touchstone::certify
