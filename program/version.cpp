// SPDX-License-Identifier: Apache-2.0
#include "audit/version.h"

#include <fmt/core.h>
#include <gmp.h>
#include <mpfr.h>
#include <png.h>

#include <nlohmann/json.hpp>

#include "program/documentation.h"

namespace touchstone::program {

std::string version() {
  return std::string("touchstone ") + version_number + "\ncompiler: " + compiler_name +
         fmt::format("\nlibraries: GMP {}, MPFR {}, nlohmann-json {}.{}.{}, {{fmt}} {}.{}.{}, CLI11 {}, libpng {}",
                     gmp_version, mpfr_get_version(), NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                     NLOHMANN_JSON_VERSION_PATCH, FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100,
                     CLI11_VERSION, PNG_LIBPNG_VER_STRING);
}

}  // namespace touchstone::program
