// SPDX-License-Identifier: Apache-2.0
#include "catalogue/catalogue.h"

namespace touchstone::audit {

const std::vector<const Operation*>& catalogue() {
  static const std::vector<const Operation*> operations = [] {
    std::vector<const Operation*> made;
    for_each_row([&]<class Row>() { made.push_back(&operation_of_row<Row>()); });
    return made;
  }();
  return operations;
}

Question Operation::on_grid(int size, std::uint64_t index, std::size_t list_length) const {
  Question question = zeros(list_length);
  const std::vector<std::size_t> places = coordinates(question);
  for (std::size_t i = places.size(); i-- > 0; index /= static_cast<std::uint64_t>(size)) {
    question.numbers[places[i]] = static_cast<double>(index % static_cast<std::uint64_t>(size));
  }
  return question;
}

std::optional<std::uint64_t> Operation::configurations(int size, std::size_t list_length) const {
  std::uint64_t total = 1;
  for (std::size_t i = coordinates(zeros(list_length)).size(); i > 0; --i) {
    if (__builtin_mul_overflow(total, static_cast<std::uint64_t>(size), &total)) return std::nullopt;
  }
  return total;
}

const Operation* find_operation(const std::string& name) {
  for (const Operation* operation : catalogue()) {
    if (operation->name() == name) return operation;
  }
  return nullptr;
}

}  // namespace touchstone::audit
