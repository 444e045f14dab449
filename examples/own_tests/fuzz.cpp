// SPDX-License-Identifier: Apache-2.0
#include <touchstone/robust/lines/segment_segment.h>
#include <touchstone/testing/fuzzed_data.h>

#include "meet.h"

using namespace touchstone;
using namespace touchstone::tests;

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size) {
  FuzzedData data(bytes, size);
  const auto question = data.question<operations::segment_segment>();
  if (!question) return -1;  // outside the contract: not for the corpus
  const auto& [a, b] = *question;
  const bool truth = robust::segment_segment(a, b).relation != SegmentRelation::disjoint;
  if (my::meet(a, b) != truth) fail(*question, truth ? "they meet" : "they do not meet");
  return 0;
}
