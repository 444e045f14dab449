// SPDX-License-Identifier: Apache-2.0
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <cstdio>
#include <memory>

#include "testing/asked.h"
#include "testing/words.h"

/// Catch2, version 2 or 3: laws of an operation that shrink their counterexamples, generators, and shapes and answers
/// that print themselves in CHECK. RapidCheck is not needed.
///
///   #include <touchstone/robust/lines/segment_segment.h>
///   TEST_CASE("segments that touch meet") {
///     always<operations::segment_segment>([](const Segment2d& a, const Segment2d& b) {
///       return my::segments_meet(a, b) == (robust::segment_segment(a, b).relation != SegmentRelation::disjoint);
///     });
///   }
///   TEST_CASE("my answer") {
///     const auto [a, b] = GENERATE(take(200, drawn<operations::segment_segment>()));
///     CHECK(my::segments_meet(a, b) == ...);
///   }
namespace touchstone::tests {

/// Fails the test with the simplest question found for which the law does not return true, or throws. The full report,
/// with the command that asks for the truth, goes to standard error: Catch2 would break it at 80 columns.
template <class Row, class... Ts, class Law>
void always(const Law& law, const Options& options = {}) {
  const auto found = counterexample<Row, Ts...>(law, options);
  if (!found) {
    SUCCEED();
    return;
  }
  std::fprintf(stderr, "%s\n", shown(*found).c_str());
  FAIL(shown(*found));
}

/// Endless; ignores `cases` of the options.
template <class Row, class... Ts>
class Generator final : public Catch::Generators::IGenerator<Asked<Row, Ts...>> {
 public:
  explicit Generator(const Options& options)
      : families_(families_named(operation_of<Row>(), options.families)), options_(options), now_(at(0)) {}
  const Asked<Row, Ts...>& get() const override { return now_; }
  bool next() override {
    now_ = at(++place_);
    return true;
  }

 private:
  Asked<Row, Ts...> at(std::uint64_t place) const {
    return asked<Row, Ts...>(families_, catalogue::seed_of(options_.seed, "question", place), options_.sizes);
  }

  std::vector<std::size_t> families_;
  Options options_;
  std::uint64_t place_ = 0;
  Asked<Row, Ts...> now_;
};

/// For GENERATE: the same questions as `always` asks with the same options. They do not shrink.
template <class Row, class... Ts>
Catch::Generators::GeneratorWrapper<Asked<Row, Ts...>> drawn(const Options& options = {}) {
#ifdef CATCH_ALL_HPP_INCLUDED
  return {new Generator<Row, Ts...>(options)};
#else
  return {std::make_unique<Generator<Row, Ts...>>(options)};
#endif
}

}  // namespace touchstone::tests

namespace Catch {

template <touchstone::audit::Printed T>
struct StringMaker<T> {
  static std::string convert(const T& value) { return touchstone::audit::printed(value); }
};
template <class Row, class... Ts>
struct StringMaker<touchstone::tests::Asked<Row, Ts...>> {
  static std::string convert(const touchstone::tests::Asked<Row, Ts...>& asked) {
    return touchstone::tests::shown(asked);
  }
};

}  // namespace Catch
