// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <utility>

#include "catalogue/operation/row.h"
#include "geometry/capsules.h"
#include "geometry/rays.h"
#include "geometry/triangles.h"
#include "robust/batch/isa/columns.h"

/// The array form of a row: its arguments of a fixed size as columns, the others shared by all rows of the arrays.
namespace touchstone::catalogue {

namespace batch = robust::batch;

/// The columns that form an argument; the argument itself if it is shared.
template <class T>
struct OperandOf {
  using type = T;
};
#define TOUCHSTONE_COLUMNS(shape, columns) \
  template <>                              \
  struct OperandOf<shape> {                \
    using type = batch::columns;           \
  };
TOUCHSTONE_COLUMNS(Point2d, Points2)
TOUCHSTONE_COLUMNS(Point3d, Points3)
TOUCHSTONE_COLUMNS(Segment2d, Segments2)
TOUCHSTONE_COLUMNS(Segment3d, Segments3)
TOUCHSTONE_COLUMNS(Aabb2d, Boxes2)
TOUCHSTONE_COLUMNS(Aabb3d, Boxes3)
TOUCHSTONE_COLUMNS(Circle2d, Spheres2)
TOUCHSTONE_COLUMNS(Sphere3d, Spheres3)
TOUCHSTONE_COLUMNS(Plane3d, Planes)
TOUCHSTONE_COLUMNS(Ray2d, Rays2)
TOUCHSTONE_COLUMNS(Ray3d, Rays3)
TOUCHSTONE_COLUMNS(Triangle3d, Triangles3)
TOUCHSTONE_COLUMNS(Capsule3d, Capsules3)
TOUCHSTONE_COLUMNS(Obb3d, Obbs3)
#undef TOUCHSTONE_COLUMNS
template <class T>
inline constexpr bool is_column = !std::is_same_v<typename OperandOf<T>::type, T>;

/// The next columns, or the argument itself.
template <class T>
typename OperandOf<T>::type operand(const T& argument, const batch::Column*& next) {
  if constexpr (is_column<T>) {
    using Operand = typename OperandOf<T>::type;
    std::array<batch::Column, sizeof(Operand) / sizeof(batch::Column)> own;
    for (batch::Column& column : own) column = *next++;
    return std::bit_cast<Operand>(own);
  } else {
    return argument;
  }
}

/// True if a row has an array form for its questions.
template <class Row, class Asked>
inline constexpr bool answers_arrays = false;
template <class Row, class... Ts>
requires requires(const typename OperandOf<Ts>::type&... operands) {
  Row::batch(operands..., std::size_t{}, static_cast<std::uint8_t*>(nullptr), batch::Instructions::avx512);
}
inline constexpr bool answers_arrays<Row, std::tuple<Ts...>> = true;
template <class Row, class... Ts>
inline constexpr bool answers_arrays<Row, std::variant<Ts...>> = (answers_arrays<Row, Ts> && ...);

/// The functions of RowFunctions::batch, for a question's type.
template <class Row, class Asked>
struct ArraysOf {
  static void decide(const Question& shared, const batch::Column* columns, std::size_t count, std::uint8_t* answers,
                     batch::Instructions at_most) {
    applied(
        [&]<class... Ts>(const Ts&... argument) {
          const batch::Column* next = columns;
          const std::tuple<typename OperandOf<Ts>::type...> operands{operand(argument, next)...};
          spread([&](const auto&... each) { Row::batch(each..., count, answers, at_most); }, operands);
        },
        unpacked<Asked>(shared));
  }

  static std::vector<std::size_t> columns(const Question& question) {
    std::vector<std::size_t> found;
    std::size_t at = 0;
    const auto add = [&]<class T>(const T& argument) {
      const std::size_t end = at + packed(argument).numbers.size();
      for (; at < end; ++at)
        if (is_column<T>) found.push_back(at);
    };
    applied([&](const auto&... argument) { (add(argument), ...); }, unpacked<Asked>(question));
    return found;
  }
};

}  // namespace touchstone::catalogue
