// SPDX-License-Identifier: Apache-2.0
// A header of the user's own, of the same name as one of ours.
#pragma once

namespace user {

inline constexpr int answer = 42;

}  // namespace user
