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
constexpr const char* Thorough = "ifraig; iprove";
constexpr const char* AtOnce = "sat -C 2000";
constexpr std::chrono::seconds AtOnceTime{5};  // at most

std::vector<bool> bits_of(const std::string& text) {
  std::vector<bool> bits;
  for (const char c : text.substr(0, text.find('#')))
    if (c == '0' || c == '1') bits.push_back(c == '1');
  return bits;
}

ZeroAnswer asked(const AndCircuit& circuit, const std::string& command,
                 std::chrono::seconds limit) {
  if (circuit.outputs.size() != 1 || !circuit.next.empty())
    throw RtlError("iprove looks at one output of a circuit without registers");
  if (circuit.outputs[0] == False) return {true, {}};
  const WorkFolder work;
  work.write("circuit.aig", aiger_of(cone_of(circuit, circuit.outputs)));
  const std::string all = "read_aiger circuit.aig; strash; " + command + "; write_cex -a inputs";
  const std::string said =
      run_tool({{"yosys-abc", "-q", all}, work.path(), {}, {}, limit + std::chrono::seconds(1)})
          .said;
  ZeroAnswer answer;
  answer.zero = said.find("UNSATISFIABLE") != std::string::npos;
  if (!answer.zero && said.find("SATISFIABLE") != std::string::npos)
    answer.inputs = bits_of(whole_file(work.file("inputs")));
  if (answer.inputs.size() != circuit.inputs) answer.inputs.clear();
  return answer;
}

}  // namespace

ZeroAnswer zero_at_once(const AndCircuit& circuit) { return asked(circuit, AtOnce, AtOnceTime); }

ZeroAnswer always_zero(const AndCircuit& circuit, std::chrono::seconds limit) {
  const ZeroAnswer soon = zero_at_once(circuit);
  return soon.zero || !soon.inputs.empty() ? soon : asked(circuit, Thorough, limit);
}

}  // namespace racebeam
