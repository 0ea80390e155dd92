// A file as it is.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <fstream>
#include <string>

namespace racebeam {

/// All bytes; none of a file that cannot be read.
inline std::string whole_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text;
  char some[65536];
  while (in.read(some, sizeof some), in.gcount() > 0)
    text.append(some, static_cast<std::size_t>(in.gcount()));
  return text;
}

}  // namespace racebeam
