// SPDX-License-Identifier: Apache-2.0
#include "audit/version.h"

#include <expat.h>
#include <fmt/core.h>
#include <gmp.h>
#include <mpfr.h>
#include <png.h>
#include <zlib.h>

#include <nlohmann/json.hpp>

#include "program/documentation.h"

namespace touchstone::program {

namespace {

std::string triple(int number, int thousand) {
  return fmt::format("{}.{}.{}", number / (thousand * thousand), number / thousand % thousand, number % thousand);
}

}  // namespace

std::string version() {
  const std::string json = triple(
      NLOHMANN_JSON_VERSION_MAJOR * 10000 + NLOHMANN_JSON_VERSION_MINOR * 100 + NLOHMANN_JSON_VERSION_PATCH, 100);
  std::string text = std::string("touchstone ") + version_number + " (" + release_date +
                     ")\nlicence: Apache-2.0\ncompiler: " + compiler_name +
                     "\nlibraries, their licences and where their sources are:";
  const auto add = [&](const std::string& library, const char* licence, const char* source) {
    text += fmt::format("\n  {}, {}, {}", library, licence, source);
  };
#ifndef TOUCHSTONE_OWN_ARITHMETIC
  add(std::string("GMP ") + gmp_version, "LGPL-3.0-or-later OR GPL-2.0-or-later", "https://gmplib.org");
  add(std::string("MPFR ") + mpfr_get_version(), "LGPL-3.0-or-later", "https://www.mpfr.org");
#endif
  add("nlohmann-json " + json, "MIT", "https://github.com/nlohmann/json");
  add("{fmt} " + triple(FMT_VERSION, 100), "MIT", "https://github.com/fmtlib/fmt");
  add(std::string("CLI11 ") + CLI11_VERSION, "BSD-3-Clause", "https://github.com/CLIUtils/CLI11");
  add(std::string("libpng ") + PNG_LIBPNG_VER_STRING, "libpng-2.0", "http://www.libpng.org/pub/png");
  add(std::string("zlib ") + ZLIB_VERSION, "Zlib", "https://zlib.net");
  add(fmt::format("Expat {}.{}.{}", XML_MAJOR_VERSION, XML_MINOR_VERSION, XML_MICRO_VERSION), "MIT",
      "https://libexpat.github.io");
  add("the C++ runtime library of the compiler", "GPL-3.0-or-later WITH GCC-exception-3.1", "https://gcc.gnu.org");
  return text;
}

}  // namespace touchstone::program
