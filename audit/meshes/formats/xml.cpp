// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/formats/xml.h"

#include <expat.h>

#include <exception>
#include <new>

#include "geometry/invalid_input.h"

namespace touchstone::audit::meshes {

struct XmlReader::State {
  std::string file;
  Begin begin;
  End end;
  XML_Parser parser = nullptr;
  std::exception_ptr thrown;  // No exception may pass through the library, which is C.

  template <class Act>
  void guarded(Act act) {
    if (thrown) return;
    try {
      act();
    } catch (...) {
      thrown = std::current_exception();
      ::XML_StopParser(parser, XML_FALSE);
    }
  }

  static void XMLCALL began(void* self, const XML_Char* name, const XML_Char** attributes) {
    auto& state = *static_cast<State*>(self);
    state.guarded([&] {
      XmlElement element{name, {}};
      for (; *attributes != nullptr; attributes += 2) element.attributes.emplace(attributes[0], attributes[1]);
      state.begin(element);
    });
  }
  static void XMLCALL ended(void* self, const XML_Char* name) {
    auto& state = *static_cast<State*>(self);
    state.guarded([&] { state.end(name); });
  }
  static void XMLCALL document_type(void* self, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    auto& state = *static_cast<State*>(self);
    state.guarded([&] { state.refuse("XML without a document type"); });
  }

  [[noreturn]] void refuse(const std::string& rule) const {
    throw InvalidInput(file + ":" + std::to_string(::XML_GetCurrentLineNumber(parser)), rule);
  }
};

XmlReader::XmlReader(std::string file, Begin begin, End end) : state_(std::make_unique<State>()) {
  state_->file = std::move(file), state_->begin = std::move(begin), state_->end = std::move(end);
  state_->parser = ::XML_ParserCreateNS(nullptr, '|');
  if (state_->parser == nullptr) throw std::bad_alloc();
  ::XML_SetUserData(state_->parser, state_.get());
  ::XML_SetElementHandler(state_->parser, State::began, State::ended);
  ::XML_SetStartDoctypeDeclHandler(state_->parser, State::document_type);
}

XmlReader::~XmlReader() { ::XML_ParserFree(state_->parser); }

void XmlReader::feed(std::string_view piece) { parse(piece, false); }
void XmlReader::finish() { parse("", true); }
void XmlReader::refuse(const std::string& rule) const { state_->refuse(rule); }

void XmlReader::parse(std::string_view piece, bool last) {
  const auto status = ::XML_Parse(state_->parser, piece.data(), static_cast<int>(piece.size()), last ? 1 : 0);
  if (state_->thrown) std::rethrow_exception(state_->thrown);
  if (status != XML_STATUS_OK) refuse(std::string("XML: ") + ::XML_ErrorString(::XML_GetErrorCode(state_->parser)));
}

}  // namespace touchstone::audit::meshes
