// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <vector>

#include "oracle/certificates/check_obbs.h"
#include "oracle/certificates/check_surd.h"
#include "oracle/certificates/check_triangles.h"

/// The first and the last t of a ray or a segment in a solid.
namespace touchstone::certify {
namespace {

/// The points from + t way with t >= 0, and t <= 1 if it ends: in the plane or in space, coordinate by coordinate.
struct Course {
  std::vector<Rational> from, displacement;
  bool ends;
  std::size_t axes() const { return from.size(); }
};

Course course(const Claim& claim) {
  const bool ends = claim.input.contains("segment");
  const std::string what = ends ? "segment" : "ray";
  const json& value = claim.input[what];
  if (ends) expect(value.is_array() && value.size() == 2, what + ": a list of two");
  else only(value, what, {"origin", "direction"});
  const std::string one = what + (ends ? "[0]" : ".origin"), other = what + (ends ? "[1]" : ".direction");
  Course found{two_or_three(ends ? value[0] : value["origin"], one),
               two_or_three(ends ? value[1] : value["direction"], other), ends};
  expect(found.displacement.size() == found.axes(), other + ": as many coordinates as " + one);
  bool moves = false;
  for (std::size_t k = 0; k < found.axes(); ++k) {
    if (ends) found.displacement[k] -= found.from[k];
    moves = moves || sgn(found.displacement[k]) != 0;
  }
  expect(ends || moves, other + ": nonzero direction");
  return found;
}

/// The claimed answer, with its numbers.
bool says_hit(const Claim& claim) {
  const std::string relation = claim.word("relation");
  expect(relation == "hit" || relation == "none", "truth: relation is wrong");
  if (relation == "hit") claim.answers({"relation", "first", "last"});
  else claim.answers({"relation"});
  return relation == "hit";
}

Rational inner(const std::vector<Rational>& x, const std::vector<Rational>& y) {
  Rational sum;
  for (std::size_t k = 0; k < x.size(); ++k) sum += x[k] * y[k];
  return sum;
}

/// Requires a `normal` along which all of the line is farther than the radius beyond the highest point of the core.
template <class Highest>
void expect_beyond(const Claim& claim, const Course& line, const Highest& highest, const Rational& radius) {
  claim.expect_kind("separating_plane"), claim.facts({"normal"});
  const std::vector<Rational> normal = claim.list("normal");
  expect(normal.size() == line.axes(), "certificate: as many coordinates as the line");
  const Rational start(inner(normal, line.from) - highest(normal)), slope = inner(normal, line.displacement),
                                                                    reach(square(radius) * inner(normal, normal));
  const auto beyond = [&reach](const Rational& height) { return sgn(height) > 0 && square(height) > reach; };
  expect(beyond(start) && (line.ends ? beyond(Rational(start + slope)) : sgn(slope) >= 0),
         "certificate: the plane does not separate");
}

/// True if the line is in the box at t, and on some axis leaves it there towards greater t, or smaller ones.
struct InBox {
  bool inside = true, leaves_forwards = false, leaves_backwards = false;
  InBox(const Course& line, const Box& solid, const Rational& t) {
    for (std::size_t k = 0; k < line.axes(); ++k) {
      const Rational x(line.from[k] + t * line.displacement[k]);
      const int v = sgn(line.displacement[k]);
      inside = inside && solid.min[k] <= x && x <= solid.max[k];
      leaves_forwards = leaves_forwards || (v > 0 && x == solid.max[k]) || (v < 0 && x == solid.min[k]);
      leaves_backwards = leaves_backwards || (v < 0 && x == solid.max[k]) || (v > 0 && x == solid.min[k]);
    }
  }
};

bool moves(const Course& line) {
  for (const Rational& v : line.displacement)
    if (sgn(v) != 0) return true;
  return false;
}

/// highest(normal) of the solid, of which `seen` and `solid` are the line and the solid in a frame of its own.
template <class Highest>
void prove_passage(const Claim& claim, const Course& line, const Highest& highest, const Course& seen,
                   const Box& solid) {
  if (!says_hit(claim)) return expect_beyond(claim, line, highest, 0);
  claim.expect_kind("passage"), claim.facts({});
  const Rational first = exact_value(claim.truth["first"], "truth.first"),
                 last = exact_value(claim.truth["last"], "truth.last");
  const InBox at_first(seen, solid, first), at_last(seen, solid, last);
  // The solid is convex: a line that leaves it on one axis does not return.
  expect(sgn(first) >= 0 && at_first.inside && (sgn(first) == 0 || at_first.leaves_backwards), "truth: first is wrong");
  const bool at_end = line.ends && (moves(line) ? last == 1 : sgn(last) == 0);
  expect(last >= first && (!line.ends || last <= 1) && at_last.inside && (at_end || at_last.leaves_forwards),
         "truth: last is wrong");
}

void prove_passage_of_box(const Claim& claim, const char* name) {
  claim.inputs({name, "aabb"});
  const Course line = course(claim);
  const Box solid = box(claim.input["aabb"], "aabb");
  expect(solid.axes() == line.axes(), std::string("aabb: as many coordinates as ") + name);
  const auto highest = [&](const std::vector<Rational>& normal) {
    Rational sum;
    for (std::size_t k = 0; k < normal.size(); ++k)
      sum += normal[k] * (sgn(normal[k]) > 0 ? solid.max[k] : solid.min[k]);
    return sum;
  };
  prove_passage(claim, line, highest, line, solid);
}

/// The frame: heights over the planes through the center that two half axes each span. The third is as high, up or
/// down, as the magnitude of the determinant.
void prove_passage_of_obb(const Claim& claim, const char* name) {
  claim.inputs({name, "obb"});
  const Course line = course(claim);
  const Obb solid = obb(claim.input["obb"], "obb");
  expect(line.axes() == 3, std::string("obb: as many coordinates as ") + name);
  const auto& [u, v, w] = solid.half_axes;
  const Triple from = Triple{line.from[0], line.from[1], line.from[2]} - solid.center,
               way{line.displacement[0], line.displacement[1], line.displacement[2]};
  Course seen{{}, {}, line.ends};
  for (const Triple& normal : {cross(v, w), cross(w, u), cross(u, v)})
    seen.from.push_back(dot(normal, from)), seen.displacement.push_back(dot(normal, way));
  const Rational high = abs(dot(cross(u, v), w)), low(-high);
  const auto highest = [&](const std::vector<Rational>& n) { return solid.reach({n[0], n[1], n[2]}); };
  prove_passage(claim, {{from.x, from.y, from.z}, line.displacement, line.ends}, highest, seen,
                {{low, low, low}, {high, high, high}});
}

/// constant + linear t + square t^2: the squared distance of the line from a point, minus the squared radius.
Quadratic gap_to(const Course& line, const std::vector<Rational>& point, const Rational& radius) {
  Quadratic f{Rational(-square(radius)), 0, 0};
  for (std::size_t k = 0; k < line.axes(); ++k) {
    const Rational p(line.from[k] - point[k]);
    f.constant += p * p, f.linear += 2 * p * line.displacement[k], f.square += square(line.displacement[k]);
  }
  return f;
}

/// at(t, direction) is f just after t, or before it, at most 0 in the solid.
///
/// f is convex: if its slope is not positive at a zero, and grows before, f is positive there; if it is not negative,
/// and grows after, f is positive after.
template <class At>
void prove_first_and_last(const Claim& claim, const Course& line, const At& at) {
  claim.expect_kind("passage"), claim.facts({});
  const Surd first = exact_surd(claim.truth["first"], "truth.first"),
             last = exact_surd(claim.truth["last"], "truth.last");
  const auto is_zero = [&at](const Surd& t, int direction) {
    const Quadratic f = at(t, direction);
    return sgn(f.square) > 0 && sign(f.at(t)) == 0 && sign(f.slope_at(t)) * direction >= 0;
  };
  const auto is_inside = [&at](const Rational& t) {
    const Surd time{t, 0, 0};
    return sign(at(time, 1).at(time)) <= 0;
  };
  const auto is_on_line = [&line](const Surd& t) {
    return sign(t) >= 0 && (!line.ends || sign(t + Rational(-1)) <= 0);
  };
  const bool starts_inside = sign(first) == 0 && is_inside(0), moved = moves(line);
  expect(starts_inside || (moved && sign(first) > 0 && is_on_line(first) && is_zero(first, -1)),
         "truth: first is wrong");
  const bool ends_inside = line.ends && sign(last + Rational(-1)) == 0 && is_inside(1);
  expect(moved ? ends_inside || (is_on_line(last) && is_zero(last, 1)) : sign(last) == 0, "truth: last is wrong");
}

void prove_passage_of_ball(const Claim& claim, const char* name) {
  claim.inputs({name, "sphere"});
  const Course line = course(claim);
  const BallOrDisc solid = ball_or_disc(claim.input["sphere"], "sphere");
  expect(solid.axes() == line.axes(), std::string("sphere: as many coordinates as ") + name);
  const Quadratic f = gap_to(line, solid.center, solid.radius);
  if (says_hit(claim)) return prove_first_and_last(claim, line, [&f](const Surd&, int) { return f; });
  const std::string kind = claim.kind();
  claim.facts({});
  expect(f.proved_positive(kind, line.ends), "certificate: the kind does not hold");
}

/// f is that of the nearest end of the segment or, between its ends, of its line, which is taken times the squared
/// length. Where one follows the other both are equal, and so are their slopes.
void prove_passage_of_capsule(const Claim& claim, const char* name) {
  claim.inputs({name, "capsule"});
  const Course line = course(claim);
  const auto [ends, radius] = capsule_in_space(claim.input["capsule"], "capsule");
  expect(line.axes() == 3, std::string("capsule: as many coordinates as ") + name);
  const auto& [a, b] = ends;
  const std::vector<Rational> from_a{line.from[0] - a.x, line.from[1] - a.y, line.from[2] - a.z},
      axis{b.x - a.x, b.y - a.y, b.z - a.z};
  const Rational place = inner(from_a, axis), climb = inner(line.displacement, axis), length = inner(axis, axis);
  const Quadratic at_a = gap_to(line, {a.x, a.y, a.z}, radius), at_b = gap_to(line, {b.x, b.y, b.z}, radius);
  const Quadratic between{Rational(length * at_a.constant - place * place),
                          Rational(length * at_a.linear - 2 * place * climb),
                          Rational(length * at_a.square - climb * climb)};
  if (!says_hit(claim)) {
    const auto highest = [&a, &b](const std::vector<Rational>& n) {
      const Triple normal{n[0], n[1], n[2]};
      return std::max(dot(normal, a), dot(normal, b));
    };
    return expect_beyond(claim, line, highest, radius);
  }
  prove_first_and_last(claim, line, [&](const Surd& t, int direction) {
    const Surd along = t * climb + place;
    const int over_a = sign(along), over_b = sign(along + Rational(-length)), rises = sgn(climb) * direction;
    if (sgn(length) == 0 || over_a < 0 || (over_a == 0 && rises < 0)) return at_a;
    return over_b > 0 || (over_b == 0 && rises > 0) ? at_b : between;
  });
}

void check_ray_aabb(const Claim& claim) { prove_passage_of_box(claim, "ray"); }
void check_segment_aabb(const Claim& claim) { prove_passage_of_box(claim, "segment"); }
void check_ray_obb(const Claim& claim) { prove_passage_of_obb(claim, "ray"); }
void check_segment_obb(const Claim& claim) { prove_passage_of_obb(claim, "segment"); }
void check_ray_sphere(const Claim& claim) { prove_passage_of_ball(claim, "ray"); }
void check_segment_sphere(const Claim& claim) { prove_passage_of_ball(claim, "segment"); }
void check_ray_capsule(const Claim& claim) { prove_passage_of_capsule(claim, "ray"); }
void check_segment_capsule(const Claim& claim) { prove_passage_of_capsule(claim, "segment"); }

}  // namespace

Checks checks_of_passages() {
  return {{"ray_aabb", check_ray_aabb},       {"segment_aabb", check_segment_aabb},
          {"ray_obb", check_ray_obb},         {"segment_obb", check_segment_obb},
          {"ray_sphere", check_ray_sphere},   {"segment_sphere", check_segment_sphere},
          {"ray_capsule", check_ray_capsule}, {"segment_capsule", check_segment_capsule}};
}

}  // namespace touchstone::certify
