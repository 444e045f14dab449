// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check_solids.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace touchstone::certify {

std::size_t index(const Rational& value, std::size_t count) {
  const bool there = value.get_den() == 1 && sgn(value) >= 0 && value < static_cast<std::uint64_t>(count);
  expect(there, "certificate: not an index");
  return value.get_num().get_ui();
}

void expect_even(const Mesh& mesh, const std::string& what) {
  std::map<std::pair<std::size_t, std::size_t>, int> times;
  for (const auto& face : mesh.faces) {
    for (std::size_t k = 0; k < 3; ++k) ++times[std::minmax(face[k], face[(k + 1) % 3])];
  }
  for (std::size_t i = 0; i < mesh.named.size(); ++i) {
    const std::vector<std::size_t>& corners = mesh.named[i];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::size_t from = corners[k], to = corners[(k + 1) % corners.size()];
      const std::string field = what + ".faces[" + std::to_string(i) + "]",
                        edge = "from vertex " + std::to_string(from) + " to vertex " + std::to_string(to);
      expect(times[std::minmax(from, to)] % 2 == 0,
             field + ": closed: the edge " + edge + " must be in an even number of faces");
    }
  }
}

Triple from_weights(const Claim& proof, const std::array<Triple, 3>& corners) {
  const std::vector<Rational> weights = proof.list("weights");
  expect(weights.size() == 3, "certificate: three weights");
  Rational sum;
  Triple combination{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    expect(sgn(weights[k]) >= 0, "certificate: a weight is negative");
    sum += weights[k];
    combination = along(combination, weights[k], corners[k]);
  }
  expect(sum == 1, "certificate: the weights give another point");
  return combination;
}

std::string proved_location(const Claim& proof, const Mesh& mesh, const Triple& p) {
  const auto corner = [&](std::size_t face, std::size_t k) { return mesh.vertices[mesh.faces[face][k]]; };
  if (proof.kind() == "on_face") {
    proof.facts({"face", "weights"});
    const std::size_t face = index(proof.single("face"), mesh.faces.size());
    expect(from_weights(proof, {corner(face, 0), corner(face, 1), corner(face, 2)}) == p,
           "certificate: the weights give another point");
    return "boundary";
  }
  proof.expect_kind("crossings");
  proof.facts({"direction", "faces", "t"});
  const Triple direction = triple(proof, "direction");
  std::vector<Rational> crossed, parameters;
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const auto t = crossing({corner(i, 0) - p, corner(i, 1) - p, corner(i, 2) - p}, direction);
    if (t) crossed.emplace_back(i), parameters.push_back(*t);
  }
  expect(proof.list("faces") == crossed && proof.list("t") == parameters, "certificate: the ray crosses other faces");
  return crossed.size() % 2 == 1 ? "inside" : "outside";
}

}  // namespace touchstone::certify
