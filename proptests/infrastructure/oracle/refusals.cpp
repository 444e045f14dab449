// SPDX-License-Identifier: Apache-2.0
#include <string>

#include "catalogue/rows/lines/implicit_circle.h"
#include "catalogue/rows/lines/line_line.h"
#include "catalogue/rows/lines/line_point_at.h"
#include "catalogue/rows/lines/parametric_circle.h"
#include "catalogue/rows/lines/ray_segment.h"
#include "catalogue/rows/polyhedra/polyhedron_polyhedron.h"
#include "proptests/catch.h"
#include "proptests/refusal.h"

namespace touchstone::proptests::refusals_tests {
namespace {

template <class Row, class Question>
std::string refusal(const Question& question) {
  return refusal_of([&] { catalogue::ask_oracle<Row>(question); });
}

}  // namespace

TEST_CASE("truth: shapes without a meaning are refused by field and rule") {
  const Point2d p{0.5, -2};
  const Segment2d s{p, {1, 1}};
  const auto refused = []<class Row>(const Row&, const typename Row::Question& question) {
    return refusal<Row>(question);
  };
  using namespace catalogue::rows;
  CHECK(refused(line_line{}, {{p, p}, {p, p}}) == "a: two distinct points");
  CHECK(refused(line_line{}, {{p, {0, 0}}, {{0.0, 1}, {-0.0, 1}}}) == "b: two distinct points");
  CHECK(refused(ray_segment{}, {{p, {0.0, -0.0}}, s}) == "ray.direction: nonzero direction");
  CHECK(refused(line_point_at{}, {{p, {-0.0, 0.0}}, 1}) == "line.direction: nonzero direction");
  CHECK(refused(implicit_circle{}, {{p, -5e-324}, p}) == "circle.radius: radius >= 0");
  CHECK(refused(parametric_circle{}, {{p, -1}, 1}) == "circle.radius: radius >= 0");
  CHECK(refused(implicit_circle{}, {{p, -0.0}, p}) == "accepted");
}

TEST_CASE("truth: a mesh is refused by rules in their order, whatever face breaks them") {
  const std::vector<Point3d> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto refused = [&](const std::vector<Face>& a, const std::vector<Face>& b) {
    return refusal<catalogue::rows::polyhedron_polyhedron>(std::tuple{Meshd{corners, a}, Meshd{corners, b}});
  };
  const std::vector<Face> solid{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, few{{0, 2, 1}},
      twice{{0, 0, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}, beyond{{0, 0, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 9}},
      open{{0, 2, 1}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}};
  CHECK(refused(beyond, beyond) == "a.faces[3][2]: index of a vertex");
  CHECK(refused(twice, beyond) == "a.faces[0]: three different vertices");
  CHECK(refused(few, beyond) == "a: at least 4 faces");
  CHECK_THAT(refused(open, beyond), StartsWith("a.faces[0]: closed"));
  CHECK(refused(solid, beyond) == "b.faces[3][2]: index of a vertex");
  CHECK(refused(solid, few) == "b: at least 4 faces");
}

}  // namespace touchstone::proptests::refusals_tests
