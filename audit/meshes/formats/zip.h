// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace touchstone::audit::meshes {

/// The files in a zip archive, listed by its directory at the end.
class Zip {
 public:
  /// Refuses data that is not a zip archive; `name` is the archive's name in refusals.
  Zip(std::string name, std::string_view bytes);

  bool has(const std::string& file) const { return entries_.contains(file); }
  /// The content, piece by piece; refuses it if it is neither stored nor deflated, or is encrypted, damaged or too
  /// large.
  void read(const std::string& file, const std::function<void(std::string_view)>& take) const;

 private:
  struct Entry {
    std::uint16_t flags, method;
    std::uint32_t checksum;
    std::uint64_t packed, unpacked, header;
  };

  [[noreturn]] void refuse(const std::string& file, const std::string& rule) const;
  std::string_view packed(const std::string& file, const Entry& entry) const;

  std::string name_;
  std::string_view bytes_;
  std::map<std::string, Entry> entries_;
};

}  // namespace touchstone::audit::meshes
