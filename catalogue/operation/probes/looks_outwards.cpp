// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/probes/looks_outwards.h"

#include <algorithm>

#include "catalogue/operation/probes/values_in.h"

namespace touchstone::catalogue {

bool looks_outwards(const Operation& operation, const Question& question) {
  bool outwards = true;
  for_each_value<Meshd>(operation, question, [&](const Meshd& mesh, const Cursor<double>&) {
    double volume = 0;
    for (const auto& [a, b, c] : mesh.faces) {
      if (std::max({a, b, c}) >= mesh.vertices.size()) return void(outwards = false);
      const auto at = [&](Index i) { return mesh.vertices[i] - mesh.vertices[0]; };
      volume += dot(at(a), cross(at(b), at(c)));
    }
    outwards = outwards && volume > 0;
  });
  return outwards;
}

}  // namespace touchstone::catalogue
