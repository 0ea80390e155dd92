// What each cell of sky130_fd_sc_hd does, written once more for the test of the cells.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tb/tt/sky130_cells.h"

namespace racebeam::sky130 {

/// Inputs by position; a flip-flop or latch has its state, and the inputs before.
struct Pins {
  const std::vector<std::string>& names;
  unsigned now, before;
  bool q;

  bool at(std::size_t input) const { return now >> input & 1; }
  bool operator()(const char* name) const {
    for (std::size_t input = 0; input < names.size(); ++input)
      if (names[input] == name) return at(input);
    ADD_FAILURE() << "no input " << name;
    return false;
  }
  bool has(const char* name) const {
    return std::find(names.begin(), names.end(), name) != names.end();
  }
  bool rose(const char* name) const { return (*this)(name) && !Pins{names, before, 0, q}(name); }
  bool fell(const char* name) const { return !(*this)(name) && Pins{names, before, 0, q}(name); }
  int ones() const { return __builtin_popcount(now & ((1u << names.size()) - 1)); }
};

/// A cell without state: its outputs, the first the lowest.
using Function = std::function<unsigned(const Pins&)>;

using P = const Pins&;
inline const std::map<std::string, std::pair<const char*, Function>>& functions() {
  static const std::map<std::string, std::pair<const char*, Function>> all = {
      {"and2", {"X A B", [](P p) -> unsigned { return p.ones() == 2; }}},
      {"and3", {"X A B C", [](P p) -> unsigned { return p.ones() == 3; }}},
      {"and4", {"X A B C D", [](P p) -> unsigned { return p.ones() == 4; }}},
      {"and2b", {"X A_N B", [](P p) -> unsigned { return p.now == 2; }}},
      {"and3b", {"X A_N B C", [](P p) -> unsigned { return p.now == 6; }}},
      {"and4b", {"X A_N B C D", [](P p) -> unsigned { return p.now == 14; }}},
      {"and4bb", {"X A_N B_N C D", [](P p) -> unsigned { return p.now == 12; }}},
      {"nand2", {"Y A B", [](P p) -> unsigned { return p.ones() < 2; }}},
      {"nand3", {"Y A B C", [](P p) -> unsigned { return p.ones() < 3; }}},
      {"nand4", {"Y A B C D", [](P p) -> unsigned { return p.ones() < 4; }}},
      {"nand2b", {"Y A_N B", [](P p) -> unsigned { return p.now != 2; }}},
      {"nand3b", {"Y A_N B C", [](P p) -> unsigned { return p.now != 6; }}},
      {"nand4b", {"Y A_N B C D", [](P p) -> unsigned { return p.now != 14; }}},
      {"nand4bb", {"Y A_N B_N C D", [](P p) -> unsigned { return p.now != 12; }}},
      {"or2", {"X A B", [](P p) -> unsigned { return p.ones() > 0; }}},
      {"or3", {"X A B C", [](P p) -> unsigned { return p.ones() > 0; }}},
      {"or4", {"X A B C D", [](P p) -> unsigned { return p.ones() > 0; }}},
      {"or2b", {"X A B_N", [](P p) -> unsigned { return p.now != 2; }}},
      {"or3b", {"X A B C_N", [](P p) -> unsigned { return p.now != 4; }}},
      {"or4b", {"X A B C D_N", [](P p) -> unsigned { return p.now != 8; }}},
      {"or4bb", {"X A B C_N D_N", [](P p) -> unsigned { return p.now != 12; }}},
      {"nor2", {"Y A B", [](P p) -> unsigned { return p.now == 0; }}},
      {"nor3", {"Y A B C", [](P p) -> unsigned { return p.now == 0; }}},
      {"nor4", {"Y A B C D", [](P p) -> unsigned { return p.now == 0; }}},
      {"nor2b", {"Y A B_N", [](P p) -> unsigned { return p.now == 2; }}},
      {"nor3b", {"Y A B C_N", [](P p) -> unsigned { return p.now == 4; }}},
      {"nor4b", {"Y A B C D_N", [](P p) -> unsigned { return p.now == 8; }}},
      {"nor4bb", {"Y A B C_N D_N", [](P p) -> unsigned { return p.now == 12; }}},
      {"xor2", {"X A B", [](P p) -> unsigned { return p.ones() % 2; }}},
      {"xor3", {"X A B C", [](P p) -> unsigned { return p.ones() % 2; }}},
      {"xnor2", {"Y A B", [](P p) -> unsigned { return p.ones() % 2 == 0; }}},
      {"xnor3", {"X A B C", [](P p) -> unsigned { return p.ones() % 2 == 0; }}},
      {"maj3", {"X A B C", [](P p) -> unsigned { return p.ones() >= 2; }}},
      {"mux2", {"X A0 A1 S", [](P p) -> unsigned { return p.at(p.at(2)); }}},
      {"mux2i", {"Y A0 A1 S", [](P p) -> unsigned { return !p.at(p.at(2)); }}},
      {"mux4", {"X A0 A1 A2 A3 S0 S1", [](P p) -> unsigned { return p.at(p.now >> 4); }}},
      {"ha", {"COUT SUM A B", [](P p) -> unsigned { return p.ones() / 2 | p.ones() % 2 << 1; }}},
      {"fa",
       {"COUT SUM A B CIN", [](P p) -> unsigned { return p.ones() / 2 | p.ones() % 2 << 1; }}},
      {"fah",
       {"COUT SUM A B CI", [](P p) -> unsigned { return p.ones() / 2 | p.ones() % 2 << 1; }}},
      {"fahcin",
       {"COUT SUM A B CIN",
        [](P p) -> unsigned {
          const int sum = p.at(0) + p.at(1) + !p.at(2);
          return sum / 2 | sum % 2 << 1;
        }}},
      {"fahcon",
       {"COUT_N SUM A B CI", [](P p) -> unsigned { return (p.ones() < 2) | p.ones() % 2 << 1; }}},
      {"conb", {"HI LO", [](P p) -> unsigned { return 1 + 0 * p.now; }}},
      {"a21o", {"X A1 A2 B1", [](P p) -> unsigned { return p.now % 4 == 3 || p.at(2); }}},
      {"a22o", {"X A1 A2 B1 B2", [](P p) -> unsigned { return p.now % 4 == 3 || p.now / 4 == 3; }}},
      {"a31o", {"X A1 A2 A3 B1", [](P p) -> unsigned { return p.now % 8 == 7 || p.at(3); }}},
      {"a32o",
       {"X A1 A2 A3 B1 B2", [](P p) -> unsigned { return p.now % 8 == 7 || p.now / 8 == 3; }}},
      {"a41o", {"X A1 A2 A3 A4 B1", [](P p) -> unsigned { return p.now >= 15; }}},
      {"a211o", {"X A1 A2 B1 C1", [](P p) -> unsigned { return p.now >= 3; }}},
      {"a221o",
       {"X A1 A2 B1 B2 C1",
        [](P p) -> unsigned { return p.now % 4 == 3 || p.now / 4 % 4 == 3 || p.at(4); }}},
      {"a311o", {"X A1 A2 A3 B1 C1", [](P p) -> unsigned { return p.now >= 7; }}},
      {"a2111o", {"X A1 A2 B1 C1 D1", [](P p) -> unsigned { return p.now >= 3; }}},
      {"a222oi",
       {"Y A1 A2 B1 B2 C1 C2",
        [](P p) -> unsigned {
          return !(p.now % 4 == 3 || p.now / 4 % 4 == 3 || p.now / 16 == 3);
        }}},
      {"a21bo", {"X A1 A2 B1_N", [](P p) -> unsigned { return p.now % 4 == 3 || !p.at(2); }}},
      {"a2bb2o",
       {"X A1_N A2_N B1 B2", [](P p) -> unsigned { return p.now % 4 == 0 || p.now / 4 == 3; }}},
      {"o21a", {"X A1 A2 B1", [](P p) -> unsigned { return p.now >= 5; }}},
      {"o22a", {"X A1 A2 B1 B2", [](P p) -> unsigned { return p.now % 4 && p.now / 4; }}},
      {"o31a", {"X A1 A2 A3 B1", [](P p) -> unsigned { return p.now >= 9; }}},
      {"o32a", {"X A1 A2 A3 B1 B2", [](P p) -> unsigned { return p.now % 8 && p.now / 8; }}},
      {"o41a", {"X A1 A2 A3 A4 B1", [](P p) -> unsigned { return p.now >= 17; }}},
      {"o211a", {"X A1 A2 B1 C1", [](P p) -> unsigned { return p.now >= 13; }}},
      {"o221a",
       {"X A1 A2 B1 B2 C1", [](P p) -> unsigned { return p.now % 4 && p.now / 4 % 4 && p.at(4); }}},
      {"o311a", {"X A1 A2 A3 B1 C1", [](P p) -> unsigned { return p.now >= 25; }}},
      {"o2111a", {"X A1 A2 B1 C1 D1", [](P p) -> unsigned { return p.now >= 29; }}},
      {"o21ba", {"X A1 A2 B1_N", [](P p) -> unsigned { return p.now >= 1 && p.now <= 3; }}},
      {"o2bb1a", {"X A1_N A2_N B1", [](P p) -> unsigned { return p.now >= 4 && p.now <= 6; }}},
      {"o2bb2a",
       {"X A1_N A2_N B1 B2", [](P p) -> unsigned { return p.now % 4 != 3 && p.now / 4; }}},
      {"flip-flop",
       {"",
        [](P p) -> unsigned {
          if (p.has("RESET_B") && !p("RESET_B")) return 0;
          if (p.has("SET_B") && !p("SET_B")) return 1;
          if (p.has("CLK") ? !p.rose("CLK") : !p.fell("CLK_N")) return p.q;
          if (p.has("SCE") && p("SCE")) return p("SCD");
          return p.has("DE") && !p("DE") ? p.q : p("D");
        }}},
      {"latch",
       {"",
        [](P p) -> unsigned {
          if (p.has("RESET_B") && !p("RESET_B")) return 0;
          const bool open = p.has("GATE") ? p("GATE") : !p("GATE_N");
          return open ? p("D") : p.q;
        }}},
      {"clock gate",
       {"",
        [](P p) -> unsigned { return p("CLK") ? p.q : p("GATE") || (p.has("SCE") && p("SCE")); }}},
  };
  return all;
}

inline std::string family(const std::string& cell) {
  if (cell.find("dlclkp") != std::string::npos) return "clock gate";
  if (cell.rfind("dlx", 0) == 0 || cell.rfind("dlr", 0) == 0) return "latch";
  const std::size_t at = cell.find("df");
  return at != std::string::npos && at <= 2 ? "flip-flop" : "";
}

/// What the outputs of a cell must be; the state goes along.
inline unsigned expected(const Sky130Cell& cell, unsigned now, unsigned before, bool& q) {
  const auto mask = (1u << cell.inputs.size()) - 1;
  const Pins pins{cell.inputs, now & mask, before & mask, q};
  if (const std::string kind = family(cell.name); !kind.empty()) {
    q = functions().at(kind).second(pins) != 0;
    if (kind == "clock gate") return q && pins("CLK");
    return q | (cell.outputs.size() == 2 ? !q << 1 : 0);
  }
  if (cell.inputs == std::vector<std::string>{"A"}) return pins.at(0) != (cell.outputs[0] == "Y");
  if (const auto at = functions().find(cell.name); at != functions().end())
    return at->second.second(pins);
  // An inverting gate is the other, inverted.
  EXPECT_EQ(cell.name.back(), 'i') << cell.name;
  return !functions().at(cell.name.substr(0, cell.name.size() - 1)).second(pins);
}

}  // namespace racebeam::sky130
