// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/probes/fitted.h"

#include <algorithm>
#include <cmath>

#include "catalogue/judge/wide.h"
#include "catalogue/numbers/ulps.h"
#include "catalogue/operation/probes/values_in.h"

namespace touchstone::catalogue {
namespace {

using Axes = HalfAxes<double>;
using Real = long double;

Vector3d in_doubles(const Displacement& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}
Displacement unit(const Displacement& v) { return Real(1 / wide_length(v)) * v; }
bool dependent(const Axes& axes) {
  const auto exact = [](const Vector3d& v) {
    return Vector3<mpq_class>{exact_value(v.x), exact_value(v.y), exact_value(v.z)};
  };
  return sgn(dot(exact(axes.u), cross(exact(axes.v), exact(axes.w)))) == 0;
}
/// Drops the polygons of meshes: their triangles become the faces.
Question triangulated(const Operation& operation, const Question& question) {
  Question result = question;
  const Word* const words = question.words.data();
  std::size_t shorter = 0;
  for_each_value<Meshd>(operation, question, [&](const Meshd& mesh, const Cursor<double>& first) {
    if (mesh.polygons.empty()) return;
    const Meshd triangles{mesh.vertices, mesh.faces, {}};
    const std::vector<Word> before = packed(mesh).words, after = packed(triangles).words;
    const auto at = result.words.begin() + (first.word - words) - static_cast<std::ptrdiff_t>(shorter);
    std::copy(after.begin(), after.end(), at);
    result.words.erase(at + static_cast<std::ptrdiff_t>(after.size()), at + static_cast<std::ptrdiff_t>(before.size()));
    shorter += before.size() - after.size();
  });
  return result;
}
bool is_finite(const Vector3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

HalfAxes<double> at_right_angles(const Axes& half_axes) {
  const Displacement u = displacement(half_axes.u), v = displacement(half_axes.v), w = displacement(half_axes.w);
  const auto beside = [](const Displacement& a, const Displacement& b) {
    return std::fabs(dot(a, b)) <= 0x1p-50L * wide_length(a) * wide_length(b);
  };
  if (beside(u, v) && beside(v, w) && beside(w, u)) return half_axes;
  if (dependent(half_axes)) return half_axes;
  Displacement second = v;
  for (int pass = 0; pass < 2; ++pass) second = second - Real(dot(u, second) / dot(u, u)) * u;  // twice is enough
  const Displacement third = unit(cross(u, second));
  const Real height =
      std::fmax(std::fabs(dot(w, third)), 0x1p-40L * wide_length(w));  // computed from what rounding leaves
  const Axes turned{half_axes.u, in_doubles(second), in_doubles(height * third)};
  return is_finite(turned.v) && is_finite(turned.w) ? turned : half_axes;
}

Question fitted(const Operation& operation, const Question& question, const Declaration& declaration) {
  Question result = declaration.polygons ? question : triangulated(operation, question);
  if (!declaration.skew_boxes) {
    for_each_value<Axes>(operation, question, [&](const Axes& axes, const Cursor<double>& first) {
      const EncodedValue<double> turned = packed(at_right_angles(axes));
      std::copy(turned.numbers.begin(), turned.numbers.end(),
                result.numbers.begin() + (first.number - question.numbers.data()));
    });
  }
  return declaration.binary32 ? operation.in_binary32(result) : result;
}

bool takes_alternative(const Operation& operation, const Question& question, const Declaration& declaration) {
  const auto only = declaration.alternatives.find(operation.name());
  return only == declaration.alternatives.end() || only->second.count(question.words[0]) > 0;
}

}  // namespace touchstone::catalogue
