// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/from_logs.h"

#include <algorithm>
#include <set>

#include "audit/counting/judged.h"
#include "audit/judging/course.h"
#include "audit/logs/log_reader.h"
#include "audit/reducing/reduced.h"
#include "audit/reducing/same_finding.h"
#include "audit/vectors/likeness.h"

namespace touchstone::audit {
namespace {

constexpr std::size_t most_of_a_kind = 6, most_before_reducing = 4 * most_of_a_kind;

struct Smaller {
  bool operator()(const Question& a, const Question& b) const { return smaller(a, b); }
};
using Questions = std::set<Question, Smaller>;

/// True if the formula is as near to another course as its own rounding, to first order.
bool is_near(const RecordedCall& call) {
  const Course course = course_of(call, call.binary32);
  return course.in_doubt || course.nearest < 1;
}

bool is_wrong(const RecordedCall& call, const Examination& examination, Declaration declaration) {
  declaration.binary32 = call.binary32;
  return is_finding(judged(reply_of(call), examination, declaration).verdict);
}

/// Accepts questions that stay of one kind.
class SameKind final : public Interest {
 public:
  SameKind(const Operation& operation, std::string kind) : operation_(operation), kind_(std::move(kind)) {}
  Look look(std::size_t, const Question& question) override {
    try {
      return likeness(*operation_.examine(question)) == kind_ ? Look::holds : Look::fails;
    } catch (const InvalidInput&) {
      return Look::refused;
    }
  }

 private:
  const Operation& operation_;
  std::string kind_;
};

}  // namespace

std::map<const Operation*, std::vector<Question>> hardest_of_logs(const std::vector<std::string>& files,
                                                                  const std::vector<const Operation*>& operations,
                                                                  int jobs) {
  std::map<const Operation*, std::map<std::string, Questions>> kinds;
  for (const std::string& file : files) {
    LogReader log(file);
    for (RecordedCall call; log.next(call);) {
      if (std::find(operations.begin(), operations.end(), call.operation) == operations.end()) continue;
      try {
        const auto examination = call.operation->examine(call.question);
        if (!is_near(call) && !is_wrong(call, *examination, log.header().declaration)) continue;
        Questions& questions = kinds[call.operation][likeness(*examination)];
        questions.insert(call.question);
        if (questions.size() > most_before_reducing) questions.erase(std::prev(questions.end()));
      } catch (const InvalidInput&) {
        continue;
      }
    }
  }
  std::map<const Operation*, std::vector<Question>> hardest;
  for (const auto& [operation, of_operation] : kinds) {
    for (const auto& [kind, questions] : of_operation) {
      Questions reduced_ones;
      for (const Question& question : questions) {
        SameKind interest(*operation, kind);
        const bool dear = steps_too_many(*operation, question);
        reduced_ones.insert(dear ? question : reduced(*operation, question, interest, {.jobs = jobs}).question);
      }
      std::size_t kept = 0;
      for (const Question& question : reduced_ones)
        if (kept++ < most_of_a_kind) hardest[operation].push_back(question);
    }
  }
  return hardest;
}

}  // namespace touchstone::audit
