// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/functional_points.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "tb/base/errors.h"
#include "tb/signoff/functional_tables.h"

namespace racebeam {

namespace {

/// Whether "left|right" names `bin`; "*" names all.
bool names_bin(const std::string& words, const std::string& bin) {
  if (words == "*") return true;
  std::istringstream parts(words);
  for (std::string one; std::getline(parts, one, '|');)
    if (one == bin) return true;
  return false;
}

}  // namespace

std::size_t FunctionalCross::points() const {
  std::size_t count = 1;
  for (const FunctionalAxis& axis : axes) count *= axis.bins.size();
  return count;
}

std::vector<std::size_t> FunctionalCross::bins_of(std::size_t number) const {
  std::vector<std::size_t> bins(axes.size());
  for (std::size_t n = axes.size(); n-- > 0; number /= axes[n].bins.size())
    bins[n] = number % axes[n].bins.size();
  return bins;
}

std::string FunctionalCross::point_name(std::size_t number) const {
  const std::vector<std::size_t> bins = bins_of(number);
  std::string text;
  for (std::size_t n = 0; n < axes.size(); ++n)
    text += (n == 0 ? "" : " ") + axes[n].name + "=" + axes[n].bins[bins[n]].name;
  return text;
}

const ImpossibleCross* FunctionalCross::impossible_at(std::size_t number,
                                                      const RtlParameters& parameters) const {
  const std::vector<std::size_t> bins = bins_of(number);
  for (const ImpossibleCross& one : impossible) {
    bool all = true;
    for (std::size_t n = 0; n < axes.size(); ++n)
      all = all && names_bin(one.bins.at(n), axes[n].bins[bins[n]].name);
    if (all && holds_with(parameters, one.when, "cross " + name)) return &one;
  }
  return nullptr;
}

FunctionalAxis axis_of_values(const std::string& name, const std::string& signal,
                              const std::vector<std::string>& values) {
  FunctionalAxis axis{name, {}};
  for (std::size_t n = 0; n < values.size(); ++n)
    axis.bins.push_back({values[n], signal + " == " + std::to_string(n)});
  return axis;
}

FunctionalAxis axis_of_flag(const std::string& name, const std::string& when) {
  return {name, {{"yes", when}, {"no", ""}}};
}

const std::vector<FunctionalCross>& all_functional_crosses() {
  static const std::vector<FunctionalCross> all = [] {
    std::vector<FunctionalCross> rows;
    for (const auto& table : {beam_tracer_crosses(), beam_other_crosses(), sphere_crosses(),
                              block_crosses(), voxel_crosses(), store_crosses()})
      rows.insert(rows.end(), table.begin(), table.end());
    return rows;
  }();
  return all;
}

std::vector<FunctionalCross> functional_crosses(const std::string& unit) {
  std::vector<FunctionalCross> some;
  for (const FunctionalCross& cross : all_functional_crosses())
    if (cross.unit == unit) some.push_back(cross);
  return some;
}

struct CrossCounter::Signal {
  std::string name;
  const UnitBench::Pin* pin;
  const probe* inside;
  double value = 0;
};

CrossCounter::~CrossCounter() = default;

std::unique_ptr<Expression> CrossCounter::made(const std::string& text, UnitBench& bench) {
  const auto value = [&](const std::string& name) {
    for (const auto& signal : signals_)
      if (signal->name == name) return &signal->value;
    Signal found{name, nullptr, nullptr};
    for (const UnitBench::Pin* pin : bench.pins())
      if (pin->name == name) found.pin = pin;
    for (const probe& one : registers_)
      if (one.name == name) found.inside = &one;
    if (!found.pin && !found.inside)
      throw UsageError(cross_.unit + " has no port and no register " + name);
    signals_.push_back(std::make_unique<Signal>(found));
    return &signals_.back()->value;
  };
  const auto no_words = [](const std::string&) {
    return static_cast<const std::vector<std::string>*>(nullptr);
  };
  const ExpressionNames names{"signal", "value", "state_q == 0", value, no_words};
  return std::make_unique<Expression>(cross_.unit + " " + cross_.name, text, names);
}

CrossCounter::CrossCounter(const FunctionalCross& cross, UnitBench& bench,
                           sc_core::sc_module& model)
    : cross_(cross), counts_(cross.points()) {
  if (auto* shown = dynamic_cast<probed*>(&model)) {
    shown->watch();
    registers_ = shown->probes();
  }
  if (!cross.during.empty()) during_ = made(cross.during, bench);
  for (const FunctionalAxis& axis : cross.axes) {
    axes_.emplace_back();
    for (const FunctionalBin& bin : axis.bins)
      axes_.back().push_back(bin.when.empty() ? nullptr : made(bin.when, bench));
  }
  for (const ImpossibleCross& one : cross.impossible)
    if (one.bins.size() != cross.axes.size())
      throw std::logic_error(cross.unit + " " + cross.name + ": impossible, but of other axes");
}

void CrossCounter::look() {
  for (const auto& signal : signals_)
    signal->value =
        static_cast<double>(signal->pin ? signal->pin->value() : signal->inside->read());
  if (during_ && !during_->holds()) return;
  std::size_t point = 0;
  for (const auto& bins : axes_) {
    const auto at = std::find_if(bins.begin(), bins.end(),
                                 [](const auto& when) { return !when || when->holds(); });
    if (at == bins.end()) return;
    point = point * bins.size() + static_cast<std::size_t>(at - bins.begin());
  }
  ++counts_[point];
}

CrossVerdict judge_cross(const FunctionalCross& cross, const std::vector<std::uint64_t>& counts,
                         const RtlParameters& parameters) {
  CrossVerdict verdict;
  for (std::size_t n = 0; n < counts.size(); ++n) {
    const ImpossibleCross* const reason = cross.impossible_at(n, parameters);
    const std::string name = cross.unit + " " + cross.name + ": " + cross.point_name(n);
    if (reason && reason->never && counts[n] > 0)
      verdict.faults.push_back(name + " was seen, and is said to be impossible: " + reason->reason);
    if (reason) continue;
    ++verdict.possible;
    if (counts[n] > 0) ++verdict.hit;
    else verdict.missing.push_back(name);
  }
  return verdict;
}

}  // namespace racebeam
