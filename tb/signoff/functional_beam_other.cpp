// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/functional_tables.h"

namespace racebeam {

namespace {

std::vector<FunctionalCross> fifo_rows() {
  const std::string depth =
      "bit(tag_i, 6) * 8 + bit(tag_i, 5) * 4 + bit(tag_i, 4) * 2 + bit(tag_i, 3)";
  const FunctionalAxis fill{
      "fill", {{"head_only", "fill_o == 1"}, {"full", "tail_ptr_q == 0"}, {"some", ""}}};
  const FunctionalAxis head{
      "head", {{"negative", "head_len_q >= 1024"}, {"short", "head_len_q < 64"}, {"long", ""}}};
  return {
      {"interval_fifo",
       "offer",
       "tracer_reset_i == 0",
       {fill,
        {"offer",
         {{"none", "emit_i == 0"}, {"own_colour", "value_i == head_value_q"}, {"other", ""}}},
        head,
        axis_of_flag("consume", "consume_i == 1")},
       {{{"full|some", "*", "negative", "*"},
         "the head is used up only when nothing else is left"}}},
      {"interval_fifo",
       "answer",
       "tracer_reset_i == 0 && emit_i == 1",
       {axis_of_flag("ack", "ack_o == 1"), axis_of_flag("starving", "starving_o == 1"), fill,
        axis_of_flag("consume", "consume_i == 1")},
       {{{"*", "yes", "full|some", "*"}, "a beam that starves has the head alone"},
        {{"yes", "*", "head_only", "yes"}, "the head that is eaten takes nothing"},
        {{"no", "yes", "head_only", "no"}, "a beam that starves takes what is offered"}}},
      {"interval_fifo",
       "length",
       "tracer_reset_i == 0",
       {fill,
        {"last_of_tail", {{"yes", "tail_len_q == 0"}, {"no", ""}}},
        axis_of_flag("consume", "consume_i == 1")},
       {}},
      {"interval_fifo",
       "reset",
       "tracer_reset_i == 1",
       {fill, axis_of_flag("emit", "emit_i == 1"), axis_of_flag("consume", "consume_i == 1")},
       {}},
      {"stacks",
       "entries",
       "",
       {axis_of_flag("push", "push_en_i == 1"),
        axis_of_values("entry", "sp_i", {"0", "1", "2", "3"}),
        axis_of_flag("write", "fwrite_i == 1"),
        {"depth", {{"0", depth + " == 0"}, {"stored", depth + " <= 9"}, {"above", ""}}}},
       {}},
  };
}

std::vector<FunctionalCross> raster_rows() {
  const FunctionalAxis pixels =
      axis_of_values("pixels", "h_region_q", {"front_porch", "sync", "back_porch", "active"});
  const FunctionalAxis lines =
      axis_of_values("lines", "v_region_q", {"back_porch", "active", "front_porch", "sync"});
  return {
      {"vga_timing",
       "regions",
       "rst_ni == 1",
       {pixels,
        lines,
        {"speed", {{"0", "speed_i == 0"}, {"some", ""}}},
        axis_of_values("half", "half_q", {"0", "1"})},
       {{{"*", "*", "*", "1"}, "a pixel is a clock", true, "ClocksPerPixel == 1"}}},
      {"vga_timing",
       "events",
       "rst_ni == 1",
       {{"event",
         {{"frame_end", "frame_end_o == 1"},
          {"line_end", "line_end_o == 1"},
          {"active_start", "active_start_o == 1"},
          {"none", ""}}},
        lines},
       {{{"frame_end", "back_porch|active|front_porch"}, "a frame ends in the sync's region"}}},
  };
}

std::vector<FunctionalCross> show_rows() {
  FunctionalAxis part{"part", {}};
  for (int n = 0; n < 7; ++n)
    part.bins.push_back(
        {std::to_string(n),
         "bit(frame_o, 13) * 4 + bit(frame_o, 12) * 2 + bit(frame_o, 11) == " + std::to_string(n)});
  const FunctionalAxis source = axis_of_values("source", "src_i", {"yaw", "pitch", "focal"});
  return {
      {"sequencer",
       "angle",
       "rst_ni == 1",
       {part, source, axis_of_flag("run", "run_i == 1"),
        axis_of_flag("gate", "bit(dr2_y_i, 6) == 1 || bit(dr2_y_i, 7) == 1")},
       {}},
      {"sequencer",
       "count",
       "rst_ni == 1",
       {axis_of_flag("frame_end", "frame_end_i == 1"), axis_of_flag("last", "frame_o == 12799")},
       {}},
      {"pixel_output",
       "index",
       "",
       {axis_of_values("face", "hit_face_i", {"x", "y", "z"}),
        axis_of_flag("shading_b", "shading_b_i == 1"), axis_of_flag("starving", "starving_i == 1"),
        axis_of_flag("odd", "bit(y_i, 0) == 1")},
       {}},
      {"pixel_output",
       "pixel",
       "",
       {axis_of_values("index", "display_i", {"0", "1", "2", "3"}),
        axis_of_values("palette", "palette_i", {"0", "1", "2", "3"}),
        axis_of_flag("lock", "lock_i == 1"), axis_of_flag("inverse", "inverse_i == 1"),
        axis_of_flag("active", "active_i == 1")},
       {}},
  };
}

}  // namespace

std::vector<FunctionalCross> beam_other_crosses() {
  std::vector<FunctionalCross> all;
  for (const auto& rows : {fifo_rows(), raster_rows(), show_rows()})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

}  // namespace racebeam
