// SPDX-License-Identifier: Apache-2.0
// One decision over arrays, so that its instructions can be counted from outside (count.py):
//
//   rows OPERATION SET CASES COUNT plain|marked     SET: portable, avx2 or neon, avx512 or sve; CASES: random or grid
//
// asks twice, the second time between two signals SIGUSR1 if marked, and prints the hash of the answers. Random
// numbers are uniform in [-1, 1), those on the grid integers in 0 .. 7, of which many questions are degenerate. The
// same rows on every machine.
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "robust/batch/aabb_aabb.h"
#include "robust/batch/orientation.h"
#include "robust/batch/point_on_segment.h"
#include "robust/batch/point_plane.h"
#include "robust/batch/ray_aabb.h"
#include "robust/batch/ray_triangle.h"
#include "robust/batch/segment_segment.h"
#include "robust/batch/segment_triangle.h"
#include "robust/batch/sphere_aabb.h"
#include "robust/batch/sphere_sphere.h"
#include "robust/batch/triangle_triangle.h"

namespace {

using namespace touchstone::robust::batch;

class Rows {
 public:
  Rows(bool on_grid, std::size_t count) : on_grid(on_grid), count(count) {}

  template <class Operand>
  Operand operand() {
    if constexpr (std::is_same_v<Operand, Points2>) return {numbers(), numbers()};
    if constexpr (std::is_same_v<Operand, Points3>) return {numbers(), numbers(), numbers()};
    if constexpr (std::is_same_v<Operand, Segments2>) return {operand<Points2>(), operand<Points2>()};
    if constexpr (std::is_same_v<Operand, Segments3>) return {operand<Points3>(), operand<Points3>()};
    if constexpr (std::is_same_v<Operand, Triangles3>)
      return {operand<Points3>(), operand<Points3>(), operand<Points3>()};
    if constexpr (std::is_same_v<Operand, Rays3>) return {operand<Points3>(), directions()};
    if constexpr (std::is_same_v<Operand, Planes>) return {directions(), numbers()};
    if constexpr (std::is_same_v<Operand, Spheres3>) return {operand<Points3>(), sizes()};
    if constexpr (std::is_same_v<Operand, Boxes3>) {
      const Points3 min = operand<Points3>();
      return {min, {above(min.x), above(min.y), above(min.z)}};
    }
  }

 private:
  double number() {
    state += 0x9E3779B97F4A7C15;
    std::uint64_t bits = state;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EB;
    bits ^= bits >> 31;
    if (on_grid) return static_cast<double>(bits >> 61);
    return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
  }
  template <class Number>
  Column column(const Number& of_row) {
    columns.emplace_back(count);
    for (std::size_t i = 0; i < count; ++i) columns.back()[i] = of_row(i);
    return Column(columns.back().data());
  }
  Column numbers() {
    return column([&](std::size_t) { return number(); });
  }
  Column sizes() {
    return column([&](std::size_t) { return std::abs(number()); });
  }
  Column above(const Column& least) {
    return column([&](std::size_t i) { return least.data[i] + std::abs(number()); });
  }
  Vectors3 directions() {  // none is zero
    const Points3 v = operand<Points3>();
    return {v.x, v.y, column([&](std::size_t i) { return v.x.data[i] == 0 && v.y.data[i] == 0 ? 1.0 : v.z.data[i]; })};
  }

  bool on_grid;
  std::size_t count;
  std::uint64_t state = 1;
  std::vector<std::vector<double>> columns;
};

struct Asked {
  Rows rows;
  Instructions set;
  std::size_t count;
  bool marked;

  template <class... Operands, class Decide>
  void operator()(const Decide& decide) {
    const std::tuple<Operands...> operands{rows.operand<Operands>()...};  // in this order
    std::vector<std::uint8_t> answers(count);
    const auto call = [&](const Operands&... each) { decide(each..., count, answers.data(), set); };
    std::apply(call, operands);
    if (marked) std::raise(SIGUSR1);
    std::apply(call, operands);
    if (marked) std::raise(SIGUSR1);
    std::uint64_t hash = 0xCBF29CE484222325;
    for (const std::uint8_t answer : answers) hash = (hash ^ answer) * 0x100000001B3;
    std::printf("%016llx\n", static_cast<unsigned long long>(hash));
  }
};

}  // namespace

#define ASK(NAME, ...) \
  if (name == #NAME) return ask.operator()<__VA_ARGS__>([](const auto&... all) { NAME(all...); }), 0

int main(int words, char** word) {
  if (words != 6) return 2;
  std::signal(SIGUSR1, [](int) {});
  const std::string name = word[1], set = word[2];
  const std::size_t count = std::strtoul(word[4], nullptr, 10);
  const Instructions at_most = set == "portable"                  ? Instructions::portable
                               : set == "avx512" || set == "sve" ? Instructions::avx512
                                                                 : Instructions::avx2;
  Asked ask{Rows(word[3] == std::string("grid"), count), at_most, count, word[5] == std::string("marked")};
  ASK(orientation, Points2, Points2, Points2);
  ASK(point_on_segment, Points2, Segments2);
  ASK(segment_segment, Segments2, Segments2);
  ASK(point_plane, Planes, Points3);
  ASK(aabb_aabb, Boxes3, Boxes3);
  ASK(sphere_sphere, Spheres3, Spheres3);
  ASK(sphere_aabb, Spheres3, Boxes3);
  ASK(ray_aabb, Rays3, Boxes3);
  ASK(ray_triangle, Rays3, Triangles3);
  ASK(segment_triangle, Segments3, Triangles3);
  ASK(triangle_triangle, Triangles3, Triangles3);
  return 2;
}
