// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/capsule_capsule.h"

#include "robust/batch/isa/run.h"
#include "robust/mixed/capsule_capsule.h"

namespace touchstone::robust::batch {

void capsule_capsule(const Capsules3& a, const Capsules3& b, std::size_t count, std::uint8_t* answers,
                     const Limits& limits) {
  constexpr auto decide = [](const auto&... q) { return robust::capsule_capsule(q...); };
  isa::run(isa::Which{&isa::Filters::capsule_capsule}, limits, decide, decide, count, answers, a, b);
}

}  // namespace touchstone::robust::batch
