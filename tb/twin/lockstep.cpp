// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/lockstep.h"

#include <algorithm>
#include <utility>

namespace racebeam {

Lockstep::Lockstep(const sc_core::sc_module_name& name, const std::string& unit,
                   const sc_core::sc_module& model, const std::vector<rtl_parameter>& wanted,
                   const std::string& plugin)
    : sc_module(name), unit_(unit), rtl_(plugin, unit, ports_of(model), wanted) {
  SC_HAS_PROCESS(Lockstep);
  SC_METHOD(clock);
  sensitive << clk_i.pos();
  dont_initialize();
}

void Lockstep::settle() {
  guarded([this] { rtl_.settle(); });
}
void Lockstep::clock() {
  guarded([this] { compare(); });
}

// At the edge the wires still have the settled values of the clock that ends.
void Lockstep::compare() {
  rtl_.settle();
  remember();
  if (wiring_ && clocks_ > 0) wiring_->look(clocks_);
  bool differs = false;
  const auto& outputs = rtl_.outputs();
  for (std::size_t n = 0; n < outputs.size() && clocks_ > 0; ++n) {
    const std::uint64_t expected = outputs[n].wire.value();
    std::uint64_t got = outputs[n].rtl.read();
    if (inversion_ && inversion_->output == n && inversion_->clock == clocks_)
      got ^= std::uint64_t{1} << inversion_->bit;
    if (got == expected) continue;
    differs = true;
    if (!first_) first_ = difference(n, expected, got);
  }
  differences_ += differs;
  rtl_.edge();
  ++clocks_;
}

void Lockstep::remember() {
  std::vector<std::uint64_t>& row = history_[clocks_ % history_.size()];
  row.resize(rtl_.inputs().size() + 2 * rtl_.outputs().size());
  std::uint64_t* to = row.data();
  for (const auto& in : rtl_.inputs()) *to++ = in.wire.value();
  for (const auto& out : rtl_.outputs()) {
    *to++ = out.wire.value();
    *to++ = out.rtl.read();
  }
  if (first_ && !first_->whole()) first_->history.push_back(row);
}

LockstepDifference Lockstep::difference(std::size_t output, std::uint64_t expected,
                                        std::uint64_t got) const {
  LockstepDifference d;
  d.unit = unit_;
  d.port = rtl_.outputs()[output].rtl.name();
  d.output = static_cast<int>(output);
  d.expected = expected;
  d.got = got;
  d.clock = clocks_;
  for (const auto& in : rtl_.inputs())
    d.columns.push_back({in.rtl.name(), LockstepDifference::Input, in.rtl.bits()});
  for (const auto& out : rtl_.outputs())
    for (const auto side : {LockstepDifference::Model, LockstepDifference::Rtl})
      d.columns.push_back({out.rtl.name(), side, out.rtl.bits()});
  if (wiring_) d.wiring = wiring_->text();
  const std::uint64_t first = clocks_ < history_.size() ? 0 : clocks_ - history_.size() + 1;
  d.before = static_cast<std::size_t>(clocks_ - first);
  for (std::uint64_t clock = first; clock <= clocks_; ++clock)
    d.history.push_back(history_[clock % history_.size()]);
  return d;
}

std::vector<probe> Lockstep::probes() const {
  std::vector<probe> all;
  for (const auto& output : rtl_.outputs())
    all.push_back(
        {output.rtl.name(), output.rtl.bits(), [rtl = output.rtl] { return rtl.read(); }});
  for (probe& inside : rtl_.probes()) all.push_back(std::move(inside));
  return all;
}

void Lockstep::invert(const std::string& port, int bit, std::uint64_t clock) {
  const auto& outputs = rtl_.outputs();
  const auto at = std::find_if(outputs.begin(), outputs.end(),
                               [&](const auto& output) { return output.rtl.name() == port; });
  if (at == outputs.end()) throw RtlError("the RTL has no output " + port);
  first_.reset();
  inversion_ = {static_cast<std::size_t>(at - outputs.begin()), bit, clock};
}

}  // namespace racebeam
