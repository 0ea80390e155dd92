// A file as it is.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

namespace racebeam {

/// The next bytes, `most` at most; `expected` is how many there may be.
inline std::string next_bytes(std::istream& in, std::size_t most, std::size_t expected = 0) {
  std::string text;
  text.reserve(expected);
  char some[65536];
  while (in.read(some, static_cast<std::streamsize>(std::min(sizeof some, most - text.size()))),
         in.gcount() > 0)
    text.append(some, static_cast<std::size_t>(in.gcount()));
  return text;
}

/// All bytes; none of a file that cannot be read.
inline std::string whole_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return next_bytes(in, std::string::npos, error ? 0 : static_cast<std::size_t>(size));
}

}  // namespace racebeam
