// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/beam_core_traffic.h"

#include <algorithm>
#include <stdexcept>

#include "sc/beam/chip_deposit.h"
#include "sc/beam/units.h"
#include "tb/monitor/raster.h"

namespace racebeam {

namespace {

constexpr std::uint64_t BlockClocks = 4096;  // they stay in the second cache

std::uint64_t clocks_of(const knobs& k, int frames) {
  const Raster raster(k.clocks_per_pixel, k.speed);
  return 1 + static_cast<std::uint64_t>(frames) * static_cast<std::uint64_t>(raster.frame_clocks());
}

}  // namespace

BeamCorePass::BeamCorePass(std::vector<TrafficHead> heads, const knobs& k,
                           const scene_program* program, int first, int frames)
    : heads_(std::move(heads)),
      knobs_(k),
      program_(program),
      first_(first),
      frames_(frames),
      clocks_(clocks_of(k, frames)),
      core_(program),
      units_(heads_.size()) {
  for (std::size_t unit = 0; unit < heads_.size(); ++unit)
    for (const PortTraffic::Port& port : heads_[unit].ports)
      units_[unit].ports.emplace_back(&wires_.at(port.name),
                                      raw_bits(~std::uint64_t{0}, port.bits));
}

void BeamCorePass::rewind() {
  core_ = chip_core(program_);
  done_ = 0;
  sought_ = false;
}

std::vector<TrafficMark> BeamCorePass::marks() const {
  const std::uint64_t frame_clocks = clocks_of(knobs_, 1) - 1;
  std::vector<TrafficMark> all;
  for (int n = 0; n < frames_; ++n)
    all.push_back({1 + static_cast<std::uint64_t>(n) * frame_clocks, first_ + n});
  return all;
}

std::size_t BeamCorePass::port(std::size_t unit, const char* name) const {
  const TrafficHead& head = heads_[unit];
  for (std::size_t n = 0; n < head.ports.size(); ++n)
    if (head.ports[n].name == name) return n;
  throw std::out_of_range(head.unit + " has no port " + name);
}

// What rtl_instance::seek() and place() do to RTL, as private clocks; of the whole chip what
// chip::deposit_beside() does to its registers.
void BeamCorePass::seek(std::size_t unit, TrafficBlock& block) {
  const std::string& name = heads_[unit].unit;
  const auto put = [&](std::vector<std::uint64_t>& row, const char* port_name, int value) {
    const std::size_t n = port(unit, port_name);
    row[n] =
        static_cast<std::uint64_t>(static_cast<std::int64_t>(value)) & units_[unit].ports[n].second;
  };
  const auto add = [&](const std::vector<std::uint64_t>& row) {
    block.values.insert(block.values.end(), row.begin(), row.end());
  };
  std::vector<std::uint64_t> row = units_[unit].last;
  if (name == "sequencer" || name == "timeline") {
    put(row, "rst_ni", 0);
    add(row);
    put(row, "rst_ni", 1);
    put(row, "frame_end_i", 1);
    for (int frame = 0; frame < first_; ++frame) add(row);
  } else if (name == "navigator") {
    put(row, "rst_ni", 1);
    put(row, "nav_reset_i", 1);
    put(row, "start_x_i", core_.navigator.position_q[0]);
    put(row, "start_y_i", core_.navigator.position_q[1]);
    put(row, "start_z_i", core_.navigator.position_q[2]);
    put(row, "start_room_i", core_.navigator.room_q);
    add(row);
  } else if (name == WholeChip) {
    block.deposits = chip_deposits(first_, core_.navigator);
  }
}

bool BeamCorePass::next(std::vector<TrafficBlock>& blocks) {
  blocks.resize(units_.size());
  const bool seeks = done_ == 1 && !sought_ && first_ != 0;  // in the first clock of a frame
  const std::uint64_t some = done_ == 0 ? 1 : std::min(BlockClocks, clocks_ - done_);
  for (std::size_t unit = 0; unit < units_.size(); ++unit) {
    blocks[unit].first = done_;
    blocks[unit].is_private = seeks;
    blocks[unit].deposits.clear();
    blocks[unit].values.resize(seeks ? 0 : some * units_[unit].ports.size());  // not made 0 again
  }
  if (seeks) {
    sought_ = true;
    core_.deposit(first_, knobs_);
    for (std::size_t unit = 0; unit < units_.size(); ++unit) seek(unit, blocks[unit]);
    return true;
  }
  for (std::uint64_t n = 0; n < some; ++n) {
    clock_wires(core_, done_ + n > 0, knobs_, wires_);
    for (std::size_t unit = 0; unit < units_.size(); ++unit) {
      const auto& ports = units_[unit].ports;
      std::uint64_t* row = blocks[unit].values.data() + n * ports.size();
      for (const auto& [wire, bits] : ports)
        *row++ = static_cast<std::uint64_t>(static_cast<std::int64_t>(*wire)) & bits;
    }
  }
  done_ += some;
  if (done_ == 1)
    for (std::size_t unit = 0; unit < units_.size(); ++unit)
      units_[unit].last = blocks[unit].values;
  return some > 0;
}

bool BeamCoreTraffic::next(TrafficBlock& block) {
  const bool more = pass_.next(blocks_);
  if (more) std::swap(block, blocks_.front());
  return more;
}

}  // namespace racebeam
