// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/state_told.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace racebeam {

namespace {

constexpr std::size_t SmallWord = 6;  // bits

/// Words of a circuit; those of which `count` says most come first.
template <class Count>
std::vector<RegisterWord> by_most(std::vector<RegisterWord> words, const Count& count) {
  std::map<RegisterWord, std::size_t> most;
  for (const RegisterWord& word : words) most[word] = count(word);
  std::stable_sort(words.begin(), words.end(), [&](const RegisterWord& a, const RegisterWord& b) {
    return most.at(a) > most.at(b);
  });
  return words;
}

/// How many gates read a bit of a word, of the bit that most read.
std::size_t most_readers(const AndCircuit& circuit, const RegisterWord& word) {
  std::map<std::size_t, std::size_t> readers;
  for (const std::size_t bit : word) readers[circuit.register_at(bit) / 2] = 0;
  for (const auto& gate : circuit.gates)
    for (const Literal read : gate)
      if (const auto bit = readers.find(read / 2); bit != readers.end()) ++bit->second;
  std::size_t most = 0;
  for (const auto& [bit, count] : readers) most = std::max(most, count);
  return most;
}

/// How many gates depend on a word, within a clock.
std::size_t dependents(const AndCircuit& circuit, const RegisterWord& word) {
  const std::size_t before = circuit.register_at(circuit.next.size()) / 2;
  std::vector<bool> depends(before + circuit.gates.size());
  for (const std::size_t bit : word) depends[circuit.register_at(bit) / 2] = true;
  for (std::size_t n = 0; n < circuit.gates.size(); ++n)
    for (const Literal read : circuit.gates[n])
      if (depends[read / 2]) depends[before + n] = true;
  return static_cast<std::size_t>(std::count(depends.begin(), depends.end(), true));
}

}  // namespace

std::vector<StateTold> ways_to_tell(const AndCircuit& circuit,
                                    const std::vector<RegisterWord>& words) {
  std::vector<RegisterWord> small, wide;
  for (const RegisterWord& word : words) (word.size() <= SmallWord ? small : wide).push_back(word);
  small = by_most(small, [&](const RegisterWord& word) { return most_readers(circuit, word); });
  wide = by_most(wide, [&](const RegisterWord& word) { return dependents(circuit, word); });
  small.insert(small.begin(), RegisterWord{});
  std::vector<StateTold> ways;
  for (const RegisterWord& word : small) ways.push_back({word, {}});
  for (std::size_t n = 1; n < small.size(); ++n)
    for (std::size_t other = 1; other < small.size(); ++other) {
      if (other == n || small[n].size() == 1 || (small[other].size() > 1 && other < n)) continue;
      ways.push_back({small[n], {}});
      RegisterWord& both = ways.back().word;
      both.insert(both.end(), small[other].begin(), small[other].end());
    }
  for (const RegisterWord& one : wide)
    for (const RegisterWord& word : small) ways.push_back({word, one});
  return ways;
}

}  // namespace racebeam
