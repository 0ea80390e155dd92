// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/lockstep.h"

#include <algorithm>
#include <cstdio>

namespace racebeam {

Lockstep::Lockstep(const sc_core::sc_module_name& name, const std::string& unit,
                   const sc_core::sc_module& model, const knobs& k, const std::string& plugin)
    : sc_module(name),
      unit_(unit),
      rtl_(plugin.empty() ? rtl_plugin_path(unit, k) : plugin, unit, ports_of(model), k) {
  SC_HAS_PROCESS(Lockstep);
  SC_METHOD(compare);
  sensitive << clk_i.pos();
  dont_initialize();
}

// At the edge the wires still have the settled values of the clock that ends.
void Lockstep::compare() {
  rtl_.settle();
  remember();
  bool differs = false;
  const auto& outputs = rtl_.outputs();
  for (std::size_t n = 0; n < outputs.size() && clocks_ > 0; ++n) {
    const int expected = outputs[n].wire.value();
    int got = outputs[n].rtl.read();
    if (inversion_ && inversion_->output == n && inversion_->clock == clocks_)
      got ^= 1 << inversion_->bit;
    if (got == expected) continue;
    differs = true;
    if (!first_) first_ = difference(n, expected, got);
  }
  differences_ += differs;
  ++clocks_;
  rtl_.edge();
}

void Lockstep::remember() {
  if (first_) return;
  std::vector<int>& row = history_[clocks_ % history_.size()];
  row.resize(rtl_.inputs().size() + 2 * rtl_.outputs().size());
  int* to = row.data();
  for (const auto& in : rtl_.inputs()) *to++ = in.last;
  for (const auto& out : rtl_.outputs()) {
    *to++ = out.wire.value();
    *to++ = out.rtl.read();
  }
}

LockstepDifference Lockstep::difference(std::size_t output, int expected, int got) const {
  LockstepDifference d;
  d.unit = unit_;
  d.port = rtl_.outputs()[output].rtl.name();
  d.expected = expected;
  d.got = got;
  d.clock = clocks_;
  for (const auto& in : rtl_.inputs()) d.columns.emplace_back(in.rtl.name());
  for (const auto& out : rtl_.outputs()) {
    d.columns.push_back(out.rtl.name() + std::string(" model"));
    d.columns.push_back(out.rtl.name() + std::string(" rtl"));
  }
  const std::uint64_t first = clocks_ < history_.size() ? 0 : clocks_ - history_.size() + 1;
  for (std::uint64_t clock = first; clock <= clocks_; ++clock)
    d.history.push_back(history_[clock % history_.size()]);
  return d;
}

void Lockstep::invert(const std::string& port, int bit, std::uint64_t clock) {
  const auto& outputs = rtl_.outputs();
  const auto at = std::find_if(outputs.begin(), outputs.end(),
                               [&](const auto& output) { return output.rtl.name() == port; });
  if (at == outputs.end()) throw RtlError("the RTL has no output " + port);
  inversion_ = {static_cast<std::size_t>(at - outputs.begin()), bit, clock};
}

std::string LockstepDifference::text() const {
  std::string text;
  std::size_t width = 0;
  for (const std::string& column : columns) width = std::max(width, column.size());
  for (std::size_t n = 0; n < columns.size(); ++n) {
    text += "  " + columns[n] + std::string(width - columns[n].size(), ' ');
    for (const auto& row : history) {
      char number[16];
      std::snprintf(number, sizeof number, " %5x", static_cast<unsigned>(row[n]));
      text += number;
    }
    text += "\n";
  }
  return text;
}

}  // namespace racebeam
