// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/always_zero.h"

#include <fmt/format.h>

#include <string>

#include "sc/swap/rtl_library.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/cache_folder.h"
#include "tb/verilate/run_tool.h"

namespace racebeam {

namespace {

constexpr int Conflicts = 10000;  // at a gate

std::vector<bool> bits_of(const std::string& text) {
  std::vector<bool> bits;
  for (const char c : text.substr(0, text.find('#')))
    if (c == '0' || c == '1') bits.push_back(c == '1');
  return bits;
}

}  // namespace

ZeroAnswer always_zero(const AndCircuit& circuit, std::chrono::seconds limit) {
  if (circuit.outputs.size() != 1 || !circuit.next.empty())
    throw RtlError("&cec -m looks at one output of a circuit without registers");
  const WorkFolder work;
  work.write("circuit.aig", aiger_of(circuit));
  const std::string commands =
      fmt::format("read_aiger circuit.aig; strash; &get; &cec -m -C {} -T {}; write_cex -a inputs",
                  Conflicts, limit.count());
  ZeroAnswer answer;
  run_tools({{{"yosys-abc", "-q", commands}, work.path(), {}, {}}}, 1,
            limit + std::chrono::seconds(1), [&](std::size_t, const ToolResult& end) {
              answer.zero = end.said.find("Networks are equivalent") != std::string::npos;
              if (end.said.find("NOT EQUIVALENT") != std::string::npos)
                answer.inputs = bits_of(whole_file(work.file("inputs")));
            });
  if (answer.inputs.size() != circuit.inputs) answer.inputs.clear();
  return answer;
}

}  // namespace racebeam
