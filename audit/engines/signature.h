// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

/// What the member functions of an engine look like, as text for pages.
namespace touchstone::audit {

/// A member function as it stands in an engine, and what else it may return.
struct Signature {
  std::string text;  ///< "SegmentSegment<double> segment_segment(Segment2<double> a, Segment2<double> b)"
  std::vector<std::string> instead;
};

/// One for each alternative of the operation's questions.
std::vector<Signature> signatures(const Operation& operation);

/// "(Segment2<double> a, Segment2<double> b)", of one alternative.
std::string arguments_text(const Operation& operation, std::size_t alternative);

}  // namespace touchstone::audit
