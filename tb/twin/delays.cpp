// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/delays.h"

#include <fmt/format.h>

#include <algorithm>

#include "sc/base/channel_delay.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/scene/input_file.h"
#include "tb/scene/table_reader.h"

namespace racebeam {

namespace {

constexpr int LongestLatency = channel_delay_core::LongestLatency;
constexpr int MostEntries = 256;

const std::vector<FileKey>& delay_keys() {
  static const std::vector<FileKey> keys = {
      {"", "engine", "name", "required", "whose channels they are"},
      {"", "channel", "tables", "none", "a channel; repeatable"},
      {"channel", "name", "name", "required", "of the channel"},
      {"channel", "from", "name", "required", "the unit that offers"},
      {"channel", "to", "name", "required", "the unit that takes"},
      {"channel", "latency", "0..63", "required", "clocks; 0: no registers"},
      {"channel", "capacity", "1..256", "required", "entries; at least one a clock of latency"},
  };
  return keys;
}

std::vector<std::string> names_of(const std::vector<ChannelRow>& rows) {
  std::vector<std::string> names;
  for (const ChannelRow& row : rows)
    if (row.may_delay()) names.emplace_back(row.name);
  return names;
}

const ChannelRow* row_named(const std::vector<ChannelRow>& rows, const std::string& name) {
  const auto at = std::find_if(rows.begin(), rows.end(),
                               [&](const ChannelRow& row) { return row.name == name; });
  return at == rows.end() ? nullptr : &*at;
}

/// Why there may be no registers in a channel; empty: there may.
std::string objection(const engine& built, const std::vector<ChannelRow>& rows,
                      const std::string& name) {
  const ChannelRow* const row = row_named(rows, name);
  if (!row) return unknown_name("channel", name, names_of(rows)).what();
  if (row->may_delay()) return "";
  return fmt::format("channel {} of {} may not be delayed: {}; these may: {}", name, built.name,
                     row->why_delay(), fmt::join(names_of(rows), ", "));
}

class DelayReader {
 public:
  DelayReader(const engine& built, Faults& faults)
      : built_(built), rows_(channels_of(built)), faults_(faults) {}

  void read(const TomlNode& root, delay_plan& plan) {
    const TableReader top(root, "", faults_, delay_keys());
    if (top.require("engine",
                    fmt::format("as the template has it: engine = \"{}\"", built_.name))) {
      std::string engine;
      if (top.read("engine", engine) && engine != built_.name)
        faults_.add(top.find("engine")->place,
                    fmt::format("these are channels of {}, and the chip is {}", quoted(engine),
                                built_.name),
                    fmt::format("racebeam delays new --engine {}", built_.name));
    }
    const TomlNode* const list = top.find("channel");
    if (!list) return;
    if (list->kind != TomlNode::Array)
      return wrong_type(*list, "channel", "written below a line [[channel]]", faults_);
    for (const TomlNode& node : list->items) read_channel(node, plan);
  }

 private:
  void read_channel(const TomlNode& node, delay_plan& plan) {
    const TableReader table(node, "channel", faults_, delay_keys());
    std::string name;
    int latency = 0, capacity = 0;
    table.require("name", fmt::format("one of {}", fmt::join(names_of(rows_), ", ")));
    table.require("latency", "clocks; 0: no registers");
    table.require("capacity", "entries, at least one for each clock of latency");
    const bool read = table.read("latency", 0, LongestLatency, latency) &
                      table.read("capacity", 1, MostEntries, capacity);
    if (!table.read("name", name)) return;
    const Place place = table.find("name")->place;
    const std::string why = objection(built_, rows_, name);
    if (!why.empty()) return faults_.add(place, why, "racebeam delays new lists them");
    const ChannelRow& row = *row_named(rows_, name);
    check_end(table, "from", row.from, name);
    check_end(table, "to", row.to, name);
    if (std::find(seen_.begin(), seen_.end(), name) != seen_.end())
      faults_.add(place, fmt::format("channel {} is there twice", name), "leave out one of them");
    seen_.push_back(name);
    if (!read) return;
    if (latency > capacity)
      return faults_.add(
          table.find("latency")->place,
          fmt::format("latency {} of channel {} is beyond what its registers hold: capacity {}",
                      latency, name, capacity),
          fmt::format("capacity = {} holds one a clock, {} lets an offer in every clock through",
                      latency, latency + 1));
    if (latency > 0) plan.channels.push_back({row.name, row.delay, latency, capacity});
  }

  void check_end(const TableReader& table, const char* key, const std::string& unit,
                 const std::string& channel) {
    table.require(key, fmt::format("as the template has it: {} = \"{}\"", key, unit));
    std::string told;
    if (table.read(key, told) && told != unit)
      faults_.add(table.find(key)->place,
                  fmt::format("channel {} is {} {}, not {}", channel, key, unit, quoted(told)),
                  fmt::format("{} = \"{}\"", key, unit));
  }

  const engine& built_;
  const std::vector<ChannelRow> rows_;
  Faults& faults_;
  std::vector<std::string> seen_;
};

}  // namespace

std::string delays_template(const engine& built) {
  std::string text = fmt::format(
      "# Registers in the channels of {0}: `render`, `trace` and `verify` take this file with "
      "--delays.\n"
      "# latency   clocks from the offer of `from` to that which `to` sees; 0: no registers\n"
      "# capacity  entries: so many offers are on the way or wait; at least one for each clock of\n"
      "#           latency, and one more to let an offer in every clock through\n"
      "# In RTL: rtl/base/channel_delay.sv with these parameters.\n"
      "engine = \"{0}\"\n",
      built.name);
  std::string not_these;
  for (const ChannelRow& row : channels_of(built))
    if (row.may_delay())
      text += fmt::format(
          "\n# {}: {}\n[[channel]]\nname = \"{}\"\nfrom = \"{}\"\nto = \"{}\"\nlatency = 0\n"
          "capacity = 2\n",
          row.signals, row.why_delay(), row.name, row.from, row.to);
    else
      not_these +=
          fmt::format("#   {:<10} {} -> {}: {}\n", row.name, row.from, row.to, row.why_delay());
  return text + "\n# These may not be delayed:\n" + not_these;
}

std::shared_ptr<const delay_plan> delay_plan_of(const engine& built, const DelayOptions& options) {
  if (options.delays.empty()) return nullptr;
  Faults faults;
  delay_plan plan;
  const auto text = read_input_file(options.delays, "file of delays", faults);
  if (const auto root = text ? parse_toml(*text, faults) : std::nullopt)
    DelayReader(built, faults).read(*root, plan);
  if (!faults.none())
    throw UsageError(counted(faults.count(), "fault") + " in " + options.delays + "\n" +
                     faults.text(options.delays));
  if (plan.channels.empty()) return nullptr;
  return std::make_shared<delay_plan>(plan);
}

delay_plan::channel delayed_channel(const engine& built, const std::string& name, int latency) {
  const std::vector<ChannelRow> rows = channels_of(built);
  const std::string why = objection(built, rows, name);
  if (!why.empty()) throw UsageError(why);
  return {name, row_named(rows, name)->delay, latency, latency + 1};
}

void check_delays(const engine& built, const DelayOptions& options, const ShakeOptions& shake,
                  const std::vector<std::string>& words, unit_choices& choices) {
  if (options.delays.empty()) return;
  if (!shake.shake.empty())
    throw UsageError("--delays and --shake both move the chip's time; leave out one of them");
  if (!*built.top) return;
  bool users = false;
  for (const std::string& word : words) {
    const bool top = word.rfind(built.top, 0) == 0;
    users |= top && word.size() > std::string(built.top).size();
    if (top && !users)
      throw UsageError(fmt::format(
          "{0} has wires of its own, into which --delays cannot put registers; leave out "
          "--delays, or name a file that has them: {0}=FILE.sv",
          built.top));
  }
  if (!users) choices.by_unit.erase(built.top);
}

}  // namespace racebeam
