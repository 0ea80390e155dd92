// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/equal_steps.h"

#include <utility>

#include "tb/signoff/always_zero.h"

namespace racebeam {

namespace {

constexpr int Quiet = 32;  // runs in which nothing new comes

using Clock = std::chrono::steady_clock;

/// 64 bits at once.
struct LaneBits {
  using Bit = std::uint64_t;
  static constexpr Bit No = 0, Yes = ~Bit{0};
  Bit all(Bit a, Bit b) const { return a & b; }
  Bit any(Bit a, Bit b) const { return a | b; }
  Bit opposite(Bit a) const { return ~a; }
};

/// Bits of a circuit.
struct CircuitBits {
  using Bit = Literal;
  static constexpr Bit No = False, Yes = True;
  AndCircuit& circuit;
  Bit all(Bit a, Bit b) const { return circuit.all(a, b); }
  Bit any(Bit a, Bit b) const { return circuit.any(a, b); }
  Bit opposite(Bit a) const { return a ^ 1; }
};

}  // namespace

EqualSteps::EqualSteps(const AndCircuit& unit, const AndCircuit& mutant,
                       const StateValues& possible, RegisterWord word)
    : unit_(unit),
      mutant_(mutant),
      possible_(possible),
      word_(std::move(word)),
      in_word_(unit.next.size()),
      where_(std::size_t{1} << word_.size()),
      unit_lanes_(unit_),
      mutant_lanes_(mutant_) {
  for (const std::size_t bit : word_) in_word_[bit] = true;
  for (Where& where : where_) where.free.resize(unit.next.size());
  where_[0].reached = true;  // both begin with zeros
}

bool EqualSteps::hold(Clock::time_point end) {
  run_a_while(end);
  for (unsigned value = 0; value < where_.size(); ++value) {
    if (!where_[value].reached) continue;
    const auto left = std::chrono::duration_cast<std::chrono::seconds>(end - Clock::now());
    if (differ_ || left.count() < 1) return false;
    const ZeroAnswer answer = always_zero(question(value), left);
    if (answer.zero) continue;
    if (answer.inputs.empty()) return false;
    run_around(answer.inputs, value);
    if (!grew_) return false;
    run_a_while(end);
    value = ~0u;  // all of them once more
  }
  return true;
}

template <class Bits>
EqualSteps::Known<typename Bits::Bit> EqualSteps::known(
    Bits bits, const std::vector<typename Bits::Bit>& state) const {
  using Bit = typename Bits::Bit;
  Known<Bit> known{Bits::No, std::vector<Bit>(word_.size(), Bits::No),
                   std::vector<Bit>(state.size(), Bits::No)};
  for (unsigned value = 0; value < where_.size(); ++value) {
    const Where& where = where_[value];
    if (!where.reached) continue;
    Bit here = Bits::Yes;
    for (std::size_t bit = 0; bit < word_.size(); ++bit) {
      const Bit one = state[word_[bit]];
      here = bits.all(here, ((value >> bit) & 1) != 0 ? one : bits.opposite(one));
    }
    known.reached = bits.any(known.reached, here);
    for (std::size_t bit = 0; bit < word_.size(); ++bit)
      if (((where.mutant >> bit) & 1) != 0) known.word[bit] = bits.any(known.word[bit], here);
    for (std::size_t n = 0; n < state.size(); ++n)
      if (where.free[n]) known.free[n] = bits.any(known.free[n], here);
  }
  return known;
}

/// The registers of the mutant, where the unit is in a state.
template <class Bits>
std::vector<typename Bits::Bit> EqualSteps::beside(
    Bits bits, const std::vector<typename Bits::Bit>& state,
    const std::vector<typename Bits::Bit>& any) const {
  const auto known = this->known(bits, state);
  std::vector<typename Bits::Bit> mutant = state;
  for (std::size_t n = 0; n < state.size(); ++n)
    if (known.free[n] != Bits::No)
      mutant[n] = bits.any(bits.all(known.free[n], any[n]),
                           bits.all(bits.opposite(known.free[n]), state[n]));
  for (std::size_t bit = 0; bit < word_.size(); ++bit) mutant[word_[bit]] = known.word[bit];
  return mutant;
}

std::vector<EqualSteps::Lanes> EqualSteps::random_lanes(std::size_t count) {
  std::vector<Lanes> lanes(count);
  for (Lanes& one : lanes) one = random_();
  return lanes;
}

/// Possible states of the unit, where the word has values that are reached.
std::vector<EqualSteps::Lanes> EqualSteps::random_state() {
  std::vector<Lanes> state = random_lanes(unit_.next.size());
  possible_.choose(random_, state);
  std::vector<unsigned> reached;
  for (unsigned value = 0; value < where_.size(); ++value)
    if (where_[value].reached) reached.push_back(value);
  for (const std::size_t bit : word_) state[bit] = 0;
  for (int lane = 0; lane < 64; ++lane) {
    const unsigned value = reached[random_() % reached.size()];
    for (std::size_t bit = 0; bit < word_.size(); ++bit)
      state[word_[bit]] |= Lanes{(value >> bit) & 1} << lane;
  }
  return state;
}

/// One clock from those states of the unit, with `any` in registers of the mutant that are free.
void EqualSteps::run(const std::vector<Lanes>& inputs, const std::vector<Lanes>& state,
                     const std::vector<Lanes>& any) {
  const std::vector<Lanes> mutant = beside(LaneBits{}, state, any);
  for (std::size_t n = 0; n < inputs.size(); ++n)
    unit_lanes_.input(n) = mutant_lanes_.input(n) = inputs[n];
  for (std::size_t n = 0; n < state.size(); ++n) {
    unit_lanes_.register_at(n) = state[n];
    mutant_lanes_.register_at(n) = mutant[n];
  }
  unit_lanes_.settle();
  mutant_lanes_.settle();
  grow();
}

/// Takes in what that clock has led to.
void EqualSteps::grow() {
  for (std::size_t n = 0; n < unit_.outputs.size(); ++n)
    differ_ |= unit_lanes_.of(unit_.outputs[n]) != mutant_lanes_.of(mutant_.outputs[n]);
  std::vector<Lanes> differs;
  for (std::size_t n = 0; n < unit_.next.size(); ++n)
    differs.push_back(
        in_word_[n] ? 0 : unit_lanes_.of(unit_.next[n]) ^ mutant_lanes_.of(mutant_.next[n]));
  for (unsigned value = 0; value < where_.size(); ++value) {
    Lanes here = LaneBits::Yes;
    for (std::size_t bit = 0; bit < word_.size(); ++bit) {
      const Lanes one = unit_lanes_.of(unit_.next[word_[bit]]);
      here &= ((value >> bit) & 1) != 0 ? one : ~one;
    }
    if (here == 0) continue;
    Where& where = where_[value];
    const Lanes first = here & -here;
    for (std::size_t bit = 0; bit < word_.size(); ++bit) {
      const Lanes one = mutant_lanes_.of(mutant_.next[word_[bit]]) & here;
      if (!where.reached && (one & first) != 0) where.mutant |= 1u << bit;
      differ_ |= one != (((where.mutant >> bit) & 1) != 0 ? here : 0);
    }
    grew_ |= !where.reached;
    where.reached = true;
    for (std::size_t n = 0; n < differs.size(); ++n)
      if ((differs[n] & here) != 0 && !where.free[n]) grew_ = where.free[n] = true;
  }
}

void EqualSteps::run_a_while(Clock::time_point end) {
  for (int quiet = 0; quiet < Quiet && !differ_ && Clock::now() < end; ++quiet) {
    grew_ = false;
    const std::vector<Lanes> state = random_state();
    run(random_lanes(unit_.inputs), state, random_lanes(state.size()));
    if (grew_) quiet = 0;
  }
}

/// One clock from what yosys-abc found, and in other lanes with other inputs.
void EqualSteps::run_around(const std::vector<bool>& values, unsigned value) {
  std::size_t at = 0;
  const auto lanes = [&](std::size_t count, bool vary) {
    std::vector<Lanes> found;
    for (std::size_t n = 0; n < count; ++n, ++at)
      found.push_back((values[at] ? LaneBits::Yes : 0) ^
                      (vary ? random_() & random_() & ~Lanes{1} : 0));
    return found;
  };
  grew_ = false;
  const std::vector<Lanes> inputs = lanes(unit_.inputs, true);
  std::vector<Lanes> state = lanes(unit_.next.size(), false);
  for (const auto& [n, one] : possible_.constants()) state[n] = one ? LaneBits::Yes : 0;
  for (std::size_t bit = 0; bit < word_.size(); ++bit)
    state[word_[bit]] = ((value >> bit) & 1) != 0 ? LaneBits::Yes : 0;
  run(inputs, state, lanes(state.size(), true));
}

/// Of states where the word has that value. Inputs: those of the unit, its registers, and values
/// for registers of the mutant that are free. The output is 1 if a clock leads out of what is
/// known.
AndCircuit EqualSteps::question(unsigned value) const {
  AndCircuit circuit;
  const std::size_t registers = unit_.next.size();
  circuit.inputs = unit_.inputs + 2 * registers;
  const CircuitBits bits{circuit};
  std::vector<Literal> inputs, state, any;
  for (std::size_t n = 0; n < unit_.inputs; ++n) inputs.push_back(circuit.input(n));
  for (std::size_t n = 0; n < registers; ++n) {
    state.push_back(circuit.input(unit_.inputs + n));
    any.push_back(circuit.input(unit_.inputs + registers + n));
  }
  for (const auto& [at, one] : possible_.constants()) state[at] = one ? True : False;
  for (std::size_t bit = 0; bit < word_.size(); ++bit)
    state[word_[bit]] = ((value >> bit) & 1) != 0 ? True : False;
  const auto step = [&](const AndCircuit& of, const std::vector<Literal>& from) {
    std::vector<Literal> values = inputs;
    values.insert(values.end(), from.begin(), from.end());
    return circuit.copy(without_registers(of), values);
  };
  std::vector<Literal> unit = step(unit_, state);
  const std::vector<Literal> mutant = step(mutant_, beside(bits, state, any));
  const Literal before = possible_.hold(circuit, state);
  const Known<Literal> after =
      known(bits, {unit.begin(), unit.begin() + static_cast<std::ptrdiff_t>(registers)});
  for (std::size_t bit = 0; bit < word_.size(); ++bit) unit[word_[bit]] = after.word[bit];
  Literal leads_out = after.reached ^ 1;
  for (std::size_t n = 0; n < unit.size(); ++n) {
    const Literal differ =
        circuit.any(circuit.all(unit[n], mutant[n] ^ 1), circuit.all(unit[n] ^ 1, mutant[n]));
    const Literal counts = n < registers ? after.free[n] ^ 1 : True;
    leads_out = circuit.any(leads_out, circuit.all(counts, differ));
  }
  circuit.outputs = {circuit.all(before, leads_out)};
  return circuit;
}

}  // namespace racebeam
