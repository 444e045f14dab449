// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "catalogue/codec/json.h"
#include "geometry/space.h"

/// Objects of a scene file, field by field.
namespace touchstone::simulate {

using catalogue::Json;

/// The fields of one object. Each reader names a field that may be present; `end` refuses all others. Throws
/// InvalidInput with the path of the field.
class Fields {
 public:
  /// Throws unless it is an object.
  Fields(const Json& json, std::string path);

  bool has(const char* name);
  std::string path_of(const char* name) const { return catalogue::member_path(path_, name); }
  /// Throws if it is missing.
  const Json& at(const char* name);

  double number(const char* name);
  double number_or(const char* name, double usual);
  double positive(const char* name);
  double not_negative_or(const char* name, double usual);
  /// From 0 to 1.
  double ratio(const char* name);
  /// An integer of at least `least`.
  std::uint32_t count_or(const char* name, std::uint32_t least, std::uint32_t usual);
  bool flag_or(const char* name, bool usual);
  std::string text_or(const char* name, const std::string& usual);
  Vector3d vector(const char* name);
  Vector3d vector_or(const char* name, const Vector3d& usual);
  /// The index of the word in the list.
  std::size_t word(const char* name, const std::vector<const char*>& words);
  std::size_t word_or(const char* name, const std::vector<const char*>& words, std::size_t usual);
  /// Each element of a list, with its path; nothing if it is missing.
  void each(const char* name, const std::function<void(const Json&, const std::string& path)>& visit);

  void end() const;

 private:
  const Json& json_;
  std::string path_;
  std::vector<const char*> known_;
};

/// The coordinates as a list of three.
template <class Triple>
Json three(const Triple& v) {
  return {catalogue::written(v.x), catalogue::written(v.y), catalogue::written(v.z)};
}

}  // namespace touchstone::simulate
