// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/memory_bits.h"

#include <iomanip>
#include <map>
#include <sstream>

namespace racebeam {

// "memory width 32 size 16 \name", before "cell $memwr_v2 $7" and its "parameter \MEMID "\\name"".
std::size_t written_bits(const std::string& rtlil) {
  std::map<std::string, std::size_t> memories;
  std::size_t written = 0;
  std::string cell;
  std::istringstream lines(rtlil);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word, name;
    words >> word;
    if (word == "cell") words >> cell;
    if (word == "memory") {
      std::size_t width = 1, size = 1;
      for (; words >> word; name = word) {
        if (word == "width") words >> width;
        if (word == "size") words >> size;
      }
      memories[name] = width * size;
    }
    if (word != "parameter" || cell.rfind("$memwr", 0) != 0) continue;
    if (words >> word >> std::quoted(name); word != "\\MEMID") continue;
    if (const auto found = memories.find(name); found != memories.end()) {
      written += found->second;
      memories.erase(found);  // it may have several ports
    }
  }
  return written;
}

}  // namespace racebeam
