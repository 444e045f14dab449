// SPDX-License-Identifier: Apache-2.0
#include "simulate/world/hash.h"

#include <fmt/format.h>

#include <bit>
#include <initializer_list>

namespace touchstone::simulate {
namespace {

/// The last step of the generator SplitMix64: each bit of the argument changes about half of the result's.
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

}  // namespace

std::uint64_t chained(std::uint64_t chain, std::uint64_t hash) {
  return mixed(mixed(chain + 0x9e3779b97f4a7c15u) ^ hash);
}

std::uint64_t hash_of(const Scene& scene, const State<double>& state) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const SceneBody& body = scene.bodies[i];
    const auto& [p, v] = state[i];
    const Vector3d& half = body.half_extents;
    std::uint64_t hash = static_cast<std::uint64_t>(body.shape) * 2 + body.fixed;
    for (const double x : {body.mass, body.radius, half.x, half.y, half.z, p.x, p.y, p.z, v.x, v.y, v.z})
      hash = chained(hash, x == 0 ? 0 : std::bit_cast<std::uint64_t>(x));
    sum += hash;
  }
  return sum;
}

std::string in_digits(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace touchstone::simulate
