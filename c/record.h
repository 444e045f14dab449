// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <touchstone_record.h>

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <optional>
#include <string>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <vector>

#include "catalogue/shape/described_all.h"
#include "catalogue/shape/encoded_value.h"

/// Records calls of your own functions, with their answers, in a log (docs/own_inputs.md). Header-only; links only
/// POSIX threads. touchstone_record.h says what the log can lose, and when.
///
///   touchstone::Recording recording("game.log", {.engine = "my game 1.0", .one_in = 100});
///   ...
///   const bool hit = touchstone::record("segment_segment", [&] { return my_test(a, b); }, segment(a), segment(b));
namespace touchstone {

/// The fields of touchstone_record_options.
struct RecordingOptions {
  const char *engine = nullptr, *boundary = nullptr;
  double tolerance = 0;
  unsigned long one_in = 1, first = 0;
  double near = 0;
  unsigned long long most_bytes = 0;
};

/// A log that stays open while the object lives. Only one is open at a time: opening another closes the previous one.
class Recording {
 public:
  /// Throws std::system_error with the file's name if the file cannot be written.
  explicit Recording(const std::string& file, const RecordingOptions& options = {}) {
    const touchstone_record_options same{options.engine, options.boundary, options.tolerance, options.one_in,
                                         options.first,  options.near,     options.most_bytes};
    if (const int error = touchstone_record_open(file.c_str(), &same); error != 0)
      throw std::system_error(error, std::generic_category(), file);
  }
  ~Recording() { touchstone_record_close(); }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
};

/// Sets how near to degenerate the next call that this thread records is: |determinant| / error bound. May be called
/// inside the recorded function.
inline void record_nearness(double nearness) { touchstone_record_nearness(nearness); }

/// The name of an operation, and the line that named it.
struct OperationHere {
  const char *operation, *file;
  int line;
  OperationHere(const char* name, const char* in_file = __builtin_FILE(), int in_line = __builtin_LINE())
      : operation(name), file(in_file), line(in_line) {}
};

namespace recording {

/// The call sites of one instantiation of `record`: functions of one type may be called in several places.
struct SiteHere {
  OperationHere here;
  touchstone_record_site site;
  SiteHere* next;
};
template <class Make>
touchstone_record_site& site_of(std::atomic<SiteHere*>& sites, const OperationHere& here, const Make& make) {
  for (SiteHere* known = sites.load(std::memory_order_acquire); known != nullptr; known = known->next)
    if (known->here.line == here.line && known->here.operation == here.operation && known->here.file == here.file)
      return known->site;
  SiteHere* const made = new SiteHere{here, make(), sites.load(std::memory_order_relaxed)};
  while (!sites.compare_exchange_weak(made->next, made, std::memory_order_release, std::memory_order_relaxed)) continue;
  return made->site;
}

/// The count of numbers in a value if all values of its type hold the same count and nothing else; otherwise 0.
template <class T>
constexpr std::size_t fixed_numbers() {
  if constexpr (Composite<T>) {
    return []<class... Member>(Types<Member...>) {
      constexpr bool fixed = ((fixed_numbers<Member>() > 0) && ...);
      return fixed ? (fixed_numbers<Member>() + ...) : 0;
    }(member_types<T>());
  } else {
    return std::is_floating_point_v<T> ? 1 : 0;
  }
}

/// True if a value of the type holds numbers of type Real.
template <class T, class Real>
inline constexpr bool holds = std::is_same_v<T, Real>;
template <class... Ts, class Real>
inline constexpr bool holds<Types<Ts...>, Real> = (holds<Ts, Real> || ...);
template <Composite T, class Real>
inline constexpr bool holds<T, Real> = holds<member_types<T>, Real>;
template <class T, class Real>
inline constexpr bool holds<std::optional<T>, Real> = holds<T, Real>;
template <class T, class Real>
inline constexpr bool holds<std::vector<T>, Real> = holds<T, Real>;
template <class... Ts, class Real>
inline constexpr bool holds<std::tuple<Ts...>, Real> = (holds<Ts, Real> || ...);

/// Float if a call has floats and no doubles.
template <class... Ts>
using number_type = std::conditional_t<(holds<Ts, float> || ...) && !(holds<Ts, double> || ...), float, double>;

/// Writes the value's numbers in order.
template <class Real, class T>
constexpr void put_numbers(const T& value, Real*& at) {
  if constexpr (Composite<T>) {
    with_members(value, [&](const auto&... member) { (put_numbers(member, at), ...); });
  } else {
    *at++ = static_cast<Real>(value);
  }
}

/// True if a value consists of its numbers in order and nothing else.
template <class Real, class T>
constexpr bool is_its_numbers() {
  constexpr std::size_t count = fixed_numbers<T>();
  if constexpr (std::is_trivially_copyable_v<T> && sizeof(T) == count * sizeof(Real)) {
    std::array<Real, count> counted{}, found{};
    for (std::size_t i = 0; i < count; ++i) counted[i] = static_cast<Real>(i);
    Real* at = found.data();
    put_numbers(std::bit_cast<T>(counted), at);
    return found == counted;
  } else {
    return false;
  }
}

/// The count of numbers in a question of these arguments; 0 if it varies or if there are enumerators.
template <class... Arguments>
constexpr std::size_t numbers_of() {
  return ((fixed_numbers<Arguments>() > 0) && ...) ? (fixed_numbers<Arguments>() + ...) : 0;
}

/// The type that a function answers with if it answers.
template <class Answer>
struct Given {
  using type = Answer;
};
template <class Answer>
struct Given<std::optional<Answer>> {
  using type = Answer;
};

template <class Real>
touchstone_record_value value_of(const catalogue::EncodedValue<Real>& value) {
  return {value.numbers.data(), value.numbers.size(), value.words.data(), value.words.size()};
}

template <class Answer>
constexpr touchstone_record_answer answer_kind() {
  if constexpr (std::is_same_v<Answer, bool>) return TOUCHSTONE_RECORD_FLAG;
  else return catalogue::Enumeration<Answer> ? TOUCHSTONE_RECORD_WORD : TOUCHSTONE_RECORD_WHOLE;
}

/// One place in a program, named by OperationHere at the first call; it stays valid for the log.
template <class Real>
touchstone_record_site site_at(const OperationHere& here, touchstone_record_answer kind, std::size_t numbers) {
  const std::string place = std::string(here.file) + ":" + std::to_string(here.line);
  char* const kept = static_cast<char*>(std::malloc(place.size() + 1));  // for as long as the program runs
  if (kept != nullptr) std::memcpy(kept, place.c_str(), place.size() + 1);
  return {here.operation, kept != nullptr ? kept : "", sizeof(Real), kind, numbers, 0};
}

/// The arguments as the operation's question.
template <class Real, class... Arguments>
void record_at(touchstone_record_site& site, const catalogue::EncodedValue<Real>* answer, const char* error,
               const Arguments&... arguments) {
  thread_local catalogue::EncodedValue<Real> question;
  question.clear();
  (catalogue::pack(arguments, question), ...);
  const touchstone_record_value asked = value_of(question);
  const touchstone_record_value answered = answer != nullptr ? value_of(*answer) : touchstone_record_value{};
  touchstone_record_call(&site, &asked, &answered, error);
}

/// Writes a short answer, or a full answer.
template <class Real, class Answer, class... Arguments>
void record_answer(touchstone_record_site& site, const Answer& answer, const Arguments&... arguments) {
  constexpr std::size_t numbers = numbers_of<Arguments...>();
  if constexpr (answer_kind<Answer>() != TOUCHSTONE_RECORD_WHOLE && numbers > 0) {
    Real question[numbers];
    Real* at = question;
    const auto put = [&at](const auto& argument) {
      if constexpr (is_its_numbers<Real, std::remove_cvref_t<decltype(argument)>>()) {
        std::memcpy(at, &argument, sizeof argument);
        at += sizeof argument / sizeof(Real);
      } else {
        put_numbers(argument, at);
      }
    };
    (put(arguments), ...);
    touchstone_record_fixed_(&site, question, sizeof question, static_cast<std::uint32_t>(answer));
  } else {
    thread_local catalogue::EncodedValue<Real> encoded;
    encoded.clear();
    catalogue::pack(answer, encoded);
    record_at<Real>(site, &encoded, nullptr, arguments...);
  }
}

}  // namespace recording

/// Makes the call, records it and its answer under the operation, and returns the answer. The arguments are the
/// operation's (docs/operations.md), over double or float, with the values they have after the call. The answer is
/// anything that a function of an engine may return (docs/engines.md): true or false, an enumerator, the full answer,
/// or a std::optional of one of these; an empty optional is not recorded. An exception is recorded as an error and
/// rethrown.
template <class Call, class... Arguments>
std::invoke_result_t<Call&> record(const OperationHere& here, Call&& call, const Arguments&... arguments) {
  using Answer = std::remove_cvref_t<std::invoke_result_t<Call&>>;
  using Given = typename recording::Given<Answer>::type;
  using Real = recording::number_type<Given, Arguments...>;
  static std::atomic<recording::SiteHere*> sites = nullptr;
  touchstone_record_site& site = recording::site_of(sites, here, [&] {
    return recording::site_at<Real>(here, recording::answer_kind<Given>(), recording::numbers_of<Arguments...>());
  });
  const auto recorded = [&](const Given& answer) {
    if (touchstone_record_wants(&site) != 0) recording::record_answer<Real>(site, answer, arguments...);
  };
  try {
    std::invoke_result_t<Call&> answer = call();
    if constexpr (!catalogue::is_optional<Answer>) recorded(answer);
    else if (answer) recorded(*answer);
    return answer;
  } catch (const std::exception& thrown) {
    static std::atomic<recording::SiteHere*> sites_of_errors = nullptr;
    touchstone_record_site& errors = recording::site_of(
        sites_of_errors, here, [&] { return recording::site_at<Real>(here, TOUCHSTONE_RECORD_ERROR, 0); });
    if (touchstone_record_wants(&errors) != 0) recording::record_at<Real>(errors, nullptr, thrown.what(), arguments...);
    throw;
  }
}

}  // namespace touchstone
