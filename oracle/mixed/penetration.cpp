// SPDX-License-Identifier: Apache-2.0
#include "oracle/mixed/penetration.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "geometry/penetration.h"
#include "geometry/validation.h"
#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/solids/meeting_solids.h"
#include "oracle/exact/solids/solid_distance.h"

namespace touchstone::oracle {
namespace {

using Vector = Vector3<Rational>;
using Level = std::vector<Index>;

/// b reaches along the direction beyond the beginning of a by height / |direction|; the vertices that are farthest; the
/// first triangle of the hull's face in that direction.
struct Reach {
  Vector direction;
  Rational height;
  Level of_a, of_b;
  std::size_t triangle = 0;
  Rational square() const { return dot(direction, direction); }
};

Vector displacement_to(const Coordinates& p) { return {Rational(p[0]), Rational(p[1]), Rational(p[2])}; }

Level farthest(const std::vector<Coordinates>& vertices, const Vector& direction, int sign) {
  Level level;
  Rational most;
  for (Index i = 0; i < vertices.size(); ++i) {
    const Rational height(sign * dot(direction, displacement_to(vertices[i])));
    if (!level.empty() && height < most) continue;
    if (level.empty() || height > most) level.clear(), most = height;
    level.push_back(i);
  }
  return level;
}

SolidPart part_of(const std::vector<Coordinates>& vertices, const Level& level) {
  std::vector<Vector> spans;
  for (const Index i : level) {
    Vector span = displacement_to(vertices[i]) - displacement_to(vertices[level[0]]);
    if (!zero(span)) spans.push_back(std::move(span));
  }
  if (spans.empty()) return SolidPart::vertex;
  const auto along = [&spans](const Vector& span) { return zero(cross(spans[0], span)); };
  return std::all_of(spans.begin(), spans.end(), along) ? SolidPart::edge : SolidPart::face;
}

/// Weights of the vertices of a and of b for points of both between which the displacement is the shortest, which is
/// given; 0 where they meet. No shorter way brings a to b, so that all of it is used: t is 1.
std::optional<Certificate> points_apart(Motion m, const Vector& shortest, const char* kind) {
  Integer whole(1);
  for (const Rational* x : {&shortest.x, &shortest.y, &shortest.z})
    mpz_lcm(whole.get_mpz_t(), whole.get_mpz_t(), x->get_den_mpz_t());
  for (std::vector<Coordinates>* vertices : {&m.a, &m.b})
    for (Coordinates& p : *vertices)
      for (Integer& x : p) x *= whole;
  const auto part = [&whole](const Rational& x) { return Integer(Rational(-x * whole).get_num()); };
  m.velocity = {part(shortest.x), part(shortest.y), part(shortest.z)};
  Meeting meeting(m);
  if (!meeting.program().feasible()) return std::nullopt;
  std::vector<Rational> weights;
  for (int k = 0; k < meeting.time(); ++k) weights.push_back(meeting.value(k));
  const auto middle = weights.begin() + static_cast<std::ptrdiff_t>(m.a.size());
  return Certificate{kind, {{"on_a", {weights.begin(), middle}}, {"on_b", {middle, weights.end()}}}};
}

/// The hull of the differences of two lists of points, in units of the motion.
class Differences {
 public:
  explicit Differences(const Motion& m) : motion_(m), of_a_(extreme(m.a)), of_b_(extreme(m.b)), cloud_(points()) {
    const std::vector<Index> simplex = cloud_.simplex();
    if (simplex.size() < 4) {
      for (std::size_t k = 1; k < simplex.size(); ++k)
        axes_.push_back(across(rational(cloud_.between(simplex[0], simplex[k]))));
      flat_ = true;
      return;
    }
    std::size_t triangle = 0;
    for (const auto& ring : face_rings(cloud_)) {
      const Vector3<Integer> normal = cloud_.normal(ring[0], ring[1], ring[2]);
      Vector direction = rational(normal);
      const auto [i, j] = ends(ring[0]);
      Rational height = dot(direction, displacement_to(m.b[j]) - displacement_to(m.a[i]));
      Level of_a = farthest(m.a, direction, -1), of_b = farthest(m.b, direction, 1);
      reaches_.push_back({std::move(direction), std::move(height), std::move(of_a), std::move(of_b), triangle});
      rings_.push_back(ring), triangle += ring.size() - 2;
    }
  }

  bool hold_origin() const {
    return std::all_of(reaches_.begin(), reaches_.end(), [](const Reach& each) { return sgn(each.height) >= 0; });
  }
  /// True if they lie in a plane.
  bool flat() const { return flat_; }
  /// The part of a vector at a right angle to all differences where these are flat, by Gram and Schmidt.
  Vector across(Vector v) const {
    for (const Vector& axis : axes_) v = v + Rational(-dot(v, axis) / dot(axis, axis)) * axis;
    return v;
  }
  /// Along such a direction, where flat differences hold the origin; if there is none, along the one that comes last in
  /// lexicographic order.
  Reach reach_across(Vector direction) const {
    for (const Vector& axis : {Vector{1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
      if (zero(direction)) direction = across(axis);
    return {direction, {}, farthest(motion_.a, direction, -1), farthest(motion_.b, direction, 1)};
  }
  /// All that are as near to the origin as any, those of the least vertices first.
  std::vector<Reach> nearest() const {
    std::vector<Reach> found;
    for (const Reach& each : reaches_) {
      const Rational here = found.empty() ? Rational() : each.height * each.height * found[0].square(),
                     there = found.empty() ? Rational() : found[0].height * found[0].height * each.square();
      if (!found.empty() && here > there) continue;
      if (here < there) found.clear();
      found.push_back(each);
    }
    std::sort(found.begin(), found.end(),
              [](const Reach& r, const Reach& s) { return std::pair(r.of_a, r.of_b) < std::pair(s.of_a, s.of_b); });
    return found;
  }

  Certificate certificate(const Reach& found) const {
    std::vector<Rational> of_a, of_b, faces;
    std::vector<std::optional<std::size_t>> corner(cloud_.size());
    const auto named = [&](Index k) {
      if (!corner[k]) {
        corner[k] = of_a.size();
        of_a.emplace_back(ends(k).first), of_b.emplace_back(ends(k).second);
      }
      return Rational(static_cast<std::uint64_t>(*corner[k]));
    };
    for (const auto& ring : rings_)
      for (std::size_t k = 2; k < ring.size(); ++k)
        for (const Index each : {ring[0], ring[k - 1], ring[k]}) faces.push_back(named(each));
    return {"difference_hull",
            {{"face", {Rational(static_cast<std::uint64_t>(found.triangle))}},
             {"of_a", std::move(of_a)},
             {"of_b", std::move(of_b)},
             {"faces", std::move(faces)}}};
  }

 private:
  static Vector rational(const Vector3<Integer>& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }
  static std::vector<Index> extreme(const std::vector<Coordinates>& vertices) {
    std::vector<Point3<Rational>> points;
    for (const Coordinates& p : vertices) points.push_back({Rational(p[0]), Rational(p[1]), Rational(p[2])});
    std::set<Index> found;
    if (const IntegerCloud cloud(points); cloud.simplex().size() == 4) {
      for (const auto& ring : face_rings(cloud)) found.insert(ring.begin(), ring.end());
    } else {
      for (Index i = 0; i < vertices.size(); ++i) found.insert(i);
    }
    return {found.begin(), found.end()};
  }
  std::vector<Point3<Rational>> points() const {
    std::vector<Point3<Rational>> all;
    for (const Index i : of_a_)
      for (const Index j : of_b_)
        all.push_back(Point3<Rational>{0, 0, 0} + (displacement_to(motion_.b[j]) - displacement_to(motion_.a[i])));
    return all;
  }
  /// The vertices of which that point is the difference.
  std::pair<Index, Index> ends(Index k) const {
    const auto count = static_cast<Index>(of_b_.size());
    return {of_a_[k / count], of_b_[k % count]};
  }

  const Motion& motion_;
  std::vector<Index> of_a_, of_b_;
  IntegerCloud cloud_;
  std::vector<std::vector<Index>> rings_;
  std::vector<Reach> reaches_;
  bool flat_ = false;
  std::vector<Vector> axes_;  // at right angles to each other, along flat differences
};

Penetration<Surd> answer_of(const Motion& m, const Reach& found, const Rational& radii) {
  const Rational square = found.square(), height(found.height * m.unit);
  const Surd depth(radii, Rational(sgn(height)), Rational(height * height / square));
  const auto unit = [&](const Rational& n) { return Surd(0, Rational(sgn(n)), Rational(n * n / square)); };
  const auto moved = [&](const Rational& n) {
    return Surd(Rational(n * height / square), Rational(sgn(n)), Rational(radii * radii * n * n / square));
  };
  const auto& [x, y, z] = found.direction;
  const int sign = sgn(depth);
  return {sign > 0    ? Contact::overlapping
          : sign == 0 ? Contact::touching
                      : Contact::disjoint,
          depth,
          {unit(x), unit(y), unit(z)},
          {moved(x), moved(y), moved(z)},
          {part_of(m.a, found.of_a), part_of(m.b, found.of_b)}};
}

Truth<Penetration<Surd>> truth_of(const Motion& m, const Reach& found, const Rational& radii) {
  const Rational height(found.height * m.unit), square(height * height / found.square());
  return {answer_of(m, found, radii), Rational(abs(radii * radii + sgn(height) * square)), {}};
}

template <class Number>
Truth<Penetration<Surd>> truth_of_penetration(const Mesh<Number>& a, const Mesh<Number>& b, const Number& radius_a,
                                              const Number& radius_b) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b);
  validation::validate_numbers("radius_a", radius_a), validation::validate_numbers("radius_b", radius_b);
  const ConvexMesh first = ConvexMesh::core("a", a), second = ConvexMesh::core("b", b);
  validation::validate("radius_a", radius_a, rule::radius), validation::validate("radius_b", radius_b, rule::radius);
  const Motion m = motion(first, second, {});
  const Rational radii(exact(radius_a) + exact(radius_b));
  const Differences differences(m);
  if (differences.flat()) {
    if (const auto common = points_apart(m, {0, 0, 0}, "common_point")) {
      auto truth = truth_of(m, differences.reach_across({0, 0, 0}), radii);
      truth.certificate = [common] { return *common; };
      return truth;
    }
  } else if (differences.hold_origin()) {
    const Reach nearest = differences.nearest()[0];
    auto truth = truth_of(m, nearest, radii);
    truth.certificate = [certificate = differences.certificate(nearest)] { return certificate; };
    return truth;
  }
  const IntegerSolid of_a(first, m.a), of_b(second, m.b);
  const Vector shortest = shortest_displacement(of_a, of_b);
  auto truth = truth_of(
      m, {shortest, Rational(-dot(shortest, shortest)), farthest(m.a, shortest, -1), farthest(m.b, shortest, 1)},
      radii);
  if (is_simplex(a) || is_simplex(b)) {
    truth.certificate = [m, shortest] { return points_apart(m, shortest, "nearest_points").value(); };
    return truth;
  }
  truth.certificate = [of_a, of_b, shortest] {
    const Point3<Rational> on_a = first_nearest(of_a, of_b, shortest), on_b = on_a + Rational(-1) * shortest;
    return Certificate{"nearest_points", {{"on_a", of_a.weights(on_a)}, {"on_b", of_b.weights(on_b)}}};
  };
  return truth;
}

}  // namespace

template <Exact Number>
Truth<Penetration<Surd>> penetration(const Mesh<Number>& a, const Mesh<Number>& b, const Number& radius_a,
                                     const Number& radius_b) {
  return truth_of_penetration(a, b, radius_a, radius_b);
}
template Truth<Penetration<Surd>> penetration(const Meshd&, const Meshd&, const double&, const double&);
template Truth<Penetration<Surd>> penetration(const Mesh<Rational>&, const Mesh<Rational>&, const Rational&,
                                              const Rational&);

Penetration<Surd> as_deep(const Meshd& a, const Meshd& b, double radius_a, double radius_b, const Vector3d& direction) {
  const ConvexMesh first = ConvexMesh::core("a", a), second = ConvexMesh::core("b", b);
  const Motion m = motion(first, second, {});
  const Differences differences(m);
  const bool flat = differences.flat();
  if (flat ? !points_apart(m, {0, 0, 0}, "") : !differences.hold_origin())
    return penetration(a, b, radius_a, radius_b).answer;
  const Rational radii(exact(radius_a) + exact(radius_b));
  const Vector to{exact(direction.x), exact(direction.y), exact(direction.z)};
  const auto cosine = [&to](const Reach& each) {
    const Rational product = dot(each.direction, to);
    return Surd(0, Rational(sgn(product)), Rational(product * product / each.square()));
  };
  const std::vector<Reach> all =
      flat ? std::vector{differences.reach_across(differences.across(to))} : differences.nearest();
  if (sgn(all[0].height) == 0 && !zero(to)) {
    Reach own{to, {}, farthest(m.a, to, -1), farthest(m.b, to, 1)};
    own.height = dot(to, displacement_to(m.b[own.of_b[0]]) - displacement_to(m.a[own.of_a[0]]));
    if (sgn(own.height) == 0) return answer_of(m, own, radii);
  }
  const auto nearest =
      std::max_element(all.begin(), all.end(), [&](const Reach& r, const Reach& s) { return cosine(r) < cosine(s); });
  return answer_of(m, *nearest, radii);
}

}  // namespace touchstone::oracle
