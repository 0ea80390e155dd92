// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/term_keys.h"

#include <cctype>

namespace racebeam {

namespace {

struct Sequence {
  std::string_view bytes;
  const char* key;
};
constexpr Sequence Sequences[] = {
    {"\x1b[A", "up"},    {"\x1b[B", "down"}, {"\x1b[C", "right"}, {"\x1b[D", "left"},
    {"\x1bOA", "up"},    {"\x1bOB", "down"}, {"\x1bOC", "right"}, {"\x1bOD", "left"},
    {"\x1bOP", "f1"},    {"\x1b[11~", "f1"}, {"\x1b[15~", "f5"},  {"\x1b[23~", "f11"},
    {"\x1b[24~", "f12"},
};

// Bytes of an unknown sequence, which mean nothing.
std::size_t unknown_sequence(std::string_view bytes) {
  if (bytes.size() < 2 || bytes[1] != '[') return 0;
  for (std::size_t i = 2; i < bytes.size(); ++i)
    if (bytes[i] >= '@' && bytes[i] <= '~') return i + 1;
  return bytes.size();
}

}  // namespace

std::vector<std::string> term_keys(std::string_view bytes) {
  std::vector<std::string> keys;
  while (!bytes.empty()) {
    std::size_t used = 0;
    for (const Sequence& sequence : Sequences)
      if (bytes.substr(0, sequence.bytes.size()) == sequence.bytes) {
        keys.emplace_back(sequence.key);
        used = sequence.bytes.size();
      }
    if (used == 0 && bytes[0] == '\x1b') used = unknown_sequence(bytes);
    if (used == 0) {
      const char c = bytes[0];
      if (c == '\x1b') keys.emplace_back("escape");
      else if (c == ' ') keys.emplace_back("space");
      else keys.emplace_back(1, static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
      used = 1;
    }
    bytes.remove_prefix(used);
  }
  return keys;
}

}  // namespace racebeam
