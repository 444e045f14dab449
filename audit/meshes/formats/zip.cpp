// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/formats/zip.h"

#include <zlib.h>

#include <limits>
#include <new>
#include <vector>

#include "audit/meshes/formats/bytes.h"
#include "audit/meshes/formats/mesh_file.h"
#include "geometry/invalid_input.h"

namespace touchstone::audit::meshes {
namespace {

/// Signatures of records, and of those for values beyond 32 bits.
constexpr std::string_view last_record = "PK\5\6", directory_entry = "PK\1\2", local_header = "PK\3\4";
constexpr std::string_view last_record_64 = "PK\6\6", locator_64 = "PK\6\7";
constexpr std::size_t locator_64_length = 20;

Bytes record(const std::string& name, std::string_view all, std::uint64_t at, std::string_view signature) {
  if (at > all.size() || !all.substr(at).starts_with(signature))
    throw InvalidInput(name, "a zip archive with an intact directory");
  return {name, all, std::endian::little, static_cast<std::size_t>(at) + signature.size()};
}

struct Directory {
  std::uint64_t entries, at;
};

Directory directory_of(const std::string& name, std::string_view all) {
  const std::size_t at = all.rfind(last_record);
  if (at == all.npos) throw InvalidInput(name, "a zip archive: it has no directory at its end");
  Bytes last = record(name, all, at, last_record);
  last.skip(6);
  Directory found{last.number<std::uint16_t>(), 0};
  last.skip(4);
  found.at = last.number<std::uint32_t>();
  last.skip(last.number<std::uint16_t>());  // a comment
  if (at < locator_64_length || !all.substr(at - locator_64_length).starts_with(locator_64)) return found;
  Bytes locator = record(name, all, at - locator_64_length, locator_64);
  locator.skip(4);
  Bytes last_64 = record(name, all, locator.number<std::uint64_t>(), last_record_64);
  last_64.skip(28);
  found.entries = last_64.number<std::uint64_t>();
  last_64.skip(8);
  found.at = last_64.number<std::uint64_t>();
  return found;
}

/// Reads the values that do not fit into 32 bits from the extra field of that number.
void extend(Bytes extra, std::vector<std::uint64_t*> values) {
  while (extra.left() >= 4) {
    const auto kind = extra.number<std::uint16_t>(), length = extra.number<std::uint16_t>();
    if (length > extra.left()) return;
    const std::size_t behind = extra.left() - length;
    for (std::uint64_t* value : values) {
      if (kind == 1 && *value == std::numeric_limits<std::uint32_t>::max() && extra.left() >= behind + 8)
        *value = extra.number<std::uint64_t>();
    }
    extra.skip(extra.left() - behind);
  }
}

/// zlib's state, freed at the end.
struct Inflation {
  z_stream stream{};
  Inflation() {
    if (::inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
  }
  ~Inflation() { ::inflateEnd(&stream); }
  Inflation(const Inflation&) = delete;
  Inflation& operator=(const Inflation&) = delete;
};

}  // namespace

Zip::Zip(std::string name, std::string_view bytes) : name_(std::move(name)), bytes_(bytes) {
  const Directory directory = directory_of(name_, bytes);
  std::uint64_t at = directory.at;
  for (std::uint64_t i = 0; i < directory.entries; ++i) {
    Bytes entry = record(name_, bytes, at, directory_entry);
    const std::size_t from = entry.left();
    entry.skip(4);
    Entry found{};
    found.flags = entry.number<std::uint16_t>(), found.method = entry.number<std::uint16_t>();
    entry.skip(4);
    found.checksum = entry.number<std::uint32_t>();
    found.packed = entry.number<std::uint32_t>(), found.unpacked = entry.number<std::uint32_t>();
    const auto length = entry.number<std::uint16_t>(), extra = entry.number<std::uint16_t>();
    const auto comment = entry.number<std::uint16_t>();
    entry.skip(8);
    found.header = entry.number<std::uint32_t>();
    const std::string file(entry.take(length));
    extend({name_, entry.take(extra), std::endian::little}, {&found.unpacked, &found.packed, &found.header});
    entry.skip(comment);
    at += directory_entry.size() + (from - entry.left());
    if (!entries_.emplace(file, found).second) refuse(file, "in the archive only once");
  }
}

void Zip::refuse(const std::string& file, const std::string& rule) const {
  throw InvalidInput(name_ + ": " + file, rule);
}

std::string_view Zip::packed(const std::string& file, const Entry& entry) const {
  Bytes header = record(name_, bytes_, entry.header, local_header);
  header.skip(22);
  const auto length = header.number<std::uint16_t>(), extra = header.number<std::uint16_t>();
  header.skip(length), header.skip(extra);
  if (entry.packed > header.left()) refuse(file, "the file ends before the declared number of bytes");
  return header.take(static_cast<std::size_t>(entry.packed));
}

void Zip::read(const std::string& file, const std::function<void(std::string_view)>& take) const {
  const Entry& entry = entries_.at(file);
  if ((entry.flags & 1) != 0) refuse(file, "not encrypted");
  if (entry.method != 0 && entry.method != Z_DEFLATED) refuse(file, "stored or deflated");
  const std::string_view bytes = packed(file, entry);
  uLong checksum = ::crc32(0, nullptr, 0);
  std::uint64_t length = 0;
  const auto piece = [&](std::string_view part) {
    length += part.size();
    if (length > most_bytes_of_a_mesh) refuse(file, "at most 256 MiB");
    checksum = ::crc32(checksum, reinterpret_cast<const Bytef*>(part.data()), static_cast<uInt>(part.size()));
    take(part);
  };
  if (entry.method == 0) {
    piece(bytes);
  } else {
    Inflation inflation;
    z_stream& stream = inflation.stream;
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    std::string part(std::size_t{1} << 16, '\0');
    for (int state = Z_OK; state != Z_STREAM_END;) {
      stream.next_out = reinterpret_cast<Bytef*>(part.data()), stream.avail_out = static_cast<uInt>(part.size());
      state = ::inflate(&stream, Z_NO_FLUSH);
      if (state != Z_OK && state != Z_STREAM_END) refuse(file, "deflated: it is damaged");
      piece(std::string_view(part).substr(0, part.size() - stream.avail_out));
    }
  }
  if (checksum != entry.checksum || length != entry.unpacked) refuse(file, "intact: its checksum or length differs");
}

}  // namespace touchstone::audit::meshes
