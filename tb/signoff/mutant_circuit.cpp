// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_circuit.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "tb/signoff/mutant_netlist.h"

namespace racebeam {

MutantCircuit::MutantCircuit(const std::string& aiger, const std::string& map)
    : named_{read_circuit(aiger), {}, {}, {}} {
  std::map<std::string, RegisterWord> words;
  std::istringstream lines(map);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    std::string kind, name;
    std::size_t at, bit;
    if (!(fields >> kind >> at >> bit >> name)) continue;
    if (kind == "latch") {
      words[name].push_back(at);
      // Names of yosys, "$auto$...", are not those of another circuit.
      if (name[0] != '$') named_.registers[fmt::format("{} {}", name, bit)] = at;
    }
    if (kind != "input") continue;
    if (name != MutantInput) {
      named_.inputs[fmt::format("{} {}", name, bit)] = at;
      continue;
    }
    choice_.resize(std::max(choice_.size(), bit + 1));
    choice_[bit] = at;
  }
  for (const auto& [name, word] : words) named_.words.push_back(word);
}

AndCircuit MutantCircuit::with(int number) const {
  std::map<std::size_t, bool> constants;
  for (std::size_t bit = 0; bit < choice_.size(); ++bit)
    constants[choice_[bit]] = ((number >> bit) & 1) != 0;
  return with_constant_inputs(named_.circuit, constants);
}

NamedCircuit MutantCircuit::named() const {
  return {with(0), named_.inputs, named_.words, named_.registers};
}

}  // namespace racebeam
