// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "audit/counting/tally_json.h"
#include "audit/gate/gate.h"
#include "catalogue/rows/broad_phase/all_pairs.h"
#include "catalogue/rows/planes/point_plane.h"
#include "catalogue/rows/planes/polygon_normal.h"
#include "catalogue/rows/response/elastic_collision.h"
#include "catalogue/rows/response/kinetic_energy.h"
#include "catalogue/rows/response/momentum.h"
#include "catalogue/rows/response/reflect_plane.h"
#include "catalogue/rows/response/restitution_collision.h"
#include "catalogue/rows/sweeps/swept_sphere_sphere.h"
#include "catalogue/rows/volumes/sphere_sphere.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/judge/foreign_formulas.h"
#include "report/screen/table.h"

/// Bugs that nobody may take for rounding: an audit counts them as wrong by the method, and its gate fails.
namespace touchstone::proptests::planted_bugs_tests {
namespace {

namespace rows = catalogue::rows;

/// At ordinary size at least that share of the answers is wrong by `algorithm`, and less by `rounding`.
template <class Row, class Formula>
void is_seen(double share, const Formula& formula, bool binary32 = false) {
  const Tally tally = audited<Row>(formula, {.binary32 = binary32});
  const Cell total = tally.operations[0].total();
  const auto part = [&](std::uint64_t n) { return static_cast<double>(n) / static_cast<double>(total.cases()); };
  INFO(Row::metadata.name << ": " << total.cases() << " cases, " << total.count(Verdict::algorithm) << " algorithm, "
                          << total.count(Verdict::rounding) << " rounding, " << total.count(Verdict::inexact)
                          << " inexact");
  CHECK(part(total.count(Verdict::algorithm)) >= share);
  CHECK(total.count(Verdict::rounding) < total.count(Verdict::algorithm));
  CHECK(total.wrong() >= total.count(Verdict::algorithm));
  for (const char* causes : {"algorithm,invalid", "algorithm,rounding,invalid"})
    CHECK_FALSE(held_against(tally, Gate{.causes = causes_named(causes)}).passed());
}

Velocitiesd bounced(const Massesd& m, const Velocitiesd& v, const Vector3d& n, double c, double e) {
  const double mass = m.first + m.second;
  return {v.first - (m.second * (1 + e) / mass * c) * n, v.second + (m.first * (1 + e) / mass * c) * n};
}
double closing(const Velocitiesd& v, const Vector3d& n) { return dot(v.first - v.second, n) / dot(n, n); }

template <class Change>
auto contact_with(const Change& change) {
  return [=](const Sphere3d& a, const Sphere3d& b, const Vector3d& va, const Vector3d& vb) {
    FirstContact<double> found = ::touchstone::reference::swept_sphere_sphere(a, b, va, vb);
    if (found.t) found.t = change(*found.t);
    return found;
  };
}

}  // namespace

TEST_CASE("planted bugs: the same numbers whatever is asked") {
  const auto always = [](const std::vector<Body<double>>&) { return Vector3d{42, 42, 42}; };
  is_seen<rows::momentum>(0.95, always);
  is_seen<rows::momentum>(0.95, always, true);
  is_seen<rows::reflect_plane>(0.95, [](const Vector3d&, const Vector3d&) { return Vector3d{1, 2, 3}; });
}

TEST_CASE("planted bugs: a factor that is missing") {
  is_seen<rows::kinetic_energy>(
      0.8, [](const std::vector<Body<double>>& bodies) { return 2 * ::touchstone::reference::kinetic_energy(bodies); });
}

TEST_CASE("planted bugs: an axis that is missing") {
  is_seen<rows::point_plane>(0.4, [](const Plane3d& plane, const Point3d& p) {
    return ::touchstone::reference::point_plane(plane, Point3d{p.x, p.y, 0});
  });
  const auto flat = [](const Sphere3d& s) { return Sphere3d{{s.center.x, s.center.y, 0}, s.radius}; };
  is_seen<rows::sphere_sphere>(0.1, [=](const auto& a, const auto& b) {
    if constexpr (std::is_same_v<std::decay_t<decltype(a)>, Sphere3d>)
      return ::touchstone::reference::sphere_sphere(flat(a), flat(b));
    else return ::touchstone::reference::sphere_sphere(a, b);
  });
}

TEST_CASE("planted bugs: a normal that is not normalised, has the wrong sign, or goes with the other body") {
  is_seen<rows::restitution_collision>(0.5, [](const Massesd& m, const Velocitiesd& v, const Vector3d& n, double e) {
    return bounced(m, v, n, dot(v.first - v.second, n), e);
  });
  is_seen<rows::restitution_collision>(0.5, [](const Massesd& m, const Velocitiesd& v, const Vector3d& n, double e) {
    return bounced(m, v, n, -closing(v, n), e);
  });
  is_seen<rows::elastic_collision>(0.5, [](const Massesd& m, const Velocitiesd& v, const Vector3d& n) {
    const Velocitiesd after = bounced(m, v, n, closing(v, n), 1);
    return Velocitiesd{after.second, after.first};
  });
  is_seen<rows::point_plane>(0.5, [](const Plane3d& plane, const Point3d& p) {
    const PointPlane<double> right = ::touchstone::reference::point_plane(plane, p);
    return PointPlane<double>{right.side, -right.signed_distance};
  });
  is_seen<rows::polygon_normal>(0.5, [](const Polygon3d& polygon) {
    PolygonNormal<double> found = ::touchstone::robust::polygon_normal(polygon);
    if (found.normal) found.normal = -1.0 * *found.normal;
    return found;
  });
}

TEST_CASE("planted bugs: a reflection that adds, and one off by a factor of one thousandth") {
  const auto moved = [](double k) {
    return [k](const Vector3d& v, const Vector3d& n) { return v + (k * dot(v, n) / dot(n, n)) * n; };
  };
  is_seen<rows::reflect_plane>(0.5, moved(2));
  is_seen<rows::reflect_plane>(0.5, moved(-2.002));
}

TEST_CASE("planted bugs: a time that is clamped, and one that is none") {
  // What never touches has no time that could be wrong.
  is_seen<rows::swept_sphere_sphere>(0.1, contact_with([](double t) { return std::clamp(t, 0.0, 0.25); }));
  is_seen<rows::swept_sphere_sphere>(0.2, contact_with([](double) { return -1e308; }));
}

TEST_CASE("planted bugs: a broad phase that lists every pair, and one that sorts along an axis") {
  const auto paired = [](const auto& solids, const auto& meet) {
    std::vector<IndexPair> pairs;
    for (Index i = 0; i < solids.size(); ++i)
      for (Index j = i + 1; j < solids.size(); ++j)
        if (meet(solids[i], solids[j])) pairs.push_back({i, j});
    return pairs;
  };
  const auto every = [&](const auto& solids) { return paired(solids, [](const auto&, const auto&) { return true; }); };
  const auto along_x = [&](const auto& solids) {
    return paired(solids, [](const auto& a, const auto& b) {
      if constexpr (requires { a.radius; })
        return a.center.x - a.radius <= b.center.x + b.radius && b.center.x - b.radius <= a.center.x + a.radius;
      else return a.min.x <= b.max.x && b.min.x <= a.max.x;
    });
  };
  const Gate usual;
  const Tally everything = audited<rows::all_pairs>(every), sorted = audited<rows::all_pairs>(along_x);
  CHECK(everything.operations[0].total().surplus_rate() == 1);
  CHECK(everything.has_findings());
  CHECK_FALSE(held_against(everything, usual).passed());
  CHECK(held_against(everything, Gate{.causes = causes_named("rounding,algorithm,invalid")}).passed());
  CHECK_THAT(text_table(everything),
             ContainsSubstring(", 100% of what is apart; more than --max-surplus 0.75 allows\n"));
  const double rate = sorted.operations[0].total().surplus_rate();
  INFO(rate);
  CHECK((rate > 0 && rate < usual_surplus));
  CHECK_FALSE(sorted.operations[0].too_much_surplus(sorted.max_surplus));
  Tally strict = sorted;
  strict.max_surplus = rate / 2;
  CHECK_FALSE(held_against(strict, usual).passed());
  CHECK(tally_json(read_tally(tally_json(strict))) == tally_json(strict));
}

}  // namespace touchstone::proptests::planted_bugs_tests
