// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

#include "catalogue/operation/probes/explained.h"
#include "oracle/certificates/check.h"
#include "proptests/closed_rings.h"
#include "proptests/forward_error.h"
#include "proptests/polygons_from_elsewhere.h"

/// What holds of every polygon cut into pieces, told without the oracle.
namespace touchstone::proptests {

using IndexLists = std::vector<std::vector<Index>>;
__extension__ typedef __int128 Int128;

/// Every edge of the ring is an edge of one piece in the one direction, every other edge of one piece in each.
inline bool edges_match(std::size_t n, const IndexLists& pieces, bool clockwise) {
  std::set<std::pair<Index, Index>> edges;
  for (const auto& piece : pieces) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      if (piece[i] >= n || !edges.insert({piece[i], piece[(i + 1) % piece.size()]}).second) return false;
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    std::pair edge{static_cast<Index>(i), static_cast<Index>((i + 1) % n)};
    if (clockwise) std::swap(edge.first, edge.second);
    if (edges.erase(edge) != 1) return false;
  }
  return std::all_of(edges.begin(), edges.end(), [&](const auto& e) { return edges.count({e.second, e.first}) == 1; });
}

/// Twice the area of three vertices of a lattice ring (proptests/laws.h).
inline Int128 lattice_turn(const Point2d& p, const Point2d& q, const Point2d& r) {
  const auto integer = [](double n) { return static_cast<Int128>(n); };
  return (integer(q.x) - integer(p.x)) * (integer(r.y) - integer(p.y)) -
         (integer(q.y) - integer(p.y)) * (integer(r.x) - integer(p.x));
}

/// The edges match one way round or the other; on a lattice also: every corner of a piece turns left (or is flat, if
/// the pieces are no triangles), and the areas add up to the ring's.
inline bool fits(const Polygon2d& given, const IndexLists& pieces) {
  const Polygon2d polygon = opened(given);
  const bool clockwise = !edges_match(polygon.size(), pieces, false);
  if (clockwise && !edges_match(polygon.size(), pieces, true)) return false;
  if (!on_lattice(std::tuple(polygon))) return true;
  const auto area = [&](const std::vector<Index>& ring) {
    Int128 sum = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i)
      sum += lattice_turn(polygon[ring[0]], polygon[ring[i]], polygon[ring[i + 1]]);
    return sum;
  };
  Int128 all = 0;
  std::vector<Index> whole;
  for (std::size_t i = 0; i < polygon.size(); ++i) whole.push_back(static_cast<Index>(i));
  for (const auto& piece : pieces) {
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const std::size_t m = piece.size();
      if (lattice_turn(polygon[piece[i]], polygon[piece[(i + 1) % m]], polygon[piece[(i + 2) % m]]) < 0) return false;
    }
    if (area(piece) <= 0) return false;
    all += area(piece);
  }
  return all == (clockwise ? -area(whole) : area(whole));
}

/// The law that pieces fit, however the list of vertices is turned round or reversed, and whatever symmetry or integer
/// map is applied.
template <class Row>
void pieces_fit(const std::string& what) {
  law<Row>(what + " fit together",
           [](const auto& ask, const auto& asked) { return fits(std::get<0>(asked), ask(asked)); });
  law<Row>(what + " fit from another vertex and the other way round", [](const auto& ask, const auto& asked) {
    Polygon2d ring = opened(std::get<0>(asked));
    std::rotate(ring.vertices.begin(), ring.vertices.begin() + static_cast<std::ptrdiff_t>(ring.size() / 2),
                ring.vertices.end());
    const bool turned = fits(ring, ask(typename Row::Question{ring}));
    std::reverse(ring.vertices.begin(), ring.vertices.end());
    return turned && fits(ring, ask(typename Row::Question{ring}));
  });
  law<Row>(what + " fit in every image", [](const auto& ask, const auto& asked) {
    const auto fit = [&](const Affine& map) {
      const auto image = map(asked);
      return fits(std::get<0>(image), ask(image));
    };
    return std::all_of(axis_symmetries.begin(), axis_symmetries.end(), fit) &&
           (!on_lattice(asked) || std::all_of(integer_maps.begin(), integer_maps.end(), fit));
  });
  law<Row>(what + " stay when the ring is scaled by powers of two", scales<Row>);
}

/// Each list from its least index on, the lists in order.
inline IndexLists sorted(IndexLists lists) {
  for (auto& list : lists) std::rotate(list.begin(), std::min_element(list.begin(), list.end()), list.end());
  std::sort(lists.begin(), lists.end());
  return lists;
}

/// A worked example with one right answer, up to the order: given by all, the reference in double too unless told
/// otherwise.
template <class Row>
void only_answer(const Polygon2d& polygon, const IndexLists& expected, bool by_reference = true) {
  const typename Row::Question question{polygon};
  INFO(catalogue::one_line(catalogue::operation_of_row<Row>().print(catalogue::packed(question))));
  CHECK(sorted(catalogue::ask_robust<Row>(question)) == expected);
  CHECK(sorted(catalogue::ask_oracle<Row>(question).answer) == expected);
  CHECK((sorted(catalogue::ask_reference<Row>(question)) == expected) == by_reference);
}

/// Whether rounding can decide nothing wrong in the slide's formula, by the bounds of
/// reference/polygons/triangulate_polygon.h.
inline bool beyond_margins(const Polygon2d& given) {
  const Polygon2d polygon = opened(given);
  const Rational u = unit();
  const auto n = static_cast<std::uint64_t>(polygon.size());
  double area = 0;
  Rational sizes;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2d &p = polygon[i], &q = polygon.next(i);
    const double forth = p.x * q.y, back = q.x * p.y;
    area += forth - back;
    if (!finite(forth, back, area)) return false;
    sizes += size(forth) + size(back);
  }
  if (size(area) <= Rational((n + 1) * u / (1 - (n + 1) * u) * sizes + n * power_of_two(-1073))) return false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    for (std::size_t j = i + 1; j < polygon.size(); ++j) {
      for (std::size_t k = j + 1; k < polygon.size(); ++k) {
        for (const auto& [a, b, c] : {std::array{i, j, k}, {j, k, i}, {k, i, j}, {i, k, j}, {k, j, i}, {j, i, k}}) {
          const Point2d &p0 = polygon[a], &p1 = polygon[b], &p = polygon[c];
          const double left = (p.y - p0.y) * (p1.x - p0.x), right = (p.x - p0.x) * (p1.y - p0.y);
          if (!finite(left, right, left - right)) return false;
          if (size(left - right) <= Rational((3 + 16 * u) * u * (size(left) + size(right)) + power_of_two(-1073)))
            return false;
        }
      }
    }
  }
  return true;
}

/// The contract of the slide's formula: right beyond its margins (asked of rings of up to nine vertices), and in exact
/// arithmetic.
template <class Row>
void formula_keeps_contract() {
  const catalogue::Operation& operation = catalogue::operation_of_row<Row>();
  const auto refused_or = [](const auto& asked, const auto& wrong) -> std::string {
    try {
      catalogue::ask_oracle<Row>(asked);
    } catch (const InvalidInput&) {
      return "";
    }
    return wrong();
  };
  int beyond = 0;
  never(
      operation, "the forward error bound holds",
      [&](const Question& question) -> std::string {
        const auto asked = typed<Row>(question);
        const Polygon2d& polygon = std::get<0>(asked);
        return refused_or(asked, [&]() -> std::string {
          if (polygon.size() > 10 || !beyond_margins(polygon)) return "";
          ++beyond;
          return Row::defect(asked, catalogue::ask_reference<Row>(asked));
        });
      },
      4);
  CHECK(beyond > 100);
  never(
      operation, "the formula is right in exact arithmetic",
      [&](const Question& question) -> std::string {
        const auto asked = typed<Row>(question);
        return refused_or(asked, [&] {
          const auto exactly = catalogue::converted<catalogue::Exact>(
              asked, [](double number) { return catalogue::Exact(exact(number)); });
          return Row::defect(asked, catalogue::ask_reference<Row>(exactly));
        });
      },
      1);
}

/// Lists changed a little: most are wrong then, a diagonal turned over in a convex quadrilateral is not.
inline IndexLists altered(catalogue::DrawStream& draws, IndexLists lists, std::size_t n) {
  const auto one = [&]() -> std::vector<Index>& { return lists[draws.below(lists.size())]; };
  switch (draws.below(7)) {
    case 0: one()[draws.below(3)] = static_cast<Index>(draws.below(n + 1)); return lists;
    case 1: {
      std::vector<Index>& list = one();
      std::reverse(list.begin(), list.end());
      return lists;
    }
    case 2: lists.pop_back(); return lists;
    case 3: lists.push_back(one()); return lists;
    case 4: std::rotate(lists.begin(), lists.begin() + 1, lists.end()); return lists;
    default: break;
  }
  std::vector<Index>&a = one(), &b = one();
  for (int i = 0; i < 9; ++i) {  // a = p q r, b = r q s: then p s r and p q s
    if (a[1] == b[1] && a[2] == b[0]) {
      const Index s = b[2];
      b = {a[0], a[1], s}, a = {a[0], s, a[2]};
      return lists;
    }
    std::rotate(a.begin(), a.begin() + 1, a.end());
    if (i % 3 == 2) std::rotate(b.begin(), b.begin() + 1, b.end());
  }
  return lists;
}

/// Whether the checker of the row and the one of certificates, which prove in different ways, say the same of altered
/// answers.
template <class Row>
void checkers_agree() {
  const catalogue::Operation& operation = catalogue::operation_of_row<Row>();
  int right = 0, wrong = 0, different = 0;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(i, "altered lists", 0));
    const Question question = operation.draw(draws, draws.below(operation.families().size()));
    const auto asked = typed<Row>(question);
    const std::size_t n = std::get<0>(asked).size();
    if (n > 12) continue;
    try {
      IndexLists lists = catalogue::ask_robust<Row>(asked);
      for (std::uint64_t more = draws.below(3); more > 0 && lists.size() > 1; --more) lists = altered(draws, lists, n);
      auto claim = catalogue::claim_of(*operation.examine(question));
      claim["truth"] = {{Row::metadata.answer, lists}};
      const bool accepted = Row::defect(asked, lists).empty();
      different += accepted == certify::refuse(claim).has_value();
      ++(accepted ? right : wrong);
    } catch (const InvalidInput&) {
    }
  }
  CHECK(different == 0);
  CHECK(right > 300);
  CHECK(wrong > 300);
}

/// What robust and oracle refuse.
inline Polygon2d times(double factor, Polygon2d polygon) {
  for (Point2d& p : polygon.vertices) p = {factor * p.x, factor * p.y};
  return polygon;
}

template <class Row>
void simple_rings_only() {
  refused<Row>({{{{0, 0}, {1, 0}}}}, "polygon", "at least 3 vertices");
  refused<Row>({{{{0, 0}, {1, not_a_number}, {0, 1}}}}, "polygon[1][1]", "finite number");
  refused<Row>({{{{0, 0}, {1, 0}, {-0.0, 0}}}}, "polygon", "at least 3 vertices");
  refused<Row>({{{{0, 0}, {1, 0}, {1, 0}, {0, 1}}}}, "polygon[1]", "different from vertex 2: drop one of the two");
  refused<Row>({{{{0, 0}, {1, 0}, {0, 1}, {0, -0.0}, {0, 0}}}}, "polygon[3]",
               "different from vertex 0: drop one of the two");
  refused<Row>({{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}}, "polygon[0]",
               "simple: its edge must not meet edge 2");  // crossing
  refused<Row>({{{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}}, "polygon[0]",
               "simple: its edge must not meet edge 2");  // a vertex on an edge
  refused<Row>({{{{0, 0}, {1, 0}, {3, 0}, {2, 0}}}}, "polygon[0]",
               "simple: its edge must not meet edge 3");  // all on one line
  refused<Row>({{{{0, 0}, {4, 0}, {4, 4}, {4, 2}, {4, 6}, {0, 6}}}}, "polygon[1]",
               "simple: its edge must not meet edge 2");  // spike
  refused<Row>({{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 2}, {2, 1}}}}, "polygon[0]",
               "simple: its edge must not meet edge 3");
}

/// Robust refuses or answers as it should on rings drawn by others, and tells how many there were: 0 where they are not
/// there.
template <class Row>
std::size_t real_rings() {
  std::size_t rings = 0;
  for (const Polygon2d& ring : polygons_from_elsewhere()) {
    const typename Row::Question question{ring};
    ++rings;
    INFO("ring " << rings << " of " << ring.size() << " vertices");
    try {
      const auto pieces = catalogue::ask_robust<Row>(question);
      CHECK(fits(ring, pieces));
      if (ring.size() <= 300) CHECK(Row::defect(question, pieces) == "");
    } catch (const InvalidInput& refusal) {
      if (ring.size() > 1200) continue;  // the oracle compares all pairs of edges
      CHECK_THROWS_WITH(catalogue::ask_oracle<Row>(question), refusal.what());
    }
  }
  return rings;
}

/// PARTITION_LAWS("convex_partition", "pieces") is five test cases, in the types of the file's `Row`.
#define PARTITION_LAWS(operation, kind)                                                                \
  TEST_CASE(operation ": " kind " fit, from any vertex, either way round, in every image and scale") { \
    pieces_fit<Row>(kind);                                                                             \
  }                                                                                                    \
  TEST_CASE(operation ": rings that are not simple are refused by the first offending vertex") {       \
    simple_rings_only<Row>();                                                                          \
  }                                                                                                    \
  TEST_CASE(operation ": the checker and that of certificates say the same of altered answers") {      \
    checkers_agree<Row>();                                                                             \
  }                                                                                                    \
  TEST_CASE(operation ": rings drawn by others") {                                                     \
    if (real_rings<Row>() == 0) WARN("skipped: no polygons below TOUCHSTONE_DATA or ../shared/data");  \
  }                                                                                                    \
  TEST_CASE(operation ": the formula in double is right beyond the margins of its contract") {         \
    formula_keeps_contract<Row>();                                                                     \
  }

}  // namespace touchstone::proptests
