// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/operation/operation.h"
#include "proptests/catch.h"

namespace touchstone::proptests {

/// Registers one test case for every operation of the catalogue, named "<operation>: <sentence>".
class EachOperation {
 public:
  using Body = void (*)(const catalogue::Operation&);

  EachOperation(const char* file, std::size_t line, const std::string& sentence, Body body) {
    for (const catalogue::Operation* operation : catalogue::all_operations()) {
      const std::string name = operation->name() + ": " + sentence;
      Catch::AutoReg(TestInvoker(new Case(*operation, body)), Catch::SourceLineInfo(file, line), Catch::StringRef(),
                     Catch::NameAndTags(name, "[agreement]"));
    }
  }

 private:
  class Case : public Catch::ITestInvoker {
   public:
    Case(const catalogue::Operation& operation, Body body) : operation_(operation), body_(body) {}
    void invoke() const override { body_(operation_); }

   private:
    const catalogue::Operation& operation_;
    Body body_;
  };
};

}  // namespace touchstone::proptests

/// EACH_OPERATION("answers as the oracle does") { ... operation ... }
#define EACH_OPERATION(sentence) TOUCHSTONE_EACH_OPERATION(__COUNTER__, sentence)
#define TOUCHSTONE_EACH_OPERATION(number, sentence) TOUCHSTONE_EACH_OPERATION_NUMBERED(number, sentence)
#define TOUCHSTONE_EACH_OPERATION_NUMBERED(number, sentence)                                            \
  static void body_##number(const ::touchstone::catalogue::Operation& operation);                       \
  static const ::touchstone::proptests::EachOperation registered_##number(__FILE__, __LINE__, sentence, \
                                                                          &body_##number);              \
  static void body_##number([[maybe_unused]] const ::touchstone::catalogue::Operation& operation)
