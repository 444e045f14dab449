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

using audit::Choices;
using audit::Operation;
using audit::Question;

using tests::Drawn;
using tests::recorded;
using tests::replayed;

/// What is wrong with a question's answers; empty where nothing is.
using Complaint = std::function<std::string(const Question&)>;

/// How many cases one pick of RapidCheck drives.
inline constexpr std::uint64_t batch = 64;

/// The property that `complaint(question)` is empty for every question of every family of an operation: `usual` batches
/// of `size` in each family, divided by the price of a question (Card::price).
void never(const Operation& operation, const std::string& sentence, const Complaint& complaint, int usual,
           std::uint64_t size = batch);

}  // namespace touchstone::proptests
