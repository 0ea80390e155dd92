// What tells a text from others, in manifests.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <xxhash.h>

#include <string>
#include <string_view>

namespace racebeam {

/// "xxh64 " and 16 digits.
inline std::string content_hash(std::string_view text) {
  return fmt::format("xxh64 {:016x}", XXH64(text.data(), text.size(), 0));
}

}  // namespace racebeam
