// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/functional_tables.h"

namespace racebeam {

namespace {

FunctionalAxis flag(const std::string& name, const std::string& port) {
  return axis_of_flag(name, port + " == 1");
}

}  // namespace

std::vector<FunctionalCross> voxel_crosses() {
  return {
      {"voxel_scan",
       "handshake",
       "rst_ni == 1",
       {axis_of_values("state", "state_o", {"idle", "ray", "shadow", "shade"}),
        flag("start", "start_i"), flag("ray_done", "ray_done_i"), flag("done", "done_i"),
        flag("ready", "put_ready_i"), axis_of_values("kind", "kind_i", {"0", "1", "2", "3"})},
       {{{"shadow", "*", "*", "*", "*", "*"}, "no ray goes to the light", true, "Shadows == 0"}}},
      {"voxel_builder",
       "state",
       "rst_ni == 1",
       {axis_of_values("state", "state_o", {"idle", "clear", "fill", "up"}),
        flag("start", "start_i"), flag("host_write", "host_write_i"), flag("walk", "walk_read_i"),
        flag("leaf", "leaf_read_i")},
       {}},
      {"voxel_walker",
       "state",
       "rst_ni == 1",
       {axis_of_values("state", "state_o",
                       {"idle", "setup", "fetch", "down", "exit", "leaf", "move", "limit"}),
        flag("start", "start_i"), flag("inside", "inside_i"), flag("hit", "hit_i"),
        flag("reached", "reached_i")},
       {{{"leaf", "*", "no", "*", "*"}, "a voxel with a leaf is in the world", false},
        {{"leaf", "*", "*", "*", "*"}, "voxels are solid", true, "Leaf == 1"}}},
      {"voxel_builder",
       "access",
       "rst_ni == 1",
       {axis_of_values("state", "state_q", {"idle", "clear", "fill", "up"}), flag("puts", "puts_q"),
        axis_of_flag("level_0", "level_q == 0"), axis_of_flag("found", "found_q == 1")},
       {{{"clear", "no", "*", "*"}, "it only puts"},
        {{"clear|fill", "*", "no", "*"}, "these are of level 0"},
        {{"up", "*", "yes", "*"}, "what is above has children"}}},
      {"voxel_scan",
       "picture",
       "rst_ni == 1",
       {flag("valid", "put_valid_o"), flag("ready", "put_ready_i"), flag("new_line", "next_line_o"),
        flag("done", "picture_done_o")},
       {{{"no", "*", "yes", "*"}, "it ends with a pixel"},
        {{"no", "*", "*", "yes"}, "it ends with a pixel"},
        {{"*", "no", "yes", "*"}, "the pixel waits"},
        {{"*", "no", "*", "yes"}, "the pixel waits"},
        {{"*", "*", "yes", "yes"}, "no line comes after the last"}}},
      {"voxel_setup",
       "handshake",
       "rst_ni == 1",
       {flag("start", "start_i"),
        {"step", {{"idle", "step_q == 0"}, {"last", "step_q == 15"}, {"some", ""}}},
        flag("done", "done_o")},
       {{{"*", "idle|some", "yes"}, "it takes 16 clocks"},
        {{"*", "last", "no"}, "it takes 16 clocks"}}},
      {"voxel_walker",
       "voxel",
       "rst_ni == 1",
       {axis_of_values("state", "state_q",
                       {"idle", "setup", "fetch", "down", "exit", "leaf", "move", "limit"}),
        {"level", {{"finest", "level_q == 0"}, {"middle", "level_q < 4"}, {"top", ""}}},
        flag("occupied", "occupied_q"),
        flag("shadow", "shadow_q")},
       {{{"down", "finest", "*", "*"}, "the finest voxels have no children"},
        {{"down", "*", "no", "*"}, "it goes into what is occupied"},
        {{"leaf", "*", "no", "*"}, "it samples what is occupied"}}},
      {"voxel_leaf",
       "sample",
       "rst_ni == 1",
       {flag("sample", "sample_o"), flag("hit", "hit_o"), flag("done", "done_o"),
        flag("stop", "stop_i"), flag("start", "start_i")},
       {{{"no", "yes", "*", "*", "*"}, "only a sample hits"},
        {{"no", "*", "yes", "*", "*"}, "only a sample is the last"},
        {{"*", "yes", "no", "*", "*"}, "a hit is the last sample"}}},
      {"voxel_shade",
       "step",
       "rst_ni == 1",
       {{"step", {{"idle", "step_q == 0"}, {"last", "step_q == 6"}, {"reads", ""}}},
        flag("shade", "shade_i"),
        flag("ready", "put_ready_i"),
        axis_of_values("kind", "kind_q", {"sky", "hit", "outer", "inner"})},
       {{{"reads", "*", "*", "*"},
         "a colour is that of a height",
         true,
         "Leaf == 0 && Shading == 0"}}},
  };
}

}  // namespace racebeam
