// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/voxel/knobs.h"

#include <iterator>

#include "sc/store/store_knob_rows.h"
#include "sc/voxel/codes.h"

namespace racebeam {

namespace {

/// A knob that a scene file sets.
knob_row of_scene(const char* name, int min, int max, const char* unit, const char* meaning) {
  knob_row row{name, min, max, {}, unit, meaning, "article \"Storage\""};
  row.of_scene = true;
  return row;
}

}  // namespace

const std::vector<knob_of<voxel_knobs>>& voxel_knob_table() {
  using k = voxel_knobs;
  static const knob_of<voxel_knobs> rows[] = {
      {{"max_outer",
        1,
        1023,
        {},
        "voxels",
        "that a ray moves on, then it stops",
        "article \"Termination\""},
       &k::max_outer},
      {{"max_inner",
        1,
        1023,
        {},
        "samples",
        "that a ray takes without a hit, then it stops",
        "article \"Termination\""},
       &k::max_inner},
      {{"leaf",
        0,
        1,
        {"march", "voxel"},
        "",
        "what an occupied smallest voxel is: columns are sampled, or it is a hit; voxels of 1 x 1 "
        "x 1",
        "article \"Storage\""},
       &k::leaf},
      {{"leaf_steps",
        1,
        8,
        {},
        "samples",
        "a unit of way along the longest axis",
        "article \"Algorithm\""},
       &k::leaf_steps},
      {{"levels",
        1,
        VoxelMaxLevels,
        {},
        "levels",
        "of the octree; all that the world has if that is less",
        "article \"Storage\""},
       &k::levels},
      {{"raise",
        0,
        1,
        {"one", "all"},
        "",
        "levels that a ray goes up at a border: one, or while it is the container's too",
        "article \"Algorithm\""},
       &k::raise},
      {{"group_fetch",
        0,
        1,
        {"off", "on"},
        "",
        "the eight children are taken from the word just read, if they are in it",
        "article \"Future work\""},
       &k::group_fetch},
      {{"shading",
        0,
        1,
        {"height", "slope"},
        "",
        "colours by material and height, or by the slope too",
        "beyond the source"},
       &k::shading},
      {{"sky",
        0,
        1,
        {"plain", "gradient"},
        "",
        "one colour, or by the ray's slope",
        "article \"Future work\""},
       &k::sky},
      {{"shadows",
        0,
        1,
        {"off", "on"},
        "",
        "a second walk towards the light",
        "article \"Future work\""},
       &k::shadows},
      {{"shadow_outer",
        1,
        1023,
        {},
        "voxels",
        "as max_outer, of rays to the light",
        "article \"Termination\""},
       &k::shadow_outer},
      {{"shadow_inner",
        1,
        1023,
        {},
        "samples",
        "as max_inner, of rays to the light",
        "article \"Termination\""},
       &k::shadow_inner},
      {{"debug_limits",
        0,
        1,
        {"off", "on"},
        "",
        "rays that a limit stopped are magenta",
        "article \"Termination\""},
       &k::debug_limits},
      {{"build_chunk",
        1,
        16777216,
        {},
        "columns",
        "that are built in a frame of the raster",
        "article \"Preparation\""},
       &k::build_chunk},
      {{"memory_clocks",
        1,
        8,
        {},
        "clocks",
        "until a read of either memory is there",
        "beyond the source"},
       &k::memory_clocks},
      {write_buffer_depth_row(), &k::write_buffer_depth},
      {write_policy_row(), &k::write_policy},
      {when_full_row(), &k::when_full},
      {of_scene("size_x", 1, VoxelMaxSide, "units", "of the world, to the right"), &k::size_x},
      {of_scene("size_y", 1, VoxelMaxSide, "units", "of the world, away"), &k::size_y},
      {of_scene("size_z", 1, VoxelMaxHeight, "units", "of the world, up"), &k::size_z},
      {of_scene("voxel_x", 1, VoxelMaxVoxel, "units", "of the smallest voxel"), &k::voxel_x},
      {of_scene("voxel_y", 1, VoxelMaxVoxel, "units", "of the smallest voxel"), &k::voxel_y},
      {of_scene("voxel_z", 1, VoxelMaxVoxel, "units", "of the smallest voxel"), &k::voxel_z},
      {of_scene("picture_width", 8, 640, "columns", "of the picture"), &k::picture_width},
      {of_scene("picture_height", 1, 480, "rows", "of the picture"), &k::picture_height},
  };
  static_assert(std::size(rows) * sizeof(int) == sizeof(voxel_knobs), "a knob has no row");
  static const std::vector<knob_of<voxel_knobs>> table(std::begin(rows), std::end(rows));
  return table;
}

const std::vector<knob_row>& voxel_knob_rows() {
  static const std::vector<knob_row> rows = rows_of(voxel_knob_table());
  return rows;
}

voxel_knobs::voxel_knobs(const knob_values& values) {
  put_values(voxel_knob_table(), voxel_knob_rows(), values, *this);
}
voxel_knobs::operator knob_values() const {
  return values_of(voxel_knob_table(), voxel_knob_rows(), *this);
}

}  // namespace racebeam
