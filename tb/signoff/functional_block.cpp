// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/functional_tables.h"

namespace racebeam {

namespace {

FunctionalAxis flag(const std::string& name, const std::string& port) {
  return axis_of_flag(name, port + " == 1");
}

}  // namespace

std::vector<FunctionalCross> block_crosses() {
  return {
      {"block_bus",
       "handshake",
       "rst_ni == 1",
       {flag("valid", "bus_valid_o"), flag("ready", "bus_ready_i"),
        axis_of_flag("turn_over", "later_q == 0"), axis_of_flag("first_core", "core_o == 0")},
       {{{"no", "*", "*", "no"}, "without a word the core is the first"}}},
      {"block_scheduler",
       "dealing",
       "rst_ni == 1",
       {flag("start", "start_i"),
        flag("deals", "deals_q"),
        flag("done", "done_o"),
        {"ready", {{"none", "job_valid_o == 0"}, {"some", ""}}}},
       {{{"*", "yes", "yes", "*"}, "what deals is not done"},
        {{"*", "no", "*", "some"}, "only what deals has jobs"}}},
      {"block_scheduler",
       "places",
       "rst_ni == 1",
       {flag("deals", "deals_q"),
        {"ready", {{"none", "job_valid_o == 0"}, {"some", ""}}},
        axis_of_flag("row_ends", "job_x_o + 16 >= width_i"),
        axis_of_flag("last_row", "job_y_o + 16 >= height_i")},
       {{{"no", "some", "*", "*"}, "only what deals has jobs"},
        {{"no", "*", "yes", "*"}, "it waits before the first block, which ends no row"}}},
      {"block_core",
       "state",
       "rst_ni == 1",
       {axis_of_values(
            "state", "state_q",
            {"idle", "job", "corner", "cull", "clear", "pixel", "group", "near", "decide", "shade",
             "store", "words", "shadow", "shadow_group", "shadow_near"}),
        flag("job", "job_valid_i"), flag("ready", "word_ready_i"), flag("write", "write_i")},
       {{{"shadow|shadow_group|shadow_near", "*", "*", "*"},
         "no ray goes to the light",
         true,
         "ShadowRays == 0"},
        {{"corner|cull", "*", "*", "*"}, "all blocks are drawn", true, "Cull == 2"}}},
      {"block_core",
       "pass",
       "rst_ni == 1",
       {{"state",
         {{"group_first", "state_q == 6 && step_q == 0"},
          {"group_second", "state_q == 6"},
          {"near", "state_q == 7"},
          {"decide", "state_q == 8"},
          {"shade", "state_q == 9"}}},
        axis_of_values("pass", "pass_q", {"first", "second", "third"}),
        flag("hit", "hit_q")},
       {{{"group_second", "first", "*"}, "rays from the eye have the sphere's numbers ready"},
        {{"shade", "*", "no"}, "only a hit has light"}}},
      {"block_core",
       "words",
       "rst_ni == 1 && word_valid_o == 1",
       {{"state", {{"clear", "state_q == 4"}, {"words", ""}}},
        axis_of_values("plane", "plane_q", {"red", "green", "blue"}),
        axis_of_flag("right", "column_q >= 8"),
        flag("ready", "word_ready_i")},
       {}},
  };
}

}  // namespace racebeam
