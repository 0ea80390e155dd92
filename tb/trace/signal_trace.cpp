// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/signal_trace.h"

#include <algorithm>
#include <map>
#include <utility>

#include "tb/base/errors.h"

namespace racebeam {

namespace {

constexpr int ForeignFrameBits = 20;  // of other chips: up to a million

/// Whether an overview has it: no register, no clock, nothing of the beam that is as regular, and
/// not the numbers that every question takes: corner, ray, and what the scene says of the room.
bool is_calm(const ChipSignal& signal) {
  static const std::vector<std::string> busy = {
      "*.x2",    "*.x2_[io]",    "*.consume",     "*.consume_[io]", "*.corner_*",
      "*.dr2_*", "*.neighbour*", "*.half_size_*", "*.position_*",   "*.look_*"};
  return signal.is_port() && !signal.is_clock() && !any_matches(busy, signal.path());
}

}  // namespace

SignalTrace::SignalTrace(const std::vector<ChipSignal>& signals, const TraceAxis& raster,
                         int period_ps, const TraceSelection& selection, bool overview,
                         std::function<std::string(int)> part, VcdWriter& vcd)
    : raster_(raster),
      period_(static_cast<std::uint64_t>(period_ps)),
      part_(std::move(part)),
      vcd_(vcd),
      line_bits_(1 + count_bits(std::max(raster.line_of_beam(raster.last_line()) + 1,
                                         -raster.first_line))),
      frame_bits_(part_ ? FrameBits : ForeignFrameBits) {
  add_beam(!overview);
  const std::size_t virtual_ones = vcd_.names().size();
  std::map<const void*, int> carried;  // signals of wires that have a name already
  for (const ChipSignal& signal : signals) {
    if (!selection.takes(signal.path()) || (overview && !is_calm(signal))) continue;
    if (signal.is_clock()) {
      vcd_.alias(signal.scope, signal.name, clk_);
      continue;
    }
    const void* carrier = signal.carrier();
    if (const auto known = carried.find(carrier); carrier && known != carried.end())
      vcd_.alias(signal.scope, signal.name, known->second);
    else if (const int added = add(signal); carrier) carried[carrier] = added;
  }
  if (vcd_.names().size() == virtual_ones) {
    const ChipSignal& one = example_of(signals);
    throw UsageError("no signal is under --scope and --depth; names look like " + one.path() +
                     ": try --scope '" + one.scope + "', or '*." + one.name + "'");
  }
}

void SignalTrace::add_beam(bool with_clock) {
  frame_ = vcd_.add("beam", raster_.of_pictures ? "picture" : "frame", frame_bits_);
  line_ = vcd_.add("beam", "line", line_bits_);
  pixel_ = vcd_.add("beam", "pixel", 11);
  clock_ = vcd_.add("beam", "clock", count_bits(raster_.line_clocks()));
  if (part_) show_ = vcd_.add_text("beam", "part");
  if (with_clock) clk_ = vcd_.add("beam", "clk_i", 1);
}

// Returns the number of the signal.
int SignalTrace::add(const ChipSignal& signal) {
  const auto* words = state_words(signal);
  const int word = words ? vcd_.add_text(signal.scope, signal.name + "_name") : None;
  const int added = vcd_.add(signal.scope, signal.name, signal.bits);
  if (signal.wire.bit) bits_.push_back({signal.wire.bit, added});
  else if (signal.wire.word) words_.push_back({signal.wire.word, added});
  else inner_.push_back({signal.inner, added, word, words});
  return added;
}

void SignalTrace::sample(const TracePoint& at) {
  const auto time = static_cast<std::uint64_t>(at.ordinal(raster_)) * period_;
  const auto raw = [](int value, int bits) {
    return static_cast<std::uint64_t>(value & low_bits(bits));
  };
  if (clk_ != None) vcd_.change(time, clk_, 1);
  vcd_.change(time, frame_, raw(at.frame, frame_bits_));
  vcd_.change(time, line_, raw(raster_.line_of_beam(at.line), line_bits_));
  vcd_.change(time, pixel_, raw(at.pixel(raster_), 11));
  vcd_.change(time, clock_, raw(at.clock, 31));
  if (show_ != None && at.frame != shown_) vcd_.change(time, show_, part_(shown_ = at.frame));
  for (const Bit& one : bits_) vcd_.change(time, one.signal, *one.at);
  for (const Word& one : words_) vcd_.change(time, one.signal, one.at->value());
  for (const Inner& one : inner_) {
    const std::uint64_t value = one.read();
    vcd_.change(time, one.signal, value);
    if (one.word != None) vcd_.change(time, one.word, one.words->at(value));
  }
  if (clk_ != None) vcd_.change(time + period_ / 2, clk_, 0);
}

}  // namespace racebeam
