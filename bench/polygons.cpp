// SPDX-License-Identifier: Apache-2.0
// point_in_polygon on rings of 16 and of 1,000 vertices: robust compared with a naive inline loop and CGAL's
// bounded_side_2.
//
// bench/polygons --verify compares every timed answer with the oracle, on every case, without timing.

// CGAL as peer: the same question to the library that people use for it.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <cstdio>
#include <cstring>
#include <string>

#include "bench/data_sets.h"
#include "bench/timing.h"
#include "oracle/polygons/point_in_polygon.h"
#include "robust/polygons/point_in_polygon.h"

namespace touchstone::bench {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

struct Case {
  Polygon2d polygon;
  Point2d point;
};

Case drawn(DataSet set, std::size_t size, catalogue::DrawStream& draws) {
  const auto number = [&] {
    return set == DataSet::small_integer_grid ? static_cast<double>(draws.below(8)) : catalogue::ordinary(draws);
  };
  Case made;
  for (std::size_t i = 0; i < size; ++i) made.polygon.vertices.push_back({number(), number()});
  made.point = {number(), number()};
  if (set == DataSet::near_degenerate) {  // rounded onto an edge
    const std::size_t i = draws.below(size);
    const Point2d &a = made.polygon[i], &b = made.polygon.next(i);
    made.point = a + (number() / 2 + 0.5) * (b - a);
  }
  const auto scale = [&](int k) {
    for (Point2d& p : made.polygon.vertices) p = {std::ldexp(p.x, k), std::ldexp(p.y, k)};
    made.point = {std::ldexp(made.point.x, k), std::ldexp(made.point.y, k)};
  };
  if (set == DataSet::huge) scale(1012);
  if (set == DataSet::tiny) scale(52), scale(-1074);
  return made;
}

/// Rings with case_count vertices in all, kept for the most recent set and size.
const std::vector<Case>& cases_of(DataSet set, std::size_t size) {
  static std::string made;
  static std::vector<Case> cases;
  const std::string wanted = std::string("point_in_polygon/") + name_of(set) + "/" + std::to_string(size);
  if (made == wanted) return cases;
  cases.clear();
  for (std::uint64_t index = 0; cases.size() < case_count / size; ++index) {
    catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(1, wanted.c_str(), index));
    cases.push_back(drawn(set, size, draws));
  }
  made = wanted;
  return cases;
}

int ours(const Case& c) { return static_cast<int>(robust::point_in_polygon(c.polygon, c.point)); }

/// The ray test without a division, a branch or any care for the boundary: on random input faster than with them.
int naive(const Case& c) {
  const Point2d& p = c.point;
  bool inside = false;
  Vector2d a = c.polygon.vertices.back() - p;
  for (const Point2d& vertex : c.polygon.vertices) {
    const Vector2d b = vertex - p;
    inside ^= ((a.y > 0) != (b.y > 0)) & ((cross(a, b) > 0) == (b.y > 0));
    a = b;
  }
  return static_cast<int>(inside ? Location::inside : Location::outside);
}

/// The ray test as usually written: a branch and a division for each edge that the ray's line meets.
int usual(const Case& c) {
  const Point2d& p = c.point;
  const std::vector<Point2d>& v = c.polygon.vertices;
  bool inside = false;
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
    if ((v[i].y > p.y) != (v[j].y > p.y) && p.x < (v[j].x - v[i].x) * (p.y - v[i].y) / (v[j].y - v[i].y) + v[i].x)
      inside = !inside;
  }
  return static_cast<int>(inside ? Location::inside : Location::outside);
}

struct CgalCase {
  std::vector<Epick::Point_2> polygon;
  Epick::Point_2 point;
};

int epick(const CgalCase& c) {
  static_assert(CGAL::ON_BOUNDED_SIDE == 1 && CGAL::ON_BOUNDARY == 0 && CGAL::ON_UNBOUNDED_SIDE == -1);
  return 1 - static_cast<int>(CGAL::bounded_side_2(c.polygon.begin(), c.polygon.end(), c.point, Epick()));
}

std::vector<CgalCase> for_cgal(const std::vector<Case>& cases) {
  std::vector<CgalCase> made;
  for (const Case& c : cases) {
    made.push_back({{}, {c.point.x, c.point.y}});
    for (const Point2d& p : c.polygon.vertices) made.back().polygon.emplace_back(p.x, p.y);
  }
  return made;
}

template <class Cases, class Ask>
void time_all(benchmark::State& state, const Cases& cases, const Ask& ask) {
  int total = 0;
  for (auto _ : state) {
    for (const auto& c : cases) {
      total += ask(c);
      keep(total);
    }
  }
  benchmark::DoNotOptimize(total);
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(cases.size()));
}

void add(DataSet set, std::size_t size) {
  const std::string group = "point_in_polygon_" + std::to_string(size) + "/" + name_of(set) + "/";
  const auto add_peer = [&](const char* peer, auto timed) {
    benchmark::RegisterBenchmark((group + peer).c_str(), timed);
  };
  add_peer("naive", [=](benchmark::State& s) { time_all(s, cases_of(set, size), naive); });
  add_peer("usual", [=](benchmark::State& s) { time_all(s, cases_of(set, size), usual); });
  add_peer("robust", [=](benchmark::State& s) { time_all(s, cases_of(set, size), ours); });
  add_peer("epick", [=](benchmark::State& s) {
    static std::string made;
    static std::vector<CgalCase> cases;
    if (made != group) cases = for_cgal(cases_of(set, size)), made = group;
    time_all(s, cases, epick);
  });
}

/// Returns false if robust is wrong anywhere. CGAL promises no answer if the ring crosses itself.
bool verified() {
  std::size_t wrong_of_ours = 0;
  for (const std::size_t size : {16, 1000}) {
    for (const DataSet set : data_sets) {
      const auto& cases = cases_of(set, size);
      const std::vector<CgalCase> cgal = for_cgal(cases);
      std::size_t wrong[4] = {};
      for (std::size_t i = 0; i < cases.size(); ++i) {
        const int truth = static_cast<int>(oracle::point_in_polygon(cases[i].polygon, cases[i].point).answer);
        wrong[0] += ours(cases[i]) != truth, wrong[1] += naive(cases[i]) != truth;
        wrong[2] += usual(cases[i]) != truth, wrong[3] += epick(cgal[i]) != truth;
      }
      std::printf("%5zu %-20s wrong of %zu: robust %zu, naive %zu, usual %zu, Epick %zu\n", size, name_of(set),
                  cases.size(), wrong[0], wrong[1], wrong[2], wrong[3]);
      wrong_of_ours += wrong[0];
    }
  }
  return wrong_of_ours == 0;
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone;
  if (argc == 2 && std::strcmp(argv[1], "--verify") == 0) return bench::verified() ? 0 : 1;
  for (const std::size_t size : {16, 1000}) {
    for (const bench::DataSet set : bench::data_sets) bench::add(set, size);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
