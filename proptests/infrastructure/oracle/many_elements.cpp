// SPDX-License-Identifier: Apache-2.0
#include <ctime>

#include "catalogue/families/numbers.h"
#include "catalogue/operation/probes/explained.h"
#include "catalogue/signatures/broad_phase/all_pairs.h"
#include "oracle/broad_phase/all_pairs.h"
#include "oracle/certificates/check.h"
#include "oracle/exact/systems/guessed_complement.h"
#include "oracle/exact/systems/principal_pivots.h"
#include "oracle/response/simultaneous_collisions.h"
#include "oracle/volumes/convex_hull_2d.h"
#include "proptests/catch.h"

/// The truth about many elements: in time, and the same as of few.
namespace touchstone::proptests::many_elements_tests {
namespace {

using catalogue::DrawStream;
using oracle::Rational;

template <class Work>
double seconds_of(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Some close together, most far from one another, along all axes and across them.
template <class Solid>
std::vector<Solid> solids(DrawStream& draws, std::size_t count) {
  std::vector<Solid> all;
  for (std::size_t i = 0; i < count; ++i) {
    const double apart = draws.below(2) == 0 ? 4 : 4000;
    const auto at = [&] { return apart * catalogue::small_integer(draws) / 8; };
    const Point3d p{at(), at(), draws.below(3) == 0 ? 0 : at()};
    const double size = static_cast<double>(draws.below(5)) / 4;
    if constexpr (std::is_same_v<Solid, Sphere3d>) all.push_back({p, size});
    else all.push_back({p, {p.x + size, p.y + size, p.z + 1}});
  }
  return all;
}

/// The pairs, and the least margin, of each two asked alone.
template <class Solid>
void check_as_two_by_two(const std::vector<Solid>& all) {
  std::vector<IndexPair> pairs;
  std::optional<Rational> least;
  for (Index i = 0; i < all.size(); ++i) {
    for (Index j = i + 1; j < all.size(); ++j) {
      const auto two = oracle::all_pairs(std::vector<Solid>{all[i], all[j]});
      if (!two.answer.empty()) pairs.push_back({i, j});
      if (!least || *two.margin < *least) least = two.margin;
    }
  }
  const auto truth = oracle::all_pairs(all);
  CHECK(truth.answer == pairs);
  CHECK(truth.margin == least);
}

/// A symmetric matrix of full rank or less, as contacts have them: products of rows of few small integers.
oracle::Complementary problem(DrawStream& draws, std::size_t contacts, std::size_t rank) {
  std::vector<std::vector<int>> rows(contacts);
  for (auto& row : rows) {
    for (std::size_t k = 0; k < rank; ++k) row.push_back(static_cast<int>(catalogue::small_integer(draws, 2)));
  }
  oracle::Complementary made;
  for (const auto& row : rows) {
    std::vector<oracle::Integer> products;
    for (const auto& other : rows) {
      int sum = 0;
      for (std::size_t k = 0; k < rank; ++k) sum += row[k] * other[k];
      products.push_back(sum);
    }
    made.matrix.push_back(products);
    made.constants.push_back(static_cast<int>(catalogue::small_integer(draws, 3)));
  }
  return made;
}

}  // namespace

TEST_CASE("many elements: of a long list, checkers compare what the sweep leaves, and miss no pair") {
  DrawStream draws = DrawStream::seeded(5);
  const catalogue::Operation& operation = *catalogue::find_operation("all_pairs");
  const auto check = [&](const auto& all) {
    const catalogue::signatures::all_pairs::Question asked{std::tuple(all)};
    auto claim = catalogue::claim_of(*operation.examine(catalogue::packed(asked)));
    REQUIRE(claim["certificate"]["kind"] == "compared_sweep");
    REQUIRE(claim["truth"]["pairs"].size() > 10);
    CHECK_FALSE(certify::refuse(claim).has_value());
    claim["truth"]["pairs"].erase(3), claim["certificate"]["meet"].erase(3);
    CHECK(certify::refuse(claim) == "certificate: a pair is left open");
  };
  check(solids<Sphere3d>(draws, 120));
  check(solids<Aabb3d>(draws, 120));
}

TEST_CASE("many elements: the pairs of many solids and their margin are those of each two alone") {
  for (std::uint64_t i = 0; i < 60; ++i) {
    DrawStream draws = DrawStream::seeded(i);
    check_as_two_by_two(solids<Sphere3d>(draws, 12));
    check_as_two_by_two(solids<Aabb3d>(draws, 12));
  }
}

TEST_CASE("many elements: pivots on the diagonal, and guesses, find the impulses of Lemke's method, or nothing") {
  int found = 0, guessed = 0, left = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    DrawStream draws = DrawStream::seeded(i);
    const std::size_t contacts = 1 + draws.below(6);
    const oracle::Complementary asked = problem(draws, contacts, contacts + 1 - draws.below(3));
    const auto single = oracle::single_complement(asked);
    const oracle::Complement all = oracle::lemke(asked);
    ++(single ? found : left);
    const auto guess = oracle::guessed_complement(asked);
    REQUIRE((single || !guess));
    guessed += guess ? 1 : 0;
    for (const auto& one : {single, guess}) {
      if (!one) continue;
      REQUIRE(all.solved);
      for (std::size_t k = 0; k < contacts; ++k)
        REQUIRE(one->numerators[k] * all.denominator == all.numerators[k] * one->denominator);
    }
  }
  CHECK(found > 200);
  CHECK(guessed > 200);
  CHECK(left > 200);
}

TEST_CASE(
    "many elements: a cradle of 400, thousands of solids that are apart or points of a hull take less than a second") {
  std::vector<PointBodyd> bodies;
  std::vector<BodyContactd> contacts;
  for (Index i = 0; i < 400; ++i) {
    bodies.push_back({1, {i == 0 ? 1.0 : 0.0, 0, 0}});
    if (i > 0) contacts.push_back({i, i - 1, {1, 0, 0}});
  }
  CHECK(seconds_of([&] { oracle::simultaneous_collisions(bodies, contacts, 1.0); }) < 1);
  std::vector<Sphere3d> spheres;
  std::vector<Point2d> parabola;
  for (int i = 0; i < 4000; ++i) {
    spheres.push_back({{8.0 * (i % 16), 8.0 * (i / 16 % 16), 8.0 * (i / 256) + 0.1 * i}, 0.1});
    parabola.push_back({static_cast<double>(i), static_cast<double>(i) * i});
  }
  CHECK(seconds_of([&] { CHECK(oracle::all_pairs(spheres).answer.empty()); }) < 1);
  CHECK(seconds_of([&] { CHECK(oracle::convex_hull_2d(parabola).answer.polygon->size() == 4000); }) < 1);
}

}  // namespace touchstone::proptests::many_elements_tests
