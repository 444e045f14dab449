// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/polyhedra.h"

namespace touchstone::catalogue {

/// A part of a question as passed to robust: itself.
template <class Part>
class OwnCut {
 public:
  explicit OwnCut(const Part& part) : part_(part) {}
  const Part& operator()() const { return part_; }

 private:
  const Part& part_;
};

/// For a mesh given by polygons: the triangulation that robust computes, so that the triangulation is judged too. If
/// the given triangulation is not valid, robust gets that one, and refuses it.
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
