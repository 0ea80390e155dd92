// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/beam_core_traffic.h"

#include <algorithm>
#include <stdexcept>

#include "tb/monitor/raster.h"

namespace racebeam {

namespace {

constexpr std::uint64_t BlockClocks = 4096;  // they stay in the second cache

std::uint64_t clocks_of(const knobs& k, int frames) {
  const Raster raster(k.clocks_per_pixel, k.speed);
  return 1 + static_cast<std::uint64_t>(frames) * static_cast<std::uint64_t>(raster.frame_clocks());
}

}  // namespace

BeamCoreTraffic::BeamCoreTraffic(TrafficHead head, const knobs& k, const scene_program* program,
                                 int first, int frames)
    : head_(std::move(head)),
      knobs_(k),
      program_(program),
      first_(first),
      frames_(frames),
      clocks_(clocks_of(k, frames)),
      core_(program) {
  for (const PortTraffic::Port& port : head_.ports)
    ports_.emplace_back(&wires_.at(port.name), raw_bits(~std::uint64_t{0}, port.bits));
  last_.resize(ports_.size());
}

void BeamCoreTraffic::rewind() {
  core_ = chip_core(program_);
  done_ = 0;
  sought_ = false;
}

std::vector<TrafficMark> BeamCoreTraffic::marks() const {
  const std::uint64_t frame_clocks = clocks_of(knobs_, 1) - 1;
  std::vector<TrafficMark> all;
  for (int n = 0; n < frames_; ++n)
    all.push_back({1 + static_cast<std::uint64_t>(n) * frame_clocks, first_ + n});
  return all;
}

std::size_t BeamCoreTraffic::port(const char* name) const {
  for (std::size_t n = 0; n < head_.ports.size(); ++n)
    if (head_.ports[n].name == name) return n;
  throw std::out_of_range(head_.unit + " has no port " + name);
}

void BeamCoreTraffic::clock(bool rst_n, std::uint64_t* row) {
  clock_wires(core_, rst_n, knobs_, wires_);
  for (const auto& [wire, bits] : ports_)
    *row++ = static_cast<std::uint64_t>(static_cast<std::int64_t>(*wire)) & bits;
}

// What rtl_instance::seek() and place() do to RTL, as private clocks.
void BeamCoreTraffic::seek(TrafficBlock& block) {
  const auto put = [&](std::vector<std::uint64_t>& row, const char* name, int value) {
    const std::size_t n = port(name);
    row[n] = static_cast<std::uint64_t>(static_cast<std::int64_t>(value)) & ports_[n].second;
  };
  const auto add = [&](const std::vector<std::uint64_t>& row) {
    block.values.insert(block.values.end(), row.begin(), row.end());
  };
  std::vector<std::uint64_t> row = last_;
  if (head_.unit == "sequencer" || head_.unit == "timeline") {
    put(row, "rst_ni", 0);
    add(row);
    put(row, "rst_ni", 1);
    put(row, "frame_end_i", 1);
    for (int frame = 0; frame < first_; ++frame) add(row);
  } else if (head_.unit == "navigator") {
    put(row, "rst_ni", 1);
    put(row, "nav_reset_i", 1);
    put(row, "start_x_i", core_.navigator.position_q[0]);
    put(row, "start_y_i", core_.navigator.position_q[1]);
    put(row, "start_z_i", core_.navigator.position_q[2]);
    put(row, "start_room_i", core_.navigator.room_q);
    add(row);
  }
}

bool BeamCoreTraffic::next(TrafficBlock& block) {
  block.first = done_;
  block.is_private = false;
  block.values.clear();
  if (done_ == 1 && !sought_ && first_ != 0) {  // in the first clock of a frame
    sought_ = true;
    core_.deposit(first_, knobs_);
    seek(block);
    block.is_private = true;
    if (!block.values.empty()) return true;
    block.is_private = false;
  }
  const std::uint64_t some = done_ == 0 ? 1 : std::min(BlockClocks, clocks_ - done_);
  block.values.resize(some * ports_.size());
  for (std::uint64_t n = 0; n < some; ++n)
    clock(done_ > 0, block.values.data() + n * ports_.size());
  done_ += some;
  if (done_ == 1) last_ = block.values;
  return some > 0;
}

}  // namespace racebeam
