// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/sphere_scene.h"

namespace racebeam {

const std::vector<FileKey>& sphere_scene_keys() {
  static const std::vector<FileKey> keys = {
      {"", "name", "text", "the file's name", "shown in reports"},
      {"", "engine", "name", "beam", "\"sphere\""},
      {"", "frames", "1..16383", "120", "pictures; then the show starts again"},
      {"", "eye", "table", "the source's", "where the pictures are seen from"},
      {"", "light", "table", "the source's", "the point light, a white sphere of radius 2"},
      {"", "modes", "table", "as its keys", "what the board's switches say"},
      {"", "box", "table", "the source's", "what the middles of moving spheres stay in"},
      {"", "sphere", "tables", "none", "a sphere; up to 15"},
      {"", "plane", "tables", "none", "a plane; up to 8"},
      {"", "input", "tables", "none", "switches and keys held for some pictures"},
      {"eye", "position", "[x, y, z]", "[0, 0, -32]", "x right, y down, z away; each -1000..1000"},
      {"eye", "screen", "-31.25..31.25", "8.0",
       "the screen stands at z = 32 times this, one unit a pixel"},
      {"light", "position", "[x, y, z]", "[15, 15, -1]", "its middle; in no sphere"},
      {"modes", "size", "512x480, 320x240", "512x480", "of the picture"},
      {"modes", "reflections", "0..3", "0", "mirrors that a ray follows"},
      {"modes", "antialias", "none, 4x, 8x", "none", "rays beside that of a pixel's middle"},
      {"modes", "planes", "true, false", "true", "the planes are seen"},
      {"box", "low", "[x, y, z]", "[-15, -15, 5]", "lowest place of a sphere's middle"},
      {"box", "high", "[x, y, z]", "[15, 15, 35]", "highest place"},
      {"sphere", "id", "text", "none", "name, unlike all others"},
      {"sphere", "centre", "[x, y, z]", "required", "in picture 0; each -1000..1000"},
      {"sphere", "radius", "1..63", "required", "whole"},
      {"sphere", "colour", "\"#rrggbb\"", "white", "the upper five bits of each channel count"},
      {"sphere", "reflect", "0..1", "0", "how much of a mirror it is; in 4096ths"},
      {"sphere", "velocity", "[x, y, z]", "[0, 0, 0]", "a picture; each -64..64"},
      {"plane", "normal", "[x, y, z]", "required", "of length 1, to the eye's side"},
      {"plane", "distance", "-1000..1000", "required", "normal . p + distance = 0 on the plane"},
      {"plane", "colour", "\"#rrggbb\"", "white", "as of a sphere"},
      {"plane", "reflect", "0..1", "0", "as of a sphere"},
      {"plane", "checker", "0..15", "0",
       "dark squares: 1, 2, 4, 8 of so many units, other masks are patterns; 0: none"},
      {"plane", "limits", "[x, y, z]", "none",
       "whole units, 1..1000: it ends where a coordinate is so far from 0"},
      {"input", "picture", "0..16382", "0", "from this picture on"},
      {"input", "pictures", "1..16383", "1", "for so many"},
      {"input", "hold", "list of names", "required",
       "SW0..SW17, KEY0..KEY3; they act at the end of a picture"},
  };
  return keys;
}

}  // namespace racebeam
