// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/functional_tables.h"

namespace racebeam {

namespace {

FunctionalAxis flag(const std::string& name, const std::string& port) {
  return axis_of_flag(name, port + " == 1");
}

std::vector<FunctionalCross> sphere_rows() {
  return {
      {"divider_unit",
       "handshake",
       "rst_ni == 1",
       {flag("start", "start_i"),
        flag("done", "done_o"),
        {"below",
         {{"0", "denominator_i == 0"},
          {"positive", "bit(denominator_i, 23) == 0"},
          {"negative", ""}}},
        axis_of_flag("minus", "bit(numerator_x_i, 35) == 1")},
       {}},
      {"root_unit",
       "handshake",
       "rst_ni == 1",
       {flag("start", "start_i"),
        flag("done", "done_o"),
        {"radicand",
         {{"0", "radicand_i == 0"}, {"negative", "bit(radicand_i, 23) == 1"}, {"positive", ""}}}},
       {}},
      {"sphere_host_link",
       "handshake",
       "rst_ni == 1",
       {flag("valid", "valid_i"), flag("wait", "host_i"), flag("scene", "scene_i"),
        flag("loaded", "loaded_o")},
       {}},
      {"sphere_shader",
       "operation",
       "rst_ni == 1",
       {axis_of_values("op", "op_i",
                       {"hold", "start", "light", "half", "lit", "plain", "add", "store"}),
        flag("dark", "dark_i"), flag("direct", "direct_i")},
       {}},
  };
}

std::vector<FunctionalCross> block_rows() {
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
  };
}

std::vector<FunctionalCross> voxel_rows() {
  return {
      {"voxel_scan",
       "handshake",
       "rst_ni == 1",
       {axis_of_values("state", "state_o", {"idle", "ray", "shadow", "shade"}),
        flag("start", "start_i"), flag("ray_done", "ray_done_i"), flag("done", "done_i"),
        flag("ready", "put_ready_i"), axis_of_values("kind", "kind_i", {"0", "1", "2", "3"})},
       {{{"shadow", "*", "*", "*", "*", "*"}, "only a chip with shadows has this state", false}}},
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
       {}},
      {"write_buffer",
       "handshake",
       "rst_ni == 1",
       {{"fill", {{"empty", "take_valid_o == 0"}, {"full", "full_q == 1"}, {"some", ""}}},
        flag("put", "put_valid_i"),
        flag("take", "take_ready_i")},
       {}},
  };
}

}  // namespace

std::vector<FunctionalCross> other_crosses() {
  std::vector<FunctionalCross> all;
  for (const auto& rows : {sphere_rows(), block_rows(), voxel_rows()})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

}  // namespace racebeam
