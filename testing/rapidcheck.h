// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck.h>

#include <ostream>

#include "testing/asked.h"
#include "testing/words.h"

/// RapidCheck: generators of every operation's questions - degenerate on purpose, always within the contract - that
/// shrink within their family and print as JSON, in hexadecimal, and with the command that asks for the truth.
///
///   #include <touchstone/robust/lines/segment_segment.h>
///   rc::check("segments that touch meet", [] {
///     const auto [a, b] = *touchstone::tests::questions<operations::segment_segment>();
///     RC_ASSERT(my::segments_meet(a, b) == (robust::segment_segment(a, b).relation != SegmentRelation::disjoint));
///   });
namespace touchstone::tests {

inline void showValue(const Drawn& drawn, std::ostream& os) { os << shown(drawn); }
template <class Row, class... Ts>
void showValue(const Asked<Row, Ts...>& asked, std::ostream& os) {
  os << shown(asked);
}

/// A question, with the questions of simpler draws as its shrinks, valid or not.
inline rc::Shrinkable<Drawn> shrinkable(Drawn drawn) {
  return rc::shrinkable::shrinkRecur(std::move(drawn), [](const Drawn& parent) {
    std::vector<Drawn> smaller;
    for (auto& bytes : simpler(parent.draws))
      smaller.push_back(replayed(*parent.operation, parent.family, std::move(bytes)));
    return rc::seq::fromContainer(std::move(smaller));
  });
}

/// The same for valid questions of one operation and of these sizes.
template <class Row, class... Ts>
rc::Shrinkable<Asked<Row, Ts...>> shrinkable(Asked<Row, Ts...> asked, Sizes sizes) {
  return rc::shrinkable::shrinkRecur(std::move(asked), [sizes](const Asked<Row, Ts...>& parent) {
    std::vector<Asked<Row, Ts...>> smaller;
    for (auto& bytes : simpler(parent.drawn.draws)) {
      Drawn drawn = replayed(*parent.drawn.operation, parent.drawn.family, std::move(bytes));
      if (!is_wanted(drawn, sizes)) continue;
      if (auto found = typed<Row, Ts...>(std::move(drawn))) smaller.push_back(*std::move(found));
    }
    return rc::seq::fromContainer(std::move(smaller));
  });
}

/// Generates questions of an operation: questions<operations::orientation>(), of some families
/// questions<operations::orientation>({"collinear"}), without extreme magnitudes questions<operations::orientation>({},
/// Sizes::ordinary), and of one alternative alone questions<operations::sphere_sphere, Sphere3d, Sphere3d>(). Throws
/// InvalidInput if the operation has no such family.
template <class Row, class... Ts>
rc::Gen<Asked<Row, Ts...>> questions(const std::vector<std::string>& families = {}, Sizes sizes = Sizes::any) {
  return [chosen = families_named(operation_of<Row>(), families), sizes](const rc::Random& random, int) {
    return shrinkable(asked<Row, Ts...>(chosen, rc::Random(random).next(), sizes), sizes);
  };
}

}  // namespace touchstone::tests

namespace touchstone {

/// Prints shapes and answers as JSON, enumerators by name.
template <audit::Printed T>
void showValue(const T& value, std::ostream& os) {
  os << audit::printed(value);
}

}  // namespace touchstone
