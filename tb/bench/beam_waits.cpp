// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/beam_waits.h"

#include <fmt/format.h>

#include <utility>

#include "sc/beam/codes.h"
#include "tb/monitor/raster.h"

namespace racebeam {

namespace {

constexpr std::uint64_t Move = 8;       // clocks: each move of the tracer is shorter
constexpr std::uint64_t Walk = 64;      // steps of the camera's walks, or of a climb
constexpr std::uint64_t Camera = 512;   // clocks, the longest head start among them
constexpr std::uint64_t Shortest = 16;  // a wait that is told of
constexpr int DescentsToWall = 128;     // of rooms with one portal a face: more than 15 x 7

}  // namespace

BeamWaits::BeamWaits(const chip& watched, const knobs& k)
    : chip_(watched),
      knobs_(k),
      line_(static_cast<std::uint64_t>(Raster(k.clocks_per_pixel, k.speed).line_clocks())) {}

void BeamWaits::remember_pushes() {
  const int sp = static_cast<int>(chip_.sp.read());
  const int top = sp == 0 ? knobs_.interval_stack_depth - 1 : sp - 1;
  const auto known = pushed_.find(top);
  if (chip_.sd.read() != 0 && known != pushed_.end())
    wrong_top_ |= static_cast<int>(chip_.top_tag.read()) != known->second;
  if (chip_.push_en.read()) pushed_[sp] = static_cast<int>(chip_.tag.read());
}

void BeamWaits::clock() {
  no_line_end_.see(!chip_.line_end.read());
  line_end_.see(chip_.line_end.read());
  reset_.see(!chip_.run.read());
  running_.see(chip_.run.read());
  lock_.see(chip_.lock.read());
  // Not where camera_unit begins its walk anew in each clock.
  if (!chip_.line_end.read())
    stepping_in_reset_.see(!chip_.run.read() && chip_.step.read() && !chip_.idx_load.read());
  // What the tracer did last in its line stays to be told.
  if (chip_.tracer_reset.read()) {
    run_ = climbed_ = descended_ = false;
    return;
  }
  if (!std::exchange(run_, true)) descents_ = 0;
  look_at_tracer();
}

void BeamWaits::look_at_tracer() {
  answer_without_offer_.see(chip_.ack.read() && !chip_.emit.read());
  // As the FIFO sees it: a channel that stalls is no offer.
  const bool refused = chip_.u_interval_fifo->emit_i->read() && !chip_.ack.read();
  offer_.see(refused);
  // It does not listen while the beam eats of it.
  if (!chip_.consume.read())
    refused_.see(refused && static_cast<int>(chip_.fill.read()) < knobs_.fifo_entries);
  second_.see(chip_.second.read());
  const bool climb = chip_.u_decision_datapath->climb_i->read();
  climb_.see(climb);
  const int tag = static_cast<int>(chip_.tag.read()) << 1 | chip_.second.read();
  climb_stays_.see(climbed_ && climb && tag == tag_);
  // At a wall there is no way down, and subdivider has to see it.
  descend_stays_.see(descended_ && chip_.descend.read() && !chip_.wall.read() && tag == tag_);
  climbed_ = climb;
  descended_ = chip_.descend.read();
  tag_ = tag;
  descents_ =
      chip_.emit.read() || chip_.wall.read() || chip_.restart.read() ? 0 : descents_ + descended_;
  // Within a room no decision is of level 4 or above.
  if (chip_.leave.read() != 0 && (tag >> 1 & 4) == 0) ++asides_;
  else if (chip_.descend.read() || chip_.wall.read() || chip_.restart.read()) asides_ = 0;
  remember_pushes();
}

Wait BeamWaits::fifo() const {
  if (no_line_end_ >= line_ + line_ / 4)
    return {"interval_fifo", "vga_timing.line_end_o = 1", no_line_end_.clocks};
  if (line_end_ >= Shortest)
    return {"interval_fifo", "vga_timing.line_end_o = 0", line_end_.clocks};
  if (answer_without_offer_ >= Move)
    return {"interval_fifo", "", answer_without_offer_.clocks,
            "ack_o is 1 and nothing is on offer (emit_i = 0)", true};
  if (offer_ >= Shortest)
    return {"interval_fifo", "", offer_.clocks,
            fmt::format("it does not take what is on offer (emit_i = 1, ack_o = 0), with {} of {} "
                        "entries in use",
                        static_cast<int>(chip_.fill.read()), knobs_.fifo_entries),
            refused_ >= Walk};
  return {"interval_fifo", "subdivider.emit_o = 1", 0};
}

Wait BeamWaits::tracer() const {
  if (stepping_in_reset_ >= Walk)
    return {"subdivider", "", stepping_in_reset_.clocks,
            "it steps on and on (step_o = 1), and camera_unit waits for the end of that"};
  if (reset_ >= Camera) return {"subdivider", "camera_unit.run_o = 1", reset_.clocks};
  if (running_ >= line_ + line_ / 4)
    return {"subdivider", "camera_unit.run_o = 0", running_.clocks};
  // It steps with the beam, to the end of the line at most.
  if (lock_ >= line_ + line_ / 4)
    return {"subdivider", chip_.has_program() ? "timeline.lock_o = 0" : "sequencer.lock_o = 0",
            lock_.clocks};
  if (second_ >= Move) return {"subdivider", "decision_datapath.second_o = 0", second_.clocks};
  if (climb_stays_ >= Move)
    return {"subdivider", "decision_datapath.tag_o = the place to climb to", climb_stays_.clocks};
  if (climb_ >= Walk || wrong_top_)
    return {"subdivider", "decision_datapath.tag_o = the place to climb to", climb_.clocks};
  if (descend_stays_ >= Move)
    return {"subdivider", "decision_datapath.tag_o = the next place down", descend_stays_.clocks};
  if (asides_ > MaxPortals)
    return {"subdivider", "decision_datapath.wall_o = 1", static_cast<std::uint64_t>(asides_)};
  if (descents_ > DescentsToWall * knobs_.portals_per_face)
    return {"subdivider", "decision_datapath.wall_o = 1", static_cast<std::uint64_t>(descents_)};
  return {"subdivider", "", 0,
          "it offers no interval, and neither camera_unit nor decision_datapath keeps it"};
}

Wait BeamWaits::conductor() const {
  return {chip_.has_program() ? "timeline" : "sequencer", "", lock_.clocks,
          "lock_o stays 1, beyond the end of a line", true};
}

Wait BeamWaits::camera() const {
  if (running_ >= line_ + line_ / 4)
    return {"camera_unit", "", running_.clocks, "run_o stays 1, beyond the end of a line", true};
  return {"camera_unit", "", reset_.clocks, "run_o stays 0, and nothing keeps it"};
}

Wait BeamWaits::decision() const {
  if (wrong_top_ && !(second_ >= Move) && !(climb_stays_ >= Move))
    return {"decision_datapath", "stacks.top_tag_o = the place that was pushed", climb_.clocks};
  if (second_ >= Move)
    return {"decision_datapath", "", second_.clocks, "second_o stays 1: it is half way for ever",
            true};
  if (climb_stays_ >= Move)
    return {"decision_datapath", "", climb_stays_.clocks, "climb_i is 1, and tag_o stays", true};
  if (climb_ >= Walk)
    return {"decision_datapath", "", climb_.clocks, "it climbs, and does not come where it is to",
            true};
  if (descend_stays_ >= Move)
    return {"decision_datapath", "", descend_stays_.clocks, "descend_i is 1, and tag_o stays",
            true};
  if (asides_ > MaxPortals)
    return {"decision_datapath",
            std::string(chip_.has_program() ? "scene_rom" : "scene") + ".neighbour_o = none",
            static_cast<std::uint64_t>(asides_)};
  return {"decision_datapath", "", static_cast<std::uint64_t>(descents_),
          "it descends, and meets no wall", descents_ > DescentsToWall * knobs_.portals_per_face};
}

std::vector<Wait> BeamWaits::chain() const {
  std::vector<Wait> links = {fifo()};
  while (!links.back().port.empty() && links.size() < 8) {
    const std::string next = links.back().port.substr(0, links.back().port.find('.'));
    if (next == "subdivider") links.push_back(tracer());
    else if (next == "camera_unit") links.push_back(camera());
    else if (next == "decision_datapath") links.push_back(decision());
    else if (next == "sequencer" || next == "timeline") links.push_back(conductor());
    else if (next == "scene" || next == "scene_rom")
      links.push_back({next, "", links.back().clocks,
                       "beside a portal of a face there is always another one", true});
    else if (next == "stacks")
      links.push_back({"stacks", "", 0, "top_tag_o is not what was pushed there", true});
    else links.push_back({"vga_timing", "", links.back().clocks, "its lines do not go on", true});
  }
  return links;
}

std::unique_ptr<WaitWatch> make_beam_waits(const wired_chip& watched, const knob_values& k,
                                           const LastRises&) {
  return std::make_unique<BeamWaits>(static_cast<const chip&>(watched), k);
}

}  // namespace racebeam
