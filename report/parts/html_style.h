// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/uses.h"

namespace touchstone::report {

/// The style sheet of every page, light and dark, screen and print. Nothing is fetched.
const std::string& page_style();

}  // namespace touchstone::report
