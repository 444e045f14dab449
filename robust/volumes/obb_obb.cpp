// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/obb_obb.h"

#include <array>

#include "geometry/validation.h"
#include "robust/kernel/filters/obb_filter.h"
#include "robust/kernel/shapes/valid.h"
#include "robust/kernel/solids/parallelepiped.h"

namespace touchstone::robust {
namespace {

/// An axis: the cross product of two of the six half axes, a's before b's; and the four others. First the normals of
/// a's faces, then of b's, then of an edge of a and an edge of b.
struct Spanned {
  std::size_t v, w;
  std::array<std::size_t, 4> others;
};
constexpr std::array<Spanned, 15> axes{{{1, 2, {0, 3, 4, 5}},
                                        {2, 0, {1, 3, 4, 5}},
                                        {0, 1, {2, 3, 4, 5}},
                                        {4, 5, {3, 0, 1, 2}},
                                        {5, 3, {4, 0, 1, 2}},
                                        {3, 4, {5, 0, 1, 2}},
                                        {0, 3, {1, 2, 4, 5}},
                                        {0, 4, {1, 2, 3, 5}},
                                        {0, 5, {1, 2, 3, 4}},
                                        {1, 3, {0, 2, 4, 5}},
                                        {1, 4, {0, 2, 3, 5}},
                                        {1, 5, {0, 2, 3, 4}},
                                        {2, 3, {0, 1, 4, 5}},
                                        {2, 4, {0, 1, 3, 5}},
                                        {2, 5, {0, 1, 3, 4}}}};

/// True if v x w is certainly zero: in each of its products a factor is 0, or one vector is the other or its opposite.
/// Compares bits: no subnormal is read as 0. (Boxes with a common orientation are frequent.)
bool parallel(const Vector3d& v, const Vector3d& w) {
  using validation::same, validation::zero;
  if (same(v.x, w.x) && same(v.y, w.y) && same(v.z, w.z)) return true;
  if (same(v.x, -w.x) && same(v.y, -w.y) && same(v.z, -w.z)) return true;
  const auto no_product = [](double x, double y) { return zero(x) || zero(y); };
  return no_product(v.y, w.z) && no_product(v.z, w.y) && no_product(v.z, w.x) && no_product(v.x, w.z) &&
         no_product(v.x, w.y) && no_product(v.y, w.x);
}

}  // namespace

Perhaps<Contact> stages::obb_obb::filter(const Obb3d& a, const Obb3d& b) {
  const auto& [u, v, w] = a.half_axes;
  const auto& [x, y, z] = b.half_axes;
  const std::array<Vector3d, 6> edges{u, v, w, x, y, z};
  const filters::ObbAxes<double> pair(edges, b.center - a.center);
  if (!pair.independent()) [[unlikely]]
    return std::nullopt;
  bool unknown = false;
  for (const Spanned& axis : axes) {
    const filters::Sign apart = pair.on_axis(axis.v, axis.w, axis.others);
    if (apart == filters::Sign::positive) return Contact::disjoint;
    if (apart == filters::Sign::unknown) [[unlikely]]
      unknown = unknown || !parallel(edges[axis.v], edges[axis.w]);
  }
  if (unknown) [[unlikely]]
    return std::nullopt;
  return Contact::overlapping;
}

namespace {

/// On each nonzero axis compares the distance of the centers with the sum of the boxes' reaches.
template <class Integer>
Contact contact(const std::array<Integer, 24>& n) {
  const auto at = [&n](std::size_t i) { return kernel::vector_at(n, i); };
  const std::array<Vector3<Integer>, 6> edges{at(3), at(6), at(9), at(15), at(18), at(21)};
  const Vector3<Integer> displacement = at(12) - at(0);
  bool touching = false;
  for (const Spanned& each : axes) {
    const auto axis = kernel::axis_across(edges[each.v], edges[each.w]);
    if (kernel::sign_of(axis.x) == 0 && kernel::sign_of(axis.y) == 0 && kernel::sign_of(axis.z) == 0) continue;
    kernel::Third<Integer> gap = kernel::along_axis(axis, displacement);
    for (const std::size_t other : each.others) gap = gap + -kernel::along_axis(axis, edges[other]);
    const int apart = kernel::sign_of(gap);
    if (apart > 0) return Contact::disjoint;
    touching = touching || apart == 0;
  }
  return touching ? Contact::touching : Contact::overlapping;
}

/// `numbers` takes any count of doubles.
template <class Numbers>
auto numbers_of(const Obb3d& a, const Obb3d& b, const Numbers& numbers) {
  const Point3d &c = a.center, &d = b.center;
  const auto& [u, v, w] = a.half_axes;
  const auto& [x, y, z] = b.half_axes;
  return numbers(c.x, c.y, c.z, u.x, u.y, u.z, v.x, v.y, v.z, w.x, w.y, w.z,  //
                 d.x, d.y, d.z, x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z);
}

void validate_obb_obb(const Obb3d& a, const Obb3d& b) {
  if (!kernel::valid(b) && kernel::valid(a)) validation::validate_numbers("b", b);  // before the rules of a
  kernel::validate_obb("a", a), kernel::validate_obb("b", b);
}

}  // namespace

Perhaps<Contact> stages::obb_obb::lattice(const Obb3d& a, const Obb3d& b) {
  const auto lattice = numbers_of(a, b, [](auto... n) { return kernel::lattice_of(n...); });
  if (!lattice) return std::nullopt;
  return contact(lattice->at);
}

Contact stages::obb_obb::exact(const Obb3d& a, const Obb3d& b) {
  return contact(numbers_of(a, b, [](auto... n) { return kernel::integers_of(n...); }).at);
}

Decided<Contact> stages::obb_obb::ask(const Obb3d& a, const Obb3d& b) {
  return in_turn<obb_obb, Stage::filter, validate_obb_obb, Stage::lattice, Stage::exact>(a, b);
}

Contact obb_obb(const Obb3d& a, const Obb3d& b) { return stages::obb_obb::ask(a, b).answer; }

}  // namespace touchstone::robust
