// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_swept_solids.h"

#include <algorithm>

#include "oracle/certificates/check_meshes.h"
#include "oracle/certificates/check_obbs.h"

namespace touchstone::certify {
namespace {

Coordinates fact(const Claim& claim, const char* name, std::size_t size) {
  Coordinates coordinates = claim.list(name);
  expect(coordinates.size() == size, std::string("certificate.") + name + ": as many coordinates as the velocity");
  return coordinates;
}

struct BoxSolid : Solid {
  explicit BoxSolid(Box of) : box(std::move(of)) {}
  bool holds(const Coordinates& p) const override { return box.holds(p); }
  Rational highest(const Coordinates& normal) const override {
    Rational sum;
    for (std::size_t k = 0; k < normal.size(); ++k) sum += normal[k] * (sgn(normal[k]) > 0 ? box.max[k] : box.min[k]);
    return sum;
  }
  Box box;
};

void check_swept_aabb_aabb(const Claim& claim) {
  claim.inputs({"a", "b", "velocity"});
  const BoxSolid a(box(claim.input["a"], "a")), b(box(claim.input["b"], "b"));
  expect(b.box.axes() == a.box.axes(), "b: as many coordinates as a");
  const json& velocity = claim.input["velocity"];
  expect(velocity.is_array() && velocity.size() == a.box.axes(), "velocity: as many coordinates as a");
  Coordinates v;
  for (const json& coordinate : velocity) v.push_back(number(coordinate, "velocity[" + std::to_string(v.size()) + "]"));
  prove_first_contact(claim, a, b, v);
}

/// The convex hull of the vertices, and the solid that the planes of the faces enclose: both are the same, see
/// check_meshes.h.
struct MeshSolid : Solid {
  MeshSolid(const Claim& claim, const char* name)
      : surface(mesh(claim.input[name], name)), planes(outward_planes(surface, name)) {}
  bool holds(const Coordinates& p) const override {
    return std::all_of(planes.begin(), planes.end(),
                       [at = Triple{p[0], p[1], p[2]}](const Plane& plane) { return sgn(plane.at(at)) <= 0; });
  }
  Rational highest(const Coordinates& normal) const override {
    const Triple n{normal[0], normal[1], normal[2]};
    Rational most = dot(n, surface.vertices[0]);
    for (const Triple& vertex : surface.vertices) most = std::max(most, dot(n, vertex));
    return most;
  }
  Mesh surface;
  std::vector<Plane> planes;
};

void check_swept_convex_polyhedra(const Claim& claim) {
  claim.inputs({"a", "b", "velocity"});
  const MeshSolid a(claim, "a"), b(claim, "b");
  const Triple velocity = point_in_space(claim.input["velocity"], "velocity");
  prove_first_contact(claim, a, b, {velocity.x, velocity.y, velocity.z});
}

/// All points between the planes of its faces: those that half axis k leads to are as far from the center as it leads
/// along the cross product of the others.
struct ObbSolid : Solid {
  explicit ObbSolid(Obb of) : box(std::move(of)) {}
  bool holds(const Coordinates& p) const override {
    const Triple way = Triple{p[0], p[1], p[2]} - box.center;
    for (std::size_t k = 0; k < 3; ++k) {
      const Triple normal = cross(box.half_axes[(k + 1) % 3], box.half_axes[(k + 2) % 3]);
      if (abs(dot(normal, way)) > abs(dot(normal, box.half_axes[k]))) return false;
    }
    return true;
  }
  Rational highest(const Coordinates& normal) const override {
    const Triple n{normal[0], normal[1], normal[2]};
    return Rational(dot(n, box.center) + box.reach(n));
  }
  Obb box;
};

void check_swept_obb_obb(const Claim& claim) {
  claim.inputs({"a", "b", "velocity"});
  const ObbSolid a(obb(claim.input["a"], "a")), b(obb(claim.input["b"], "b"));
  const Triple velocity = point_in_space(claim.input["velocity"], "velocity");
  prove_first_contact(claim, a, b, {velocity.x, velocity.y, velocity.z});
}

}  // namespace

Rational dot(const Coordinates& p, const Coordinates& q) {
  Rational sum;
  for (std::size_t k = 0; k < p.size(); ++k) sum += p[k] * q[k];
  return sum;
}

Rational Solid::lowest(Coordinates normal) const {
  for (Rational& coordinate : normal) coordinate = -coordinate;
  return Rational(-highest(normal));
}

void prove_first_contact(const Claim& claim, const Solid& a, const Solid& b, const Coordinates& velocity) {
  const std::string relation = claim.word("relation"), kind = claim.kind();
  if (relation == "never") {
    claim.answers({"relation"});
    expect(kind == "separating_axis", wrong_kind), claim.facts({"normal"});
    const Coordinates normal = fact(claim, "normal", velocity.size());
    const Rational gap(b.lowest(normal) - a.highest(normal));
    expect(sgn(gap) > 0 && gap > dot(normal, velocity), "certificate: the axis does not separate");
    return;
  }
  expect(relation == "hit", "truth: relation is wrong");
  claim.answers({"relation", "t"});
  const Rational t = exact_value(claim.truth["t"], "truth.t");
  const bool start = kind == "start";
  expect(start || kind == "first_contact", wrong_kind);
  if (start) {
    claim.facts({"point"});
  } else {
    claim.facts({"point", "normal"});
  }
  expect(start ? sgn(t) == 0 : sgn(t) > 0 && t <= 1, "truth: t is wrong");
  const Coordinates point = fact(claim, "point", velocity.size());
  Coordinates before = point;
  for (std::size_t k = 0; k < before.size(); ++k) before[k] -= t * velocity[k];
  expect(a.holds(before) && b.holds(point), "certificate: the point is not in both at t");
  if (start) return;
  const Coordinates normal = fact(claim, "normal", velocity.size());
  const Rational speed = dot(normal, velocity);
  const bool first = sgn(speed) > 0 && a.highest(normal) + t * speed <= b.lowest(normal);
  expect(first, "certificate: the axis does not separate them before t");
}

Checks checks_of_swept_solids() {
  return {{"swept_aabb_aabb", check_swept_aabb_aabb},
          {"swept_convex_polyhedra", check_swept_convex_polyhedra},
          {"swept_obb_obb", check_swept_obb_obb}};
}

}  // namespace touchstone::certify
