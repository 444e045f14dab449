// SPDX-License-Identifier: Apache-2.0
#include "simulate/world/energy.h"

namespace touchstone::simulate {
namespace {

using catalogue::exact_value;

Vector3<Exact> in_exact(const Vector3d& v) {
  return {Exact(exact_value(v.x)), Exact(exact_value(v.y)), Exact(exact_value(v.z))};
}

mpq_class square(const Vector3<Exact>& v) { return dot(v, v).value(); }

/// The energy of the wall's spring while a particle is behind it.
mpq_class of_spring(const Scene& scene, const Wall& wall, const Vector3<Exact>& place) {
  const Vector3<Exact> normal = in_exact(wall.plane.normal);
  const mpq_class e = dot(normal, place).value() + exact_value(wall.plane.offset);
  if (sgn(e) >= 0) return 0;
  return exact_value(scene.settings.stiffness) * e * e / (2 * square(normal));
}

}  // namespace

mpq_class energy(const Scene& scene, const State<Exact>& state) {
  mpq_class sum = 0;
  const Vector3<Exact> gravity = in_exact(scene.gravity);
  for (std::size_t i = 0; i < state.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    if (body.fixed) continue;
    const auto& [p, v] = state[i];
    const Vector3<Exact> place{p.x, p.y, p.z};
    const mpq_class mass = exact_value(body.mass);
    sum += kinetic_energy(mass, v) - mass * dot(gravity, place).value();
    if (scene.settings.law != Law::penalty) continue;
    for (const Wall& wall : scene.walls) sum += of_spring(scene, wall, place);
  }
  return sum;
}

mpq_class kinetic_energy(const mpq_class& mass, const Vector3<Exact>& velocity) { return mass * square(velocity) / 2; }

std::array<mpq_class, 3> momentum(const Scene& scene, const State<Exact>& state) {
  std::array<mpq_class, 3> sum;
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (scene.bodies[i].fixed) continue;
    const mpq_class mass = exact_value(scene.bodies[i].mass);
    const Vector3<Exact>& v = state[i].velocity;
    sum[0] += mass * v.x.value(), sum[1] += mass * v.y.value(), sum[2] += mass * v.z.value();
  }
  return sum;
}

State<Exact> in_exact(const State<double>& state) {
  const auto number = [](double x) { return Exact(exact_value(x)); };
  State<Exact> exact;
  for (const auto& [p, v] : state)
    exact.push_back({{number(p.x), number(p.y), number(p.z)}, {number(v.x), number(v.y), number(v.z)}});
  return exact;
}

}  // namespace touchstone::simulate
