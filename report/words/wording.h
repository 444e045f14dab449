// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <cstdint>
#include <string>
#include <vector>

#include "audit/counted.h"
#include "audit/counting/tally.h"
#include "report/uses.h"

/// Texts shared by tables and pages.
namespace touchstone::report {

/// 0.0123 of 1 -> "1.2%"; never "0.0%" for a part that is not empty, nor "100%" for one that is not everything.
std::string share(std::uint64_t part, std::uint64_t whole);

/// A distance in units in the last place: "0.5 ulps", "4.5e+15 ulps", "more than 1e298 ulps".
std::string ulps_in_words(double ulps);

/// The error of a number: "12 ulps off"; both numbers if the distance is meaningless: "expected 0, got -1.92".
std::string off_in_words(const Judgement& judgement);

/// "textbook formulas (binary64)"
std::string subject(const Declaration& declaration);

/// The author of an answer: "by rounding" is decided, and so explained, differently for each.
enum class Speaker { reference, robust, foreign };
Speaker speaker_of(const Declaration& declaration);
/// The meaning of a verdict, in a few words.
std::string meaning(Verdict verdict, Speaker speaker);
/// The reason for a verdict, in one or two plain sentences. binary32: the engine's number type.
std::string why(const Finding& finding, const Operation* operation, Speaker speaker, bool binary32);
/// "none of 1,498 answers is right: ...", and what to do then.
std::string nothing_right_in_words(const Cell& cell);
/// "70 answers name other points, as near as the contract's: right for `nearest` any"
std::string other_nearest_in_words(const Cell& cell);
/// "12,345 questions not asked: the engine was given up after ..."
std::string not_asked_in_words(const Cell& cell);

/// "1,234 elements listed beyond the truth, 12.3% of what is apart", and whether that is too much.
std::string surplus_in_words(const Cell& cell, double most);

/// An exact value for display: "3/7", or "about 1.234e-310" to that many digits if it is longer than `most` characters.
std::string readable(const mpq_class& exact, std::size_t most = 48, std::size_t digits = 6);
/// Any answer for display: numbers as they were typed become numbers, long exact values are abbreviated.
Json readable(const Json& answer, std::size_t most = 48, std::size_t digits = 20);

/// The first enumerator in an answer ("left", "overlap"), or "value".
std::string word_in(const Json& answer);

/// The origin of a finding: "family collinear, case 7"; for recorded calls "game.cpp:120, call 7".
std::string place_in_words(const std::string& family, const Finding& finding, const Repeat& repeat);
/// The questions asked: "2,000 cases per operation, seed 1", "1,234 recorded calls of game.log".
std::string asked_in_words(const Tally& tally);

/// The shell command that asks a question again, also to a foreign engine; the input as decimals that read back
/// exactly.
std::string repeat_command(const Operation& operation, const Question& question, Speaker speaker, const Repeat& repeat);

/// Sums over operations.
Cell sum_of(const std::vector<OperationTally>& tallies);
/// "1,234 of 200,000 answers wrong (ordinary size: 234 of 99,000): 1,000 by rounding (200 cancellation, 800 overflow or
/// underflow), 234 by algorithm; 12 inexact". Wrong is rounding, algorithm and invalid together.
std::string summary_of(const Cell& sum);
/// "textbook formulas (binary64): 1,234 of 200,000 answers wrong: ...; robust: 0"
std::string closing_sentence(const Tally& tally);

}  // namespace touchstone::report
