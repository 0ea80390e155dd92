// The plants, and that no unit of an engine is without one, or a reason.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "tb/scene/engines.h"
#include "tests/cli/hang_plants.h"

namespace racebeam {

void PrintTo(const Plant& plant, std::ostream* out) { *out << plant.name; }

namespace {

Plant in(const char* engine, const char* folder, const char* name, const char* unit,
         const char* right, const char* wrong, std::vector<const char*> more = {}) {
  return {name, engine, unit, std::string(folder) + "/" + unit + ".sv", right, wrong, "", more};
}
Plant beam(const char* name, const char* unit, const char* right, const char* wrong,
           std::vector<const char*> more = {}) {
  return in("beam", "beam", name, unit, right, wrong, more);
}
Plant sphere(const char* name, const char* unit, const char* right, const char* wrong) {
  return in("sphere", "sphere", name, unit, right, wrong);
}
Plant voxel(const char* name, const char* unit, const char* right, const char* wrong,
            std::vector<const char*> more = {}) {
  return in("voxel", "voxel", name, unit, right, wrong, more);
}
Plant block(const char* name, const char* unit, const char* right, const char* wrong) {
  return in("block", "block", name, unit, right, wrong);
}
/// A mistake of block_core in a module of its own.
Plant in_core(const char* name, const char* module, const char* right, const char* wrong) {
  Plant plant = block(name, "block_core", right, wrong);
  plant.file = std::string("block/") + module + ".sv";
  return plant;
}
Plant harmless(Plant plant, const char* why) {
  plant.why = why;
  return plant;
}

/// Of the frame store's units, in the chip of each engine that has one.
std::vector<Plant> in_stores() {
  std::vector<Plant> all;
  for (const char* engine : {"sphere", "voxel", "block"}) {
    all.push_back(in(engine, "store", "WriteBufferNeverTakesAgain", "write_buffer",
                     "assign put_ready_o = WhenFull == 1 || !full_q || take_ready_i;",
                     "assign put_ready_o = head_q == '0;"));
    all.push_back(in(engine, "store", "StoreArbiterRefuses", "store_arbiter",
                     "assign take_ready_o = ", "assign take_ready_o = 1'b0 && "));
    all.push_back(in(engine, "store", "FrameScanoutReadsAllTheTime", "frame_scanout",
                     "read_o = group_begins || word_q != '0;", "read_o = 1'b1;"));
    all.push_back(in(engine, "video", "VgaTimingStopsInALine", "vga_timing", "h_pos_q <= h_pos_d;",
                     "h_pos_q <= h_pos_q == 7 ? h_pos_q : h_pos_d;",
                     {"--set", "write_policy=sync"}));
  }
  all.push_back(in("voxel", "store", "WriteBufferOffersForEver", "write_buffer",
                   "assign take_valid_o = full_q || head_q != tail_q;",
                   "assign take_valid_o = 1'b1;"));
  return all;
}

}  // namespace

std::vector<Plant> quick_plants() {
  return {
      beam("DecisionDatapathIsHalfWayForEver", "decision_datapath", "second_q <= second_d;",
           "second_q <= second_d || second_q && !root;"),
      sphere("RootUnitIsDoneOnce", "root_unit", "done_d = 1'b1;", "done_d = root_q == '0;"),
      voxel("VoxelLeafTakesNoSample", "voxel_leaf",
            "assign sample_o = active_q && phase_q == LastPhase;",
            "assign sample_o = active_q && phase_q == LastPhase && t_q[9];"),
      block("BlockBusServesNobody", "block_bus",
            "wire logic [Cores-1:0] asks = word_valid_i[Cores-1:0];",
            "wire logic [Cores-1:0] asks = later_q == '0 ? word_valid_i[Cores-1:0] : '0;"),
  };
}

std::vector<Plant> other_plants() {
  std::vector<Plant> all = {
      in("beam", "video", "VgaTimingStopsInALine", "vga_timing", "h_pos_q <= h_pos_d;",
         "h_pos_q <= v_pos_q == -10'sd200 && h_pos_q == 7 ? h_pos_q : h_pos_d;"),
      beam("SequencerNeverUnlocks", "sequencer", "lock_o = 1'b0;", "lock_o = part == 3'd3;"),
      beam("TimelineNeverUnlocks", "timeline", "assign lock_o = shown && run_i;",
           "assign lock_o = 1'b1;", {"grid"}),
      beam("CameraUnitNeverRuns", "camera_unit", "Load: phase_d = Scale;",
           "Load: if ($signed(y_i) < -10'sd250) phase_d = Scale;"),
      beam("CameraUnitRunsForEver", "camera_unit", "assign camera_reset = line_end_i || !rst_ni;",
           "assign camera_reset = line_end_i && $signed(y_i) < -10'sd250 || !rst_ni;"),
      beam("SubdividerNeverEndsItsWalk", "subdivider", "if (idx_load_i) idx2_d = idx_start_i;",
           "if (idx_load_i) idx2_d = idx_start_i;\n    else if (tracer_reset_i) idx2_d = idx2_q;"),
      beam("SubdividerNeverHits", "subdivider", "wire logic hit_now = accept && (wall_i || hurry);",
           "wire logic hit_now = accept && (wall_i || hurry) && len_m1 > 10'd700;"),
      beam("SubdividerForgetsToOffer", "subdivider",
           "wire logic emit = returning && !emit_done_q && !line_done_q;",
           "wire logic emit = returning && !emit_done_q && !line_done_q && i1_q == '1;"),
      beam("StacksGiveAnotherPlace", "stacks", "top_tag_o = racebeam_pkg::TagPortBits'(tags_q[n]);",
           "top_tag_o = racebeam_pkg::TagPortBits'({tags_q[n][6:3], 3'd5});"),
      beam("DecisionDatapathDoesNotClimb", "decision_datapath", "level_q <= level_d;",
           "if (!climb_i || root) level_q <= level_d;"),
      beam("DecisionDatapathMeetsNoWall", "decision_datapath", "wall_q <= wall_d;",
           "wall_q <= 1'b0 & wall_d;"),
      beam("SceneRomHasAlwaysAnotherPortal", "scene_rom", "portal_beside = portal_beside + 1'b1;",
           "portal_beside = portal_beside;", {"museum"}),
      beam("IntervalFifoTakesNothingOnceItWasFull", "interval_fifo",
           "wire logic listen = ~eat_head & ~split & emit_i;",
           "logic dead_q;\n  always_ff @(posedge clk_i) dead_q <= dead_q | full;\n"
           "  wire logic listen = ~eat_head & ~split & emit_i & ~dead_q;"),
      beam("IntervalFifoAnswersNobody", "interval_fifo", "assign ack_o = merge | take;",
           "assign ack_o = merge | take | 1'b1;"),

      sphere("SphereInputsKeepTheReset", "sphere_inputs", "assign rst_no = rst_ni && key_ni[3];",
             "assign rst_no = rst_ni && !key_ni[3];"),
      sphere("SphereHostLinkHearsNoCpu", "sphere_host_link",
             "loaded_d = (cpu || built_in) && is_last;", "loaded_d = built_in && is_last;"),
      sphere("SphereTableHasNoLast", "sphere_table", "assign last_o = last_q;",
             "assign last_o = index_i + 1'b1;"),
      sphere("PlaneTableHasNoLast", "plane_table",
             "assign last_o = sphere_pkg::PlaneIndexBits'(Rows - 1);",
             "assign last_o = index_i + 1'b1;"),
      sphere("DividerUnitDoesNotTellItsEnd", "divider_unit", "assign done_o = done_q;",
             "assign done_o = done_q && !denominator_q[3];"),
      sphere("SphereTracerDoesNotGoOn", "sphere_tracer",
             "wire logic stall = word_valid_o && !word_ready_i;",
             "wire logic stall = word_valid_o && (!word_ready_i || x_q == 10'd20);"),
      sphere("SphereTracerDoesNotBegin", "sphere_tracer", "if (loaded_i) begin",
             "if (loaded_i && sphere_last_i == '0) begin"),
      sphere("SphereTracerTestsForEver", "sphere_tracer",
             "wire logic last_sphere = object_q == sphere_last_i;",
             "wire logic last_sphere = object_q == sphere_last_i && x_q != 10'd20;"),

      voxel("VoxelBuilderStopsInABuild", "voxel_builder",
            "wire logic over = phase_q == 4'(MemoryClocks);",
            "wire logic over = phase_q == 4'(MemoryClocks) && y_q != Bits'(3);"),
      voxel("VoxelScanAsksForNoColour", "voxel_scan", "assign shade_o = ray_done_i && ",
            "assign shade_o = ray_done_i && column_q < PlaceBits'(20) && "),
      voxel("VoxelWalkerWaitsInALevel", "voxel_walker",
            "wire logic fetched = fetch && (known_q || step_q == LastFetch);",
            "wire logic fetched = fetch && (known_q || step_q == LastFetch) && level_q != 4'd1;"),
      voxel("VoxelWalkerDoesNotBegin", "voxel_walker",
            "if ((ray_done_o || state_q == voxel_pkg::VoxelIdle) && start_i)",
            "if (ray_done_o && start_i)"),
      voxel("VoxelWalkerForgetsItsLimit", "voxel_walker",
            "wire logic limited = limit && step_q == LastLimit;", "wire logic limited = 1'b0;",
            {"--set", "max_outer=3"}),
      voxel("VoxelShadeHasNoSky", "voxel_shade", "assign done_o = step_q == Last;",
            "assign done_o = step_q == Last && kind_q != voxel_pkg::VoxelSky;", {"level.toml"}),

      block("BlockConvertDerivesForEver", "block_convert",
            "derive_d = derive_q == '0 ? '0 : derive_q + 1'b1;", "derive_d = derive_q;"),
      block("BlockSchedulerDealsNothing", "block_scheduler",
            "wire logic [Cores-1:0] ready = job_ready_i[Cores-1:0];",
            "wire logic [Cores-1:0] ready = x_q == '0 ? job_ready_i[Cores-1:0] : '0;"),
      block("BlockBusAnswersNobody", "block_bus", "assign word_ready_o = bus_ready_i ?",
            "assign word_ready_o = bus_ready_i && !word_valid_i[0] ?"),
      block("BlockCoreIsNeverReady", "block_core",
            "assign job_ready_o = state_q == block_pkg::BlockIdle;",
            "assign job_ready_o = state_q == block_pkg::BlockIdle && job_x_q == '0;"),
      block("BlockCoreDoesNotHearTheBus", "block_core",
            "wire logic accepted = word_valid_o && word_ready_i;",
            "wire logic accepted = word_valid_o && word_ready_i && row_q != 4'd3;"),
      in_core("BlockCoreWaitsForARoot", "block_root", "assign done_o = last;",
              "assign done_o = 1'b0;"),
      in_core("BlockCoreWaitsForAUnitVector", "block_normalise", "assign done_o = last;",
              "assign done_o = last && !v_x_i[3];"),
      in_core("BlockCoreWaitsForItsShade", "block_shade", "assign done_o = step_q == StepLast;",
              "assign done_o = 1'b0;"),
  };
  for (const Plant& plant : in_stores()) all.push_back(plant);
  return all;
}

std::vector<Plant> harmless_plants() {
  const char* const Data = "each of its values is some ray's, and no walk asks what it is";
  return {
      harmless(beam("RaySteps", "ray_stepper",
                    "else dr2_d = subtract ? dr2_q - change : dr2_q + change;",
                    "else dr2_d = subtract ? dr2_q ^ change : dr2_q + (change << 1);"),
               "walks end by counting, bisections by halving, descents at the deepest room"),
      harmless(beam("Rooms", "scene", "RoomPortBits'(neighbour) : '1;",
                    "RoomPortBits'(neighbour ^ 9'd5) : racebeam_pkg::RoomPortBits'(neighbour);"),
               "with one portal in a face each descent ends at the deepest room"),
      harmless(beam("Flight", "navigator", "RoomPortBits'({room_j_q, 4'd4});",
                    "RoomPortBits'({~room_j_q, 4'd9});"),
               "any camera in any room has a picture"),
      harmless(beam("Colours", "pixel_output", "else value_o = 2'd3 - hit_face_i;",
                    "else value_o = y_i[1:0] ^ ray_signs_i[1:0];"),
               "nothing waits for colours or pins"),
      harmless(beam("Sound", "pwm_sound", "assign pwm_o = ~pwm_q[10];", "assign pwm_o = 1'b0;"),
               "nothing waits for a pin"),
      harmless(sphere("Rays", "sphere_raygen", "assign direction_z_o = screen_i - back;",
                      "assign direction_z_o = {14'd0, x_i};"),
               Data),
      harmless(sphere("Products", "vector_unit", "assign sum_o = lane_x + lane_y + lane_z;",
                      "assign sum_o = ~lane_x ^ lane_y;"),
               Data),
      harmless(sphere("Weights", "sphere_shader", "assign weight_o = scaled(weight_q, reflect_i);",
                      "assign weight_o = '1;"),
               "reflections are counted, too"),
      harmless(voxel("Directions", "voxel_camera",
                     "assign direction_x_o = pixel_q[2*Bits+Cut+:voxel_pkg::VoxelDirectionBits];",
                     "assign direction_x_o = pixel_q[Cut+:voxel_pkg::VoxelDirectionBits] ^ '1;"),
               "a ray of any direction ends at its limits"),
      harmless(voxel("Inverses", "voxel_setup", "else if (divides) step_q <= step_q + 1'b1;",
                     "else if (divides) step_q <= step_q + 4'd3;"),
               "nobody waits for done_o, and a ray ends at its limits"),
      harmless(voxel("Limits", "voxel_limits", "assign reached_o = ", "assign reached_o = 1'b0 && ",
                     {"level.toml"}),
               "a ray ends where its numbers end, too"),
      harmless(voxel("Addresses", "voxel_address", "assign inside_o = z_i < side_z;",
                     "assign inside_o = 1'b1;"),
               "a ray through any voxels ends at its limits"),
  };
}

namespace {

TEST(HangPlants, ThereIsOneForEachUnitOfEachEngineOrAReasonWhyNot) {
  std::vector<Plant> stops = quick_plants();
  for (const Plant& plant : other_plants()) stops.push_back(plant);
  const auto has = [](const std::vector<Plant>& plants, const engine& one, const char* unit) {
    return std::any_of(plants.begin(), plants.end(), [&](const Plant& plant) {
      return one.name == std::string(plant.engine) && unit == std::string(plant.unit);
    });
  };
  for (const engine* one : engines())
    for (const unit_row& row : one->units)
      EXPECT_NE(has(stops, *one, row.name), has(harmless_plants(), *one, row.name))
          << one->name << ": " << row.name;
  for (const Plant& plant : harmless_plants()) EXPECT_STRNE(plant.why, "") << plant.name;
}

}  // namespace
}  // namespace racebeam
