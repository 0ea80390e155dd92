// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/picture_waits.h"

#include <fmt/format.h>

#include "sc/block/block_chip.h"
#include "sc/sphere/sphere_chip.h"
#include "sc/voxel/voxel_chip.h"

namespace racebeam {

namespace {

constexpr std::uint64_t Told = 1000;  // clocks: an answer of one unit to another takes less

/// From the frame store up to the tracer, which each engine has of its own.
class PictureWaits : public WaitWatch {
 public:
  explicit PictureWaits(const picture_chip& chip) : store_(chip) {}

  void clock() override {
    refused_.see(store_.take_valid.read() && !store_.take_ready.read());
    line_.see(!store_.line_end.read());
    full_.see(!store_.put_ready.read() && !store_.take_valid.read());
    look();
  }
  std::vector<Wait> chain() const override {
    if (line_ >= Lines)
      return {{"store_arbiter", "vga_timing.line_end_o = 1", line_.clocks},
              {"vga_timing", "", line_.clocks, "its lines do not go on"}};
    if (refused_ >= Told)
      return {{"write_buffer", "store_arbiter.take_ready_o = 1", refused_.clocks},
              {"store_arbiter", "", refused_.clocks,
               "it refuses the word on offer (take_valid_i = 1)"}};
    if (full_ >= Told)
      return {{"write_buffer", "", full_.clocks,
               "it takes nothing (put_ready_o = 0), and offers nothing (take_valid_o = 0)"}};
    return tracer();
  }

 protected:
  virtual void look() = 0;
  virtual std::vector<Wait> tracer() const = 0;

 private:
  static constexpr std::uint64_t Lines = 4000;  // clocks: two lines

  const picture_chip& store_;
  Held refused_, line_, full_;
};

class SphereWaits final : public PictureWaits {
 public:
  explicit SphereWaits(const sphere_chip& chip) : PictureWaits(chip), chip_(chip) {}

 private:
  void look() override {
    host_.see(chip_.done_o->read());
    root_.see(chip_.root_start.read() && !chip_.root_done.read());
    divider_.see(chip_.divider_start.read() && !chip_.divider_done.read());
  }
  std::vector<Wait> tracer() const override {
    std::vector<Wait> links = {{"write_buffer", "sphere_tracer.word_valid_o = 1"}};
    if (host_ >= Told) {
      links.push_back({"sphere_tracer", "sphere_host_link.loaded_o = 1", host_.clocks});
      links.push_back({"sphere_host_link", "", host_.clocks,
                       "the CPU has sent its words, or none, and loaded_o stays 0"});
    } else if (root_ >= Told) {
      links.push_back({"sphere_tracer", "root_unit.done_o = 1", root_.clocks});
      links.push_back({"root_unit", "", root_.clocks, "start_i is 1, and done_o stays 0"});
    } else if (divider_ >= Told) {
      links.push_back({"sphere_tracer", "divider_unit.done_o = 1", divider_.clocks});
      links.push_back({"divider_unit", "", divider_.clocks, "start_i is 1, and done_o stays 0"});
    } else {
      links.push_back({"sphere_tracer", "", 0,
                       fmt::format("it offers no word, in state {}",
                                   static_cast<int>(chip_.state.read().to_uint()))});
    }
    return links;
  }

  const sphere_chip& chip_;
  Held host_, root_, divider_;
};

class BlockWaits final : public PictureWaits {
 public:
  explicit BlockWaits(const block_chip& chip) : PictureWaits(chip), chip_(chip) {}

 private:
  void look() override {
    const bool busy = chip_.busy.read() != 0, ready = chip_.job_ready.read() != 0;
    unserved_.see(chip_.word_valid.read() != 0 && !chip_.bus_valid.read());
    converting_.see(chip_.valid_i->read() && !chip_.ready_o->read());
    undealt_.see(!busy && ready && chip_.job_valid.read() == 0 && !chip_.done_o->read());
    unready_.see(!busy && !ready && !chip_.done_o->read());
    busy_.see(busy);
  }
  std::vector<Wait> tracer() const override {
    std::vector<Wait> links = {{"write_buffer", "block_bus.bus_valid_o = 1"}};
    if (converting_ >= Told)
      return {{"the host", "block_convert.ready_o = 1", converting_.clocks},
              {"block_convert", "", converting_.clocks, "valid_i is 1, and ready_o stays 0"}};
    if (unserved_ >= Told) {
      links.push_back(
          {"block_bus", "", unserved_.clocks, "word_valid_i asks, and bus_valid_o is 0"});
      return links;
    }
    links.push_back({"block_bus", "block_core.word_valid_o = 1"});
    if (undealt_ >= Told) {
      links.push_back({"block_core", "block_scheduler.job_valid_o = 1", undealt_.clocks});
      links.push_back(
          {"block_scheduler", "", undealt_.clocks, "cores are ready, and none gets a job"});
    } else if (unready_ >= Told) {
      links.push_back(
          {"block_core", "", unready_.clocks, "it has no job (busy_o = 0), and takes none"});
    } else if (busy_ >= Told) {
      std::string states;
      for (const auto& place : chip_.g_core)
        states += fmt::format(" {}", static_cast<int>(place->state.read().to_uint()));
      links.push_back({"block_core", "", busy_.clocks,
                       "it has a job (busy_o = 1), and offers no word; states" + states});
    } else {
      links.push_back({"block_core", "block_scheduler.done_o = 0"});
      links.push_back({"block_scheduler", "", 0, "the picture does not begin, or does not end"});
    }
    return links;
  }

  const block_chip& chip_;
  Held unserved_, converting_, undealt_, unready_, busy_;
};

class VoxelWaits final : public PictureWaits {
 public:
  explicit VoxelWaits(const voxel_chip& chip) : PictureWaits(chip), chip_(chip) {}

 private:
  void look() override {
    const auto scan = static_cast<int>(chip_.scan_state.read().to_uint());
    const auto walker = static_cast<int>(chip_.walker_state.read().to_uint());
    building_.see(static_cast<int>(chip_.builder_state.read().to_uint()) != VoxelBuilderIdle);
    ray_.see((scan == VoxelScanRay || scan == VoxelScanShadow) && !chip_.ray_done.read());
    shade_.see(scan == VoxelScanShade && !chip_.shade_done.read());
    leaf_.see(walker == VoxelLeaf && !chip_.leaf_done.read());
    idle_.see(walker == VoxelIdle);
  }
  std::vector<Wait> tracer() const override {
    if (building_ >= Told)
      return {{"the host", "voxel_builder.done_o = 1", building_.clocks},
              {"voxel_builder", "", building_.clocks, "it builds, and does not end"}};
    std::vector<Wait> links = {{"write_buffer", "voxel_scan.put_valid_o = 1"}};
    if (ray_ >= Told && idle_ >= Told) {
      links.push_back({"voxel_scan", "", ray_.clocks,
                       "it is at a ray, and voxel_walker is idle: no colour was asked for"});
    } else if (shade_ >= Told) {
      links.push_back({"voxel_scan", "voxel_shade.done_o = 1", shade_.clocks});
      links.push_back({"voxel_shade", "", shade_.clocks, "done_o stays 0"});
    } else if (ray_ >= Told) {
      links.push_back({"voxel_scan", "voxel_walker.ray_done_o = 1", ray_.clocks});
      if (leaf_ >= Told) {
        links.push_back({"voxel_walker", "voxel_leaf.done_o = 1", leaf_.clocks});
        links.push_back({"voxel_leaf", "", leaf_.clocks, "done_o stays 0"});
      } else {
        links.push_back({"voxel_walker", "", ray_.clocks,
                         fmt::format("its ray does not end, in state {}",
                                     static_cast<int>(chip_.walker_state.read().to_uint()))});
      }
    } else {
      links.push_back({"voxel_scan", "", 0, "it begins no ray, and asks for no colour"});
    }
    return links;
  }

  const voxel_chip& chip_;
  Held building_, ray_, shade_, leaf_, idle_;
};

}  // namespace

std::unique_ptr<WaitWatch> make_sphere_waits(const wired_chip& chip, const knob_values&) {
  return std::make_unique<SphereWaits>(static_cast<const sphere_chip&>(chip));
}
std::unique_ptr<WaitWatch> make_block_waits(const wired_chip& chip, const knob_values&) {
  return std::make_unique<BlockWaits>(static_cast<const block_chip&>(chip));
}
std::unique_ptr<WaitWatch> make_voxel_waits(const wired_chip& chip, const knob_values&) {
  return std::make_unique<VoxelWaits>(static_cast<const voxel_chip&>(chip));
}

}  // namespace racebeam
