// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/staged.h"

namespace touchstone::catalogue {

/// Combines the stages of an operation whose alternatives have answers of different types into those of one type, their
/// variant.
template <class Stages, class Either>
struct StagesEither {
  static robust::Perhaps<Either> enclosed(const auto&... q) {
    const auto found = Stages::enclosed(q...);
    if (!found) return std::nullopt;
    return Either(*found);
  }
  static Either exact(const auto&... q) { return Stages::exact(q...); }
  static robust::Decided<Either> ask(const auto&... q) {
    const auto [answer, stage] = Stages::ask(q...);
    return {answer, stage};
  }
};

}  // namespace touchstone::catalogue
