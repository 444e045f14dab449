// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_shapes.h"
#include "geometry/commands.h"

/// Programs: {"insert":box}, {"move":body,"box":box}, {"remove":body}, {"ask":"pairs"}.
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
template <>
struct Described<PairsReply> {
  static constexpr Form form = Form::record;
  static constexpr auto members = std::tuple{member("pairs", &PairsReply::pairs)};
};

template <>
struct Words<Query> {
  static constexpr std::array<const char*, 1> words{"pairs"};
};

}  // namespace touchstone::catalogue
