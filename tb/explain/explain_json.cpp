// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/explain/explain_json.h"

#include <nlohmann/json.hpp>

#include "tb/explain/step_text.h"
#include "tb/show/knobs_json.h"

namespace racebeam {

namespace {

using Json = nlohmann::ordered_json;

Json rgb(int colour) { return Json::array({colour >> 4, colour >> 2 & 3, colour & 3}); }

Json colour_json(const Explanation& e) {
  const ShownColumn& c = e.shown();
  Json colours = Json::array();
  for (const int colour : c.colours) colours.push_back(rgb(colour));
  return {{"rgb", rgb(c.colour)},
          {"index", c.index},
          {"fifo_index", c.display},
          {"palette", c.palette == TablePalette ? Json("scene") : Json(c.palette)},
          {"palette_colours", colours},
          {"dithered", e.story.shading_b},
          {"inverse", c.inverse},
          {"pattern", c.pattern},
          {"starved", c.starving},
          {"why", e.why_index()}};
}

Json room_json(const Explanation& e, int id) {
  Json json = {{"id", id}};
  if (const std::string name = e.room_name(id); !name.empty()) json["name"] = name;
  return json;
}

Json face_json(int axis, bool negative) {
  return {{"axis", std::string(1, "xyz"[axis])},
          {"sign", negative ? "-" : "+"},
          {"name", face_name(2 * axis + negative)}};
}

Json hit_json(const Explanation& e) {
  const TracedInterval& i = *e.interval;
  if (!i.known()) return nullptr;
  Json way = Json::array();
  for (std::size_t n = 0; n < i.way.size(); ++n) {
    Json room = room_json(e, i.way[n].room);
    if (n) room["through"] = face_json(i.way[n].axis, i.way[n].negative);
    way.push_back(room);
  }
  return {{"end", end_name(i.end)},
          {"wall", i.end != IntervalEnd::GivenUp},
          {"room", room_json(e, i.way.back().room)},
          {"behind", i.behind == SolidRoom ? Json() : room_json(e, i.behind)},
          {"face", i.axis < 0 ? Json() : face_json(i.axis, i.negative)},
          {"depth", i.way.size() - 1},
          {"tracer", {{"depth", i.depth}, {"level", i.level}}},
          {"way", way}};
}

Json cost_json(const StepTotals& t) {
  return {{"decisions", t.decisions()},
          {"left", t.left},
          {"right", t.right},
          {"bisect", t.bisect},
          {"clocks", t.clocks()},
          {"walk_clocks", t.walks},
          {"room_change_clocks", t.room_changes},
          {"return_clocks", t.returns},
          {"wait_clocks", t.waits},
          {"pushes", t.pushes},
          {"restarts", t.restarts}};
}

Json step_json(const TracerStep& s) {
  return {{"clock", s.clock},
          {"clocks", s.clocks},
          {"state", state_name(s.state)},
          {"decision", s.decision},
          {"first", s.first},
          {"last", s.last},
          {"idx2", s.idx2},
          {"pixel", s.asked()},
          {"room", s.room},
          {"depth", s.depth},
          {"level", s.level},
          {"question", s.decision ? Json(question_text(s)) : Json()},
          {"answer", s.decision ? Json(answer_text(s)) : Json()},
          {"agrees", s.decision && s.state ? Json(s.agrees) : Json()},
          {"outcome", outcomes(s)}};
}

Json interval_json(const Explanation& e) {
  if (!e.interval) return nullptr;
  const TracedInterval& i = *e.interval;
  Json steps = Json::array();
  for (std::size_t n = i.step_begin; n < i.step_end; ++n)
    steps.push_back(step_json(e.story.steps[n]));
  return {{"first", i.first},
          {"last", i.last},
          {"length", i.length()},
          {"value", i.known() ? Json(i.value) : Json()},
          {"starving", i.starving},
          {"hit", hit_json(e)},
          {"cost", cost_json(totals(e.story, i))},
          {"steps", steps}};
}

}  // namespace

std::string explain_json(const Explanation& e, const knobs& k, const std::string& repeat) {
  const bool known = e.interval && e.interval->known();
  const Json json = {{"schema", "racebeam-explain"},
                     {"version", 1},
                     {"scene", e.show.name()},
                     {"knobs", knobs_json(k)},
                     {"frame", e.story.frame},
                     {"column", e.column},
                     {"row", e.row()},
                     {"line", e.story.y},
                     {"pixel", e.fate == PixelFate::Column0 ? Json() : Json(e.pixel())},
                     {"fate", fate_name(e.fate)},
                     {"why_unknown", e.why_unknown()},
                     {"colour", colour_json(e)},
                     {"shown_clock", e.shown().clock},
                     {"known_clock", known ? Json(e.interval->clock) : Json()},
                     {"slack", known ? Json(e.slack()) : Json()},
                     {"tracer_begin", e.story.tracer_begin},
                     {"interval", interval_json(e)},
                     {"trace", trace_command(e, repeat)}};
  return json.dump(2) + "\n";
}

}  // namespace racebeam
