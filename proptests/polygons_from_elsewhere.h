// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "geometry/polygons.h"

namespace touchstone::proptests {

/// Every ring, outlines and holes alike, of the polygons that others tested with: earcut's fixtures in the folder
/// polygons/earcut below TOUCHSTONE_DATA, or below ../shared/data. None where they are not there.
inline std::vector<Polygon2d> polygons_from_elsewhere() {
  const char* given = std::getenv("TOUCHSTONE_DATA");
  const std::filesystem::path folder =
      std::filesystem::path(given == nullptr ? "../shared/data" : given) / "polygons/earcut/fixtures";
  std::vector<Polygon2d> rings;
  std::error_code missing;
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(folder, missing)) {
    if (file.path().extension() == ".json") files.push_back(file.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    std::ifstream in(file);
    for (const auto& ring : nlohmann::json::parse(in)) {
      Polygon2d polygon;
      for (const auto& p : ring) polygon.vertices.push_back({p[0].get<double>(), p[1].get<double>()});
      rings.push_back(std::move(polygon));
    }
  }
  return rings;
}

}  // namespace touchstone::proptests
