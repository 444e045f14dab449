// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "catalogue/row.h"
#include "catalogue/codec/json.h"

/// The shape of an operation's answer in JSON, from its type: "number", "on | off", ["number", "number"], {"t": ...}. A
/// name that ends in ? may be left out.
namespace touchstone::audit {

template <class T>
Json shape_of() {
  if constexpr (Enumeration<T>) {
    std::string words;
    for (const char* word : Words<T>::words) words += (words.empty() ? "" : " | ") + std::string(word);
    return words;
  } else if constexpr (std::is_same_v<T, bool>) {
    return "true | false";
  } else if constexpr (Plain<T>) {
    return "index";
  } else if constexpr (is_optional<T>) {
    return shape_of<typename T::value_type>();
  } else if constexpr (is_vector<T>) {
    return Json::array({shape_of<typename T::value_type>(), "..."});
  } else if constexpr (Composite<T>) {
    Json shape = Described<T>::form == Form::list ? Json::array() : Json::object();
    Json bare;
    for_each_member<T>([&](const auto& member) {
      using Part = std::remove_cvref_t<decltype(std::declval<T>().*member.pointer)>;
      bare = shape_of<Part>();
      if constexpr (Described<T>::form == Form::list) {
        shape.push_back(bare);
      } else {
        shape[std::string(member.name) + (is_optional<Part> ? "?" : "")] = bare;
      }
    });
    return Described<T>::form == Form::bare ? bare : shape;
  } else {
    return "number";
  }
}

template <class Row>
Json answer_shape() {
  Json shape = shape_of<answer_t<Row>>();
  if (Row::card().answer[0] == 0) return shape;
  Json named = Json::object();
  named[Row::card().answer] = std::move(shape);
  return named;
}

}  // namespace touchstone::audit
