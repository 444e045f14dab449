// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/orientation.h"

#include "robust/batch/isa/rows.h"
#include "robust/lines/orientation.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::orientation(q...); };

}  // namespace

void orientation(const Points2& p0, const Points2& p1, const Points2& p, std::size_t count, std::uint8_t* answers,
                 Instructions) {
  decide_each(decide, count, answers, p0, p1, p);
}

}  // namespace touchstone::robust::batch
