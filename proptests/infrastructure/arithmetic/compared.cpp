// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <cstdlib>
#include <string>

#include "catalogue/families/draw_stream.h"
#include "proptests/infrastructure/arithmetic/results.h"

/// Our arithmetic against GMP and MPFR: compared PERCENT asks so much of the usual cases. Exit code 1 where a result
/// differs; it prints the first of each kind.
namespace touchstone::proptests::arithmetic_results {
namespace {

using Ask = Results (*)(std::uint64_t);

/// How many results were compared; 0 where one differs.
std::uint64_t compared(const char* kind, int cases, Ask gmp, Ask own, Ask small_words) {
  std::uint64_t count = 0;
  for (int i = 0; i < cases; ++i) {
    const std::uint64_t seed = catalogue::seed_of(1, kind, static_cast<std::uint64_t>(i));
    const Results expected = gmp(seed);
    for (const Ask ask : {own, small_words}) {
      const Results found = ask(seed);
      for (std::size_t k = 0; k < expected.size(); ++k, ++count) {
        if (k < found.size() && expected[k].what == found[k].what && expected[k].value == found[k].value) continue;
        std::printf("%s, case %d, words of %d bits: %s is\n  %s\nand not\n  %s\nIts numbers:\n  %s\n  %s\n", kind, i,
                    ask == own ? 64 : 32, expected[k].what.c_str(), expected[k].value.c_str(),
                    k < found.size() ? found[k].value.c_str() : "", expected[0].value.c_str(),
                    expected[1].value.c_str());
        return 0;
      }
      if (found.size() != expected.size()) return 0;
    }
  }
  std::printf("%s: %llu results are GMP's and MPFR's\n", kind, static_cast<unsigned long long>(count));
  return count;
}

}  // namespace
}  // namespace touchstone::proptests::arithmetic_results

int main(int argc, char** argv) {
  using namespace touchstone::proptests::arithmetic_results;
  const int percent = argc > 1 ? std::atoi(argv[1]) : 100;
  const auto cases = [percent](int usual) { return usual * percent / 100 + 1; };
  const bool same[]{
      compared("integers", cases(20000), with_gmp::integers, with_own::integers, with_small_words::integers) != 0,
      compared("rationals", cases(8000), with_gmp::rationals, with_own::rationals, with_small_words::rationals) != 0,
      compared("rounded numbers", cases(4000), with_gmp::rounded, with_own::rounded, with_small_words::rounded) != 0};
  return same[0] && same[1] && same[2] ? 0 : 1;
}
