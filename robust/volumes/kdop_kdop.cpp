// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/kdop_kdop.h"

#include <algorithm>
#include <string>

#include "geometry/validation.h"
#include "robust/kernel/filters/box_differences.h"
#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

bool same(const Vector3d& n, const Vector3d& m) {
  return validation::same(n.x, m.x) && validation::same(n.y, m.y) && validation::same(n.z, m.z);
}

void validate_kdop_kdop(const Kdop3d& a, const Kdop3d& b) {
  if (!kernel::valid(a) || !kernel::valid(b)) validation::validate_all("a", a, "b", b);
  if (a.normals.size() != b.normals.size()) throw InvalidInput("b.normals", "the same normals as a");
  for (std::size_t i = 0; i < a.normals.size(); ++i) {
    if (!same(a.normals[i], b.normals[i]))
      throw InvalidInput("b.normals[" + std::to_string(i) + "]", "the same normal as in a");
  }
}

}  // namespace

/// Differences of slabs are those of boxes with as many axes.
Perhaps<Contact> stages::kdop_kdop::filter(const Kdop3d& a, const Kdop3d& b) {
  const std::size_t count = a.normals.size();
  if (count == 0 || b.normals.size() != count || a.slabs.size() != count || b.slabs.size() != count)
    return std::nullopt;
  kernel::BoxDifferences all =
      kernel::differences_on_axis(a.slabs[0].min, a.slabs[0].max, b.slabs[0].min, b.slabs[0].max);
  int valid = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const Slabd &s = a.slabs[i], &t = b.slabs[i];
    if (i > 0) all = kernel::together(all, kernel::differences_on_axis(s.min, s.max, t.min, t.max));
    valid &= static_cast<int>(kernel::valid(a.normals[i], rule::normal)) &
             static_cast<int>(same(a.normals[i], b.normals[i]));
  }
  if (valid == 0 || !all.certain()) return std::nullopt;
  return all.contact();
}

Contact stages::kdop_kdop::exact(const Kdop3d& a, const Kdop3d& b) {
  using kernel::ordered_bits;
  Contact contact = Contact::overlapping;
  for (std::size_t i = 0; i < a.slabs.size(); ++i) {
    const auto low = std::max(ordered_bits(a.slabs[i].min), ordered_bits(b.slabs[i].min));
    const auto high = std::min(ordered_bits(a.slabs[i].max), ordered_bits(b.slabs[i].max));
    if (low > high) return Contact::disjoint;
    if (low == high) contact = Contact::touching;
  }
  return contact;
}

Decided<Contact> stages::kdop_kdop::ask(const Kdop3d& a, const Kdop3d& b) {
  return in_turn<kdop_kdop, Stage::filter, validate_kdop_kdop, Stage::exact>(a, b);
}

Contact kdop_kdop(const Kdop3d& a, const Kdop3d& b) { return stages::kdop_kdop::ask(a, b).answer; }

}  // namespace touchstone::robust
