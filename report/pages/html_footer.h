// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/pages/html.h"

namespace touchstone::report {

/// The command that reproduces this tally: the one that was run, if it is known.
std::string audit_command_of(const Tally& tally, const ReportNotes& notes);

/// The last lines of a page: how the truth was found, the command, the versions of the program, of its compiler and of
/// its libraries.
std::string page_footer(const Tally& tally, const ReportNotes& notes);
/// The same without a command.
std::string page_footer();

/// "touchstone 0.1.0, g++ 12.2.0, GMP 6.2.1, MPFR 4.2.0, libpng 1.6.39"
std::string versions();

}  // namespace touchstone::report
