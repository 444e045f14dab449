// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include "audit/counting/audit_run.h"
#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/pages/html.h"

/// Pages that were written while the audit ran.
namespace touchstone::proptests::standing_pages_tests {

TEST_CASE("standing pages: they are written anew, to the same bytes, whether there is time for a map or not") {
  AuditOptions options;
  options.operations = {find_operation("orientation"), find_operation("point_ground_plane")};
  options.cases = 40;
  const Tally tally = run_audit(options, false, [](const std::string&, std::uint64_t) {});
  const std::filesystem::path directory = std::filesystem::temp_directory_path() / "touchstone_standing_pages";
  const auto pages = [&] {
    std::string bytes;
    for (const char* name : {"index.html", "orientation.html", "point_ground_plane.html"}) {
      std::ifstream file(directory / name);
      bytes += std::string(std::istreambuf_iterator<char>(file), {});
    }
    return bytes;
  };
  for (const double seconds : {0.0, 1e-9}) {
    report::write_report(tally, directory, 1, nullptr, {.seconds = seconds});
    const std::string written = pages();
    for (std::size_t i = 1; i <= 2; ++i) {
      Tally so_far = tally;
      so_far.operations.resize(i);
      report::write_so_far(so_far, directory, {.expected = 2});
    }
    CHECK(pages() != written);
    report::write_report(tally, directory, 1, nullptr, {.seconds = seconds, .pages_stand = true});
    CHECK(pages() == written);
  }
  std::filesystem::remove_all(directory);
}

}  // namespace touchstone::proptests::standing_pages_tests
