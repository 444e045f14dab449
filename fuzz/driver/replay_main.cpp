// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "catalogue/families/draw_stream.h"
#include "fuzz/driver/target.h"

// Runs the fuzz program without libFuzzer, for any compiler:
//    fuzz OP [--mutations N] FILE|FOLDER...   asks every file, and N mutations of each (default 500), fewer where a
//                                             question costs more than eight of the cheap ones (Metadata::cost)
//   fuzz OP --write-seeds FOLDER             one file for every hard case of the operation
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed);

// Replaces libFuzzer's own mutation, which is absent: sets one byte, chosen by the bytes alone.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size) {
  std::uint64_t state = size;
  for (std::size_t i = 0; i < size; ++i) state = touchstone::catalogue::seed_of(state, "", data[i]);
  if (size < max_size) data[size++] = 0;
  data[state % size] = static_cast<std::uint8_t>(state >> 32);
  return size;
}

namespace {

namespace fs = std::filesystem;
using Buffer = std::vector<std::uint8_t>;
constexpr std::size_t longest = 4096;

std::vector<fs::path> files_in(const fs::path& place) {
  if (!fs::is_directory(place)) return {place};
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(place)) {
    if (entry.is_regular_file() && entry.path().extension() != ".md") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

Buffer contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "%s: a file that can be read\n", path.c_str());
    std::exit(2);
  }
  return Buffer(std::istreambuf_iterator<char>(file), {});
}

void ask(const Buffer& data, unsigned mutations) {
  LLVMFuzzerTestOneInput(data.data(), data.size());
  Buffer current = data;
  for (unsigned seed = 1; seed <= mutations; ++seed) {
    const std::size_t size = std::min(current.size(), longest);
    current.resize(longest);
    current.resize(LLVMFuzzerCustomMutator(current.data(), size, longest, seed));
    LLVMFuzzerTestOneInput(current.data(), current.size());
    if (seed % 16 == 0) current = data;
  }
}

int write_seeds(const fs::path& folder) {
  fs::create_directories(folder);
  for (const auto& [name, bytes] : touchstone::fuzz::target().seeds()) {
    std::ofstream(folder / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  touchstone::fuzz::choose_target(argc, argv);
  unsigned mutations = 500;
  std::size_t asked = 0;
  const auto of_each = [&mutations] {
    const auto cost = static_cast<unsigned>(touchstone::fuzz::target().operation().metadata().cost);
    return cost <= 8 ? mutations : std::max(mutations * 8 / cost, std::min(mutations, 32u));
  };
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--write-seeds" && i + 1 < argc) return write_seeds(argv[i + 1]);
    if (word == "--mutations" && i + 1 < argc) {
      mutations = static_cast<unsigned>(std::strtoul(argv[++i], nullptr, 10));
      continue;
    }
    for (const fs::path& file : files_in(word)) ask(contents(file), of_each()), ++asked;
  }
  std::printf("%zu files, %u mutations of each\n", asked, of_each());
  return asked == 0 ? 2 : 0;
}
