// SPDX-License-Identifier: Apache-2.0
#include "report/html.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace touchstone::audit {

void write_whole_file(const std::string& file, const std::string& bytes) {
  std::ofstream opened(file, std::ios::binary);
  if (!opened || !opened.write(bytes.data(), static_cast<std::streamsize>(bytes.size())) || !opened.flush()) {
    throw std::runtime_error(file + ": cannot be written");
  }
}

void write_report(const Tally& tally, const std::string& directory, int jobs, Engine* engine) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) throw std::runtime_error(directory + ": " + error.message());
  OperationMaps maps;
  for (std::size_t i = 0; i < tally.operations.size(); ++i) {
    const std::string& name = tally.operations[i].operation;
    const Operation* operation = find_operation(name);
    std::vector<FailureMap> shown;
    if (operation) shown = failure_maps(*operation, jobs, tally.declaration.binary32, engine);
    write_whole_file(directory + "/" + name + ".html", operation_page(tally, i, shown));
    if (operation) maps.emplace_back(name, std::move(shown));
  }
  write_whole_file(directory + "/index.html", index_page(tally, maps));
}

}  // namespace touchstone::audit
