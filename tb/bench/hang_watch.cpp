// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/hang_watch.h"

#include <stdexcept>
#include <utility>

namespace racebeam {

namespace {

constexpr int Slower = 50;  // a chip whose channels stall nearly all of the time

std::uint64_t clocks_of(int lines, int line_clocks) {
  return static_cast<std::uint64_t>(lines) * static_cast<std::uint64_t>(line_clocks);
}

}  // namespace

HangWatch::HangWatch(const wired_chip& chip, const knob_values& k, const WaitKind& kind,
                     const sc_core::sc_event& edge, const sc_core::sc_time& period, int line_clocks,
                     bool stalled)
    : chip_(chip),
      knobs_(k),
      kind_(kind),
      edge_(edge),
      period_(period),
      limit_(clocks_of(kind.lines * (stalled ? Slower : 1), line_clocks)),
      rare_limit_(clocks_of(kind.rare_lines * (stalled ? Slower : 1), line_clocks)),
      watched_for_(clocks_of(kind.watched_lines, line_clocks)),
      steady_(!stalled && kind.steady(k)) {
  note(kind.progress, [this] { last_ = sc_core::sc_time_stamp(); });
  if (!kind.rare.empty()) note(kind.rare, [this] { last_rare_ = sc_core::sc_time_stamp(); });
  for (const char* const name : kind.heard) note({name}, [this, name] { heard_.rose(name); });
}

// At each rising edge of one of the chip's wires.
void HangWatch::note(const std::vector<const char*>& wires, const std::function<void()>& rose) {
  sc_core::sc_spawn_options process;
  process.spawn_method();
  for (const char* const name : wires) {
    const std::string path = std::string(chip_.name()) + "." + name;
    const auto* const found = dynamic_cast<const wire<1>*>(sc_core::sc_find_object(path.c_str()));
    if (!found) throw std::logic_error("no wire of one bit is called " + path);
    process.set_sensitivity(&found->posedge_event());
  }
  process.dont_initialize();
  sc_core::sc_spawn(rose, sc_core::sc_gen_unique_name("progress"), &process);
}

std::uint64_t HangWatch::since(const sc_core::sc_time& time) const {
  return static_cast<std::uint64_t>((sc_core::sc_time_stamp() - time) / period_);
}

std::uint64_t HangWatch::clocks() const { return since(last_); }

bool HangWatch::hangs(bool idle) {
  if (idle) last_ = last_rare_ = sc_core::sc_time_stamp();
  if (!stands() && !(!kind_.rare.empty() && since(last_rare_) >= rare_limit_)) {
    looking_ = false;
    return false;
  }
  if (!looking_) {
    waits_ = kind_.make(chip_, knobs_, heard_);
    looking_since_ = sc_core::sc_time_stamp();
    looking_ = true;
    look();
    return false;
  }
  return since(looking_since_) >= watched_for_ &&
         ((stands() && steady_) || waits_->chain().back().sure);
}

// At the edge that ends a clock the wires still have its settled values.
void HangWatch::look() {
  if (std::exchange(spawned_, true)) return;
  sc_core::sc_spawn_options process;
  process.spawn_method();
  process.dont_initialize();
  process.set_sensitivity(&edge_);
  sc_core::sc_spawn(
      [this] {
        if (looking_) waits_->clock();
      },
      "waits", &process);
}

}  // namespace racebeam
