// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/equal_steps.h"

#include <iterator>
#include <utility>

#include "tb/signoff/step_question.h"
#include "tb/signoff/value_bits.h"
#include "tb/signoff/zero_mark.h"

namespace racebeam {

namespace {

constexpr int Quiet = 32;  // runs in which nothing new comes
constexpr int Shares = 4;  // of the time, for a question at once

RegisterWord and_mark(RegisterWord word, const RegisterWord& wide, std::size_t mark) {
  if (!wide.empty()) word.push_back(mark);
  return word;
}

}  // namespace

EqualSteps::EqualSteps(const AndCircuit& unit, const AndCircuit& mutant,
                       const StateValues& possible, const RegisterWord& word, RegisterWord wide)
    : wide_(std::move(wide)),
      unit_(with_zero_mark(unit, wide_)),
      mutant_(with_zero_mark(mutant, wide_)),
      possible_(possible),
      reached_(and_mark(word, wide_, unit.next.size()), unit_.next.size()),
      unit_lanes_(unit_),
      mutant_lanes_(mutant_) {}

bool EqualSteps::hold(WorkClock::time_point end, Effort effort) {
  const StepQuestion question{unit_, mutant_, possible_, reached_, wide_};
  do {
    run_a_while(end);
    for (const auto& [value, where] : reached_.by_value()) {
      const auto now = WorkClock::now();
      const auto left = std::chrono::duration_cast<std::chrono::seconds>(end - now);
      if (differ_ || left.count() < 1) return false;
      ZeroAnswer answer =
          question.ask(value, now, effort == AtOnce ? std::chrono::seconds{0} : left / Shares);
      if (effort == Thorough && !answer.zero && answer.inputs.empty())
        answer = question.ask(value, now + (end - now) / 2, left / Shares);
      if (answer.zero) continue;
      if (answer.inputs.empty()) return false;
      run_around(answer.inputs, value);
      if (!grew_) return false;
      break;  // and all of them once more
    }
  } while (grew_);
  return !differ_;
}

std::vector<EqualSteps::Lanes> EqualSteps::random_lanes(std::size_t count) {
  std::vector<Lanes> lanes(count);
  for (Lanes& one : lanes) one = random_();
  return lanes;
}

/// Possible states of the unit, and values of both words that are reached.
void EqualSteps::choose(std::vector<Lanes>& state, std::vector<Lanes>& any) {
  const RegisterWord& word = reached_.word();
  possible_.choose(random_, state);
  const auto pairs = reached_.pairs();
  for (const std::size_t bit : word) state[bit] = any[bit] = 0;
  for (int lane = 0; lane < 64; ++lane) {
    const auto [value, mutant] = pairs[random_() % pairs.size()];
    for (std::size_t bit = 0; bit < word.size(); ++bit) {
      state[word[bit]] |= Lanes{(value >> bit) & 1} << lane;
      any[word[bit]] |= Lanes{(mutant >> bit) & 1} << lane;
    }
  }
  for (const std::size_t bit : wide_) state[bit] &= state.back();
}

/// The lanes in which claims hold, and the mark is what it has to be.
EqualSteps::Lanes EqualSteps::are_possible(const std::vector<Lanes>& state) const {
  const Lanes claimed = possible_.claimed(state);
  return wide_.empty() ? claimed
                       : claimed & ~(state.back() ^ is_not_zero(LaneBits{}, wide_, state));
}

/// States of the unit that were seen, and for each some value of the mutant's word that goes with
/// it; the lanes in which there is one.
EqualSteps::Lanes EqualSteps::choose_seen(std::vector<Lanes>& state, std::vector<Lanes>& any) {
  const RegisterWord& word = reached_.word();
  state = possible_.seen()[random_() % possible_.seen().size()];
  if (!wide_.empty()) state.push_back(is_not_zero(LaneBits{}, wide_, state));
  for (const std::size_t bit : word) any[bit] = 0;
  Lanes known = 0;
  for (int lane = 0; lane < 64; ++lane) {
    unsigned value = 0;
    for (std::size_t bit = 0; bit < word.size(); ++bit)
      value |= static_cast<unsigned>(state[word[bit]] >> lane & 1) << bit;
    const auto where = reached_.by_value().find(value);
    if (where == reached_.by_value().end()) continue;
    const auto& others = where->second.mutant;
    const unsigned mutant =
        *std::next(others.begin(), static_cast<std::ptrdiff_t>(random_() % others.size()));
    for (std::size_t bit = 0; bit < word.size(); ++bit)
      any[word[bit]] |= Lanes{(mutant >> bit) & 1} << lane;
    known |= Lanes{1} << lane;
  }
  return known;
}

/// One clock, in those lanes, from those states of the unit, with `any` in registers of the mutant
/// that are free.
void EqualSteps::run(const std::vector<Lanes>& inputs, const std::vector<Lanes>& state,
                     const std::vector<Lanes>& any, Lanes which) {
  const std::vector<Lanes> mutant = reached_.beside(LaneBits{}, state, any);
  for (std::size_t n = 0; n < inputs.size(); ++n)
    unit_lanes_.input(n) = mutant_lanes_.input(n) = inputs[n];
  for (std::size_t n = 0; n < state.size(); ++n) {
    unit_lanes_.register_at(n) = state[n];
    mutant_lanes_.register_at(n) = mutant[n];
  }
  unit_lanes_.settle();
  mutant_lanes_.settle();
  grow(which & are_possible(state));
}

/// Takes in what that clock has led to in those lanes.
void EqualSteps::grow(Lanes which) {
  const RegisterWord& word = reached_.word();
  for (std::size_t n = 0; n < unit_.outputs.size(); ++n)
    differ_ |=
        ((unit_lanes_.of(unit_.outputs[n]) ^ mutant_lanes_.of(mutant_.outputs[n])) & which) != 0;
  std::vector<Lanes> unit, mutant;
  for (std::size_t n = 0; n < unit_.next.size(); ++n) {
    unit.push_back(unit_lanes_.of(unit_.next[n]));
    mutant.push_back(mutant_lanes_.of(mutant_.next[n]));
  }
  std::map<ReachedPairs::Pair, Lanes> led;  // in which lanes
  for (int lane = 0; lane < 64; ++lane) {
    ReachedPairs::Pair pair{0, 0};
    for (std::size_t bit = 0; bit < word.size(); ++bit) {
      pair.first |= static_cast<unsigned>(unit[word[bit]] >> lane & 1) << bit;
      pair.second |= static_cast<unsigned>(mutant[word[bit]] >> lane & 1) << bit;
    }
    if (((which >> lane) & 1) != 0) led[pair] |= Lanes{1} << lane;
  }
  for (const auto& [pair, here] : led) {
    grew_ |= reached_.reach(pair);
    for (std::size_t n = 0; n < unit.size(); ++n)
      if (((unit[n] ^ mutant[n]) & here) != 0) grew_ |= reached_.set_free(pair.first, n);
  }
}

void EqualSteps::run_a_while(WorkClock::time_point end) {
  for (int quiet = 0; quiet < Quiet && !differ_ && WorkClock::now() < end; ++quiet) {
    grew_ = false;
    std::vector<Lanes> state = random_lanes(unit_.next.size()), any = random_lanes(state.size());
    Lanes which = LaneBits::Yes;
    if (quiet % 2 == 1 && !possible_.seen().empty()) which = choose_seen(state, any);
    else choose(state, any);
    run(random_lanes(unit_.inputs), state, any, which);
    if (grew_) quiet = 0;
  }
}

/// One clock from what yosys-abc found, and in other lanes with other inputs.
void EqualSteps::run_around(const std::vector<bool>& values, unsigned value) {
  const RegisterWord& word = reached_.word();
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
  std::vector<Lanes> state = lanes(unit_.next.size(), false), any = lanes(state.size(), true);
  for (const auto& [n, one] : possible_.constants()) state[n] = one ? LaneBits::Yes : 0;
  const auto [least, most] = bits_of(reached_.by_value().at(value).mutant);
  for (std::size_t bit = 0; bit < word.size(); ++bit) {
    const bool found = values[unit_.inputs + state.size() + word[bit]];
    const unsigned all = found ? most : least;  // what is the same in all is not asked
    state[word[bit]] = ((value >> bit) & 1) != 0 ? LaneBits::Yes : 0;
    any[word[bit]] = ((all >> bit) & 1) != 0 ? LaneBits::Yes : 0;
  }
  run(inputs, state, any, LaneBits::Yes);
}

}  // namespace racebeam
