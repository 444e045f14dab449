// SPDX-License-Identifier: Apache-2.0
#include "audit/catalogue/catalogue.h"

#include "audit/catalogue/operation_of.h"

namespace touchstone::audit {

const std::vector<const Operation*>& catalogue() {
  static const std::vector<const Operation*> operations = [] {
    std::vector<const Operation*> made;
    for_each_row([&]<class Row>() {
      static const OperationOf<Row> operation;
      made.push_back(&operation);
    });
    return made;
  }();
  return operations;
}

Question Operation::on_grid(int size, std::uint64_t index) const {
  Question question{std::vector<double>(arity())};
  for (std::size_t i = arity(); i-- > 0; index /= static_cast<std::uint64_t>(size)) {
    question.numbers[i] = static_cast<double>(index % static_cast<std::uint64_t>(size));
  }
  return question;
}

const Operation* find_operation(const std::string& name) {
  for (const Operation* operation : catalogue()) {
    if (operation->name() == name) return operation;
  }
  return nullptr;
}

}  // namespace touchstone::audit
