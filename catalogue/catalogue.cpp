// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/operation.h"
#include "catalogue/operation/row.h"
#include "catalogue/rows/declared.h"

namespace touchstone::catalogue {
namespace {

template <class... R>
std::vector<const Operation*> made_from(const RowList<R...>* /*type*/) {
  return {&operation_of_row<R>()...};
}

}  // namespace

const std::vector<const Operation*>& all_operations() {
  static const std::vector<const Operation*> operations = made_from(static_cast<const Rows*>(nullptr));
  return operations;
}

}  // namespace touchstone::catalogue
