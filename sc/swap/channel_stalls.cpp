// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/channel_stalls.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace racebeam {

namespace {

// splitmix64: a good stream from any seed.
std::uint64_t next_of(std::uint64_t& state) {
  std::uint64_t z = state += 0x9e3779b97f4a7c15;
  z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
  z = (z ^ z >> 27) * 0x94d049bb133111eb;
  return z ^ z >> 31;
}

std::uint64_t mixed(std::uint64_t seed, const std::string& name, std::uint64_t place) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::uint64_t state = seed;
  state = next_of(state) ^ hash;
  state = next_of(state) ^ place;
  return next_of(state);
}

bool happens(std::uint64_t& state, double probability) {
  constexpr double Range = 9007199254740992;  // 2^53
  return static_cast<double>(next_of(state) >> 11) < probability * Range;
}

/// "g_core[3].u_block_core.job_ready_o" becomes "g_core[*]..." and "[3]".
std::pair<std::string, std::string> without_index(const std::string& path) {
  const auto open = path.find('['), close = path.find(']');
  if (open == std::string::npos || close == std::string::npos) return {path, ""};
  return {path.substr(0, open) + "[*" + path.substr(close), path.substr(open, close - open + 1)};
}

std::string plain(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '.' || c == '[' || c == ']'; }, '_');
  return name;
}

/// What chips that are made now get; a chip's constructor is given knobs and units only.
std::shared_ptr<const stall_plan> planned;

std::map<const sc_core::sc_module*, channel_stalls*>& by_chip() {
  static std::map<const sc_core::sc_module*, channel_stalls*> all;
  return all;
}

}  // namespace

planned_stalls::planned_stalls(std::shared_ptr<const stall_plan> plan) {
  planned = std::move(plan);
}
planned_stalls::~planned_stalls() { planned.reset(); }

std::unique_ptr<channel_stalls> channel_stalls::make(const sc_core::sc_module& chip,
                                                     in_port<1>& clk) {
  if (!planned) return nullptr;
  return std::unique_ptr<channel_stalls>(new channel_stalls(chip, *planned, clk));
}

channel_stalls* channel_stalls::of(const sc_core::sc_module& chip) {
  const auto found = by_chip().find(&chip);
  return found == by_chip().end() ? nullptr : found->second;
}

channel_stalls::~channel_stalls() { by_chip().erase(&chip_); }

channel_stalls::channel_stalls(const sc_core::sc_module& chip, const stall_plan& plan,
                               in_port<1>& clk)
    : chip_(chip), plan_(plan) {
  by_chip()[&chip] = this;
  sc_core::sc_spawn_options process;
  process.spawn_method();
  process.dont_initialize();
  process.set_sensitivity(&clk.pos());
  sc_core::sc_spawn([this] { tick(); }, "stall_channels", &process);
}

wire<1>& channel_stalls::before(const in_port<1>& port, wire<1>& from) {
  const auto by = held(path_of(port));
  if (by.empty()) return from;
  const std::string name = "held_" + plain(path_of(port));
  wires_.push_back(std::make_unique<wire<1>>(name.c_str()));
  filter(name, from, *wires_.back(), by);
  return *wires_.back();
}

wire<1>& channel_stalls::behind(const out_port<1>& port, wire<1>& to) {
  const auto by = held(path_of(port));
  if (by.empty()) return to;
  const std::string name = "held_" + plain(path_of(port));
  wires_.push_back(std::make_unique<wire<1>>(name.c_str()));
  filter(name, *wires_.back(), to, by);
  return *wires_.back();
}

void channel_stalls::filter(const std::string& name, const wire<1>& from, wire<1>& to,
                            const std::vector<held_port>& by) {
  sc_core::sc_spawn_options process;
  process.spawn_method();
  process.set_sensitivity(&from.value_changed_event());
  for (const held_port& one : by) {
    process.set_sensitivity(&one.of->stall->value_changed_event());
    if (one.of->unless) process.set_sensitivity(&one.of->unless->value_changed_event());
  }
  sc_core::sc_spawn(
      [&from, &to, by] {
        const auto at = std::find_if(by.begin(), by.end(),
                                     [](const held_port& one) { return one.of->holds(); });
        to.write(at == by.end() ? from.read() : at->held);
      },
      (name + "_filter").c_str(), &process);
}

std::vector<channel_stalls::held_port> channel_stalls::held(const std::string& port) {
  const auto [pattern, index] = without_index(port);
  std::vector<held_port> by;
  for (const stall_plan::channel& row : plan_.channels)
    for (const stall_plan::port& one : row.ports) {
      if (one.name != pattern) continue;
      found_.push_back(pattern);
      by.push_back({&channel_of(row, index), one.held});
    }
  return by;
}

channel_stalls::channel& channel_stalls::channel_of(const stall_plan::channel& row,
                                                    const std::string& index) {
  const std::string name = row.name + index;
  for (const auto& one : channels_)
    if (one->name == name) return *one;
  const wire<1>* const unless = row.unless.empty() ? nullptr : wire_named(row.unless);
  channels_.push_back(std::make_unique<channel>(
      channel{name, std::make_unique<wire<1>>(("stall_" + plain(name)).c_str()), unless, 0}));
  return *channels_.back();
}

const wire<1>* channel_stalls::wire_named(const std::string& name) const {
  const std::string path = std::string(chip_.name()) + "." + name;
  const auto* found = dynamic_cast<const wire<1>*>(sc_core::sc_find_object(path.c_str()));
  if (!found) throw std::logic_error("no wire of one bit is called " + path);
  return found;
}

std::string channel_stalls::path_of(const sc_core::sc_object& port) const {
  return std::string(port.name()).substr(std::string(chip_.name()).size() + 1);
}

std::vector<std::string> channel_stalls::missing() const {
  std::vector<std::string> names;
  for (const stall_plan::channel& row : plan_.channels)
    for (const stall_plan::port& one : row.ports)
      if (std::find(found_.begin(), found_.end(), one.name) == found_.end())
        names.push_back(one.name);
  return names;
}

void channel_stalls::begin(std::uint64_t place) {
  for (const auto& one : channels_) {
    one->state = mixed(plan_.seed, one->name, place);
    one->stall->write(false);
  }
  begun_ = true;
}

void channel_stalls::reseed(std::uint64_t seed) {
  plan_.seed = seed;
  resting_ = false;
}

void channel_stalls::tick() {
  for (const auto& one : channels_) {
    const bool before = one->stall->read();
    const bool now = begun_ && !resting_ && happens(one->state, before ? plan_.go_on : plan_.begin);
    one->stall->write(now);
    stalled_ += now;
  }
}

}  // namespace racebeam
