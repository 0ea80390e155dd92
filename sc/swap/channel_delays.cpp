// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/channel_delays.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace racebeam {

namespace {

/// What chips that are made now get; a chip's constructor is given knobs and units only.
std::shared_ptr<const delay_plan> planned;

std::map<const sc_core::sc_module*, channel_delays*>& by_chip() {
  static std::map<const sc_core::sc_module*, channel_delays*> all;
  return all;
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

planned_delays::planned_delays(std::shared_ptr<const delay_plan> plan) {
  planned = std::move(plan);
}
planned_delays::~planned_delays() { planned.reset(); }

std::unique_ptr<channel_delays> channel_delays::make(const sc_core::sc_module& chip,
                                                     in_port<1>& clk) {
  if (!planned) return nullptr;
  return std::unique_ptr<channel_delays>(new channel_delays(chip, *planned, clk));
}

channel_delays* channel_delays::of(const sc_core::sc_module& chip) {
  const auto found = by_chip().find(&chip);
  return found == by_chip().end() ? nullptr : found->second;
}

channel_delays::~channel_delays() { by_chip().erase(&chip_); }

channel_delays::channel_delays(const sc_core::sc_module& chip, const delay_plan& plan,
                               in_port<1>& clk)
    : chip_(chip), plan_(plan) {
  by_chip()[&chip] = this;
  const std::string prefix = std::string(chip.name()) + ".";
  const auto find = [&](const std::string& name) {
    return sc_core::sc_find_object((prefix + name).c_str());
  };
  reset_ = dynamic_cast<const in_port<1>*>(find("rst_ni"));
  for (const delay_plan::channel& row : plan_.channels) {
    delays_.push_back(
        std::make_unique<delay>(delay{&row, channel_delay_core{row.latency, row.capacity}}));
    if (row.at.clear == "rst_ni") continue;
    delays_.back()->clear = dynamic_cast<const wire<1>*>(find(row.at.clear));
    if (!delays_.back()->clear)
      throw std::logic_error("no wire of one bit is called " + prefix + row.at.clear);
  }
  sc_core::sc_spawn_options process;
  process.spawn_method();
  process.dont_initialize();
  process.set_sensitivity(&clk.pos());
  sc_core::sc_spawn([this] { tick(); }, "delay_channels", &process);
}

channel_delays::found_port channel_delays::find(const sc_core::sc_object& port) {
  const std::string path = path_of(port);
  for (const auto& one : delays_) {
    const delay_plan::place& at = one->row->at;
    const bool valid = at.valid == path, data = holds(at.data, path), ack = holds(at.ack, path);
    if (!valid && !data && !ack && !holds(at.ready, path)) continue;
    found_.push_back(path);
    return {one.get(), valid ? Valid : data ? Data : ack ? Ack : Ready};
  }
  return {nullptr, Data};
}

void channel_delays::join(delay& of, port_role role, const wire<1>& from, wire<1>& to) {
  if (role == Valid) {
    of.offered = &from;
    of.offer = &to;
    sc_core::sc_spawn_options process;
    process.spawn_method();
    process.set_sensitivity(&from.value_changed_event());
    sc_core::sc_spawn([&of] { of.answer(); }, ("answer_" + of.row->name).c_str(), &process);
    return;
  }
  of.taken = &from;
  (role == Ack ? of.acks : of.readies).push_back(&to);
}

void channel_delays::delay::answer() {
  const bool ready = core.ready();
  for (wire<1>* to : readies) to->write(ready);
  for (wire<1>* to : acks) to->write(ready && offered->read());
}

void channel_delays::delay::drive() {
  offer->write(core.offers());
  for (datum& one : data) one.write(one.entries[static_cast<std::size_t>(core.read_q)]);
  answer();
}

// At the edge wires are still those of the clock that ends; what is written comes after it.
void channel_delays::tick() {
  for (const auto& one : delays_) {
    const auto moves = one->core.comb(one->offered->read(), !one->taken || one->taken->read());
    const bool clear = cleared(*one);
    if (moves.put && !clear)
      for (datum& datum : one->data)
        datum.entries[static_cast<std::size_t>(one->core.write_q)] = datum.read();
    one->core.clock(clear, moves);
    one->drive();
  }
  busy_.write(std::any_of(delays_.begin(), delays_.end(),
                          [](const auto& one) { return one->core.count_q > 0; }));
}

bool channel_delays::cleared(const delay& one) const {
  return one.clear ? one.clear->read() : !reset_->value();
}

std::string channel_delays::path_of(const sc_core::sc_object& port) const {
  return std::string(port.name()).substr(std::string(chip_.name()).size() + 1);
}

std::string channel_delays::late_name(const sc_core::sc_object& port) const {
  std::string name = "late_" + path_of(port);
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

std::vector<std::string> channel_delays::missing() const {
  std::vector<std::string> names;
  const auto look = [&](const std::string& name) {
    if (!holds(found_, name)) names.push_back(name);
  };
  for (const delay_plan::channel& row : plan_.channels) {
    look(row.at.valid);
    for (const auto* list : {&row.at.data, &row.at.ack, &row.at.ready})
      for (const std::string& name : *list) look(name);
  }
  return names;
}

}  // namespace racebeam
