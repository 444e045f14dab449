// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "proptests/array_tables.h"
#include "proptests/catch.h"
#include "robust/batch/orientation.h"
#include "robust/batch/point_in_polygon.h"

// Questions over arrays that families draw seldom, with the answers that follow from their definition.
namespace touchstone::proptests::arrays_tests {
namespace {

/// Asks each of the rows many times, in turn, with every instruction set.
void check_in_turn(const char* name, const std::vector<Question>& rows, const std::vector<Word>& answers) {
  const Operation& operation = *catalogue::find_operation(name);
  Table table{{}, operation.row().batch.columns(rows[0])};
  std::vector<Word> expected;
  for (std::size_t i = 0; i < 300; ++i) {
    table.questions.push_back(rows[i % rows.size()]);
    expected.push_back(answers[i % rows.size()]);
  }
  CHECK(mismatch(operation, table, expected, expected.size(), all_of(table, 1), 0) == "");
  CHECK(decisions(operation, table) == expected);
}

/// The same of points beside a mesh, and beside the mesh with its faces in the opposite order.
void check_in_every_order(Meshd mesh, const std::vector<Point3d>& points, const std::vector<Word>& places) {
  for (int order = 0; order < 2; ++order) {
    std::vector<Question> rows;
    for (const Point3d& point : points) rows.emplace_back(catalogue::packed(std::tuple(mesh, point)));
    check_in_turn("point_in_convex_polyhedron", rows, places);
    check_in_turn("point_in_polyhedron", rows, places);
    std::reverse(mesh.faces.begin(), mesh.faces.end());
  }
}

}  // namespace

TEST_CASE("arrays: what follows asks something") {
  std::size_t with_arrays = 0;
  for (const Operation* operation : catalogue::all_operations())
    with_arrays += operation->row().batch.decide != nullptr;
  CHECK(with_arrays >= 15);
}

TEST_CASE("arrays: turns whose sign in double is wrong by nearly three units of rounding") {
  // In each product all three roundings go the same way, and in the other product the other way. The difference of the
  // products in double is 2.9999999 * 2^-53 times the magnitude of their sum, and on the other side of 0.
  const std::vector<double> right = {-0x1.0000000008p-53,   -0x1.0000000008p-53,   0x1.0000002p+0,
                                     -0x1.0000002000003p+0, -0x1.0000003fffffdp+0, 0x1.0000003fffffep+0};
  std::vector<double> left = right;
  for (std::size_t k = 0; k < left.size(); k += 2) left[k] = -left[k];
  check_in_turn("orientation", {{right, {}}, {left, {}}}, {2, 0});  // right, left
}

TEST_CASE("arrays: three points on the diagonal, whose differences are rounded, and one beside it") {
  // 1 - 2^-60 and 3 - 2^-60 are rounded to 1 and 3: the products are equal as computed, whatever the turn is.
  const double least = 0x1p-60, beyond = 0x1.8000000000001p1;
  const std::vector<Question> rows = {{{least, least, 1, 1, 3, 3}, {}},      {{least, least, 1, 1, 3, beyond}, {}},
                                      {{least, least, 1, 1, beyond, 3}, {}}, {{least, least * 2, 1, 1, 3, 3}, {}},
                                      {{least * 2, least, 1, 1, 3, 3}, {}},  {{1, 1, least, least, 1, 1}, {}}};
  const std::vector<Word> sides = {1, 0, 2, 0, 2, 1};  // on, left, right
  check_in_turn("orientation", rows, sides);
}

TEST_CASE("arrays: a triangle as large as the range, and small ones in its plane and across it") {
  const double far = 0x1p1023;
  const auto beside = [far](const std::vector<double>& small) {
    std::vector<double> numbers{0, 0, 0, far, 0, 0, 0, far, 0};
    numbers.insert(numbers.end(), small.begin(), small.end());
    return Question{numbers, {}};
  };
  const std::vector<Question> rows = {beside({1, 1, 0, 2, 1, 0, 1, 2, 0}),      // inside
                                      beside({1, 1, 1, 2, 1, 1, 1, 2, 1}),      // above
                                      beside({1, 1, -1, 1, 1, 1, 2, 2, 1}),     // through it
                                      beside({1, 1, 0, 1, 1, 1, 2, 2, 1}),      // a corner on it
                                      beside({-1, 1, 0, 1, 1, 0, -1, 1, 0}),    // a segment over an edge
                                      beside({-1, 0, 0, 0, -1, 0, -1, -1, 0}),  // next to its corner
                                      beside({-1, 1, 0, 1, -1, 0, -1, -1, 0}),  // its corner on an edge
                                      beside({0, 3, 0, 0, 3, 0, 0, 3, 0})};     // a point on an edge
  check_in_turn("triangle_triangle", rows, {3, 0, 2, 1, 2, 0, 1, 1});           // area, none, segment, point
}

TEST_CASE("arrays: of two rows that are refused the first is named, also where fewer rows of its chunk are open") {
  const Operation& operation = *catalogue::find_operation("orientation");
  const double bad = std::numeric_limits<double>::infinity();
  const Question sure{{0, 0, 1, 0, 0, 1}, {}}, on_line{{0, 0, 1, 1, 2, 2}, {}}, refused{{0, 0, 1, bad, 2, 2}, {}};
  Table table{{}, operation.row().batch.columns(sure)};
  for (std::size_t i = 0; i < 128; ++i) table.questions.push_back(i < 64 ? sure : on_line);
  table.questions[5] = refused, table.questions[100] = refused;
  const Columns given(table, table.questions.size(), all_of(table, 1), 0);
  for (const Instructions set : every_set) {
    std::vector<std::uint8_t> answers(table.questions.size());
    std::string named;
    try {
      operation.row().batch.decide(table.questions[0], given.columns.data(), answers.size(), answers.data(), set);
    } catch (const InvalidInput& error) {
      named = error.field();
    }
    CHECK(named == "questions[5].p1[1]");
  }
}

TEST_CASE("arrays: on several threads the answers are the same, and of two rows that are refused the first is named") {
  const double bad = std::numeric_limits<double>::infinity();
  std::vector<double> x(100'000), y(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = 0.1 * static_cast<double>(i % 97), y[i] = 0.3 * (i % 101);
  const double zero = 0, one = 0.1, three = 0.3;
  const robust::batch::Points2 p0{{&zero, 0}, {&zero, 0}}, p1{{&one, 0}, {&three, 0}}, p{{x.data()}, {y.data()}};
  Polygon2d star;
  for (std::size_t i = 0; i < 600; ++i)
    star.vertices.push_back({(i % 2 + 4) * std::cos(0.01 * i), (i % 2 + 4) * std::sin(0.01 * i)});
  const auto named = [](const auto& call) -> std::string {
    try {
      call();
    } catch (const InvalidInput& error) {
      return error.field();
    }
    return "";
  };
  for (const std::size_t threads : {0U, 2U, 3U, 7U}) {
    const robust::batch::Limits limits{Instructions::avx512, threads};
    std::vector<std::uint8_t> alone(x.size()), together(x.size(), 9);
    robust::batch::orientation(p0, p1, p, x.size(), alone.data());
    robust::batch::orientation(p0, p1, p, x.size(), together.data(), limits);
    CHECK(together == alone);
    robust::batch::point_in_polygon(star, p, x.size(), alone.data());
    robust::batch::point_in_polygon(star, p, x.size(), together.data(), limits);
    CHECK(together == alone);
    for (const auto& [first, second] : {std::pair{99'999, 49'000}, std::pair{17, 99'000}, std::pair{60'000, 60'001}}) {
      std::vector<double> wrong = x;
      wrong[first] = wrong[second] = bad;
      const robust::batch::Points2 q{{wrong.data()}, {y.data()}};
      const std::string expected = "questions[" + std::to_string(std::min(first, second)) + "].";
      CHECK(named([&] { robust::batch::orientation(p0, p1, q, x.size(), together.data(), limits); }) ==
            expected + "p[0]");
      CHECK(named([&] { robust::batch::point_in_polygon(star, q, x.size(), together.data(), limits); }) ==
            expected + "point[0]");
    }
  }
}

TEST_CASE("arrays: decimals whose height in double has the wrong sign") {
  // normal, offset, point
  const std::vector<Question> rows = {{{0.7, 0.6, 0.8, -0.63, 0.1, 0.8, 0.1}, {}},
                                      {{0.3, 0.6, 0.3, -0.6, 0.4, 0.7, 0.2}, {}},
                                      {{0.7, 0.2, 0.7, -1.18, 0.8, 0.3, 0.8}, {}},
                                      {{0.8, 0.8, 0.5, -1.07, 0.1, 0.8, 0.7}, {}},
                                      // 1 is lost beside 2^60 before that is taken away again.
                                      {{1, 0x1p60, -0x1p60, -0.5, 1, 1, 1}, {}},
                                      {{-1, -0x1p60, 0x1p60, 0.5, 1, 1, 1}, {}}};
  const std::vector<Word> sides = {0, 2, 0, 2, 0, 2};  // front, back
  check_in_turn("point_plane", rows, sides);
}

TEST_CASE("arrays: points in the plane of one face, and on either side of another by less than is rounded") {
  // 3 times 0.1, as a double, is greater than 0.3, and 3 times the double before 0.1 is less: x - 3 y + 2 z is outside
  // where it is positive, and the base has z = 0. Another face has x = z.
  const double before = std::nextafter(0.1, 0.0), after = std::nextafter(0.1, 1.0);
  const Meshd mesh{{{0, 0, 0}, {3, 1, 0}, {0, 3, 0}, {1, 1, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  const std::vector<Point3d> points = {{0.3, 0.1, 0},     {0.3, before, 0}, {0.3, 0.1, 0x1p-70}, {0.3, before, 0x1p-70},
                                       {after, 0.5, 0.1}, {0.1, 0.5, 0.1},  {before, 0.5, 0.1}};
  const std::vector<Word> places = {1, 2, 0, 2, 0, 1, 2};  // on the boundary 1, outside 2
  check_in_every_order(mesh, points, places);
}

TEST_CASE("arrays: points between two faces that are closer to each other than is rounded") {
  // Two faces meet in an edge along z and lead to x = 2^60 and x = 2^60 + 256 where y is 1. Where y is 0.1, rounded,
  // they are at 2^60 times that, which is a double, and 25.6 farther on; the next double is 16 farther on.
  const double y = 0.1, x = 0x1p60 * y;
  const Meshd mesh{{{0, 0, -1}, {0, 0, 1}, {0x1p60, 1, 0}, {0x1p60 + 256, 1, 0}},
                   {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  check_in_every_order(mesh, {{x - 16, y, 0.05}, {x, y, 0.05}, {x + 16, y, 0.05}, {x + 32, y, 0.05}}, {2, 1, 0, 2});
}

TEST_CASE("arrays: a point in the plane of a face that is seen edge-on, as high as its corner, and outside") {
  // The base is in z = y + 1, as the point is, which is 1 beside it along x.
  const Meshd mesh{{{3, 1, 2}, {0, 1, 2}, {0, 0, 1}, {2, 2, 2}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  check_in_every_order(mesh, {{1, 0, 1}, {0, 0, 1}, {0, 0.5, 1.5}, {-1, 0, 1}}, {2, 1, 1, 2});
}

TEST_CASE("arrays: balls that meet only by a radius too small to be told beside the other") {
  // The second center is a hair farther than the first radius: h h, with h = 2^-170, is less than twice the product of
  // the radii 2^400 and 2^-721, and more than that of 2^400 and 2^-750.
  const double r = 0x1p400, hair = 0x1p-170;
  const std::vector<double> much{0, 0, r, r, hair, 0x1p-721}, little{0, 0, r, r, hair, 0x1p-750};
  check_in_turn("sphere_sphere", {{much, {0}}, {little, {0}}}, {2, 0});
}

}  // namespace touchstone::proptests::arrays_tests
