// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/value_groups.h"

#include <algorithm>

#include "tb/signoff/value_bits.h"

namespace racebeam {

namespace {

constexpr std::size_t SmallWord = 6;  // bits

using Lanes = std::uint64_t;

bool is_free(const ValueGroups::Group& group) {
  return group.values.size() == std::size_t{1} << group.bits.size();
}

bool is_bit(const ValueGroups::Group& group) { return group.bits.size() == 1; }

Literal has_value(const ValueGroups::Group& group, AndCircuit& circuit,
                  const std::vector<Literal>& state) {
  Literal one = False;
  for (const unsigned value : group.values) {
    Literal is = True;
    for (std::size_t bit = 0; bit < group.bits.size(); ++bit)
      is = circuit.all(is, state[group.bits[bit]] ^ (((value >> bit) & 1) == 0 ? 1 : 0));
    one = circuit.any(one, is);
  }
  return one;
}

}  // namespace

ValueGroups::ValueGroups(const std::vector<RegisterWord>& words) {
  for (const RegisterWord& word : words) {
    if (word.size() <= SmallWord) groups_.push_back({word, {0}});
    else
      for (const std::size_t bit : word) groups_.push_back({{bit}, {0}});
  }
}

void ValueGroups::drop_bits() {
  groups_.erase(std::remove_if(groups_.begin(), groups_.end(), is_bit), groups_.end());
}

bool ValueGroups::take(const AndCircuit& circuit, const CircuitLanes& lanes, Lanes which) {
  bool grew = false;
  for (Group& group : groups_)
    for (int lane = 0; lane < 64; ++lane) {
      if (((which >> lane) & 1) == 0) continue;
      unsigned value = 0;
      for (std::size_t bit = 0; bit < group.bits.size(); ++bit)
        value |= static_cast<unsigned>((lanes.of(circuit.next[group.bits[bit]]) >> lane) & 1)
                 << bit;
      grew |= group.values.insert(value).second;
    }
  groups_.erase(std::remove_if(groups_.begin(), groups_.end(), is_free), groups_.end());
  return grew;
}

void ValueGroups::choose(std::mt19937_64& random, std::vector<Lanes>& state) const {
  for (const Group& group : groups_) {
    const std::vector<unsigned> values(group.values.begin(), group.values.end());
    for (const std::size_t bit : group.bits) state[bit] = 0;
    for (int lane = 0; lane < 64; ++lane) {
      const unsigned value = values[random() % values.size()];
      for (std::size_t bit = 0; bit < group.bits.size(); ++bit)
        state[group.bits[bit]] |= Lanes{(value >> bit) & 1} << lane;
    }
  }
}

Literal ValueGroups::hold(AndCircuit& circuit, const std::vector<Literal>& state, std::size_t first,
                          std::size_t count) const {
  Literal all = True;
  for (std::size_t n = first; n < first + count; ++n)
    all = circuit.all(all, has_value(groups_[n], circuit, state));
  return all;
}

std::map<std::size_t, bool> ValueGroups::constants() const {
  std::map<std::size_t, bool> constants;
  for (const Group& group : groups_) {
    const auto [all, any] = bits_of(group.values);
    for (std::size_t bit = 0; bit < group.bits.size(); ++bit)
      if (((all ^ any) >> bit & 1) == 0) constants[group.bits[bit]] = (any >> bit & 1) != 0;
  }
  return constants;
}

}  // namespace racebeam
