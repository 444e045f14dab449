// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "catalogue/codec/json.h"
#include "proptests/catch.h"
#include "proptests/uses.h"
#include "report/pages/html.h"

/// Scripts of pages, run in node.
namespace touchstone::proptests {

/// Warns where there is none.
inline bool there_is_node() {
  const bool found = std::system("node -e 'new DecompressionStream(\"deflate\")' >/dev/null 2>&1") == 0;
  if (!found) WARN("skipped: there is no node that can run the page's script");
  return found;
}

/// What a script beside this file prints of a page, line by line.
inline std::vector<Json> lines_of_node(const std::string& script, const std::string& page,
                                       const std::vector<std::string>& arguments) {
  const auto file = std::filesystem::temp_directory_path() / (std::to_string(::getpid()) + "_" + script + ".html");
  write_whole_file(file.string(), page);
  std::string command = "node proptests/infrastructure/report/" + script + " '" + file.string() + "'", text;
  for (const std::string& argument : arguments) command += " '" + argument + "'";
  {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
    REQUIRE(pipe);
    std::array<char, 4096> part{};
    while (std::size_t n = std::fread(part.data(), 1, part.size(), pipe.get())) text.append(part.data(), n);
  }
  std::filesystem::remove(file);
  std::vector<Json> lines;
  for (std::size_t at = 0, end; (end = text.find('\n', at)) != std::string::npos; at = end + 1) {
    lines.push_back(Json::parse(text.substr(at, end - at)));
  }
  return lines;
}

}  // namespace touchstone::proptests
