// SPDX-License-Identifier: Apache-2.0
#include "report/pages/html_footer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmp.h>
#include <mpfr.h>
#include <png.h>

#include "audit/version.h"
#include "report/parts/html_parts.h"
#include "report/words/wording.h"

namespace touchstone::report {

std::string versions() {
#ifdef TOUCHSTONE_OWN_ARITHMETIC
  const std::string arithmetic = "its own arithmetic";
#else
  const std::string arithmetic = fmt::format("GMP {}, MPFR {}", gmp_version, mpfr_get_version());
#endif
  return fmt::format("touchstone {}, {}, {}, libpng {}", version_number, compiler_name, arithmetic,
                     PNG_LIBPNG_VER_STRING);
}

std::string audit_command_of(const Tally& tally, const ReportNotes& notes) {
  if (!notes.command.empty()) return notes.command;
  std::string names;
  for (const OperationTally& operation : tally.operations) names += (names.empty() ? "" : ",") + operation.operation;
  if (tally.operations.size() == all_operations().size()) names = "all";
  if (tally.grid.size > 0) return fmt::format("touchstone exhaust {} --grid {}", names, tally.grid.size);
  if (tally.repeat.recorded)
    return fmt::format("{} judge {} --report DIR", tally.repeat.program, fmt::join(tally.logs, " "));
  const std::string options = tally.repeat.options.empty() ? "" : " " + tally.repeat.options;
  const std::string range = tally.ordinary_only() ? " --range ordinary" : "";
  return fmt::format("{} audit{} --ops {} --cases {}{} --seed {}{} --report DIR", tally.repeat.program, options, names,
                     tally.cases, tally.by_cost ? " --by-cost" : "", tally.seed, range);
}

std::string page_footer(const Tally& tally, const ReportNotes& notes) {
  return "<footer><p>The truth is computed in exact rationals and comes with a certificate for every answer. Inputs "
         "are "
         "taken as exactly the real numbers that their doubles are.</p><p>Made by:</p>" +
         shell_line(audit_command_of(tally, notes)) + "<p>" + escaped(versions()) + "</p></footer>";
}

std::string page_footer() { return "<footer><p>" + escaped(versions()) + "</p></footer>"; }

}  // namespace touchstone::report
