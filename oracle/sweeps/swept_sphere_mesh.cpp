// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_sphere_mesh.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/numbers/space.h"
#include "oracle/exact/solids/polygon_faces.h"
#include "oracle/sweeps/swept_sphere_triangle.h"

namespace touchstone::oracle {
namespace {

/// The ball and the faces in exact numbers, and the truth of each.
struct BallNearFaces {
  Point3<Rational> center;
  Rational radius;
  Vector3<Rational> velocity;
  std::vector<std::array<Point3<Rational>, 3>> faces;
  std::vector<Truth<FirstContact<Surd>>> truths;

  /// As the checkers ask it.
  bool beyond(std::size_t face, const std::vector<Rational>& numbers) const {
    const Vector3<Rational> n{numbers[0], numbers[1], numbers[2]};
    const Rational reach(radius * radius * dot(n, n)), rise = dot(n, velocity);
    return std::all_of(faces[face].begin(), faces[face].end(), [&](const Point3<Rational>& corner) {
      const Rational start = dot(n, center - corner), end(start + rise);
      return sgn(start) > 0 && sgn(end) > 0 && start * start > reach && end * end > reach;
    });
  }

  Certificate certificate() const {
    std::vector<Certificate> missed, met;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Rational face(i);
      if (const std::optional<Surd>& t = truths[i].answer.t) {
        met.push_back(truths[i].certificate());
        auto& facts = met.back().facts;
        facts.insert(facts.begin(), {"face", {face}});
        facts.push_back({"time", {t->rational_part(), t->coefficient(), Rational(t->radicand())}});
        continue;
      }
      const auto known = std::find_if(missed.begin(), missed.end(),
                                      [&](const Certificate& c) { return beyond(i, c.facts[0].second); });
      if (known != missed.end()) {
        known->facts[1].second.push_back(face);
      } else {
        missed.push_back(truths[i].certificate());
        missed.back().facts.push_back({"faces", {face}});
      }
    }
    return {"faces", {}, {{"missed", std::move(missed)}, {"met", std::move(met)}}};
  }
};

template <class Number>
Truth<FirstFaceContact<Surd>> truth_swept_sphere_mesh(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                                      const Mesh<Number>& mesh) {
  validation::validate_all("sphere", sphere, "velocity", velocity, "mesh", mesh);
  validate_polygons("mesh", mesh);
  BallNearFaces q{
      exact(sphere.center), exact(sphere.radius), {exact(velocity.x), exact(velocity.y), exact(velocity.z)}, {}, {}};
  FirstFaceContact<Surd> first{HitRelation::never, std::nullopt, std::nullopt};
  std::optional<Rational> margin;
  const auto consider = [&margin](const Rational& square) { margin = margin ? std::min(*margin, square) : square; };
  const std::vector<Index> named = named_face_of_each(mesh);
  bool at_once = false;
  for (Index i = 0; i < mesh.faces.size(); ++i) {
    const auto& [a, b, c] = triangle_of_face(mesh, i);
    q.faces.push_back({exact(a), exact(b), exact(c)});
    q.truths.push_back(swept_sphere_triangle(sphere, velocity, triangle_of_face(mesh, i)));
    const auto& [contact, depth, certificate] = q.truths.back();
    consider(*depth);
    if (!contact.t || (first.t && *first.t < *contact.t)) continue;
    const bool tie = first.t && *first.t == *contact.t;
    at_once = tie && (at_once || named[i] != named[*first.face]);
    if (!tie) first = {HitRelation::hit, contact.t, i};
  }
  if (first.t && sgn(*first.t) == 0) {
    margin.reset();
    const Vector3<Number> rest{0, 0, 0};
    for (Index i = 0; i <= *first.face; ++i)
      consider(*swept_sphere_triangle(sphere, rest, triangle_of_face(mesh, i)).margin);
  } else if (at_once) {
    margin = 0;
  }
  if (first.face) first.face = named[*first.face];
  return {std::move(first), std::move(margin), [q = std::move(q)] { return q.certificate(); }};
}

}  // namespace

template <Exact Number>
Truth<FirstFaceContact<Surd>> swept_sphere_mesh(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                                const Mesh<Number>& mesh) {
  return truth_swept_sphere_mesh(sphere, velocity, mesh);
}
template Truth<FirstFaceContact<Surd>> swept_sphere_mesh(const Sphere3d&, const Vector3d&, const Meshd&);
template Truth<FirstFaceContact<Surd>> swept_sphere_mesh(const Sphere3<Rational>&, const Vector3<Rational>&,
                                                         const Mesh<Rational>&);

}  // namespace touchstone::oracle
