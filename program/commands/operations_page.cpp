// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "audit/engines/signature.h"
#include "program/commands/commands.h"
#include "program/commands/shape_pairs.h"
#include "program/terminal/exit_codes.h"

namespace touchstone::program {
namespace {

constexpr const char* introduction = R"(# Operations: C++ signatures, JSON fields, words

This page is printed by `touchstone ops --markdown`, from the catalogue; do not edit it. What an operation means -
closed sets, degenerate inputs, errors - is its contract, the comment at its name in a header of
[reference/](../reference).

- **C++**: the member function of an engine ([engines.md](engines.md)) and the arguments that `robust`, `reference`
  and the generators of [testing.md](testing.md) have. Shapes are in [geometry/](../geometry); `Segment2d` is short
  for `Segment2<double>`. Arguments may be taken by value or by const reference, and with `using number = float` over
  `float`. A member of an operation's name with other arguments does not compile. An engine may return the whole
  answer, one of the types after "or", or a `std::optional` of these.
- **JSON**: the question as an engine over pipes is given it, and the answer. A name that ends in `?` may be left out;
  `A | B` stands for one of these words, "index" for a place in a list, counted from 0.
- **Words**: the enumerators of the answer. Where "plain" names a word, `true` and `false` are answers as well, and
  `false` means that word.
- **Other formulas** of textbooks and programs for the same question are in
  [reference/standard/](../reference/standard): the judge does not blame an engine where they round
  ([judging.md](judging.md#who-is-to-blame)).
- **Time** grows like this with n, the elements of all lists of a question in general position (vertices and faces of
  meshes are elements): of `robust`, of the oracle's truth and margin, of all that `ask` prints but the textbook
  formula, and of that formula. Where nothing is said, a question has no lists.
)";

/// Collects enumerators of an answer that mean "no common point".
void plain_words(const Shape& shape, std::vector<std::string>& found) {
  if (shape.kind == Shape::Kind::word && shape.no >= 0)
    found.push_back(shape.words[static_cast<std::size_t>(shape.no)]);
  for (const Shape::Part& part : shape.parts) plain_words(*part.shape, found);
}

std::string in_code(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "`" : ", `") + word + "`";
  return text;
}

/// JSON with conventional spacing: `{"a": [1, 2]}`.
std::string spaced(const Json& json) {
  std::string text;
  bool quoted = false;
  for (const char c : json.dump()) {
    quoted = quoted != (c == '"');
    text += c;
    if (!quoted && (c == ':' || c == ',')) text += ' ';
  }
  return text;
}

/// "`robust` n log n, oracle n^2, `ask` n^2, formula n^2"; empty if there are no lists.
std::string time_in_words(const Operation& operation) {
  if (elements_of_lists(operation.question_shape(), operation.zeros(1)) == 0) return "";
  const Time& time = operation.metadata().time;
  return "`robust` " + name_of(time.robust) + ", oracle " + name_of(time.oracle) + ", `ask` " + name_of(time.ask) +
         ", formula " + name_of(time.reference);
}

void print_operation(const Operation& operation, std::ostream& out) {
  out << "\n### `" << operation.name() << "`\n\n"
      << operation.metadata().question << " ([contract](../reference/" << operation.metadata().chapter << '/'
      << operation.name() << ".h))\n\n```cpp\n";
  for (const audit::Signature& signature : audit::signatures(operation)) {
    out << signature.text << ";";
    for (const std::string& shorter : signature.instead)
      out << (&shorter == &signature.instead[0] ? "  // or " : ", ") << shorter;
    out << '\n';
  }
  out << "```\n```\n";
  const Json described = operation.question_description();
  for (const Json& input : described.is_array() ? described : Json::array({described})) out << spaced(input) << '\n';
  out << "-> " << spaced(operation.answer_description()) << "\n```\n";
  const std::string time = time_in_words(operation);
  if (!time.empty()) out << "\nTime: " << time << ".\n";
  std::string formulas;
  for (const TrackedFormula& formula : operation.row().standard)
    formulas += (formulas.empty() ? "" : "; ") + std::string(formula.name);
  if (!formulas.empty()) out << "\nOther formulas: " << formulas << ".\n";
  std::vector<std::string> methods;
  for (const Operation* other : all_operations())
    if (other->metadata().implementation_of == operation.name()) methods.push_back(other->name());
  if (!methods.empty())
    out << "\nBy a certain method, with the same input and answer: " << in_code(methods) << ". Engines are asked `"
        << operation.name() << "` alone.\n";
  std::vector<std::string> plain;
  plain_words(operation.answer_shape(), plain);
  if (operation.words().empty()) return;
  out << "\nWords: " << in_code(operation.words());
  if (!plain.empty()) out << "; plain: " << in_code(plain);
  out << ".\n";
}

}  // namespace

int operations_page_command(std::ostream& out) {
  out << introduction;
  print_shape_pairs(out);
  std::vector<std::string> chapters;
  for (const Operation* operation : all_operations()) {
    const std::string chapter = operation->metadata().chapter;
    if (std::find(chapters.begin(), chapters.end(), chapter) == chapters.end()) chapters.push_back(chapter);
  }
  for (const std::string& chapter : chapters) {
    out << "\n## " << chapter << '\n';
    for (const Operation* operation : all_operations())
      if (operation->metadata().chapter == chapter && !operation->metadata().is_implementation())
        print_operation(*operation, out);
  }
  return nothing_found;
}

}  // namespace touchstone::program
