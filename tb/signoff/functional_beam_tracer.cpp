// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/functional_tables.h"

namespace racebeam {

namespace {

const FunctionalAxis SubdividerState =
    axis_of_values("state", "state_o", {"left", "right", "bisect", "return"});

std::vector<FunctionalCross> subdivider_rows() {
  const FunctionalAxis answer{"answer",
                              {{"wall", "wall_i == 1"},
                               {"second", "second_i == 1"},
                               {"0", "bit(dec_i, 0) == 0"},
                               {"1", "bit(dec_i, 0) == 1"}}};
  const FunctionalAxis offer{
      "offer", {{"none", "emit_o == 0"}, {"taken", "ack_i == 1"}, {"waits", "ack_i == 0"}}};
  const FunctionalAxis beam = axis_of_flag("starving", "starving_i == 1");
  return {
      {"subdivider",
       "decision",
       "tracer_reset_i == 0",
       {SubdividerState, answer, offer, beam},
       {{{"left|right|bisect", "second|0|1", "taken|waits", "no"},
         "an interval is offered at a wall, or short ones while the beam starves"},
        {{"bisect", "*", "taken|waits", "*"},
         "a bisection stays below i2, but for the lock effect and loads that no chip makes",
         false}}},
      {"subdivider",
       "move",
       "tracer_reset_i == 0",
       {SubdividerState,
        {"move",
         {{"descends", "descend_o == 1"},
          {"climbs", "climb_o == 1"},
          {"restarts", "restart_o == 1"},
          {"stays", ""}}},
        {"stack", {{"empty", "sd_o == 0"}, {"entries", ""}}}},
       {{{"return", "descends", "*"}, "on its way back it only climbs"},
        {{"left|right|bisect", "restarts", "*"}, "the way back alone ends at the top"},
        {{"return", "restarts", "entries"}, "entries of the stack come before a restart"}}},
      {"subdivider",
       "push",
       "tracer_reset_i == 0",
       {axis_of_flag("push", "push_en_o == 1"),
        axis_of_values("entry", "sp_o", {"0", "1", "2", "3"}),
        axis_of_values("entries", "sd_o", {"0", "1", "2", "3", "4"})},
       {}},
      {"subdivider",
       "lock",
       "",
       {axis_of_flag("lock", "lock_i == 1"), axis_of_flag("consume", "consume_i == 1"),
        axis_of_flag("reset", "tracer_reset_i == 1"), axis_of_flag("load", "idx_load_i == 1"),
        SubdividerState},
       {}},
  };
}

std::vector<FunctionalCross> datapath_rows() {
  const FunctionalAxis level{"level",
                             {{"0", "level_q == 0"},
                              {"1", "level_q == 1"},
                              {"2", "level_q == 2"},
                              {"3", "level_q == 3"},
                              {"6", "level_q == 6"},
                              {"7", "level_q == 7"}}};
  const FunctionalAxis move{
      "move", {{"descends", "descend_i == 1"}, {"climbs", "climb_i == 1"}, {"holds", ""}}};
  const FunctionalAxis second = axis_of_flag("second", "second_q == 1");
  const FunctionalAxis solid{"behind", {{"wall", "neighbour_i == 8191"}, {"room", ""}}};
  const FunctionalAxis left = axis_of_flag("left", "state_i == 0");
  return {
      {"decision_datapath",
       "move",
       "tracer_reset_i == 0 && nav_line_i == 0 && restart_i == 0",
       {level, move, second, solid},
       {{{"0|1|2|3|6", "*", "yes", "*"},
         "half way into a room it is at level 7; at others where a face has several portals",
         false}}},
      {"decision_datapath",
       "depth",
       "tracer_reset_i == 0 && nav_line_i == 0 && restart_i == 0",
       {{"depth", {{"root", "depth_q == 0"}, {"rooms", "depth_q < 9"}, {"deepest", ""}}},
        move,
        second,
        left},
       {}},
      {"decision_datapath",
       "answer",
       "",
       {level,
        left,
        {"bit", {{"0", "bit(dec_o, 0) == 0"}, {"1", ""}}},
        axis_of_values("face", "face_q", {"x", "y", "z"})},
       {}},
      {"decision_datapath",
       "flight",
       "nav_line_i == 1",
       {axis_of_values("op", "nav_op_i",
                       {"hold", "add_velocity", "add_s", "subtract_2s", "leave_plus", "leave_minus",
                        "add_r", "camera"}),
        axis_of_flag("move", "nav_move_i == 1"), axis_of_flag("start", "active_start_i == 1")},
       {}},
  };
}

std::vector<FunctionalCross> flight_rows() {
  const FunctionalAxis found{
      "below",
      {{"none", "bit(corner_x_i, 15) == 0 && bit(corner_y_i, 15) == 0 && bit(corner_z_i, 15) == 0"},
       {"all", "bit(corner_x_i, 15) == 1 && bit(corner_y_i, 15) == 1 && bit(corner_z_i, 15) == 1"},
       {"some", ""}}};
  return {{"navigator",
           "state",
           "rst_ni == 1 && nav_reset_i == 0",
           {axis_of_values(
                "state", "nav_state_q",
                {"idle", "to_plus", "check_plus", "check_minus", "finish", "store", "adjust"}),
            found, axis_of_flag("line", "nav_line_i == 1"),
            axis_of_flag("start", "active_start_i == 1")},
           {}}};
}

std::vector<FunctionalCross> ray_rows() {
  return {
      {"ray_stepper",
       "direction",
       "",
       {axis_of_flag("reset", "tracer_reset_i == 1"), axis_of_flag("load", "load_i == 1"),
        axis_of_flag("zero", "load_zero_i == 1"), axis_of_flag("ext", "ext_i == 1"),
        axis_of_flag("step", "step_i == 1"), axis_of_flag("negative", "neg_i == 1")},
       {}},
      {"ray_stepper",
       "copy",
       "",
       {axis_of_flag("copy_ext", "copy_ext_i == 1"),
        axis_of_flag("copy_sub", "copy_sub_i == 1"),
        axis_of_flag("step", "step_i == 1"),
        {"size",
         {{"1", "step_size_i == 1"},
          {"2", "step_size_i == 2"},
          {"4", "step_size_i == 4"},
          {"8", "step_size_i == 8"},
          {"16", "step_size_i == 16"},
          {"32", "step_size_i == 32"},
          {"64", "step_size_i == 64"},
          {"128", "step_size_i == 128"},
          {"256", "step_size_i == 256"},
          {"512", "step_size_i == 512"}}}},
       {}},
      {"camera_unit",
       "factor",
       "rst_ni == 1 && line_end_i == 0 && phase_q == 0",
       {axis_of_values("pass", "pass_q", {"forward", "down", "right"}),
        axis_of_values("factor", "pstage_q", {"yaw", "pitch", "pitch2", "sign"}),
        axis_of_values("clock", "pclk_q", {"0", "1", "2", "3"}),
        axis_of_flag("step", "step_i == 1")},
       {{{"right", "pitch|pitch2", "*", "*"}, "the last pass has no factor of the pitch"},
        {{"*", "pitch|pitch2", "1|2", "*"}, "these factors go from their first clock to 3"},
        {{"*", "sign", "1", "*"}, "the sign has the clocks 0, 3 and 2"}}},
      {"camera_unit",
       "phase",
       "rst_ni == 1 && line_end_i == 0",
       {axis_of_values("pass", "pass_q", {"forward", "down", "right"}),
        axis_of_values("phase", "phase_q", {"product", "load", "scale", "run"}),
        axis_of_flag("step", "step_i == 1"), axis_of_flag("seen", "step_seen_q == 1")},
       {{{"forward|down", "run", "*", "*"}, "the last pass alone ends in a run"}}},
  };
}

}  // namespace

std::vector<FunctionalCross> beam_tracer_crosses() {
  std::vector<FunctionalCross> all;
  for (const auto& rows : {subdivider_rows(), datapath_rows(), flight_rows(), ray_rows()})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

}  // namespace racebeam
