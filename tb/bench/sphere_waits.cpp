// Who waits for whom in the sphere tracer's chip.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "sc/sphere/codes.h"
#include "sc/sphere/engine.h"
#include "sc/sphere/sphere_chip.h"
#include "tb/bench/picture_waits.h"
#include "tb/twin/engine_raster.h"

namespace racebeam {

namespace {

/// A walk through a table that is to end with its last entry.
struct Walk {
  int entries = 0;    ///< looked at
  bool last = false;  ///< one of them was the last
  void see(bool begins, bool looks, bool is_last) {
    if (begins) *this = {};
    entries += looks;
    last |= looks && is_last;
  }
};

class SphereWaits final : public PictureWaits {
 public:
  SphereWaits(const sphere_chip& chip, const knob_values& k, const LastRises& heard)
      : PictureWaits(chip, k,
                     static_cast<std::uint64_t>(raster_of(sphere_engine(), k).line_clocks())),
        chip_(chip),
        heard_(heard) {}

 private:
  void look() override {
    const auto state = static_cast<int>(chip_.state.read().to_uint());
    reset_.see(!chip_.rst_n.read());
    host_.see(chip_.done_o->read());
    root_.see(chip_.root_start.read() && !chip_.root_done.read());
    divider_.see(chip_.divider_start.read() && !chip_.divider_done.read());
    const bool begins = state == SphereRay || state == SphereLight || state == SphereAdd ||
                        state == SphereNext || state == SphereHost;
    spheres_.see(begins, state == SphereCentre || state == SphereShadowCentre,
                 chip_.sphere_index.read() == chip_.sphere_last.read());
    planes_.see(begins, state == SpherePlane, chip_.plane_index.read() == chip_.plane_last.read());
  }

  std::vector<Wait> tracer() const override {
    std::vector<Wait> links = {{"write_buffer", "sphere_tracer.word_valid_o = 1"}};
    const auto waits = [&](const char* unit, const char* port, std::uint64_t clocks,
                           const char* what) {
      links.push_back({"sphere_tracer", std::string(unit) + "." + port, clocks});
      links.push_back({unit, "", clocks, what});
    };
    if (reset_ >= Told)
      waits("sphere_inputs", "rst_no = 1", reset_.clocks, "it keeps all units in reset");
    else if (host_ >= Told && !told())
      waits("sphere_host_link", "loaded_o = 1", host_.clocks,
            "the CPU has sent its words, or none, and loaded_o stays 0");
    else if (root_ >= Told)
      waits("root_unit", "done_o = 1", root_.clocks, "start_i is 1, and done_o stays 0");
    else if (divider_ >= Told)
      waits("divider_unit", "done_o = 1", divider_.clocks, "start_i is 1, and done_o stays 0");
    else if (spheres_.entries > 1 << SphereIndexBits && !spheres_.last)
      waits("sphere_table", "last_o = index_i", 0, "none of its entries is the last");
    else if (planes_.entries > 1 << PlaneIndexBits && !planes_.last)
      waits("plane_table", "last_o = index_i", 0, "none of its planes is the last");
    else
      links.push_back({"sphere_tracer", "", 0,
                       fmt::format("it offers {}, in state {}",
                                   repeats() ? "the same word for ever" : "no word",
                                   static_cast<int>(chip_.state.read().to_uint()))});
    return links;
  }

  /// Since the tracer waits for the table, it was told that it is there.
  bool told() const {
    const auto loaded = heard_.of("loaded");
    return loaded > heard_.of("picture_done") && loaded > heard_.of("rst_n");
  }

  const sphere_chip& chip_;
  const LastRises& heard_;
  Held reset_, host_, root_, divider_;
  Walk spheres_, planes_;
};

}  // namespace

std::unique_ptr<WaitWatch> make_sphere_waits(const wired_chip& chip, const knob_values& k,
                                             const LastRises& heard) {
  return std::make_unique<SphereWaits>(static_cast<const sphere_chip&>(chip), k, heard);
}

}  // namespace racebeam
