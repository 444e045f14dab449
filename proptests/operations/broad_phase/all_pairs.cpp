// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/broad_phase/all_pairs.h"

#include "proptests/space_laws.h"
#include "robust/volumes/aabb_aabb.h"

namespace touchstone::proptests::all_pairs_tests {
namespace {

using Row = rows::all_pairs;
using Spheres = Row::Spheres;
using Boxes = Row::Boxes;
using Pairs = std::vector<IndexPair>;

/// The law that `holds(ask, solids)` for both sorts of solids; ask: a list of them -> its pairs.
template <class Holds>
auto of_solids(const Holds& holds) {
  return [holds](const auto& ask, const auto& asked) {
    return std::visit(
        [&](const auto& arguments) {
          const auto of_list = [&](const auto& solids) { return Pairs(ask(Row::Question{std::tuple(solids)})); };
          return holds(of_list, std::get<0>(arguments));
        },
        asked);
  };
}

bool lists(const Pairs& pairs, std::size_t i, std::size_t j) {
  const IndexPair pair{static_cast<Index>(std::min(i, j)), static_cast<Index>(std::max(i, j))};
  return std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
}

/// The pairs i < j of so many places of which `meet(i, j)` says that they do.
template <class Meet>
Pairs pairs_where(std::size_t count, const Meet& meet) {
  Pairs pairs;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      if (meet(i, j)) pairs.push_back({static_cast<Index>(i), static_cast<Index>(j)});
    }
  }
  return pairs;
}

double in_range(double number) { return std::clamp(number, -greatest, greatest); }

/// Half as large again, or as much as the range allows; what was in it still is.
Sphere3d grown(const Sphere3d& ball) { return {ball.center, in_range(1.5 * ball.radius)}; }
Aabb3d grown(Aabb3d box) {
  const auto grow = [](double& low, double& high) {
    const double quarter = in_range(high / 4 - low / 4);
    low = in_range(low - quarter), high = in_range(high + quarter);
  };
  grow(box.min.x, box.max.x), grow(box.min.y, box.max.y), grow(box.min.z, box.max.z);
  return box;
}

/// The box of a ball, where it is exact.
Aabb3d box_of(const Sphere3d& ball) {
  const auto& [c, r] = ball;
  return {{c.x - r, c.y - r, c.z - r}, {c.x + r, c.y + r, c.z + r}};
}

/// A worked example and its margin.
template <class Solids>
void gives(const Solids& solids, const Pairs& expected, const std::optional<Rational>& margin,
           const std::string& by_reference = "agree") {
  example<Row>(std::tuple(solids), expected, by_reference);
  CHECK(examined<Row>(std::tuple(solids))->margin() == margin);
}

using proptests::certain;
bool certain(const Aabb3d&, const Aabb3d&) { return true; }

const Spheres tangent{{{0, 0, 0}, 3}, {{5, 0, 0}, 2}, {{1, 4, 4}, 1}, {{9, 0, 0}, 1}};
const Boxes corner{{{0, 0, 0}, {2, 2, 2}}, {{2, 2, 2}, {3, 4, 5}}, {{1, 3, 0}, {4, 4, 1}}, {{5, 0, 0}, {5, 1, 1}}};

/// What the judge says of an engine that answers these pairs to `tangent`, of which only the first two meet.
catalogue::Judgement judged(const std::string& pairs, catalogue::Declaration::Boundary boundary) {
  const auto examination = examined<Row>(std::tuple(tangent));
  return examination->judge_engine(catalogue::parse_line(R"({"pairs":)" + pairs + "}"), {"by hand", boundary});
}

}  // namespace

TEST_CASE("all_pairs: pairs are i < j, in order, each once") {
  law<Row>("in order", of_solids([](const auto& ask, const auto& solids) {
             const Pairs pairs = ask(solids);
             return pairs == pairs_where(solids.size(), [&](auto i, auto j) { return lists(pairs, i, j); });
           }));
}

TEST_CASE("all_pairs: the order of the list does not matter") {
  law<Row>("permuted", of_solids([](const auto& ask, const auto& solids) {
             const std::size_t n = solids.size();
             const Pairs pairs = ask(solids);
             auto reversed = solids;
             std::reverse(reversed.begin(), reversed.end());
             if (ask(reversed) != pairs_where(n, [&](auto i, auto j) { return lists(pairs, n - 1 - i, n - 1 - j); })) {
               return false;
             }
             auto turned = solids;
             std::rotate(turned.begin(), turned.begin() + (n > 0 ? 1 : 0), turned.end());
             return ask(turned) ==
                    pairs_where(n, [&](auto i, auto j) { return lists(pairs, (i + 1) % n, (j + 1) % n); });
           }));
}

TEST_CASE("all_pairs: a twin of each solid meets it, and whatever it meets") {
  law<Row>("twins", of_solids([](const auto& ask, const auto& solids) {
             const std::size_t n = solids.size();
             const Pairs pairs = ask(solids);
             auto twins = solids;
             twins.insert(twins.end(), solids.begin(), solids.end());
             return ask(twins) ==
                    pairs_where(2 * n, [&](auto i, auto j) { return i % n == j % n || lists(pairs, i % n, j % n); });
           }));
}

TEST_CASE("all_pairs: without one of the solids, its pairs are missing and no others") {
  law<Row>("removed", of_solids([](const auto& ask, const auto& solids) {
             if (solids.empty()) return true;
             const Pairs pairs = ask(solids);
             for (const std::size_t gone : {std::size_t{0}, solids.size() / 2, solids.size() - 1}) {
               auto fewer = solids;
               fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(gone));
               const auto before = [gone](std::size_t i) { return i < gone ? i : i + 1; };
               if (ask(fewer) !=
                   pairs_where(fewer.size(), [&](auto i, auto j) { return lists(pairs, before(i), before(j)); })) {
                 return false;
               }
             }
             return true;
           }));
}

TEST_CASE(
    "all_pairs: boxes stretched along each axis by its own power of two, or shifted on the lattice, meet as before") {
  law<Row>("boxes stretched", of_solids([](const auto& ask, const auto& solids) {
             if constexpr (std::is_same_v<decltype(solids), const Boxes&>) {
               const auto stretched = [](Boxes boxes, int x, int y, int z) {
                 for (Aabb3d& box : boxes) {
                   for (Point3d* p : {&box.min, &box.max})
                     *p = {std::ldexp(p->x, x), std::ldexp(p->y, y), std::ldexp(p->z, z)};
                 }
                 return boxes;
               };
               const Boxes image = stretched(solids, 3, -40, 400);
               return numbers_of(stretched(image, -3, 40, -400)) != numbers_of(solids) || ask(image) == ask(solids);
             }
             return true;
           }));
  law<Row>("shifted", of_solids([](const auto& ask, const auto& solids) {
             if (!on_small_lattice(solids)) return true;
             struct Shift {
               static void place(Point3d& p) { p = {p.x + 7, p.y - 1e6, p.z + 123456789}; }
             };
             auto shifted = solids;
             for_each_part(shifted, Shift{});
             return ask(shifted) == ask(solids);
           }));
}

TEST_CASE("all_pairs: solids that grow lose no pair") {
  law<Row>("grown", of_solids([](const auto& ask, const auto& solids) {
             auto larger = solids;
             for (auto& solid : larger) solid = grown(solid);
             const Pairs pairs = ask(solids), found = ask(larger);
             return std::all_of(pairs.begin(), pairs.end(), [&](const IndexPair& p) { return lists(found, p.i, p.j); });
           }));
}

TEST_CASE("all_pairs: boxes meet if they do on each axis alone, and as aabb_aabb says; balls only if their boxes do") {
  law<Row>(
      "axis by axis", of_solids([](const auto& ask, const auto& solids) {
        if constexpr (std::is_same_v<decltype(solids), const Boxes&>) {
          const auto flattened = [&](double Point3d::*axis) {
            Boxes flat = solids;
            for (Aabb3d& box : flat) {
              Aabb3d other{{0, 0, 0}, {0, 0, 0}};
              other.min.*axis = box.min.*axis, other.max.*axis = box.max.*axis;
              box = other;
            }
            return ask(flat);
          };
          const Pairs x = flattened(&Point3d::x), y = flattened(&Point3d::y), z = flattened(&Point3d::z);
          const Pairs pairs = ask(solids);
          return pairs ==
                     pairs_where(solids.size(),
                                 [&](auto i, auto j) { return lists(x, i, j) && lists(y, i, j) && lists(z, i, j); }) &&
                 pairs == pairs_where(solids.size(), [&](auto i, auto j) {
                   return robust::aabb_aabb(solids[i], solids[j]) != Contact::disjoint;
                 });
        } else {
          if (!on_small_lattice(solids)) return true;
          Boxes boxes;
          std::transform(solids.begin(), solids.end(), std::back_inserter(boxes), box_of);
          const Pairs pairs = ask(solids), found = ask(boxes);
          return std::all_of(pairs.begin(), pairs.end(), [&](const IndexPair& p) { return lists(found, p.i, p.j); });
        }
      }));
}

TEST_CASE("all_pairs: p. 56's loop worked by hand") {
  // Squared distances and sums of radii: 25 and 25, 33 and 16, 81 and 16, 48 and 9, 16 and 9, 96 and 4.
  gives(tangent, {{0, 1}}, 0);
  // The first two share a corner; the others are beside these, and each other, on some axis.
  gives(corner, {{0, 1}}, 0);
  gives(Spheres{{{0, 0, 0}, 0}, {{0, 0, 0}, 0}, {{0, 1, 0}, 4}}, {{0, 1}, {0, 2}, {1, 2}}, 0);
  gives(Spheres{{{0, 0, 0}, 1}, {{0, 3, 0}, 1}}, {}, 5);                        // 9 - 4
  gives(Spheres{{{0, 0, 0}, 2}, {{0, 3, 0}, 2}}, {{0, 1}}, 7);                  // 16 - 9
  gives(Spheres{{{0, 0, 0}, 1}, {{0, 3, 0}, 1}, {{0, 0, 2}, 2}}, {{0, 2}}, 4);  // 9 - 4, 9 - 4, 13 - 9
  gives(Boxes{{{0, 0, 0}, {1, 1, 1}}, {{4, 0, 0}, {5, 1, 1}}}, {}, 9);          // 3 apart
  gives(Boxes{{{0, 0, 0}, {4, 4, 4}}, {{3, 1, 1}, {5, 2, 2}}}, {{0, 1}}, 1);    // 1 deep
  gives(Boxes{{{0, 0, 0}, {1, 1, 1}}, {{2, 5, 0}, {3, 6, 1}}}, {}, 16);         // 1 and 4 apart
  gives(Boxes{{{1, 2, 3}, {1, 2, 3}}, {{0, 0, 0}, {5, 5, 5}}, {{1, 2, 3}, {1, 2, 3}}}, {{0, 1}, {0, 2}, {1, 2}}, 0);
}

TEST_CASE("all_pairs: fewer than two solids have no pairs, and nothing is near to having one") {
  gives(Spheres{}, {}, std::nullopt);
  gives(Boxes{}, {}, std::nullopt);
  gives(Spheres{{{1, 2, 3}, 4}}, {}, std::nullopt);
  gives(Boxes{{{1, 2, 3}, {4, 5, 6}}}, {}, std::nullopt);
}

TEST_CASE("all_pairs: rounding, huge, subnormal and negative zero") {
  // S = 1 + 2^-52 is exact; the sum of the radii rounds to 1, and R = (1 + 2^-53)^2 with it.
  gives(Spheres{{{0, 0, 0}, 1}, {{1, 0x1p-26, 0}, 0x1p-53}}, {{0, 1}}, power_of_two(-106), "rounding");
  gives(Spheres{{{-huge, 0, 0}, huge}, {{huge, 0, 0}, huge}}, {{0, 1}}, 0);  // infinity <= infinity
  gives(Spheres{{{0, 0, 0}, tiny}, {{0, 0, 2 * tiny}, tiny}}, {{0, 1}}, 0);
  gives(Boxes{{{-0.0, -0.0, -0.0}, {0, 0, 0}}, {{0, 0, 0}, {-0.0, -0.0, -0.0}}}, {{0, 1}}, 0);
  gives(Boxes{{{-huge, 0, 0}, {-tiny, 1, 1}}, {{0, 0, 0}, {huge, 1, 1}}}, {}, power_of_two(-2148));
}

TEST_CASE("all_pairs: what the formula lists beyond the truth is surplus; robust lists nothing beyond it") {
  const auto too_many = [](const Spheres& spheres, const Rational& margin) {
    const auto examination = examined<Row>(std::tuple(spheres));
    CHECK(examination->truth() == catalogue::parse_line(R"({"pairs":[]})"));
    CHECK(examination->margin() == margin);
    CHECK(catalogue::ask_robust<Row>(Row::Question{std::tuple(spheres)}).empty());
    const catalogue::Judgement judgement = examination->judge_reference();
    CHECK(judgement.verdict == catalogue::Verdict::agree);
    CHECK(judgement.surplus == 1);
  };
  // As doubles, 0.5 + 0.6 = 1.1 - 2^-53, which rounds to 1.1.
  too_many({{{0, 0, 0}, 0.5}, {{1.1, 0, 0}, 0.6}}, power_of_two(-52) * exact(1.1) - power_of_two(-106));
  too_many({{{0, 0, 0}, tiny}, {{0, 3 * tiny, 0}, tiny}}, 5 * power_of_two(-2148));  // 9 - 4; both squares are 0
  // (1.5^2 - 1.25^2) 2^2046; both squares are infinite.
  too_many({{{0, 0, 0}, 0x1p1023}, {{0, 0, 0x1.8p1023}, 0x1p1021}}, Rational(11, 16) * power_of_two(2046));
}

TEST_CASE("all_pairs: what is not finite is refused first, then a negative radius and min > max in order of the list") {
  const auto refuses = [](const auto& solids, const std::string& field, const std::string& rule) {
    refused<Row>(std::tuple(solids), field, rule);
  };
  const std::string finite = "finite number", radius = "radius >= 0", order = "min <= max";
  refuses(Spheres{{{0, 0, 0}, 1}, {{0, not_a_number, 0}, -1}}, "spheres[1].center[1]", finite);
  refuses(Spheres{{{0, 0, 0}, -tiny}, {{infinity, 0, 0}, 1}}, "spheres[1].center[0]", finite);
  refuses(Spheres{{{0, 0, 0}, -tiny}, {{0, 0, 0}, 1}}, "spheres[0].radius", radius);
  refuses(Spheres{{{0, 0, 0}, 1}, {{0, 0, 0}, -1}, {{0, 0, 0}, -1}}, "spheres[1].radius", radius);
  refuses(Boxes{{{9, 0, 0}, {1, 1, not_a_number}}}, "boxes[0].max[2]", finite);
  refuses(Boxes{{{0, 0, 0}, {1, -tiny, 1}}, {{infinity, 0, 0}, {1, 1, 1}}}, "boxes[1].min[0]", finite);
  refuses(Boxes{{{0, 0, 0}, {1, -tiny, 1}}, {{9, 0, 0}, {1, 1, 1}}}, "boxes[0].max[1]", order);
  gives(Boxes{{{0, 0, 0}, {-0.0, -0.0, -0.0}}}, {}, std::nullopt);  // a point
  gives(Spheres{{{0, 0, 0}, -0.0}}, {}, std::nullopt);
}

TEST_CASE("all_pairs: balls apart by an ulp, one of the least radius, are apart") {
  const Spheres apart{{{0, 0, 0}, 5}, {{3, 4 + 0x1p-50, 0}, tiny}};
  CHECK(robust::all_pairs(apart).empty());
}

TEST_CASE("all_pairs: an engine may list more than the truth, in any order, and must miss nothing") {
  constexpr auto closed = catalogue::Declaration::Boundary::closed,
                 unspecified = catalogue::Declaration::Boundary::unspecified;
  const auto agrees = [](const std::string& pairs, std::uint64_t surplus) {
    INFO(pairs);
    const catalogue::Judgement judgement = judged(pairs, closed);
    CHECK(judgement.verdict == catalogue::Verdict::agree);
    CHECK(judgement.surplus == surplus);
  };
  agrees("[[0,1]]", 0);
  agrees("[[1,0]]", 0);
  agrees("[[0,1],[1,0],[0,1]]", 2);
  agrees("[[0,1],[0,2]]", 1);
  agrees("[[3,2],[0,2],[1,0],[2,3]]", 3);
  agrees("[[0,1],[0,2],[0,3],[1,2],[1,3],[2,3]]", 5);
  // The spheres that it misses are tangent, but their numbers are small integers: nothing was rounded.
  for (const char* pairs : {"[]", "[[0,2]]", "[[2,3],[1,3]]"}) {
    INFO(pairs);
    CHECK(judged(pairs, closed).verdict == catalogue::Verdict::algorithm);
    CHECK(judged(pairs, unspecified).verdict == catalogue::Verdict::convention);
  }
  for (const char* pairs :
       {"[[0]]", "[0,1]", "[[0,1,2]]", "[[0,-1]]", "[[0,0.5]]", "[[0,1],[2,2]]", "[[0,4]]", "{}", "true"}) {
    INFO(pairs);
    CHECK(judged(pairs, closed).verdict == catalogue::Verdict::invalid);
  }
}

TEST_CASE("all_pairs: the formula in double is right of every pair beyond the bound of its contract") {
  const auto complaint = [](const Question& question) -> std::string {
    const auto asked = typed<Row>(question);
    try {
      const Pairs truth = catalogue::ask_oracle<Row>(asked).answer, answer = catalogue::ask_reference<Row>(asked);
      const bool kept = std::visit(
          [&](const auto& arguments) {
            const auto& solids = std::get<0>(arguments);
            const auto inconclusive = [&](const IndexPair& p) { return !certain(solids[p.i], solids[p.j]); };
            Pairs differing;
            for (const auto& [one, other] : {std::pair(&truth, &answer), {&answer, &truth}}) {
              std::copy_if(one->begin(), one->end(), std::back_inserter(differing),
                           [&other = *other](const IndexPair& p) { return !lists(other, p.i, p.j); });
            }
            return std::all_of(differing.begin(), differing.end(), inconclusive);
          },
          asked);
      return kept ? "" : "the reference in double breaks its contract";
    } catch (const InvalidInput&) {
      return "";
    }
  };
  never(catalogue::operation_of_row<Row>(), "the forward error bound holds", complaint, 6);
  right_in_exact_arithmetic<Row>();
}

}  // namespace touchstone::proptests::all_pairs_tests
