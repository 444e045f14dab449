// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_rays.h"
#include "catalogue/shape/described_shapes.h"
#include "geometry/commands.h"

/// Programs: {"insert":box}, {"move":body,"box":box}, {"remove":body}; {"ask":"pairs"}, {"in_box":box},
/// {"at_point":point}, {"along_ray":ray}.
namespace touchstone::catalogue {

template <class R>
struct Described<Insert<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("insert", &Insert<R>::box)};
};
template <class R>
struct Described<Move<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("move", &Move<R>::body), member("box", &Move<R>::box)};
};
template <>
struct Described<Remove> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("remove", &Remove::body)};
};
template <>
struct Described<Ask> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("ask", &Ask::query)};
};
template <class R>
struct Described<InBox<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("in_box", &InBox<R>::box)};
};
template <class R>
struct Described<AtPoint<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("at_point", &AtPoint<R>::point)};
};
template <class R>
struct Described<AlongRay<R>> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("along_ray", &AlongRay<R>::ray)};
};
template <>
struct Described<PairsReply> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("pairs", &PairsReply::pairs)};
};
template <>
struct Described<BodiesReply> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("bodies", &BodiesReply::bodies)};
};
/// What is called `in_order` is judged with its order (catalogue/judge/compare.h).
template <>
struct Described<RayReply> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("in_order", &RayReply::in_order)};
};

template <>
struct Words<Query> {
  static constexpr std::array<const char*, 1> words{"pairs"};
};

}  // namespace touchstone::catalogue
