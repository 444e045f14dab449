// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/operation/operation.h"
#include "catalogue/rows/all.h"

namespace touchstone::catalogue {

template <class... R>
struct RowList {
  template <class Visit>
  static void for_each(const Visit& visit) {
    (visit.template operator()<R>(), ...);
  }
};

/// visit.template operator()<Row>() for every row, in the order of the deck. `Rows` is made from the files in
/// catalogue/rows/ (cmake/rows.cmake): there is no other list of operations.
template <class Visit>
void for_each_row(const Visit& visit) {
  Rows::for_each(visit);
}

}  // namespace touchstone::catalogue
