// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>

#include "geometry/capsules.h"
#include "geometry/invalid_input.h"
#include "geometry/rays.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "robust/batch/isa/columns.h"
#include "robust/kernel/machine/parallel.h"

/// Rows of columns, as the operands of a function of one question.
namespace touchstone::robust::batch {

inline double row(const Column& c, std::size_t i) { return c.data[static_cast<std::ptrdiff_t>(i) * c.stride]; }
inline Point2d row(const Points2& p, std::size_t i) { return {row(p.x, i), row(p.y, i)}; }
inline Point3d row(const Points3& p, std::size_t i) { return {row(p.x, i), row(p.y, i), row(p.z, i)}; }
inline Vector2d row(const Vectors2& v, std::size_t i) { return {row(v.x, i), row(v.y, i)}; }
inline Vector3d row(const Vectors3& v, std::size_t i) { return {row(v.x, i), row(v.y, i), row(v.z, i)}; }
inline Segment2d row(const Segments2& s, std::size_t i) { return {row(s.a, i), row(s.b, i)}; }
inline Segment3d row(const Segments3& s, std::size_t i) { return {row(s.a, i), row(s.b, i)}; }
inline Aabb2d row(const Boxes2& b, std::size_t i) { return {row(b.min, i), row(b.max, i)}; }
inline Aabb3d row(const Boxes3& b, std::size_t i) { return {row(b.min, i), row(b.max, i)}; }
inline Circle2d row(const Spheres2& s, std::size_t i) { return {row(s.center, i), row(s.radius, i)}; }
inline Sphere3d row(const Spheres3& s, std::size_t i) { return {row(s.center, i), row(s.radius, i)}; }
inline Plane3d row(const Planes& p, std::size_t i) { return {row(p.normal, i), row(p.offset, i)}; }
inline Ray2d row(const Rays2& r, std::size_t i) { return {row(r.origin, i), row(r.direction, i)}; }
inline Ray3d row(const Rays3& r, std::size_t i) { return {row(r.origin, i), row(r.direction, i)}; }
inline Triangle3d row(const Triangles3& t, std::size_t i) { return {row(t.a, i), row(t.b, i), row(t.c, i)}; }
inline Capsule3d row(const Capsules3& c, std::size_t i) { return {row(c.segment, i), row(c.radius, i)}; }
inline Obb3d row(const Obbs3& b, std::size_t i) {
  const auto& [u, v, w] = b.half_axes;
  return {row(b.center, i), {row(u, i), row(v, i), row(w, i)}};
}

/// Throws the error of a row, with the row's number before the field.
[[noreturn]] void refuse_row(std::size_t i, const InvalidInput& refused);

/// Calls decide(operands...) of one row.
template <class Decide, class... Operands>
std::uint8_t decided(const Decide& decide, std::size_t i, const Operands&... operands) {
  try {
    return static_cast<std::uint8_t>(decide(row(operands, i)...));
  } catch (const InvalidInput& refused) {
    refuse_row(i, refused);
  }
}

/// The parts of so many rows for threads: a thread is made in about the time of a thousand rows.
inline kernel::ThreadParts parts_of(const Limits& limits, std::size_t count) {
  return {limits.threads == 0 ? threads_of_machine() : limits.threads, count, 1U << 13};
}

/// Calls it for every row.
template <class Decide, class... Operands>
void decide_each(const Limits& limits, const Decide& decide, std::size_t count, std::uint8_t* answers,
                 const Operands&... operands) {
  parts_of(limits, count).each([&](std::size_t, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) answers[i] = decided(decide, i, operands...);
  });
}

/// The columns of the operands, one after another.
template <class... Operands>
struct Flat {
  static constexpr std::size_t size = (sizeof(Operands) + ...) / sizeof(Column);
  std::array<Column, size> columns;

  explicit Flat(const Operands&... operands) {
    std::size_t at = 0;
    (add(operands, at), ...);
  }

 private:
  template <class Operand>
  void add(const Operand& operand, std::size_t& at) {
    using Own = std::array<Column, sizeof(Operand) / sizeof(Column)>;
    for (const Column& column : std::bit_cast<Own>(operand)) columns[at++] = column;
  }
};

}  // namespace touchstone::robust::batch
