// Who waits for whom in a chip that makes no progress, told from the wires between its units, so
// that it does not matter what they are made of.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <systemc>
#include <vector>

#include "sc/base/engine.h"
#include "sc/base/wired_chip.h"

namespace racebeam {

/// A link of the chain.
struct Wait {
  std::string unit;
  std::string port;  ///< of the unit that it waits for: "interval_fifo.ack_o = 1"; empty: it is the
                     ///< last of the chain, which waits for nobody
  std::uint64_t clocks = 0;  ///< for so long, as far as it was watched
  std::string what{};        ///< of the last one: what it does, or does not
  bool sure = false;         ///< of the last one: no unit that is right ever does that
};

/// How long something has been so, in clocks.
struct Held {
  std::uint64_t clocks = 0;
  void see(bool is) { clocks = is ? clocks + 1 : 0; }
  bool operator>=(std::uint64_t limit) const { return clocks >= limit; }
};

/// When wires of the chip rose last: who was told what before anybody looked.
class LastRises {
 public:
  void rose(const std::string& wire) { last_[wire] = sc_core::sc_time_stamp(); }
  /// 0: never.
  sc_core::sc_time of(const std::string& wire) const {
    const auto found = last_.find(wire);
    return found == last_.end() ? sc_core::SC_ZERO_TIME : found->second;
  }

 private:
  std::map<std::string, sc_core::sc_time> last_;
};

class WaitWatch {
 public:
  virtual ~WaitWatch() = default;
  /// Once for each clock, at its end, the wires settled.
  virtual void clock() = 0;
  /// From the unit at the chip's end to the one that waits for nobody.
  virtual std::vector<Wait> chain() const = 0;
};

/// How an engine's chip is watched.
struct WaitKind {
  const racebeam::engine& engine;
  std::vector<const char*> progress;  ///< wires of the chip: their rising edges are progress
  const char* what;                   ///< "an interval was taken"
  int lines;                          ///< so many scan lines without are too many
  std::vector<const char*> rare;      ///< wires whose rising edges come to a chip in good time
  int rare_lines;                     ///< after so many without, a wait that is sure is a fault
  int watched_lines;                  ///< so long the waits are watched
  std::vector<const char*> heard;     ///< wires that `make` is told the last rises of
  /// Whether progress comes in that time to every chip with these knobs; if not, and where
  /// channels stall, only a wait that is sure is a fault.
  bool (*steady)(const knob_values& k);
  std::unique_ptr<WaitWatch> (*make)(const wired_chip& chip, const knob_values& k,
                                     const LastRises& heard);
};

/// The row of an engine. Throws std::out_of_range.
const WaitKind& waits_of(const engine& built);

/// "... waits for ...; ... waits for ...; ... waits for nobody: ...".
std::string text_of(const std::vector<Wait>& chain);

}  // namespace racebeam
