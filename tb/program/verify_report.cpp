// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/verify_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/twin/lockstep_report.h"

namespace racebeam {

using Json = nlohmann::ordered_json;

namespace {

constexpr const char* Row = "{:<18} {:<8} {:>12} {:>7} {:>10} {:>11}\n";

Json to_json(const ShrunkDifference& d) {
  return {{"clocks", d.clocks}, {"moving", d.moving}, {"expected", d.expected}, {"got", d.got},
          {"plays", d.plays},   {"stream", d.stream}, {"repeat", d.repeat}};
}

Json to_json(const FirstDifference& d) {
  Json json = {{"port", d.port}, {"clock", d.clock}, {"expected", d.expected}, {"got", d.got}};
  if (d.place)
    json["place"] = {{"frame", d.place->frame}, {"line", d.place->line}, {"clock", d.place->clock}};
  json["text"] = d.text;
  if (d.shrunk) json["shrunk"] = to_json(*d.shrunk);
  return json;
}

std::optional<ShrunkDifference> shrunk_of(const Json& difference) {
  if (!difference.contains("shrunk")) return std::nullopt;
  const Json& d = difference["shrunk"];
  return ShrunkDifference{d["clocks"], d["moving"], d["expected"], d["got"],
                          d["plays"],  d["stream"], d["repeat"]};
}

}  // namespace

Json to_json(const UnitVerdict& v) {
  return {{"unit", v.unit},
          {"traffic", v.traffic},
          {"clocks", v.clocks},
          {"seconds", v.seconds},
          {"masked", v.masked},
          {"differences", v.differences},
          {"first", v.first ? to_json(*v.first) : Json()},
          {"fault", v.fault.empty() ? Json() : Json(v.fault)}};
}

UnitVerdict verdict_of(const Json& json) {
  UnitVerdict verdict{json["unit"],
                      json["traffic"],
                      json["clocks"],
                      json["masked"],
                      json["differences"],
                      json["seconds"],
                      {},
                      json["fault"].is_null() ? "" : json["fault"]};
  if (const Json& d = json["first"]; !d.is_null()) {
    verdict.first = FirstDifference{d["port"], d["clock"], d["expected"], d["got"],
                                    {},        d["text"],  shrunk_of(d)};
    if (d.contains("place"))
      verdict.first->place =
          BeamPlace{d["place"]["frame"], d["place"]["line"], d["place"]["clock"]};
  }
  return verdict;
}

std::string verdict_table(const std::vector<UnitVerdict>& verdicts) {
  std::string text =
      fmt::format(Row, "unit", "traffic", "clocks", "masked", "differ", "M clocks/s");
  for (const UnitVerdict& v : verdicts) {
    const double speed = v.seconds > 0 ? static_cast<double>(v.clocks) / v.seconds / 1e6 : 0;
    const std::string row = fmt::format(Row, v.unit, v.traffic, v.clocks, v.masked, v.differences,
                                        fmt::format("{:.2f}", speed));
    text += v.fault.empty() ? row : row.substr(0, row.size() - 1) + "  " + v.fault + "\n";
  }
  return text;
}

int tell_verdicts(const std::vector<UnitVerdict>& verdicts, long long seed, bool as_json) {
  bool differs = false, faulty = false;
  Json json = Json::array();
  for (const UnitVerdict& verdict : verdicts) {
    differs |= verdict.differences > 0;
    faulty |= !verdict.fault.empty();
    json.push_back(to_json(verdict));
  }
  if (as_json) {
    print(Json{{"schema", "racebeam-verify"}, {"version", 1}, {"seed", seed}, {"units", json}}.dump(
              2) +
          "\n");
  } else {
    print(verdict_table(verdicts));
  }
  for (const UnitVerdict& verdict : verdicts) {
    if (verdict.first) tell_difference(verdict.first->text);
    if (!verdict.fault.empty()) tell(verdict.unit + ": " + verdict.fault);
  }
  if (interrupted()) return ExitInterrupted;
  if (faulty) return ExitUsage;
  return differs ? ExitDifference : ExitGood;
}

}  // namespace racebeam
