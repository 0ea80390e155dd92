// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "tb/judge/goldens.h"
#include "tb/sweep/frame_judge.h"
#include "tb/sweep/packed.h"

namespace racebeam {

namespace {

/// Levels of a colour, by channel.
int level_of(std::uint32_t colour, int channel, int bits) {
  return static_cast<int>(colour >> channel * bits & ((1u << bits) - 1));
}

/// Of an engine with one golden tracer.
class PictureFrameJudge final : public FrameJudge {
 public:
  /// `look`: knobs that change what is meant, and not how well it is drawn.
  PictureFrameJudge(const Show& show, const Block& block, std::vector<const char*> look)
      : show_(show), k_(block.k), golden_(*golden_of(show.engine())), look_(std::move(look)) {}

  ReferenceKeys keys() const override {
    std::string key = "geometry";
    for (const char* name : look_) key += ' ' + std::to_string(k_.of(name));
    return {key};
  }

  std::vector<std::int64_t> errors(const ChipBench::Frame& frame, const KeptPictures& kept,
                                   Answer& answer) override {
    const PackedPicture& drawn = frame.picture;
    PackedPicture meant;
    if (kept.reference.empty()) {
      meant = golden_.picture(show_.tables(), k_, frame.number);
      answer.made.reference = packed_picture(meant);
    } else {
      meant = unpacked_picture(kept.reference);
    }
    std::int64_t differing = 0, by_more = 0;
    for (std::size_t pixel = 0; pixel < drawn.pixels(); ++pixel) {
      const std::uint32_t is = drawn.colour(pixel), wanted = meant.colour(pixel);
      if (is == wanted) continue;
      int most = 0;
      for (int c = 0; c < 3; ++c)
        most =
            std::max(most, std::abs(level_of(is, c, drawn.bits) - level_of(wanted, c, drawn.bits)));
      ++differing;
      by_more += most > 1;
    }
    return {static_cast<std::int64_t>(drawn.pixels()), differing, by_more};
  }

 private:
  const Show& show_;
  const knob_values k_;
  const GoldenKind& golden_;
  const std::vector<const char*> look_;
};

}  // namespace

std::unique_ptr<FrameJudge> make_sphere_frame_judge(const Show& show, const Block& block) {
  return std::make_unique<PictureFrameJudge>(
      show, block,
      std::vector<const char*>{"colour_bits", "table_entries", "shadow_rays", "plane_shadows",
                               "min_weight", "wide", "capture_guard", "as_built"});
}

std::unique_ptr<FrameJudge> make_block_frame_judge(const Show& show, const Block& block) {
  return std::make_unique<PictureFrameJudge>(
      show, block,
      std::vector<const char*>{"max_passes", "specular_squarings", "shadow_rays", "background",
                               "size", "time_skip", "load_bar"});
}

std::unique_ptr<FrameJudge> make_voxel_frame_judge(const Show& show, const Block& block) {
  return std::make_unique<PictureFrameJudge>(show, block,
                                             std::vector<const char*>{"shading", "sky", "shadows"});
}

}  // namespace racebeam
