// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/row_digest.h"

#define XXH_INLINE_ALL
#include <endian.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <xxhash.h>

#include <cstring>

namespace racebeam {

namespace {

void add(std::string& bytes, std::int64_t value) {
  const std::uint64_t little = htole64(static_cast<std::uint64_t>(value));
  bytes.append(reinterpret_cast<const char*>(&little), sizeof little);
}

std::uint64_t digest_of(std::string_view bytes) { return XXH3_64bits(bytes.data(), bytes.size()); }

void digest(sqlite3_context* context, int count, sqlite3_value** values) {
  std::string bytes;
  for (int i = 0; i < count; ++i) {
    if (const int type = sqlite3_value_type(values[i]); type == SQLITE_INTEGER) {
      add(bytes, sqlite3_value_int64(values[i]));
    } else if (type == SQLITE_FLOAT) {
      const double real = sqlite3_value_double(values[i]);
      std::int64_t bits;
      std::memcpy(&bits, &real, sizeof bits);
      add(bytes, bits);
    } else {
      const void* data = sqlite3_value_blob(values[i]);  // first: it may change what follows
      const auto size = static_cast<std::size_t>(sqlite3_value_bytes(values[i]));
      add(bytes, static_cast<std::int64_t>(size));
      if (size) bytes.append(static_cast<const char*>(data), size);
    }
  }
  sqlite3_result_int64(context, static_cast<std::int64_t>(digest_of(bytes)));
}

}  // namespace

std::uint64_t frame_digest(int frame, const std::vector<std::int64_t>& values) {
  std::string bytes;
  bytes.reserve((values.size() + 1) * sizeof(std::int64_t));
  add(bytes, frame);
  for (const std::int64_t value : values) add(bytes, value);
  return digest_of(bytes);
}

std::int64_t picture_digest(std::string_view colours) {
  return static_cast<std::int64_t>(digest_of(colours));
}

std::string text_hash(std::string_view text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

void add_digest_function(sqlite3* database) {
  sqlite3_create_function_v2(database, "digest", -1,
                             SQLITE_UTF8 | SQLITE_DETERMINISTIC | SQLITE_DIRECTONLY, nullptr,
                             digest, nullptr, nullptr, nullptr);
}

}  // namespace racebeam
