// SPDX-License-Identifier: Apache-2.0
#include "simulate/run.h"

#include "simulate/step.h"

namespace touchstone::simulate {
namespace {

template <class Real>
Json printed(const State<Real>& state) {
  Json list = Json::array();
  for (const auto& [position, velocity] : state) {
    Json particle = Json::object();
    const auto coordinates = [](const auto& of) {
      Json three = Json::array();
      for (const Real number : {of.x, of.y, of.z}) three.push_back(catalogue::written(static_cast<double>(number)));
      return three;
    };
    particle["position"] = coordinates(position);
    particle["velocity"] = coordinates(velocity);
    list.push_back(std::move(particle));
  }
  return list;
}

State<float> in_float(const State<double>& state) {
  const auto number = [](double x) { return static_cast<float>(x); };
  State<float> result;
  for (const auto& [x, v] : state)
    result.push_back({{number(x.x), number(x.y), number(x.z)}, {number(v.x), number(v.y), number(v.z)}});
  return result;
}

}  // namespace

void run(const Scene& scene, std::uint64_t steps, std::ostream& out) {
  State<double> in_double = scene.particles, by_robust = scene.particles;
  State<float> floats = in_float(scene.particles);
  for (std::uint64_t step = 0;; ++step) {
    Json line = Json::object();
    line["step"] = step;
    line["float"] = printed(floats);
    line["double"] = printed(in_double);
    line["robust"] = printed(by_robust);
    out << catalogue::one_line(line) << '\n';
    if (step == steps) return;
    floats = step_by_formulas(scene, floats);
    in_double = step_by_formulas(scene, in_double);
    by_robust = step_by_robust(scene, by_robust);
  }
}

}  // namespace touchstone::simulate
