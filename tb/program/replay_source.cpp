// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/replay_source.h"

#include <fmt/format.h>

#include <filesystem>
#include <numeric>
#include <sstream>

#include "sc/beam/engine.h"
#include "sc/swap/rtl_library.h"
#include "sc/swap/rtl_remarks.h"
#include "tb/base/content_hash.h"
#include "tb/base/forked.h"
#include "tb/base/whole_file.h"
#include "tb/bench/beam_core_traffic.h"
#include "tb/bench/chip_traffic.h"
#include "tb/program/run_traffic.h"
#include "tb/sweep/model_hash.h"
#include "tb/twin/traffic_head.h"
#include "tb/twin/traffic_tap.h"
#include "tb/twin/use_option.h"

namespace racebeam {

namespace {

/// A setting; of a table, whose file lies in a cache, what is in it.
std::string without_place(const std::string& setting) {
  const std::size_t begin = setting.find('"'), end = setting.rfind('"');
  if (begin == end || !std::filesystem::is_regular_file(setting.substr(begin + 1, end - begin - 1)))
    return setting;
  return setting.substr(0, begin) + whole_file(setting.substr(begin + 1, end - begin - 1));
}

/// Of its sources, if they are all there, and what it was built with; else of the plug-in.
std::string rtl_hash(const std::string& plugin) {
  if (plugin == ModelPlayer) return plugin;
  const rtl_library library(plugin);
  std::string text;
  std::istringstream settings(library.model().parameters);
  for (std::string setting; settings >> setting;) text += without_place(setting) + " ";
  for (const std::string& remark : remarks_of(library.model(), "file")) {
    const std::string file = remark.substr(0, remark.rfind(':'));
    if (!std::filesystem::is_regular_file(file)) return content_hash(whole_file(plugin));
    text += whole_file(file);
  }
  return content_hash(text);
}

/// Of the whole chip: those of its own RTL but the clock, which are the chip's pins.
TrafficHead top_head(const Replay& what) {
  unit_choices own;
  UseOption(what.run.show.engine(), what.run.k, what.run.show.tables())
      .lockstep(own, what.dut.unit);
  const rtl_library library(own.of(what.dut.unit).plugin);
  std::vector<PortTraffic::Port> ports;
  for (int n = 0; n < library.model().port_count; ++n)
    if (const rtl_port& port = library.model().ports[n]; port.name != std::string("clk_i"))
      ports.push_back({port.name, port.bits, port.is_input != 0});
  return traffic_head(what.run, what.dut.unit, "chip", ports);
}

}  // namespace

// Ports are known of modules only, and SystemC elaborates once.
TrafficHead replay_head(const Replay& what) {
  if (what.dut.unit == what.run.show.engine().top) return top_head(what);
  return head_of(forked([&] {
    const Show& show = what.run.show;
    const auto model = show.engine().unit(what.dut.unit)->make("model", what.run.k, show.tables());
    return head_text(traffic_head(what.run, what.dut.unit, "chip", traffic_ports(*model)));
  }));
}

std::string replay_key(const Replay& what, const TrafficHead& head) {
  std::string key = fmt::format("unit {}\nengine {}\nscene {} {}\nknobs", head.unit, head.engine,
                                head.scene, head.scene_hash);
  for (const auto& [name, value] : head.knobs) key += fmt::format(" {}={}", name, value);
  return key + fmt::format("\nmodel {} {}\nRTL {}\n", head.program, model_hash(head.engine),
                           what.gates.empty() ? rtl_hash(what.dut.plugin)
                                              : content_hash(whole_file(what.gates)));
}

std::unique_ptr<TrafficSource> part_source(const Replay& what, const TrafficHead& head,
                                           const ReplayPart& part, const std::string& folder,
                                           std::string& file) {
  const Show& show = what.run.show;
  if (&show.engine() == &beam_engine())
    return std::make_unique<BeamCoreTraffic>(head, what.run.k, show.program(), part.first,
                                             part.frames);
  file = folder + "/" + std::filesystem::path(part.file()).stem().string() + ".traffic";
  forked([&] {
    std::unique_ptr<TrafficWriter> writer;
    std::vector<int> frames(static_cast<std::size_t>(part.frames));
    std::iota(frames.begin(), frames.end(), part.first);
    record_chip_traffic(
        {show.engine(), what.run.k, show.tables(), show.frames()}, what.dut.unit, frames,
        [&](const auto&) -> TrafficSink& {
          return *(writer = std::make_unique<TrafficWriter>(file, head));
        },
        [](int, std::uint64_t) {});
    writer->commit();
    return std::string();
  });
  return std::make_unique<TrafficFile>(file);
}

}  // namespace racebeam
