// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace touchstone::audit::meshes {

/// The start of an element of XML. Names in a namespace are written "NAMESPACE|NAME".
struct XmlElement {
  std::string name;
  std::map<std::string, std::string, std::less<>> attributes;
};

/// A streaming XML reader. Refuses, with the line, text that is not XML, and document types, by which a small text may
/// expand to a huge one.
class XmlReader {
 public:
  using Begin = std::function<void(const XmlElement&)>;
  using End = std::function<void(const std::string& name)>;

  XmlReader(std::string file, Begin begin, End end);
  ~XmlReader();
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

  void feed(std::string_view piece);
  /// Call after the last piece.
  void finish();
  [[noreturn]] void refuse(const std::string& rule) const;

 private:
  struct State;
  void parse(std::string_view piece, bool last);

  std::unique_ptr<State> state_;
};

}  // namespace touchstone::audit::meshes
