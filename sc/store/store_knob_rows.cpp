// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/store_knob_rows.h"

#include "sc/store/store_knobs.h"

namespace racebeam {

knob_row write_buffer_depth_row() {
  return {"write_buffer_depth",
          1,
          MaxWriteBuffer,
          {},
          "entries",
          "words that wait for the frame store",
          "report \"Write Buffer\""};
}

knob_row write_policy_row() {
  return {"write_policy",
          0,
          2,
          {"sync", "blanking", "free"},
          "",
          "when the tracer may write: in syncs, in all blanking, whenever the beam does not read",
          "report \"VGA/SRAM\""};
}

knob_row when_full_row() {
  return {
      "when_full",
      0,
      1,
      {"stall", "drop"},
      "",
      "a word that finds the write buffer full: the tracer waits, or the buffer's words are lost",
      "report \"Write Buffer\""};
}

}  // namespace racebeam
