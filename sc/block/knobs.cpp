// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/knobs.h"

#include <iterator>

#include "sc/block/codes.h"
#include "sc/store/store_knob_rows.h"

namespace racebeam {

const std::vector<knob_of<block_knobs>>& block_knob_table() {
  using k = block_knobs;
  static const knob_of<block_knobs> rows[] = {
      {{"cores",
        1,
        BlockCores,
        {},
        "cores",
        "that draw blocks at the same time",
        "article \"Command and Control\""},
       &k::cores},
      {{"lanes",
        1,
        8,
        {},
        "spheres",
        "that a core meets in a clock: 1, 2, 4 or 8",
        "article \"The Integer Raytracer\""},
       &k::lanes},
      {{"newton_steps",
        0,
        3,
        {},
        "steps",
        "of Newton's, that an inverse root takes",
        "article \"Integers\""},
       &k::newton_steps},
      {{"specular_squarings",
        0,
        6,
        {},
        "squarings",
        "the highlight is a cosine to the power of 2 to the power of this",
        "beyond the source"},
       &k::specular_squarings},
      {{"max_passes",
        1,
        8,
        {},
        "passes",
        "a ray and its reflections",
        "article \"The Integer Raytracer\""},
       &k::max_passes},
      {{"root",
        0,
        2,
        {"bits", "heron", "exact"},
        "",
        "how a root is made: of the bits of a float, with a step of Heron's, of all its digits",
        "article \"Integers\""},
       &k::root},
      {{"shadow_rays",
        0,
        1,
        {"off", "on"},
        "",
        "a ray from each hit to the light: what a sphere is in the way of adds nothing",
        "beyond the source"},
       &k::shadow_rays},
      {{"cull",
        0,
        2,
        {"corners", "cone", "off"},
        "",
        "what clears a block that shows no sphere: its four corner rays, a cone around it, nothing",
        "article \"The Integer Raytracer\""},
       &k::cull},
      {{"background",
        0,
        0xffffff,
        {},
        "rgb",
        "red, green and blue where nothing is hit",
        "article \"The Integer Raytracer\""},
       &k::background},
      {{"fraction_bits",
        12,
        20,
        {},
        "bits",
        "of the host's numbers when they are converted; those below are 0",
        "article \"Integers\""},
       &k::fraction_bits},
      {{"size",
        0,
        2,
        {"640x480", "512x480", "1920x1080"},
        "",
        "of the picture",
        "article \"Summing Up\""},
       &k::size},
      {write_buffer_depth_row(), &k::write_buffer_depth},
      {write_policy_row(), &k::write_policy},
      {when_full_row(), &k::when_full},
      {{"time_skip",
        0,
        16,
        {},
        "steps",
        "of time between a picture and the next",
        "article \"Command and Control\""},
       &k::time_skip},
      {{"load_bar",
        0,
        1,
        {"off", "on"},
        "",
        "a row of squares in the picture, one a core: how busy it was",
        "article \"Command and Control\""},
       &k::load_bar},
  };
  static_assert(std::size(rows) * sizeof(int) == sizeof(block_knobs), "a knob has no row");
  static const std::vector<knob_of<block_knobs>> table(std::begin(rows), std::end(rows));
  return table;
}

const std::vector<knob_row>& block_knob_rows() {
  static const std::vector<knob_row> rows = rows_of(block_knob_table());
  return rows;
}

block_knobs::block_knobs(const knob_values& values) {
  put_values(block_knob_table(), block_knob_rows(), values, *this);
}
block_knobs::operator knob_values() const {
  return values_of(block_knob_table(), block_knob_rows(), *this);
}

}  // namespace racebeam
