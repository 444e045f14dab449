// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/orientation.h"

#include "robust/batch/isa/run.h"
#include "robust/lines/orientation.h"

namespace touchstone::robust::batch {
namespace {

constexpr auto decide = [](const auto&... q) { return robust::orientation(q...); };
constexpr auto past_filter = [](const auto&... q) { return stages::orientation::past_filter(q...).answer; };

}  // namespace

void orientation(const Points2& p0, const Points2& p1, const Points2& p, std::size_t count, std::uint8_t* answers,
                 const Limits& limits) {
  isa::run(isa::Which{&isa::Filters::orientation, &isa::Filters::close_orientation}, limits, decide, past_filter, count,
           answers, p0, p1, p);
}

}  // namespace touchstone::robust::batch
