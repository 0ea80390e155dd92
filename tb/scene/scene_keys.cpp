// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/scene_keys.h"

namespace racebeam {

const std::vector<FileKey>& scene_keys() {
  static const std::vector<FileKey> keys = {
      {"", "name", "text", "the file's name", "shown in reports"},
      {"", "engine", "name", "beam", "the kind of chip that shows it"},
      {"", "frames", "1..16383", "600 after the last shot", "length; the chip shows 60 a second"},
      {"", "corner_bits", "10..16", "as needed", "width of each corner coordinate"},
      {"", "wrap", "true, false", "false", "corners beyond corner_bits may wrap, as on the chip"},
      {"", "overlap", "true, false", "false",
       "rooms may overlap and portals lead to rooms that do not touch"},
      {"", "plan", "table or tables", "none", "a floor plan drawn in characters; repeatable"},
      {"", "room", "tables", "none", "a room given in full; repeatable"},
      {"", "camera", "table", "start", "the camera of frame 0"},
      {"", "look", "table", "the chip's", "colours of frame 0"},
      {"", "shot", "tables", "none", "what changes at a frame; repeatable, by frame"},
      {"plan", "storeys", "text or list of texts", "required",
       "rows of cells, north first; lowest storey first"},
      {"plan", "cells", "table", "none", "kinds of cells: a table of its own for each letter"},
      {"plan", "cell", "2..8192, or [x, z]", "256", "edge of a cell, even"},
      {"plan", "widths", "list of 2..8192", "all as cell",
       "edges of the columns from the west, repeating; even"},
      {"plan", "depths", "list of 2..8192", "all as cell",
       "edges of the rows from the south, repeating; even"},
      {"plan", "height", "2..8192", "512", "height of a cell, even"},
      {"plan", "slab", "0..8192", "32", "thickness between storeys, even"},
      {"plan", "opening", "2..8192", "3/4 of the smallest cell",
       "edge of skylights and floor holes, even; at most from cell to cell"},
      {"plan", "origin", "[x, y, z]", "[0, 0, 0]",
       "floor of the lowest south-west cell, in its middle; even"},
      {"plan", "set", "text", "\"\"",
       "as for a room; its cells are then SET.storey.row.column, SET.start; each plan has another"},
      {"cells", "height", "2..8192", "as the plan", "own height, even"},
      {"cells", "floor", "-8192..8192", "0", "floor above that of the storey, even: steps"},
      {"cells", "skylight", "true, false", "false", "opens the ceiling, to the cell above if any"},
      {"cells", "hole", "true, false", "false", "opens the floor, to the cell below if any"},
      {"cells", "id", "text", "storey.row.column",
       "name; with a number after it if there are several"},
      {"room", "id", "text", "required", "name, unlike all others"},
      {"room", "centre", "[x, y, z]", "required", "x east, y down, z north"},
      {"room", "half_size", "[x, y, z]", "required", "1..8191 each"},
      {"room", "portals", "table", "none", "rooms behind its faces; one side is enough"},
      {"room", "set", "text", "\"\"", "rooms of different sets may stand in one place"},
      {"portals", "east", "id or up to 4 ids", "none", "behind the face towards +x"},
      {"portals", "west", "id or up to 4 ids", "none", "behind the face towards -x"},
      {"portals", "down", "id or up to 4 ids", "none", "behind the floor, +y"},
      {"portals", "up", "id or up to 4 ids", "none", "behind the ceiling, -y"},
      {"portals", "north", "id or up to 4 ids", "none", "behind the face towards +z"},
      {"portals", "south", "id or up to 4 ids", "none", "behind the face towards -z"},
      {"camera", "room", "id", "\"start\": the cell @", "room in which the flight starts"},
      {"camera", "position", "[x, y, z]", "[0, 0, 0]", "from the middle of that room"},
      {"camera", "velocity", "[x, y, z]", "[0, 0, 0]", "per frame, from the second frame on"},
      {"camera", "yaw", "turn, or its start", "0", "turn to the east, 2048 is a full turn"},
      {"camera", "pitch", "turn, or its start", "0", "turn downwards"},
      {"camera", "fov", "turn, or its start", "96", "focal length in pixels, 0..255"},
      {"camera", "interlace", "true, false", "false", "odd lines show z one unit back"},
      {"turn", "start", "-65536..65536", "what it was", "value at the frame that sets it"},
      {"turn", "step", "-1024..1024", "0", "added after every so many frames"},
      {"turn", "every", "1..65536", "1", "frames between steps"},
      {"turn", "per_line", "-16..16", "0", "added from line to line: twists the picture"},
      {"look", "palette", "4 of \"RGB\" or [r, g, b]", "[\"000\", \"001\", \"012\", \"223\"]",
       "digits 0..3: unlit, north/south walls, floors, east/west walls"},
      {"look", "shading", "axis, dithered", "axis", "by axis, or by direction with dithered lines"},
      {"look", "pattern", "off, partial, full", "off", "shows the ray direction as a pattern"},
      {"look", "pattern_palette", "4 of \"RGB\" or [r, g, b]",
       "[\"101\", \"211\", \"321\", \"332\"]", "colours of the pattern"},
      {"look", "inverse", "true, false", "false", "swaps the last two colours"},
      {"shot", "frame", "1..16382", "required", "from this frame on"},
      {"shot", "name", "text", "none", "of this shot only; shown in reports"},
      {"shot", "camera", "table", "goes on", "what changes; room or position restart the flight"},
      {"shot", "look", "table", "goes on", "what changes"},
  };
  return keys;
}

std::vector<std::string> keys_of(std::string_view table, const std::vector<FileKey>& keys) {
  std::vector<std::string> found;
  for (const FileKey& row : keys)
    if (row.table == table) found.push_back(row.key);
  return found;
}

std::string key_row(const FileKey& key) {
  const std::string table = *key.table ? std::string(key.table) + "." : "";
  return "| `" + table + key.key + "` | " + key.type + " | " + key.standard + " | " + key.meaning +
         " |";
}

}  // namespace racebeam
