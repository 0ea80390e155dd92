// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/lint.h"

#include <set>
#include <sstream>

#include "tb/base/counted.h"
#include "tb/verilate/run_tool.h"
#include "tb/verilate/verilator.h"

namespace racebeam {

namespace {

constexpr std::size_t Told = 20;  // warnings

bool is_warning(const std::string& line) {
  return line.rfind("%Warning-", 0) == 0 || line.rfind("%Error", 0) == 0;
}

}  // namespace

CheckResult sign_off_lint(const SignoffUnit& unit, const SignoffOptions&) {
  CheckResult result;
  result.unit = unit.dut.unit;
  result.check = "lint";
  ToolRun run{{"verilator", "--lint-only", "-Wall", "--top-module", unit.sources.top}, "", {}, {}};
  if (!unit.file.empty()) run.words.push_back("-Wno-DECLFILENAME");  // it has the user's name
  for (const std::string& word : source_words(unit.sources)) run.words.push_back(word);
  const ToolResult said = run_tool(run);
  std::set<std::string> warnings;  // one is told once for each instance
  std::istringstream lines(said.said);
  for (std::string line; std::getline(lines, line);)
    if (is_warning(line) && line.rfind("%Error: Exiting", 0) != 0) warnings.insert(line);
  for (const std::string& warning : warnings) {
    if (result.faults.size() == Told) {
      result.faults.push_back("and more: " + std::to_string(warnings.size() - Told));
      break;
    }
    result.faults.push_back(warning +
                            "; mend it, or say in a comment why it is right and lint_off it there");
  }
  if (!said.good && warnings.empty())
    result.faults.push_back("verilator says no more than: " + said.said);
  result.verdict = result.faults.empty() ? CheckResult::Good : CheckResult::Bad;
  result.summary = result.faults.empty()
                       ? "no warning"
                       : counted(std::max<std::size_t>(1, warnings.size()), "warning");
  result.detail = {{"warnings", warnings.size()}};
  return result;
}

}  // namespace racebeam
