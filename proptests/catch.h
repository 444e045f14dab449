// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Catch2, whichever of its two versions there is.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <string>

namespace touchstone {

#ifdef CATCH_ALL_HPP_INCLUDED
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
using TestInvoker = Catch::Detail::unique_ptr<Catch::ITestInvoker>;
#else
inline auto ContainsSubstring(const std::string& part) { return Catch::Matchers::Contains(part); }
using TestInvoker = Catch::ITestInvoker*;
#endif
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

}  // namespace touchstone
