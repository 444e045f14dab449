// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/named_files.h"

#include <algorithm>

#include "catalogue/codec/shape_json.h"
#include "catalogue/families/meshes/named_meshes.h"
#include "catalogue/shape/described.h"
#include "oracle/certificates/named_file.h"

namespace touchstone::audit {
namespace {

/// Puts one vertex or face on each line, for viewing and diffing.
std::string in_lines(std::string text) {
  for (std::size_t at = 0; (at = text.find("],", at)) != std::string::npos;) text.insert(at += 2, "\n");
  return text + "\n";
}

}  // namespace

const std::vector<NamedFile>& named_files() {
  static const std::vector<NamedFile> all = [] {
    std::vector<NamedFile> files;
    for (const auto* meshes : {&named_meshes(), &named_solids(), &long_solids()}) {
      for (const NamedMesh& named : *meshes)
        files.push_back({"meshes/" + named.name + ".json", in_lines(one_line(to_json(named.mesh)))});
    }
    return files;
  }();
  return all;
}

Json with_names(Json input) {
  for (Json& value : input) {
    if (!value.is_object() || !value.contains("faces")) continue;
    const auto& files = named_files();
    const auto same = [text = in_lines(one_line(value))](const NamedFile& file) { return file.text == text; };
    const auto found = std::find_if(files.begin(), files.end(), same);
    if (found != files.end()) value = found->name;
  }
  return input;
}

Json without_names(Json input, const std::string& folder) {
  if (!input.is_object()) return input;
  for (const auto& [field, value] : input.items()) {
    if (!value.is_string()) continue;
    if (const auto text = certify::text_of_named_file(folder, field, value.get<std::string>()))
      value = parse_line(*text);
  }
  return input;
}

}  // namespace touchstone::audit
