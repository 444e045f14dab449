// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/obb_obb.h"

#include "robust/batch/isa/run.h"
#include "robust/volumes/obb_obb.h"

namespace touchstone::robust::batch {

void obb_obb(const Obbs3& a, const Obbs3& b, std::size_t count, std::uint8_t* answers, const Limits& limits) {
  constexpr auto decide = [](const auto&... q) { return robust::obb_obb(q...); };
  isa::run(isa::Which{&isa::Filters::obb_obb}, limits, decide, decide, count, answers, a, b);
}

}  // namespace touchstone::robust::batch
