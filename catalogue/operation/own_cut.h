// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/polyhedra.h"

namespace touchstone::catalogue {

/// A part of a question as robust is asked it: itself.
template <class Part>
class OwnCut {
 public:
  explicit OwnCut(const Part& part) : part_(part) {}
  const Part& operator()() const { return part_; }

 private:
  const Part& part_;
};

/// Of a mesh named by polygons the cut that robust makes itself, so that what cuts is judged too. Where the cut that
/// was given is not valid, robust is asked that, and refuses it.
template <>
class OwnCut<Meshd> {
 public:
  explicit OwnCut(const Meshd& mesh);
  const Meshd& operator()() const { return cut_ ? *cut_ : mesh_; }

 private:
  const Meshd& mesh_;
  std::optional<Meshd> cut_;
};

}  // namespace touchstone::catalogue
