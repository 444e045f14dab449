// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "catalogue/rows/broad_phase/all_pairs.h"
#include "catalogue/rows/planes/polygon_normal.h"
#include "catalogue/rows/polygons/point_in_convex_polygon.h"
#include "catalogue/rows/response/contact_state.h"
#include "catalogue/rows/response/kinetic_energy.h"
#include "catalogue/rows/response/momentum.h"
#include "catalogue/rows/response/rigid_body_collision.h"
#include "catalogue/rows/response/simultaneous_collisions.h"
#include "catalogue/rows/volumes/aabb_aabb.h"
#include "catalogue/rows/volumes/aabb_of_points.h"
#include "catalogue/rows/volumes/bounding_sphere.h"
#include "catalogue/rows/volumes/closest_point_on_aabb.h"
#include "catalogue/rows/volumes/convex_hull.h"
#include "catalogue/rows/volumes/convex_hull_2d.h"
#include "catalogue/rows/volumes/kdop_kdop.h"
#include "catalogue/rows/volumes/kdop_of_points.h"
#include "catalogue/rows/volumes/obb_obb.h"
#include "catalogue/rows/volumes/obb_of_points.h"
#include "catalogue/rows/volumes/point_in_kdop.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/judge/foreign_formulas.h"

/// Bugs that only questions of some families show: what they make of their lists, of plane physics and of long boxes.
namespace touchstone::proptests::planted_families_tests {
namespace {

namespace rows = catalogue::rows;
namespace robust = ::touchstone::robust;

std::uint64_t findings(const Cell& cell) {
  std::uint64_t found = 0;
  for (std::size_t v = 0; v < verdict_count; ++v)
    if (is_finding(static_cast<Verdict>(v))) found += cell.count(static_cast<Verdict>(v));
  return found;
}

/// Of the answers to that family, so many hundredths are accused at least.
template <class Row, class Formula>
void is_accused(const std::string& family, std::uint64_t percent, const Formula& formula) {
  const Tally tally = audited<Row>(formula, {.each = 200, .family = family});
  const Cell total = tally.operations[0].total();
  INFO(Row::metadata.name << ", " << family << ": " << findings(total) << " of " << total.cases());
  CHECK(findings(total) * 100 >= percent * total.cases());
  CHECK(total.cases() > 0);
}

/// As many as an array of a fixed length holds.
template <class T>
std::vector<T> first(std::size_t most, std::vector<T> list) {
  if (list.size() > most) list.resize(most);
  return list;
}
/// As many as are left where a counter of eight bits begins anew.
template <class T>
std::vector<T> by_eight_bits(std::vector<T> list) {
  if (list.size() > 256) list.resize(list.size() - 256);
  return list;
}
Kdop3d first_slabs(std::size_t most, const Kdop3d& kdop) {
  return {first(most, kdop.normals), first(most, kdop.slabs)};
}

/// The normals of the faces, and no more.
Contact without_edges(const Obb3d& a, const Obb3d& b) {
  const auto axes = [](const Obb3d& box) { return std::array{box.half_axes.u, box.half_axes.v, box.half_axes.w}; };
  for (const Obb3d* faces : {&a, &b}) {
    for (const Vector3d& n : axes(*faces)) {
      double reach = 0;
      for (const Obb3d* box : {&a, &b})
        for (const Vector3d& axis : axes(*box)) reach += std::fabs(dot(n, axis));
      if (std::fabs(dot(n, b.center - a.center)) > reach) return Contact::disjoint;
    }
  }
  return Contact::overlapping;
}

}  // namespace

TEST_CASE("planted in lists: slabs after the thirteenth, or the ninth, are left out") {
  for (const std::size_t most : {9, 13}) {
    is_accused<rows::kdop_kdop>("many_slabs", 15, [most](const Kdop3d& a, const Kdop3d& b) {
      return robust::kdop_kdop(first_slabs(most, a), first_slabs(most, b));
    });
    is_accused<rows::point_in_kdop>("many_slabs", 15, [most](const Kdop3d& kdop, const Point3d& p) {
      return robust::point_in_kdop(first_slabs(most, kdop), p);
    });
    is_accused<rows::kdop_of_points>("many_normals", 40,
                                     [most](const std::vector<Point3d>& points, const std::vector<Vector3d>& normals) {
                                       std::vector<Slabd> slabs = robust::kdop_of_points(points, normals);
                                       for (std::size_t i = most; i < slabs.size(); ++i) slabs[i] = {0, 0};
                                       return slabs;
                                     });
  }
}

TEST_CASE("planted in lists: edges after the sixteenth are left out") {
  is_accused<rows::point_in_convex_polygon>("many_edges", 15, [](const Polygon2d& polygon, const Point2d& p) {
    return robust::point_in_convex_polygon({first(16, polygon.vertices)}, p);
  });
}

TEST_CASE("planted in lists: contacts after the eighth are left out") {
  using Bodies = std::vector<PointBodyd>;
  using Contacts = std::vector<BodyContactd>;
  is_accused<rows::simultaneous_collisions>("many_contacts", 25,
                                            [](const Bodies& bodies, const Contacts& contacts, double e) {
                                              return robust::simultaneous_collisions(bodies, first(8, contacts), e);
                                            });
}

TEST_CASE("planted in lists: what is counted in eight bits") {
  using Points = std::vector<Point3d>;
  const auto points = [](const auto& formula) {
    return [=](const auto& list) { return formula(by_eight_bits(list)); };
  };
  is_accused<rows::aabb_of_points>("many_points", 1, [](const auto& list) {
    return catalogue::either<rows::aabb_of_points::Answers>(robust::aabb_of_points(by_eight_bits(list)));
  });
  is_accused<rows::convex_hull>("many_points", 1, points([](const Points& p) { return robust::convex_hull(p); }));
  is_accused<rows::convex_hull_2d>("many_points", 1,
                                   points([](const std::vector<Point2d>& p) { return robust::convex_hull_2d(p); }));
  is_accused<rows::obb_of_points>("many_points", 1, points([](const Points& p) { return robust::obb_of_points(p); }));
  is_accused<rows::bounding_sphere>("many_points", 1, [](const Points& p, const rows::bounding_sphere::Method& method) {
    return robust::bounding_sphere(by_eight_bits(p), rows::bounding_sphere::method_of(method));
  });
  is_accused<rows::kdop_of_points>("many_points", 1, [](const Points& p, const std::vector<Vector3d>& normals) {
    return robust::kdop_of_points(by_eight_bits(p), normals);
  });
  is_accused<rows::polygon_normal>("many_vertices", 1, [](const Polygon3d& polygon) {
    return robust::polygon_normal({by_eight_bits(polygon.vertices)});
  });
  is_accused<rows::momentum>("many_bodies", 1, [](const auto& b) { return robust::momentum(by_eight_bits(b)); });
  is_accused<rows::kinetic_energy>("many_bodies", 1,
                                   [](const auto& b) { return robust::kinetic_energy(by_eight_bits(b)); });
  is_accused<rows::all_pairs>("many", 1, [](const auto& solids) { return robust::all_pairs(by_eight_bits(solids)); });
}

TEST_CASE("planted in plane physics: the first moment of inertia is taken for the last") {
  const auto of_a_ball = [](RigidBodyd body) {
    body.inertia.z.z = body.inertia.x.x;
    return body;
  };
  is_accused<rows::rigid_body_collision>(
      "in_a_plane", 25, [&](const RigidBodyd& a, const RigidBodyd& b, const Point3d& p, const Vector3d& n, double e) {
        return robust::rigid_body_collision(of_a_ball(a), of_a_ball(b), p, n, e);
      });
}

TEST_CASE("planted in boxes: no axis of two edges is asked") {
  for (const char* first : {"u", "v", "w"})
    for (const char* second : {"u", "v", "w"})
      is_accused<rows::obb_obb>(std::string("apart_by_edges_") + first + "_" + second, 33, without_edges);
  is_accused<rows::obb_obb>("beams_on_edge", 33, without_edges);
  const Tally tally = audited<rows::obb_obb>(without_edges, {.each = 100});
  const Cell total = tally.operations[0].total();
  INFO(findings(total) << " of " << total.cases());
  CHECK(findings(total) * 10 >= total.cases());
}

TEST_CASE("planted in boxes: the middle and half the width stand for the ends") {
  const auto middle = [](double min, double max) { return min / 2 + max / 2; };
  const auto half = [](double min, double max) { return max / 2 - min / 2; };
  is_accused<rows::aabb_aabb>("wide", 10, [=](const auto& a, const auto& b) {
    const auto apart = [=](double p, double q, double r, double s) {
      return std::fabs(middle(p, q) - middle(r, s)) > half(p, q) + half(r, s);
    };
    bool disjoint = apart(a.min.x, a.max.x, b.min.x, b.max.x) || apart(a.min.y, a.max.y, b.min.y, b.max.y);
    if constexpr (requires { a.min.z; }) disjoint = disjoint || apart(a.min.z, a.max.z, b.min.z, b.max.z);
    return disjoint ? Contact::disjoint : Contact::overlapping;
  });
}

}  // namespace touchstone::proptests::planted_families_tests
