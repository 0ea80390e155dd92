// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/sweep_keys.h"

namespace racebeam {

const std::vector<FileKey>& sweep_keys() {
  static const std::vector<FileKey> keys = {
      {"", "name", "text", "the file's name", "shown in reports"},
      {"", "scenes", "list of demo or scene files", "[\"demo\"]", "each is reported apart"},
      {"", "frames", "table", "256 of each point", "which frames are rendered"},
      {"", "knobs", "table", "none", "what a search varies"},
      {"", "point", "tables", "none", "a point beside those of the search; repeatable"},
      {"", "base", "table", "the chip", "what all points are compared with, and start from"},
      {"", "search", "table", "grid", "how points are chosen"},
      {"", "goals", "table", "none", "figure = \"min\", \"max\" or limits: of racing and tables"},
      {"", "measure", "table", "counters and picture error", "what else is found out"},
      {"frames", "sample", "1..16383, or all", "256", "frames of each point"},
      {"frames", "skip", "list of patterns", "[\"*ray pattern*\"]",
       "parts of a show that are left out, by name"},
      {"frames", "guard", "0..16383", "64", "the base point's worst frames, kept out of means"},
      {"frames", "until", "table", "none",
       "figure = \"5 %\": goes on until intervals are this narrow, in % of the mean"},
      {"frames", "most", "1..16383", "2048", "frames of a point, however wide its intervals"},
      {"knobs", "where", "condition", "none", "over knobs: what points of a search must hold"},
      {"range", "from", "number", "required", "first value"},
      {"range", "to", "number", "required", "largest value"},
      {"range", "step", "from 1 on", "1", "from value to value"},
      {"point", "name", "text", "required", "unlike all others"},
      {"point", "knobs", "table", "none", "what differs from the base"},
      {"base", "name", "text", "chip if it is the chip, else base", "shown in reports"},
      {"base", "knobs", "table", "none", "what differs from the chip"},
      {"search", "method", "grid, one-by-one, sobol, nsga2", "grid",
       "all combinations; one knob at a time; points spread over all knobs; a search for the "
       "front"},
      {"search", "points", "1..100000", "64", "of sobol; more of them go on with the sequence"},
      {"search", "population", "8..100000, a multiple of 4", "32",
       "of nsga2: points of a generation; sobol brings the first one"},
      {"search", "generations", "1..100000", "12", "of nsga2, beside the first one"},
      {"search", "seed", "0..2147483647", "1", "of sobol and nsga2, and of the order of frames"},
      {"search", "race", "true, false", "true", "points that are surely dominated stop early"},
      {"goal", "least", "number, or text with unit", "none", "below it a point is not wanted"},
      {"goal", "most", "number, or text with unit", "none", "beyond it a point is not wanted"},
      {"measure", "causes", "true, false", "false", "errors by cause"},
      {"measure", "silicon", "off, generic", "off", "flip-flops and generic cells, by yosys"},
      {"measure", "timing", "off, front, all", "off",
       "area and longest path of whole chips, by yosys, OpenSTA and nextpnr"},
      {"measure", "pictures", "list of 0..16382 and worst", "none", "frames kept as pictures"},
      {"measure", "reference", "geometry, trace4, base", "geometry",
       "what pictures are compared with"},
  };
  return keys;
}

}  // namespace racebeam
