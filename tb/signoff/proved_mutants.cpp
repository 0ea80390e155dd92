// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/proved_mutants.h"

#include <fmt/format.h>

#include <fstream>

#include "tb/base/project_folder.h"
#include "tb/scene/engines.h"

namespace racebeam {

namespace {

constexpr const char* Circuit = "circuit ";

}  // namespace

std::string known_proofs(const UnitUnderTest& dut) {
  return fmt::format("{}/tb/signoff/proved/{}/{}.proved", project_folder(), engine_of(dut.k).name,
                     dut.unit);
}

MutantNames read_proved(const std::string& path, const std::string& circuit) {
  std::ifstream file(path);
  MutantNames names;
  bool same = false;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (same) names.insert(line);
    else if (line != Circuit + circuit) return {};
    same = true;
  }
  return names;
}

std::string proved_text(const std::string& unit, const std::string& circuit,
                        const MutantNames& names) {
  std::string text = fmt::format(
      "# Mutants of {0} that yosys-abc has proved equal; racebeam signoff {0} takes its word, but\n"
      "# with --prove-again, or if the circuit is another one.\n{1}{2}\n",
      unit, Circuit, circuit);
  for (const std::string& name : names) text += name + "\n";
  return text;
}

}  // namespace racebeam
