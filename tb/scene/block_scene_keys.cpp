// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/block_scene.h"

namespace racebeam {

const std::vector<FileKey>& block_scene_keys() {
  static const std::vector<FileKey> keys = {
      {"", "name", "text", "the file's name", "shown in reports"},
      {"", "engine", "name", "beam", "\"block\""},
      {"", "frames", "1..16383", "120", "pictures; then the show starts again"},
      {"", "scale", "power of two", "1",
       "1/64..1, as 0.125: what a unit of the file is to the renderer"},
      {"", "eye", "table", "the source's", "where the pictures are seen from"},
      {"", "screen", "table", "the source's", "what they are seen through"},
      {"", "light", "table", "the source's", "the point light"},
      {"", "box", "table", "as its keys", "what the middles of moving spheres stay in"},
      {"", "sphere", "tables", "none", "a sphere; up to 64"},
      {"eye", "position", "[x, y, z]", "[0, 0, -7]", "x right, y down, z away; each -1000..1000"},
      {"screen", "size", "[width, height]", "[8, 6]", "in units; each up to 2000"},
      {"screen", "z", "-1000..1000", "0", "where it stands, across the z axis"},
      {"light", "position", "[x, y, z]", "[-8, -9, -9]", "its place; it is not seen"},
      {"box", "low", "[x, y, z]", "[-6, -5, 0]", "lowest place of a sphere's middle"},
      {"box", "high", "[x, y, z]", "[6, 5, 11]", "highest place"},
      {"sphere", "id", "text", "none", "name, unlike all others"},
      {"sphere", "centre", "[x, y, z]", "required", "in picture 0; each -1000..1000"},
      {"sphere", "radius", "number", "required", "scaled, 1/64 and more and below 2.828"},
      {"sphere", "colour", "\"#rrggbb\", [r, g, b]", "white", "or three numbers 0..1"},
      {"sphere", "velocity", "[x, y, z]", "[0, 0, 0]", "a step of time; each -64..64"},
  };
  return keys;
}

}  // namespace racebeam
