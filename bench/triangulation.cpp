// SPDX-License-Identifier: Apache-2.0
// Triangulations of rings of ten thousand vertices, by robust.
//
// bench/triangulation --shapes FILE writes the rings as one JSON object of lists x, y, x, y, ..., for peers in other
// languages (bench/earcut.mjs). bench/triangulation --verify checks every triangulation by the oracle without timing.

#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bench/timing.h"
#include "catalogue/families/draw_stream.h"
#include "catalogue/families/numbers.h"
#include "oracle/polygons/triangulate_polygon.h"
#include "robust/polygons/triangulate_polygon.h"

namespace touchstone::bench {
namespace {

constexpr std::size_t vertices = 10000;

Point2d polar(double radius, double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

double part(std::size_t i, std::size_t n) { return static_cast<double>(i) / static_cast<double>(n); }

/// A ring of points at distance radius(u) around the origin, with u from 0 to 1.
Polygon2d round_about(const std::function<double()>& radius) {
  Polygon2d ring;
  for (std::size_t i = 0; i < vertices; ++i) ring.vertices.push_back(polar(radius(), part(i, vertices)));
  return ring;
}

/// A ring out along one curve and back along another.
template <class Out, class Back>
Polygon2d there_and_back(const Out& out, const Back& back) {
  Polygon2d ring;
  for (std::size_t i = 0; i < vertices / 2; ++i) ring.vertices.push_back(out(i));
  for (std::size_t i = vertices / 2; i-- > 0;) ring.vertices.push_back(back(i));
  return ring;
}

std::vector<std::pair<std::string, Polygon2d>> shapes() {
  catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(1, "triangulation", 0));
  const auto random = [&draws] { return (catalogue::ordinary(draws) + 1) / 2; };  // from [0, 1)
  const auto x = [](std::size_t i) { return static_cast<double>(i); };
  const auto spiral = [](double width) {
    return [width](std::size_t i) {
      const double turns = 0.5 + 40 * part(i, vertices / 2);
      return polar(turns + width, turns);
    };
  };
  return {{"circle", round_about([] { return 1.0; })},
          {"star", round_about([&] { return 0.5 + random() / 2; })},
          {"spiral", there_and_back(spiral(0), spiral(0.4))},
          {"stairs", there_and_back(
                         [&](std::size_t i) {
                           return Point2d{x((i + 1) / 2), x(i / 2)};
                         },
                         [&](std::size_t i) {
                           return Point2d{x((i + 1) / 2) - 3, x(i / 2) + 3};
                         })},
          {"comb", there_and_back(
                       [&](std::size_t i) {
                         return Point2d{x(i), -1};
                       },
                       [&](std::size_t i) {
                         return Point2d{x(i), i % 2 == 1 ? 1 + 1000 * random() : 0};
                       })},
          {"strip", there_and_back(
                        [&](std::size_t i) {
                          return Point2d{x(i), 50 * random()};
                        },
                        [&](std::size_t i) {
                          return Point2d{x(i), 51 + 50 * random()};
                        })}};
}

void write_shapes(const char* file) {
  nlohmann::ordered_json all;
  for (const auto& [name, ring] : shapes()) {
    for (const Point2d& p : ring.vertices) all[name].push_back(p.x), all[name].push_back(p.y);
  }
  std::ofstream(file) << all << '\n';
}

bool verified() {
  bool held = true;
  for (const auto& [name, ring] : shapes()) {
    const std::string defect = oracle::triangulate_polygon_defect(ring, robust::triangulate_polygon(ring));
    std::printf("%-8s %zu vertices: %s\n", name.c_str(), ring.size(), defect.empty() ? "right" : defect.c_str());
    held = held && defect.empty();
  }
  return held;
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone;
  if (argc == 3 && std::strcmp(argv[1], "--shapes") == 0) return bench::write_shapes(argv[2]), 0;
  if (argc == 2 && std::strcmp(argv[1], "--verify") == 0) return bench::verified() ? 0 : 1;
  for (const auto& [name, ring] : bench::shapes()) {
    benchmark::RegisterBenchmark(("triangulate_polygon_10000/" + name + "/robust").c_str(),
                                 [ring = ring](benchmark::State& state) {
                                   for (auto _ : state) benchmark::DoNotOptimize(robust::triangulate_polygon(ring));
                                   state.SetItemsProcessed(state.iterations());
                                 });
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
