// SPDX-License-Identifier: Apache-2.0
#include "catalogue/catalogue.h"

#include "catalogue/operation/operation.h"

namespace touchstone::catalogue {

const std::vector<const Operation*>& all_operations() {
  static const std::vector<const Operation*> operations = [] {
    std::vector<const Operation*> made;
    for_each_row([&]<class Row>() { made.push_back(&operation_of_row<Row>()); });
    return made;
  }();
  return operations;
}

}  // namespace touchstone::catalogue
