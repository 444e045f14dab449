// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <cstring>

#include "catalogue/catalogue.h"
#include "catalogue/operation/operation.h"
#include "proptests/robust_bits.h"

// robust_digest [--contracted] [OPERATION]
//
// What robust answers to questions of every family in every floating-point environment: a line for each operation, or
// for each question of one. CMakeLists.txt compiles it, and with it all that is inline in robust's headers, in several
// ways; all have to print the same.
namespace touchstone::proptests {
namespace {

/// Of each family; an expensive question is asked less often.
std::uint64_t asked_of(const catalogue::Operation& operation) {
  return std::max<std::uint64_t>(3, 60 / static_cast<std::uint64_t>(operation.metadata().cost));
}

/// FNV-1a over everything said.
class Digest {
 public:
  void add(const AnswerBits& bits) {
    for (const std::uint64_t word : bits.words) mix(word);
    for (const char letter : bits.refused) mix(static_cast<unsigned char>(letter));
    mix(bits.words.size());
  }
  std::uint64_t value() const { return hash_; }

 private:
  void mix(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001b3u; }
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

/// Typed, so that what is inline in robust's headers is compiled here.
AnswerBits typed_bits(const catalogue::Operation& operation, const catalogue::Question& question,
                      std::size_t environment) {
  AnswerBits bits;
  catalogue::for_each_row([&]<class Row>() {
    if (&Row::metadata == &operation.metadata()) bits = robust_bits<Row>(question, environment);
  });
  return bits;
}

void print_digest(const catalogue::Operation& operation, bool each_question) {
  Digest of_all;
  for (std::size_t family = 0; family < operation.families().size(); ++family) {
    const std::string& name = operation.families()[family];
    for (std::uint64_t i = 0; i < asked_of(operation); ++i) {
      catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(1, name.c_str(), i));
      const catalogue::Question question = operation.draw(draws, family);
      Digest of_one;
      for (std::size_t environment = 0; environment < environment_count; ++environment) {
        const AnswerBits bits = typed_bits(operation, question, environment);
        of_all.add(bits), of_one.add(bits);
      }
      if (!each_question) continue;
      std::printf("%016llx %s\n", static_cast<unsigned long long>(of_one.value()),
                  catalogue::one_line(operation.print(question)).c_str());
    }
  }
  if (!each_question) {
    std::printf("%016llx %s\n", static_cast<unsigned long long>(of_all.value()), operation.name().c_str());
  }
}

/// Whether the compiler makes one rounding of a product and a sum: (1 + u)(1 - u) - 1 is -u^2, and 0 where the product
/// is rounded.
bool contracts() {
  volatile double a = 1 + 0x1p-52, b = 1 - 0x1p-52, c = -1;
  const double x = a, y = b, z = c;
  return x * y + z != 0;
}

}  // namespace
}  // namespace touchstone::proptests

int main(int argc, char** argv) {
  using namespace touchstone;
  const bool contracted = argc > 1 && std::strcmp(argv[1], "--contracted") == 0;
  if (proptests::contracts() != contracted) {
    std::fprintf(stderr, "products and sums are %s, which is not what was to be tested\n",
                 contracted ? "rounded one by one" : "contracted");
    return 2;
  }
  const char* const only = argc > 1 + contracted ? argv[1 + contracted] : nullptr;
  for (const catalogue::Operation* operation : catalogue::all_operations()) {
    if (only == nullptr || operation->name() == only) proptests::print_digest(*operation, only != nullptr);
  }
  return 0;
}
