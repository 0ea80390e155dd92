// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/channels.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "sc/beam/engine.h"
#include "sc/block/engine.h"
#include "sc/sphere/engine.h"
#include "sc/voxel/engine.h"
#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/scene/engines.h"

namespace racebeam {

namespace {

constexpr double UsualBegin = 0.05, UsualGoOn = 0.75;
constexpr const char* Form = "--shake takes SEED[,BEGIN,GO_ON], such as 7 or 7,0.05,0.75";

constexpr const char* OneAtATime = "a start and a done that stay 1 until seen, and no offer";
constexpr const char* WordLater = "words reach the write buffer later";

/// Of the words that `ready`, ports of whoever offers them, puts into the write buffer.
delay_plan::place words_into_buffer(std::vector<std::string> ready) {
  return {"u_write_buffer.put_valid_i",
          {"u_write_buffer.put_address_i", "u_write_buffer.put_data_i"},
          {},
          std::move(ready)};
}

std::vector<ChannelRow> beam() {
  return {
      {"interval",
       "subdivider",
       "interval_fifo",
       "emit, ack",
       "subdivider holds its offer in RETURN until it is acknowledged",
       {{"u_interval_fifo.emit_i", false}, {"u_subdivider.ack_i", false}},
       "",
       {"u_interval_fifo.emit_i",
        {"u_interval_fifo.len_m1_i", "u_interval_fifo.value_i", "u_interval_fifo.half_i"},
        {"u_subdivider.ack_i"},
        {},
        "tracer_reset"},
       "intervals reach the FIFO later; what is on the way at the end of a line is forgotten"},
      {"decision",
       "decision_datapath",
       "subdivider",
       "second, climb",
       "subdivider waits while second is 1, decision_datapath holds when nothing is asked; not "
       "within a climb of two clocks, which must go on",
       {{"u_subdivider.second_i", true}, {"u_decision_datapath.climb_i", false}},
       "second",
       {},
       "subdivider moves in the clock in which it is answered"},
      {"camera",
       "subdivider",
       "camera_unit",
       "step",
       "camera_unit waits in SCALE, and at the end of each factor, while step is 1",
       {{"u_camera_unit.step_i", true}},
       "",
       {},
       "camera_unit waits for the end of the steps: later it would take half a product"},
      {"line",
       "vga_timing",
       "camera_unit",
       "line_end",
       "no answer: the beam does not wait",
       {},
       "",
       {"u_camera_unit.line_end_i"},
       "the line is begun later, by camera and tracer"},
      {"beam", "interval_fifo", "pixel_output", "consume, display",
       "no answer: the beam does not wait"},
      {"push", "subdivider", "stacks", "push_en, i2, sp", "no answer: written in this clock"},
      {"face", "decision_datapath", "stacks", "fwrite, fdata", "no answer: written in this clock"},
      {"restart", "subdivider", "decision_datapath", "restart",
       "no answer: both begin anew in this clock"},
      {"hurry", "interval_fifo", "subdivider", "starving", "a level, and no handshake"},
  };
}

std::vector<ChannelRow> sphere() {
  return {
      {"root",
       "root_unit",
       "sphere_tracer",
       "root_start, root_done",
       "start stays 1 until done was seen, and the root stays with it",
       {{"u_sphere_tracer.root_done_i", false}},
       "",
       {},
       OneAtATime},
      {"divider",
       "divider_unit",
       "sphere_tracer",
       "divider_start, divider_done",
       "start stays 1 until done was seen, and the quotients stay with it",
       {{"u_sphere_tracer.divider_done_i", false}},
       "",
       {},
       OneAtATime},
      {"word",
       "sphere_tracer",
       "write_buffer",
       "word_valid, put_ready",
       "sphere_tracer holds its word, and its state, until put_ready",
       {{"u_write_buffer.put_valid_i", false}, {"u_sphere_tracer.word_ready_i", false}},
       "",
       words_into_buffer({"u_sphere_tracer.word_ready_i"}),
       WordLater},
      {"host", "the CPU", "sphere_host_link", "valid",
       "no answer: the CPU sends at its own pace, the knob host_clocks_per_word"},
      {"loaded", "sphere_host_link", "sphere_tracer", "loaded", "no answer: 1 for a single clock"},
  };
}

std::vector<ChannelRow> block() {
  return {
      {"job",
       "block_scheduler",
       "block_core",
       "job_valid, job_ready",
       "block_scheduler offers a block to cores that are ready only",
       {{"g_core[*].u_block_core.job_ready_o", false}},
       "",
       {},
       "the offer goes to the core that says ready in the same clock"},
      {"core_word",
       "block_core",
       "block_bus",
       "word_valid, word_ready",
       "block_core holds its word until word_ready",
       {{"g_core[*].u_block_core.word_valid_o", false},
        {"g_core[*].u_block_core.word_ready_i", false}},
       "",
       {},
       "block_bus chooses among the offers of this clock; registers behind it are those of word"},
      {"word",
       "block_bus",
       "write_buffer",
       "bus_valid, put_ready",
       "block_bus serves nobody while put_ready is 0",
       {{"u_write_buffer.put_valid_i", false}, {"u_block_bus.bus_ready_i", false}},
       "",
       words_into_buffer({"u_block_bus.bus_ready_i"}),
       WordLater},
      {"host", "the host", "block_convert", "valid, ready",
       "the host counts its clocks, and starts the picture by them"},
      {"table", "block_convert", "block_core", "write, field, index, fixed",
       "no answer: written in this clock"},
  };
}

std::vector<ChannelRow> voxel() {
  return {
      {"colour",
       "voxel_shade",
       "voxel_scan",
       "shade_done, put_ready",
       "voxel_shade holds its colour until put_ready",
       {{"u_voxel_scan.done_i", false}, {"u_voxel_shade.put_ready_i", false}},
       "",
       {},
       "a done that stays 1 until its word is put, and no offer"},
      {"word",
       "voxel_scan",
       "write_buffer",
       "put_valid, put_ready",
       "voxel_scan holds its word until put_ready",
       {{"u_write_buffer.put_valid_i", false},
        {"u_voxel_scan.put_ready_i", false},
        {"u_voxel_shade.put_ready_i", false}},
       "",
       words_into_buffer({"u_voxel_scan.put_ready_i", "u_voxel_shade.put_ready_i"}),
       WordLater},
      {"ray", "voxel_walker", "voxel_scan", "start, ray_done", "no answer: 1 for a single clock"},
      {"leaf", "voxel_leaf", "voxel_walker", "leaf, leaf_done", "no answer: 1 for a single clock"},
      {"setup", "voxel_setup", "voxel_walker", "setup, inverse",
       "no answer: voxel_walker counts the clocks"},
      {"memory", "column_memory", "voxel_shade", "column_read, column_word",
       "no answer: the word comes after memory_clocks"},
      {"host", "the host", "voxel_builder", "build, built", "no answer: 1 for a single clock"},
  };
}

std::vector<ChannelRow> store() {
  return {
      {"take",
       "write_buffer",
       "store_arbiter",
       "take_valid, take_ready",
       "write_buffer holds its word until take_ready",
       {{"u_store_arbiter.take_valid_i", false}, {"u_write_buffer.take_ready_i", false}},
       "",
       {"u_store_arbiter.take_valid_i",
        {"u_store_arbiter.take_address_i", "u_store_arbiter.take_data_i"},
        {},
        {"u_write_buffer.take_ready_i"}},
       "words reach the frame store later"},
      {"scanout", "frame_memory", "frame_scanout", "read, mem_read_data",
       "no answer: the beam does not wait"},
  };
}

std::vector<double> numbers_of(const std::string& shake) {
  std::istringstream parts(shake);
  std::vector<double> numbers;
  for (std::string part; std::getline(parts, part, ',');) {
    double value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc() || end != part.data() + part.size())
      throw UsageError(fmt::format("--shake '{}': '{}' is not a number; {}", shake, part, Form));
    numbers.push_back(value);
  }
  if ((numbers.size() != 1 && numbers.size() != 3) || shake.back() == ',')
    throw UsageError(fmt::format("--shake '{}' has {} numbers; {}", shake, numbers.size(), Form));
  return numbers;
}

std::uint64_t seed_of(const std::string& shake) {
  constexpr std::uint64_t LargestSeed = 0xffffffff;
  const std::string text = shake.substr(0, shake.find(','));
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error == std::errc::invalid_argument || end != text.data() + text.size())
    throw UsageError(fmt::format("--shake '{}': the seed '{}' is not a whole number 0..{}; {}",
                                 shake, text, LargestSeed, Form));
  if (error != std::errc() || seed > LargestSeed)
    throw UsageError(fmt::format("--shake: the seed {} is out of range; 0..{}", text, LargestSeed));
  return seed;
}

double share(const char* name, double value, double largest) {
  if (!(value >= 0 && value <= largest))
    throw UsageError(fmt::format("--shake: {} {} is out of range; 0..{}", name, value, largest));
  return value;
}

const ChannelRow& row_named(const engine& built, const std::vector<ChannelRow>& rows,
                            const std::string& name) {
  std::vector<std::string> may;
  for (const ChannelRow& row : rows)
    if (row.may_stall()) may.push_back(row.name);
  for (const ChannelRow& row : rows) {
    if (row.name != name) continue;
    if (row.may_stall()) return row;
    throw UsageError(fmt::format("channel {} of {} may not stall: {}; these may: {}", name,
                                 built.name, row.why, fmt::join(may, ", ")));
  }
  throw unknown_name("channel", name, may);
}

}  // namespace

std::vector<ChannelRow> channels_of(const engine& built) {
  if (&built == &beam_engine()) return beam();
  std::vector<ChannelRow> rows = &built == &sphere_engine()  ? sphere()
                                 : &built == &block_engine() ? block()
                                                             : voxel();
  for (ChannelRow& row : store()) rows.push_back(std::move(row));
  return rows;
}

const char* timed_wire(const engine& built) { return &built == &beam_engine() ? "lock" : nullptr; }

std::shared_ptr<const stall_plan> stall_plan_of(const engine& built, const ShakeOptions& options) {
  const std::string& shake = options.shake;
  if (shake.empty()) {
    if (!options.stalls.empty())
      throw UsageError("--stall names a channel that --shake SEED stalls; add --shake");
    return nullptr;
  }
  constexpr double LongestBurst = 0.99;  // a hundred clocks in the mean
  stall_plan plan;
  plan.seed = seed_of(shake);
  const std::vector<double> numbers = numbers_of(shake);
  plan.begin = numbers.size() == 1 ? UsualBegin : share("BEGIN", numbers[1], 1);
  plan.go_on = numbers.size() == 1 ? UsualGoOn : share("GO_ON", numbers[2], LongestBurst);
  const std::vector<ChannelRow> rows = channels_of(built);
  std::vector<std::string> names = options.stalls;
  if (names.empty())
    for (const ChannelRow& row : rows)
      if (row.may_stall()) names.push_back(row.name);
  for (const std::string& name : names) {
    const ChannelRow& row = row_named(built, rows, name);
    plan.channels.push_back({row.name, row.ports, row.unless});
  }
  return std::make_shared<stall_plan>(plan);
}

void leave_out_whole_chip(const engine& built, const ShakeOptions& options,
                          const std::vector<std::string>& words, unit_choices& choices) {
  if (options.shake.empty() || !*built.top) return;
  for (const std::string& word : words)
    if (word.rfind(built.top, 0) == 0)
      throw UsageError(fmt::format(
          "{} has wires of its own, in which --shake cannot stall; leave out --shake, or it",
          built.top));
  choices.by_unit.erase(built.top);
}

std::string ShakeOptions::text() const {
  std::string text = shake.empty() ? "" : " --shake " + shake;
  for (const std::string& channel : stalls) text += " --stall " + channel;
  return text;
}

std::vector<std::string> channel_names() {
  std::vector<std::string> names;
  for (const engine* one : engines())
    for (const ChannelRow& row : channels_of(*one))
      if (row.may_stall() && std::find(names.begin(), names.end(), row.name) == names.end())
        names.emplace_back(row.name);
  return names;
}

}  // namespace racebeam
