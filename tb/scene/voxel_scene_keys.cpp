// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/voxel_scene.h"

namespace racebeam {

const std::vector<FileKey>& voxel_scene_keys() {
  static const std::vector<FileKey> keys = {
      {"", "name", "text", "the file's name", "shown in reports"},
      {"", "engine", "name", "beam", "\"voxel\""},
      {"", "frames", "1..16383", "120", "pictures; then the show starts again"},
      {"", "terrain", "table", "required", "the world, and what it is made from"},
      {"", "material", "tables", "a landscape's", "colours of one of eight materials"},
      {"", "crater", "tables", "none", "a hole that is dug before a picture"},
      {"", "camera", "table", "as its keys", "where picture 0 is seen from"},
      {"", "shot", "tables", "none", "what changes at a picture; repeatable, in their order"},
      {"", "light", "table", "as its keys", "where it comes from"},
      {"", "picture", "table", "as its keys", "what is drawn"},
      {"terrain", "size", "[x, y, z]", "[512, 512, 128]",
       "of the world: right, away, up; x and y up to 16384, z a power of two, 16..256; it repeats "
       "along x and y"},
      {"terrain", "voxel", "[x, y, z]", "[1, 4, 1]", "the smallest: 1, 2, 4, 8 or 16 each"},
      {"terrain", "function", "tiny, hills, canyon", "none",
       "steps and a post, noise, or two cliffs; one of function, picture, rooms and spheres"},
      {"terrain", "seed", "0..1000000", "1", "of hills and canyon: other numbers, other ground"},
      {"terrain", "octaves", "1..8", "5", "of hills: more is rougher"},
      {"terrain", "posts", "0..1000000", "900", "of hills: columns for each post; 0: none"},
      {"terrain", "caves", "true, false", "true", "of hills: roofs over the low ground"},
      {"terrain", "offset", "0..16383", "0", "of canyon: from sides of large voxels to its cliffs"},
      {"terrain", "picture", "file", "none",
       "heights: grey, as large as the world; black is 0, white the top; its top row is the "
       "farthest"},
      {"terrain", "middle", "file", "none", "with high: where a second layer begins, as a picture"},
      {"terrain", "high", "file", "none", "where it ends; black: there is none"},
      {"terrain", "materials", "file", "by height",
       "of a picture: its upper three bits are the material"},
      {"terrain", "rooms", "file", "none", "a scene of beam, of one storey"},
      {"terrain", "spheres", "file", "none", "a scene of sphere, none above another"},
      {"terrain", "scale", "1/64..64", "1", "of rooms and spheres: units to one of their file"},
      {"terrain", "floor", "0..255", "8", "the height of their lowest floor, or of the ground"},
      {"terrain", "base", "-100000..100000", "by floor", "the height of their y = 0"},
      {"material", "number", "0..7", "required",
       "meadow, sand, forest, rock, snow, wood, roof, brick"},
      {"material", "low", "\"#rrggbb\"", "a landscape's", "at height 0"},
      {"material", "high", "\"#rrggbb\"", "a landscape's", "at the top of the world"},
      {"crater", "picture", "0..16382", "0", "before this one it is dug"},
      {"crater", "centre", "[x, y]", "required", "whole"},
      {"crater", "radius", "1..4096", "required", "at most half of the world"},
      {"crater", "depth", "1..255", "required", "in its middle"},
      {"camera", "position", "[x, y, z]", "above the south",
       "in the world or in one beside it; z 0..16383"},
      {"camera", "velocity", "[x, y, z]", "[0, 0, 0]", "a picture; each -1000..1000"},
      {"camera", "yaw", "turn, or its start", "0", "to the right, 2048 is a full turn"},
      {"camera", "pitch", "turn, or its start", "114", "down"},
      {"camera", "fov", "turn, or its start", "320", "focal length in pixels, 1..4096"},
      {"camera", "d00", "[x, y, z]", "by fov and turns",
       "the ray of pixel (0, 0) as the tracer has it, in 2^-24; with dx and dy"},
      {"camera", "dx", "[x, y, z]", "by fov and turns", "from pixel to pixel"},
      {"camera", "dy", "[x, y, z]", "by fov and turns", "from line to line"},
      {"turn", "start", "-65536..65536", "what it was", "value at the picture that sets it"},
      {"turn", "step", "-1024..1024", "0", "added after every so many pictures"},
      {"turn", "every", "1..65536", "1", "pictures between steps"},
      {"shot", "frame", "1..16382", "required", "from this picture on"},
      {"shot", "name", "text", "none", "of this shot only; shown in reports"},
      {"shot", "camera", "table", "goes on", "what changes"},
      {"light", "direction", "[x, y, z]", "[1, 2, 4]", "towards it, of any length"},
      {"picture", "size", "[width, height]", "[640, 480]", "8..640 and 1..480"},
  };
  return keys;
}

}  // namespace racebeam
