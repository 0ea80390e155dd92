// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/always_zero.h"

#include <string>

#include "sc/swap/rtl_library.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace {

// Both copies of a multiplier become one in a tenth of a second; &cec takes half a minute for that.
constexpr const char* Commands =
    "read_aiger circuit.aig; strash; ifraig; iprove; write_cex -a inputs";

std::vector<bool> bits_of(const std::string& text) {
  std::vector<bool> bits;
  for (const char c : text.substr(0, text.find('#')))
    if (c == '0' || c == '1') bits.push_back(c == '1');
  return bits;
}

}  // namespace

ZeroAnswer always_zero(const AndCircuit& circuit, std::chrono::seconds limit) {
  if (circuit.outputs.size() != 1 || !circuit.next.empty())
    throw RtlError("iprove looks at one output of a circuit without registers");
  if (circuit.outputs[0] == False) return {true, {}};
  const WorkFolder work;
  work.write("circuit.aig", aiger_of(cone_of(circuit, circuit.outputs)));
  ZeroAnswer answer;
  const std::string said =
      run_tool(
          {{"yosys-abc", "-q", Commands}, work.path(), {}, {}, limit + std::chrono::seconds(1)})
          .said;
  answer.zero = said.find("UNSATISFIABLE") != std::string::npos;
  if (!answer.zero && said.find("SATISFIABLE") != std::string::npos)
    answer.inputs = bits_of(whole_file(work.file("inputs")));
  if (answer.inputs.size() != circuit.inputs) answer.inputs.clear();
  return answer;
}

}  // namespace racebeam
