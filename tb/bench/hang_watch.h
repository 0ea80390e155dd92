// HangWatch: notices that a wired chip makes no progress, and says who waits for whom.
//
// Rising edges of a few wires are noted, which costs next to nothing. Only when they have not come
// for longer than they ever take is every clock looked at.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "tb/bench/waits.h"

namespace racebeam {

class HangWatch {
 public:
  /// Before the first clock of `chip`, which has clocks of `period` and lines of so many.
  /// `stalled`: its channels stall, and everything may take longer.
  HangWatch(const wired_chip& chip, const knob_values& k, const WaitKind& kind,
            const sc_core::sc_event& edge, const sc_core::sc_time& period, int line_clocks,
            bool stalled);

  /// Between clocks. `idle`: nobody expects progress. True: there has been none for long enough,
  /// and the waits have been watched.
  bool hangs(bool idle);
  /// There is none; else only the rare wire of the kind has no rising edge.
  bool stands() const { return clocks() >= limit_; }
  std::uint64_t rare_clocks() const { return since(last_rare_); }
  /// Clocks without progress.
  std::uint64_t clocks() const;
  /// "subdivider waits for ...; ...".
  std::string chain() const { return text_of(waits_->chain()); }
  const WaitKind& kind() const { return kind_; }

 private:
  void look();
  std::uint64_t since(const sc_core::sc_time& time) const;
  void note(const std::vector<const char*>& wires, const std::function<void()>& rose);

  const wired_chip& chip_;
  const knob_values knobs_;
  const WaitKind& kind_;
  const sc_core::sc_event& edge_;
  const sc_core::sc_time period_;
  const std::uint64_t limit_, rare_limit_, watched_for_;  // clocks
  sc_core::sc_time last_, last_rare_;
  LastRises heard_;
  std::unique_ptr<WaitWatch> waits_;  // while it is watched
  sc_core::sc_time looking_since_;
  const bool steady_;
  bool looking_ = false, spawned_ = false;
};

}  // namespace racebeam
