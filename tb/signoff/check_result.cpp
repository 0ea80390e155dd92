// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/check_result.h"

namespace racebeam {

namespace {

constexpr const char* Verdicts[] = {"good", "bad", "undecided"};

}  // namespace

nlohmann::ordered_json to_json(const CheckResult& result) {
  return {{"engine", result.engine},   {"unit", result.unit},
          {"check", result.check},     {"verdict", Verdicts[result.verdict]},
          {"summary", result.summary}, {"faults", result.faults},
          {"detail", result.detail},   {"seconds", result.seconds}};
}

CheckResult check_result_of(const nlohmann::ordered_json& json) {
  CheckResult result;
  result.engine = json.at("engine");
  result.unit = json.at("unit");
  result.check = json.at("check");
  const std::string verdict = json.at("verdict");
  result.verdict = verdict == Verdicts[CheckResult::Good]  ? CheckResult::Good
                   : verdict == Verdicts[CheckResult::Bad] ? CheckResult::Bad
                                                           : CheckResult::Undecided;
  result.summary = json.at("summary");
  result.faults = json.at("faults").get<std::vector<std::string>>();
  result.detail = json.at("detail");
  result.seconds = json.at("seconds");
  return result;
}

}  // namespace racebeam
