// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

/// The signatures of an engine's member functions, as text for pages.
namespace touchstone::audit {

/// A member function as written in an engine, and its other possible return types.
struct Signature {
  std::string text;  ///< "SegmentSegment<double> segment_segment(Segment2<double> a, Segment2<double> b)"
  std::vector<std::string> instead;
};

/// One for each alternative of the operation's questions.
std::vector<Signature> signatures(const Operation& operation);

/// The arguments of one alternative: "(Segment2<double> a, Segment2<double> b)".
std::string arguments_text(const Operation& operation, std::size_t alternative);

}  // namespace touchstone::audit
