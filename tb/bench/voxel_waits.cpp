// Who waits for whom in the voxel tracer's chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "sc/voxel/codes.h"
#include "sc/voxel/engine.h"
#include "sc/voxel/voxel_chip.h"
#include "tb/bench/picture_waits.h"
#include "tb/twin/engine_raster.h"

namespace racebeam {

namespace {

class VoxelWaits final : public PictureWaits {
 public:
  VoxelWaits(const voxel_chip& chip, const knob_values& k, const LastRises& heard)
      : PictureWaits(chip, k,
                     static_cast<std::uint64_t>(raster_of(voxel_engine(), k).line_clocks())),
        chip_(chip),
        heard_(heard) {}

 private:
  void look() override {
    const auto scan = static_cast<int>(chip_.scan_state.read().to_uint());
    const auto walker = static_cast<int>(chip_.walker_state.read().to_uint());
    building_.see(!chip_.built_o->read());
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
    if (shade_ >= Told) {
      links.push_back({"voxel_scan", "voxel_shade.done_o = 1", shade_.clocks});
      links.push_back({"voxel_shade", "", shade_.clocks, "done_o stays 0"});
    } else if (ray_ >= Told && idle_ >= Told && !begun()) {
      links.push_back({"voxel_scan", "", ray_.clocks,
                       "it is at a ray, and voxel_walker is idle: no colour was asked for"});
    } else if (ray_ >= Told) {
      links.push_back({"voxel_scan", "voxel_walker.ray_done_o = 1", ray_.clocks});
      add_walker(links);
    } else {
      links.push_back({"voxel_scan", "", 0,
                       repeats() ? "it offers the same word for ever"
                                 : "it begins no ray, and asks for no colour"});
    }
    return links;
  }

  void add_walker(std::vector<Wait>& links) const {
    const auto state = static_cast<int>(chip_.walker_state.read().to_uint());
    if (leaf_ >= Told && heard_.of("leaf_done") <= heard_.of("leaf")) {
      links.push_back({"voxel_walker", "voxel_leaf.done_o = 1", leaf_.clocks});
      links.push_back({"voxel_leaf", "", leaf_.clocks, "done_o stays 0"});
    } else {
      links.push_back({"voxel_walker", "", ray_.clocks,
                       idle_ >= Told ? "it is idle, though a ray was begun (start_i = 1)"
                                     : fmt::format("its ray does not end, in state {}", state)});
    }
  }

  /// After the last ray that was done, or with it, another one was begun.
  bool begun() const { return heard_.of("start") >= heard_.of("ray_done"); }

  const voxel_chip& chip_;
  const LastRises& heard_;
  Held building_, ray_, shade_, leaf_, idle_;
};

}  // namespace

std::unique_ptr<WaitWatch> make_voxel_waits(const wired_chip& chip, const knob_values& k,
                                            const LastRises& heard) {
  return std::make_unique<VoxelWaits>(static_cast<const voxel_chip&>(chip), k, heard);
}

}  // namespace racebeam
