// Values that a small word has in a unit and, at the same time, in a mutant beside it; and which
// other registers of the mutant may then have any value.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "tb/signoff/aiger.h"
#include "tb/signoff/named_circuit.h"

namespace racebeam {

/// 64 bits at once.
struct LaneBits {
  using Bit = std::uint64_t;
  static constexpr Bit No = 0, Yes = ~Bit{0};
  Bit all(Bit a, Bit b) const { return a & b; }
  Bit any(Bit a, Bit b) const { return a | b; }
  Bit opposite(Bit a) const { return ~a; }
};

/// Literals of a circuit.
struct CircuitBits {
  using Bit = Literal;
  static constexpr Bit No = False, Yes = True;
  AndCircuit& circuit;
  Bit all(Bit a, Bit b) const { return circuit.all(a, b); }
  Bit any(Bit a, Bit b) const { return circuit.any(a, b); }
  Bit opposite(Bit a) const { return a ^ 1; }
};

class ReachedPairs {
 public:
  /// Of a value of the unit's word.
  struct Where {
    std::set<unsigned> mutant;  ///< values of the mutant's word
    std::vector<bool> free;     ///< registers of the mutant that may have any value
  };
  using Pair = std::pair<unsigned, unsigned>;  ///< values of the unit's and of the mutant's word

  /// The word may be empty: it has one value then. Both begin with zeros.
  ReachedPairs(RegisterWord word, std::size_t registers)
      : word_(std::move(word)), in_word_(registers) {
    for (const std::size_t bit : word_) in_word_[bit] = true;
    reach({0, 0});
  }

  const RegisterWord& word() const { return word_; }
  bool in_word(std::size_t n) const { return in_word_[n]; }
  const std::map<unsigned, Where>& by_value() const { return where_; }
  std::vector<Pair> pairs() const {
    std::vector<Pair> all;
    for (const auto& [value, where] : where_)
      for (const unsigned mutant : where.mutant) all.emplace_back(value, mutant);
    return all;
  }
  /// Whether it is new.
  bool reach(Pair pair) {
    Where& where = where_[pair.first];
    where.free.resize(in_word_.size());
    return where.mutant.insert(pair.second).second;
  }
  /// Whether that is new; not of the word itself. The value is reached.
  bool set_free(unsigned value, std::size_t n) {
    Where& where = where_.at(value);
    if (in_word_[n] || where.free[n]) return false;
    return where.free[n] = true;
  }

  // Bits are lanes or literals.

  /// Whether the word has that value.
  template <class Bits>
  typename Bits::Bit is(Bits bits, const std::vector<typename Bits::Bit>& state,
                        unsigned value) const {
    typename Bits::Bit all = Bits::Yes;
    for (std::size_t bit = 0; bit < word_.size(); ++bit) {
      const auto one = state[word_[bit]];
      all = bits.all(all, ((value >> bit) & 1) != 0 ? one : bits.opposite(one));
    }
    return all;
  }

  /// Which registers of the mutant may have any value, where the unit is in a state.
  template <class Bits>
  std::vector<typename Bits::Bit> free_in(Bits bits,
                                          const std::vector<typename Bits::Bit>& state) const {
    std::vector<typename Bits::Bit> free(state.size(), Bits::No);
    for (const auto& [value, where] : where_) {
      const auto here = is(bits, state, value);
      for (std::size_t n = 0; n < state.size(); ++n)
        if (where.free[n]) free[n] = bits.any(free[n], here);
    }
    return free;
  }

  /// The registers of the mutant, where the unit is in a state. Its word is that of `any`.
  template <class Bits>
  std::vector<typename Bits::Bit> beside(Bits bits, const std::vector<typename Bits::Bit>& state,
                                         const std::vector<typename Bits::Bit>& any) const {
    const auto free = free_in(bits, state);
    std::vector<typename Bits::Bit> mutant = state;
    for (std::size_t n = 0; n < state.size(); ++n)
      if (free[n] != Bits::No)
        mutant[n] = bits.any(bits.all(free[n], any[n]), bits.all(bits.opposite(free[n]), state[n]));
    for (const std::size_t bit : word_) mutant[bit] = any[bit];
    return mutant;
  }

 private:
  const RegisterWord word_;
  std::vector<bool> in_word_;        // by register
  std::map<unsigned, Where> where_;  // by value
};

}  // namespace racebeam
