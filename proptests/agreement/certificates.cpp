// SPDX-License-Identifier: Apache-2.0
#include "catalogue/explained.h"
#include "proptests/drawn.h"
#include "proptests/each_operation.h"

namespace touchstone::proptests {
namespace {

std::string complaint(const Operation& operation, const Question& question) {
  try {
    operation.examine(question);
  } catch (const InvalidInput&) {
    return "";
  }
  return audit::certificate_complaint(operation, question);
}

}  // namespace

EACH_OPERATION("the checker accepts every certificate of the oracle") {
  if (operation.card().is_method()) return;  // the oracle is that of the operation
  never(
      operation, "the certificate is accepted",
      [&](const Question& question) { return complaint(operation, question); }, 12, 8);
}

}  // namespace touchstone::proptests
