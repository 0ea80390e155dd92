// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/register_history.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "tb/base/counted.h"
#include "tb/twin/contract_registers.h"

namespace racebeam {

namespace {

/// "sp_q", "faces_q[3]", "g_axis[0].dr1_q".
bool is_register(const std::string& name) {
  const std::string stem = name.back() == ']' ? name.substr(0, name.rfind('[')) : name;
  return stem.size() > 2 && stem.compare(stem.size() - 2, 2, "_q") == 0;
}

}  // namespace

RegisterHistory::RegisterHistory(sc_core::sc_module& model, const Lockstep& lockstep)
    : unit_(lockstep.unit()) {
  auto* const inside = dynamic_cast<probed*>(&model);
  if (!inside) return;
  inside->watch();
  std::map<std::string, probe> of_model;
  for (probe& one : inside->probes())
    if (is_register(one.name)) of_model.emplace(one.name, one);
  const std::size_t outputs = lockstep.outputs();
  const std::vector<probe> of_rtl = lockstep.probes();  // outputs, then what is inside
  readable_ = !of_model.empty() && of_rtl.size() > outputs;
  for (std::size_t n = outputs; n < of_rtl.size(); ++n)
    if (const auto found = of_model.find(of_rtl[n].name);
        found != of_model.end() && found->second.bits == of_rtl[n].bits)
      pairs_.push_back({found->second, of_rtl[n]});
}

void RegisterHistory::take(std::uint64_t clock) {
  if (values_.empty()) first_ = clock;
  for (const Pair& pair : pairs_) values_.push_back({pair.model.read(), pair.rtl.read()});
}

RegisterHistory::Values RegisterHistory::values(std::uint64_t clock, std::size_t pair) const {
  if (clock < first_) return {0, 0};  // before the first edge
  const std::size_t at = (clock - first_) * pairs_.size() + pair;
  return at < values_.size() ? values_[at] : Values{0, 0};
}

std::vector<RegisterHistory::Found> RegisterHistory::differing(const LockstepDifference& d) const {
  std::vector<Found> found;
  for (std::size_t pair = 0; pair < pairs_.size(); ++pair)
    for (std::uint64_t clock = std::max(d.first_clock(), first_); clock <= d.clock; ++clock)
      if (const Values both = values(clock, pair); both.model != both.rtl) {
        found.push_back({pair, clock});
        break;
      }
  std::stable_sort(found.begin(), found.end(),
                   [](const Found& a, const Found& b) { return a.clock < b.clock; });
  return found;
}

LockstepDifference RegisterHistory::beside(LockstepDifference d) const {
  std::vector<Found> shown = differing(d);
  if (shown.size() > MostShown) shown.resize(MostShown);
  for (const Found& one : shown) {
    const probe& model = pairs_[one.pair].model;
    for (const auto side : {LockstepDifference::Model, LockstepDifference::Rtl})
      d.columns.push_back({model.name, side, model.bits});
    for (std::size_t row = 0; row < d.history.size(); ++row) {
      const Values both = values(d.first_clock() + row, one.pair);
      d.history[row].push_back(both.model);
      d.history[row].push_back(both.rtl);
    }
  }
  return d;
}

std::string RegisterHistory::text(const LockstepDifference& d) const {
  if (!readable_) return "";
  if (pairs_.empty())
    return "registers: none of the RTL has the name and the bits of one of the model\n";
  const std::vector<Found> found = differing(d);
  const std::string all = counted(pairs_.size(), "register") + " named alike";
  if (found.empty())
    return "registers: no difference up to here in the " + all +
           ": look at what is computed from them\n";
  std::string names;
  std::size_t first = 0;
  for (; first < found.size() && found[first].clock == found.front().clock; ++first) {
    const std::string& name = pairs_[found[first].pair].model.name;
    const std::string reason = contract_reason(unit_, name);
    if (first < MostShown)
      names += (first > 0 ? ", " : "") + name + (reason.empty() ? "" : " (" + reason + ")");
  }
  if (first > MostShown) names += fmt::format(" and {} more", first - MostShown);
  const auto ago = static_cast<long long>(found.front().clock) - static_cast<long long>(d.clock);
  return fmt::format("registers: {} {} first, in clock {}; {} of the {} {} up to clock 0\n", names,
                     first == 1 ? "differs" : "differ", ago, found.size(), all,
                     found.size() == 1 ? "does" : "do");
}

}  // namespace racebeam
