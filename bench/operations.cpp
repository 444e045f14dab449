// SPDX-License-Identifier: Apache-2.0
// Every operation of the catalogue: the full answer of robust compared with the slide's formula; and if the operation
// decides something, the decision of robust compared with a naive inline formula, CGAL and plain rationals.
//
// bench/operations --verify compares every timed answer with the oracle, on every case, without timing.

#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>

#include "bench/data_sets.h"
#include "bench/miniball.h"
#include "bench/peers_of_rays.h"
#include "bench/plain_peers.h"
#include "bench/shewchuk.h"
#include "bench/timing.h"

namespace touchstone::bench {
namespace {

template <class Row>
concept Decides = requires {
  Decisions<Row>::decides;
};

template <class Row>
using QuestionOf = typename Row::Question;

template <class Row>
concept HasCgal = requires {
  CgalPeer<Row>::only_epeck;
};

/// The formula is generic in the number type, and right in exact arithmetic.
template <class Row>
concept HasRational = !requires {
  Decisions<Row>::doubles_alone;
};

template <class Row>
concept HasAnswerPeer = requires {
  AnswerPeer<Row>::name;
};
template <class Row>
auto peer_answer(const QuestionOf<Row>& q) {
  return catalogue::applied([](const auto&... field) { return AnswerPeer<Row>::answer(field...); }, q);
}

#ifdef TOUCHSTONE_BENCH_TET
template <class Row>
inline constexpr bool has_shewchuk = std::is_same_v<Row, catalogue::rows::orientation>;
#else
template <class Row>
inline constexpr bool has_shewchuk = false;
#endif

/// Turns functions of a question's fields into functions of the question.
template <class Row>
struct Asked {
  static int ours(const QuestionOf<Row>& q) {
    return catalogue::applied([](const auto&... field) { return Decisions<Row>::ours(field...); }, q);
  }
  static int naive(const QuestionOf<Row>& q) {
    return catalogue::applied([](const auto&... field) { return Decisions<Row>::naive(field...); }, q);
  }
  static constexpr bool has_usual = requires { &Decisions<Row>::usual; };
  static int usual(const QuestionOf<Row>& q) {
    return catalogue::applied([](const auto&... field) { return Decisions<Row>::usual(field...); }, q);
  }
  static int rational(const QuestionOf<Row>& q) {
    return catalogue::applied(
        [](const auto&... field) {
          if constexpr (requires { Decisions<Row>::complete(field...); }) return Decisions<Row>::complete(field...);
          else return Decisions<Row>::naive(field...);
        },
        catalogue::converted<mpq_class>(q, [](double number) { return mpq_class(number); }));
  }
#ifdef TOUCHSTONE_BENCH_TET
  static int shewchuk(const QuestionOf<Row>& q) { return catalogue::applied(side_by_shewchuk, q); }
#endif
  template <class K>
  static auto shapes(const QuestionOf<Row>& q) {
    return catalogue::applied([](const auto&... field) { return CgalPeer<Row>::template shapes<K>(field...); }, q);
  }
  template <class Shapes>
  static int cgal(const Shapes& shapes) {
    return catalogue::applied([](const auto&... shape) { return CgalPeer<Row>::decide(shape...); }, shapes);
  }
  static bool promised(const QuestionOf<Row>& q) {
    return catalogue::applied([](const auto&... field) { return CgalPeer<Row>::promised(field...); }, q);
  }
};

/// Counts of answers of robust and the peers that differ from the oracle's.
struct Wrong {
  std::size_t robust = 0, naive = 0, epick = 0, epeck = 0, rational = 0, shewchuk = 0;
};

template <class Row>
Wrong wrong_decisions(DataSet set) {
  using A = Asked<Row>;
  Wrong wrong;
  for (const auto& q : cases_of<Row>(set)) {
    const int truth = Decisions<Row>::truth(catalogue::ask_oracle<Row>(q).answer);
    wrong.robust += A::ours(q) != truth;
    wrong.naive += A::naive(q) != truth;
    if constexpr (HasRational<Row>) wrong.rational += A::rational(q) != truth;
    if constexpr (has_shewchuk<Row>) wrong.shewchuk += A::shewchuk(q) != truth;
    if constexpr (HasCgal<Row>) {
      if (!A::promised(q)) continue;
      if constexpr (!CgalPeer<Row>::only_epeck) wrong.epick += A::cgal(A::template shapes<Epick>(q)) != truth;
      wrong.epeck += A::cgal(A::template shapes<Epeck>(q)) != truth;
    }
  }
  return wrong;
}

template <class Row>
std::size_t wrong_answers(DataSet set) {
  const auto& operation = *catalogue::find_operation(Row::metadata.name);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < chunk; ++i) {
    const catalogue::Question flat{catalogue::packed(cases_of<Row>(set)[i])};
    wrong += operation.examine(flat)->judge_robust().verdict != catalogue::Verdict::agree;
  }
  return wrong;
}

/// Counts the peer's full answers that are not even nearly right.
template <class Row>
std::size_t wrong_peer_answers(DataSet set) {
  std::size_t wrong = 0;
  for (const auto& q : cases_of<Row>(set))
    wrong += !AnswerPeer<Row>::right(peer_answer<Row>(q), catalogue::ask_robust<Row>(q));
  return wrong;
}

/// Prints a line for each operation and set; returns false if an implementation that promises exactness was wrong.
bool verified() {
  bool held = true;
  std::printf("%-18s %-20s %8s %8s %8s %8s %8s %8s\n", "wrong of 131072", "", "robust", "naive", "Epick", "Epeck",
              "mpq", "Shewchuk");
  catalogue::for_each_row([&]<class Row>() {
    for (const DataSet set : data_sets) {
      std::size_t wrong_full = wrong_answers<Row>(set);
      if constexpr (Decides<Row>) {
        const Wrong w = wrong_decisions<Row>(set);
        std::printf("%-18s %-20s %8zu %8zu %8zu %8zu %8zu %8zu\n", Row::metadata.name, name_of(set), w.robust, w.naive,
                    w.epick, w.epeck, w.rational, w.shewchuk);
        wrong_full += w.robust + w.epick + w.epeck + w.rational;
        if (set != DataSet::huge && set != DataSet::tiny) wrong_full += w.shewchuk;  // it promises nothing there
      }
      if constexpr (HasAnswerPeer<Row>) {
        std::printf("%-18s %-20s %s: %zu far off\n", Row::metadata.name, name_of(set), AnswerPeer<Row>::name,
                    wrong_peer_answers<Row>(set));
      }
      if (wrong_full != 0) {
        held = false;
        std::printf("%s %s: an exact answer is wrong\n", Row::metadata.name, name_of(set));
      }
    }
  });
  return held;
}

/// CGAL's objects for the cases of one set, kept for the most recent set: Epeck's points take 100 bytes and more.
template <class Row, class K>
const auto& shapes_of(DataSet set) {
  using Shapes = decltype(Asked<Row>::template shapes<K>(cases_of<Row>(set)[0]));
  static DataSet made = set;
  static std::vector<Shapes> shapes;
  if (shapes.empty() || made != set) {
    shapes.clear();
    for (const auto& q : cases_of<Row>(made = set)) shapes.push_back(Asked<Row>::template shapes<K>(q));
  }
  return shapes;
}

template <class Row>
void add_row(DataSet set) {
  using Q = QuestionOf<Row>;
  const std::string group = std::string(Row::metadata.name) + "/" + name_of(set) + "/";
  const auto add = [&](const char* peer, auto timed) { benchmark::RegisterBenchmark((group + peer).c_str(), timed); };
  if constexpr (Decides<Row>) {
    using A = Asked<Row>;
    add("naive",
        [=](benchmark::State& s) { time_decisions(s, cases_of<Row>(set), [](const Q& q) { return A::naive(q); }); });
    if constexpr (A::has_usual) {
      add("usual",
          [=](benchmark::State& s) { time_decisions(s, cases_of<Row>(set), [](const Q& q) { return A::usual(q); }); });
    }
    add("robust",
        [=](benchmark::State& s) { time_decisions(s, cases_of<Row>(set), [](const Q& q) { return A::ours(q); }); });
    if constexpr (HasCgal<Row>) {
      if constexpr (!CgalPeer<Row>::only_epeck) {
        add("epick", [=](benchmark::State& s) {
          time_decisions(s, shapes_of<Row, Epick>(set), [](const auto& shapes) { return A::cgal(shapes); });
        });
      }
      add("epeck", [=](benchmark::State& s) {
        time_decisions(s, shapes_of<Row, Epeck>(set), [](const auto& shapes) { return A::cgal(shapes); });
      });
    }
    if constexpr (has_shewchuk<Row>) {
      add("shewchuk", [=](benchmark::State& s) {
        time_decisions(s, cases_of<Row>(set), [](const Q& q) { return A::shewchuk(q); });
      });
    }
    if constexpr (HasRational<Row>) {
      add("mpq",
          [=](benchmark::State& s) { time_answers(s, cases_of<Row>(set), [](const Q& q) { return A::rational(q); }); });
    }
  }
  if constexpr (HasAnswerPeer<Row>) {
    add(AnswerPeer<Row>::name, [=](benchmark::State& s) {
      time_answers(s, cases_of<Row>(set), [](const Q& q) { return peer_answer<Row>(q); });
    });
  }
  // Tells which answers hold numbers, for the goals of ratios.py.
  const catalogue::Kind kind = Row::metadata.kind;
  const char* label = kind == catalogue::Kind::measure || kind == catalogue::Kind::set ? "numbers" : "";
  add("slide_answer", [=](benchmark::State& s) {
    time_answers(s, cases_of<Row>(set), [](const Q& q) { return catalogue::ask_reference<Row>(q); });
  });
  add("robust_answer", [=](benchmark::State& s) {
    s.SetLabel(label);
    time_answers(s, cases_of<Row>(set), [](const Q& q) { return catalogue::ask_robust<Row>(q); });
  });
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  using namespace touchstone;
  if (argc == 2 && std::strcmp(argv[1], "--verify") == 0) return bench::verified() ? 0 : 1;
  catalogue::for_each_row([]<class Row>() {
    for (const bench::DataSet set : bench::data_sets) bench::add_row<Row>(set);
  });
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
