// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "proptests/property.h"
#include "testing/drawn.h"

/// Questions of the catalogue as RapidCheck draws and shrinks them.
namespace touchstone::proptests {

using catalogue::DrawStream;
using catalogue::Operation;
using catalogue::Question;

using tests::Drawn;
using tests::recorded;
using tests::replayed;

/// What is wrong with a question's answers; empty where nothing is.
using Complaint = std::function<std::string(const Question&)>;

/// How many cases one pick of RapidCheck drives.
inline constexpr std::uint64_t batch = 64;

/// How many questions of a family are asked however dear they are.
inline constexpr std::uint64_t least_cases = 8;

/// How many questions of a family are asked instead of so many, by the cost of a question (Metadata::cost), but not
/// fewer than `least`.
std::uint64_t affordable(const Operation& operation, std::uint64_t questions, std::uint64_t least = least_cases);

/// The property that `complaint(question)` is empty for every question of every family of an operation: `usual` batches
/// of `size` in each family, divided by the cost of a question.
void never(const Operation& operation, const std::string& sentence, const Complaint& complaint, int usual,
           std::uint64_t size = batch);

/// The same, told the question's place in its batch, counted from 0, so that some places can be asked for more than
/// others. Place 0 has to be asked for everything: what fails at any place is asked once more and made smaller there.
using ComplaintAt = std::function<std::string(const Question&, std::uint64_t place)>;
void never_at(const Operation& operation, const std::string& sentence, const ComplaintAt& complaint, int usual,
              std::uint64_t size = batch);

}  // namespace touchstone::proptests
