// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/lockstep.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "sc/unit_choices.h"
#include "tb/trace/vcd_writer.h"

namespace racebeam {

Lockstep::Lockstep(const sc_core::sc_module_name& name, const std::string& unit,
                   const sc_core::sc_module& model, const knobs& k, const std::string& plugin)
    : sc_module(name), unit_(unit), rtl_(plugin, unit, ports_of(model), k) {
  SC_HAS_PROCESS(Lockstep);
  SC_METHOD(clock);
  sensitive << clk_i.pos();
  dont_initialize();
}

template <class Work>
void Lockstep::guarded(const Work& work) {
  if (fault_) return;
  try {
    work();
  } catch (const RtlFault& fault) {
    if (!outlives_) throw;
    fault_ = fault.what();
  }
}

void Lockstep::settle() {
  guarded([this] { rtl_.settle(); });
}
void Lockstep::deposit_frame(int frame) {
  guarded([&] { rtl_.seek(frame); });
}
void Lockstep::deposit_place(const vec3& position, int room) {
  guarded([&] { rtl_.place(position, room); });
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
  for (const auto& in : rtl_.inputs())
    d.columns.push_back({in.rtl.name(), LockstepDifference::Input, in.rtl.bits()});
  for (const auto& out : rtl_.outputs())
    for (const auto side : {LockstepDifference::Model, LockstepDifference::Rtl})
      d.columns.push_back({out.rtl.name(), side, out.rtl.bits()});
  if (wiring_) d.wiring = wiring_->text();
  const std::uint64_t first = clocks_ < history_.size() ? 0 : clocks_ - history_.size() + 1;
  for (std::uint64_t clock = first; clock <= clocks_; ++clock)
    d.history.push_back(history_[clock % history_.size()]);
  return d;
}

std::vector<probe> Lockstep::probes() const {
  std::vector<probe> all;
  for (const auto& output : rtl_.outputs())
    all.push_back({output.rtl.name(), output.rtl.bits(), [rtl = output.rtl] {
                     return static_cast<std::uint64_t>(static_cast<std::uint32_t>(rtl.read()));
                   }});
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

std::string LockstepDifference::text() const {
  const auto label = [](const Column& column) {
    return column.port + (column.side == Model ? " model" : column.side == Rtl ? " rtl" : "");
  };
  std::string text;
  std::size_t width = 0;
  for (const Column& column : columns) width = std::max(width, label(column).size());
  const std::size_t from = history.size() > Shown ? history.size() - Shown : 0;
  for (std::size_t n = 0; n < columns.size(); ++n) {
    const std::string name = label(columns[n]);
    text += "  " + name + std::string(width - name.size(), ' ');
    for (std::size_t clock = from; clock < history.size(); ++clock) {
      char number[16];
      std::snprintf(number, sizeof number, " %5x", static_cast<unsigned>(history[clock][n]));
      text += number;
    }
    text += "\n";
  }
  return text;
}

// What the model and the chip around it have lies in `chip`, what the RTL has in `rtl`.
std::string LockstepDifference::vcd(int period) const {
  VcdWriter vcd;
  const std::string place = unit == "racebeam_top" ? "" : "." + instance_of(unit);
  const int clk = vcd.add("chip", "clk_i", 1), count = vcd.add("chip", "clock", 64);
  const int differs = vcd.add("rtl", "differs", 1);
  std::vector<int> signals;
  for (const Column& column : columns)
    signals.push_back(
        vcd.add((column.side == Rtl ? "rtl" : "chip") + place, column.port, column.bits));
  const std::uint64_t first = clock + 1 - history.size(), step = static_cast<std::uint64_t>(period);
  for (std::size_t n = 0; n < history.size(); ++n) {
    const std::uint64_t at = n * step;
    vcd.change(at, clk, 1);
    vcd.change(at, count, first + n);
    vcd.change(at, differs, n + 1 == history.size());
    for (std::size_t c = 0; c < columns.size(); ++c)
      vcd.change(at, signals[c], static_cast<std::uint64_t>(history[n][c]));
    vcd.change(at + step / 2, clk, 0);
  }
  return vcd.text("racebeam: the clocks before the first difference of " + unit,
                  history.size() * step);
}

}  // namespace racebeam
