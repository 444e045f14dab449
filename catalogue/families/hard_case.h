// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/families/draw_stream.h"

namespace touchstone::catalogue {

/// A family of questions that are hard on purpose.
template <class Question>
struct HardCase {
  std::string name;               ///< the family: "collinear", "shared_end" ...
  Question (*draw)(DrawStream&);  ///< integers and other exact parameters, so that a shrunk case stays degenerate
  /// Neither scaled nor, as a family of its own, moved by an ulp: its mesh has to stay one that test vectors can name,
  /// or its lists are so long that once is dear enough.
  bool unscaled = false;
};

}  // namespace touchstone::catalogue
