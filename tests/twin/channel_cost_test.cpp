// What is not asked for costs nothing: a chip without stalls and delays has no module, process or
// wire for them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "sc/base/wired_chip.h"
#include "sc/swap/channel_delays.h"
#include "sc/swap/channel_stalls.h"
#include "tb/scene/engines.h"
#include "tb/twin/channels.h"
#include "tb/twin/delays.h"

namespace racebeam {
namespace {

/// All objects in a chip, "sc_signal ack", by their place in it.
using Parts = std::set<std::string>;

void add(const sc_core::sc_object& of, std::size_t prefix, Parts& parts) {
  for (const sc_core::sc_object* child : of.get_child_objects()) {
    parts.insert(std::string(child->kind()) + " " + (child->name() + prefix));
    add(*child, prefix, parts);
  }
}

Parts parts_of(const engine& built, const char* name) {
  const auto chip = built.make_signal(name, built.standard(nullptr), nullptr, {});
  Parts parts;
  add(*chip, std::string(chip->name()).size() + 1, parts);
  return parts;
}

Parts beyond(const Parts& more, const Parts& less) {
  Parts rest;
  std::set_difference(more.begin(), more.end(), less.begin(), less.end(),
                      std::inserter(rest, rest.end()));
  return rest;
}

/// Modules, processes and wires.
std::map<std::string, int> counted(const Parts& parts) {
  std::map<std::string, int> counts;
  for (const std::string& part : parts) {
    const std::string kind = part.substr(0, part.find(' '));
    if (kind == "sc_module" || kind == "sc_method_process" || kind == "sc_signal") ++counts[kind];
  }
  return counts;
}

std::string text_of(const Parts& parts) {
  std::string text;
  for (const auto& [kind, count] : counted(parts)) text += " " + kind + " " + std::to_string(count);
  return text;
}

class OffCost : public testing::TestWithParam<const engine*> {};

TEST_P(OffCost, OfStallsAndDelaysIsNothing) {
  const engine& built = *GetParam();
  const Parts off = parts_of(built, "off");
  Parts stalled, delayed;
  {
    const planned_stalls planned(stall_plan_of(built, {"1", {}}));
    stalled = parts_of(built, "stalled");
  }
  {
    auto plan = std::make_shared<delay_plan>();
    for (const ChannelRow& row : channels_of(built))
      if (row.may_delay()) plan->channels.push_back(delayed_channel(built, row.name, 1));
    const planned_delays planned(plan);
    delayed = parts_of(built, "delayed");
  }
  std::cout << built.name << ": off" << text_of(off) << "; stalls add"
            << text_of(beyond(stalled, off)) << "; delays add" << text_of(beyond(delayed, off))
            << '\n';
  // All that is there without them is there with them, ...
  EXPECT_EQ(beyond(off, stalled), Parts());
  EXPECT_EQ(beyond(off, delayed), Parts());
  // ... what they add has names of their own, ...
  const auto is_own = [](const std::string& part) {
    const std::string name = part.substr(part.find(' ') + 1);
    for (const char* own : {"stall_", "held_", "late_", "answer_", "delay_channels", "delays_busy"})
      if (name.rfind(own, 0) == 0) return true;
    return false;
  };
  for (const Parts& more : {beyond(stalled, off), beyond(delayed, off)}) {
    EXPECT_GT(counted(more)["sc_method_process"], 1);
    EXPECT_GT(counted(more)["sc_signal"], 1);
    for (const std::string& part : more) EXPECT_TRUE(is_own(part)) << part;
  }
  // ... and none of it is in the chip without them, nor a module besides units and memories.
  for (const std::string& part : off) {
    EXPECT_FALSE(is_own(part)) << part;
    if (part.rfind("sc_module u_", 0) == 0 || part.rfind("sc_module g_core", 0) == 0) continue;
    EXPECT_NE(part.rfind("sc_module", 0), 0u) << part;
  }
}

// Nor has it a process that only looks whether they are asked for.
TEST_P(OffCost, AChipHasNoProcessOfItsOwnButTheLogicThatItsHeaderNames) {
  const std::map<std::string, Parts> own = {
      {"beam", {}},
      {"sphere", {"follow_raster"}},
      {"voxel", {"follow_raster"}},
      {"block", {"follow_raster", "part_jobs", "part_ready", "join", "choose_word"}}};
  Parts found;
  for (const std::string& part : parts_of(*GetParam(), "chip")) {
    const std::string kind = "sc_method_process ";
    if (part.rfind(kind, 0) == 0 && part.find('.') == std::string::npos)
      found.insert(part.substr(kind.size()));
  }
  EXPECT_EQ(found, own.at(GetParam()->name));
}

INSTANTIATE_TEST_SUITE_P(Engines, OffCost, testing::ValuesIn(engines()),
                         [](const auto& one) { return std::string(one.param->name); });

}  // namespace
}  // namespace racebeam
