// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/sky130_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace racebeam {

namespace {

using Words = std::vector<std::string>;

constexpr int Strengths[] = {0, 1, 2, 3, 4, 6, 8, 12, 16, 20, 24, 32};

std::string joined(const Words& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

bool is_inverted(const std::string& pin) {
  return pin.size() > 2 && pin.compare(pin.size() - 2, 2, "_N") == 0;
}

/// Pins, those that end in _N inverted, with an operator between them: "(~A_N & B)".
std::string term(const Words& pins, const std::string& operation) {
  Words terms;
  for (const std::string& pin : pins) terms.push_back((is_inverted(pin) ? "~" : "") + pin);
  return "(" + joined(terms, " " + operation + " ") + ")";
}

Sky130Cell gate(const std::string& name, const std::string& output, const Words& inputs,
                const std::string& function) {
  return {name, {output}, inputs, fmt::format("assign {} = {};", output, function)};
}

/// and2 to nor4bb: an AND inverts its first pins, an OR its last ones.
void add_plain_gates(std::vector<Sky130Cell>& cells) {
  for (const bool is_and : {true, false})
    for (const bool inverts : {false, true})
      for (int size = 2; size <= 4; ++size)
        for (int bars = 0; bars <= (size == 4 ? 2 : 1); ++bars) {
          Words pins;
          for (int pin = 0; pin < size; ++pin) {
            const bool bar = is_and ? pin < bars : pin >= size - bars;
            pins.push_back(std::string(1, static_cast<char>('A' + pin)) + (bar ? "_N" : ""));
          }
          const std::string name = (inverts ? "n" : "") + std::string(is_and ? "and" : "or") +
                                   std::to_string(size) + std::string(bars, 'b');
          cells.push_back(gate(name, inverts ? "Y" : "X", pins,
                               (inverts ? "~" : "") + term(pins, is_and ? "&" : "|")));
        }
}

/// a21o to o41ai: an inner gate for each digit, of as many pins, and an outer one. A name ends with
/// the outer gate, inverting with i; bb after the first digit inverts its pins, b at the end those
/// of the last.
void add_two_level_gates(std::vector<Sky130Cell>& cells) {
  for (const char* name :
       {"a21o",    "a21oi",  "a22o",    "a22oi",  "a31o",    "a31oi",  "a32o",    "a32oi",
        "a41o",    "a41oi",  "a211o",   "a211oi", "a221o",   "a221oi", "a222oi",  "a311o",
        "a311oi",  "a2111o", "a2111oi", "a21bo",  "a21boi",  "a2bb2o", "a2bb2oi", "o21a",
        "o21ai",   "o22a",   "o22ai",   "o31a",   "o31ai",   "o32a",   "o32ai",   "o41a",
        "o41ai",   "o211a",  "o211ai",  "o221a",  "o221ai",  "o311a",  "o311ai",  "o2111a",
        "o2111ai", "o21ba",  "o21bai",  "o2bb1a", "o2bb1ai", "o2bb2a", "o2bb2ai"}) {
    const std::string text = name;
    const bool inner_and = text[0] == 'a', inverts = text.back() == 'i';
    std::vector<Words> groups;
    const std::size_t end = text.find(inner_and ? 'o' : 'a', 1);
    for (std::size_t at = 1; at < end; ++at) {
      const char letter = static_cast<char>('A' + groups.size());
      if (std::isdigit(static_cast<unsigned char>(text[at])))
        for (int pin = (groups.emplace_back(), 1); pin <= text[at] - '0'; ++pin)
          groups.back().push_back(fmt::format("{}{}", letter, pin));
      else if (text[at - 1] != 'b')  // of two it is the first
        for (std::string& pin : groups.back()) pin += "_N";
    }
    Words pins, terms;
    for (const Words& group : groups) {
      pins.insert(pins.end(), group.begin(), group.end());
      terms.push_back(term(group, inner_and ? "&" : "|"));
    }
    cells.push_back(gate(name, inverts ? "Y" : "X", pins,
                         (inverts ? "~(" : "(") + joined(terms, inner_and ? " | " : " & ") + ")"));
  }
}

void add_buffers(std::vector<Sky130Cell>& cells) {
  for (const char* name :
       {"buf", "clkbuf", "bufbuf", "probe_p", "probec_p", "clkdlybuf4s15", "clkdlybuf4s18",
        "clkdlybuf4s25", "clkdlybuf4s50", "dlygate4sd1", "dlygate4sd2", "dlygate4sd3",
        "dlymetal6s2s", "dlymetal6s4s", "dlymetal6s6s"})
    cells.push_back(gate(name, "X", {"A"}, "A"));
  for (const char* name : {"inv", "clkinv", "clkinvlp", "bufinv"})
    cells.push_back(gate(name, "Y", {"A"}, "~A"));
}

void add_arithmetic(std::vector<Sky130Cell>& cells) {
  const Words three = {"A", "B", "C"};
  const std::string majority = "(A & B) | (C & (A | B))";
  cells.push_back(gate("xor2", "X", {"A", "B"}, "A ^ B"));
  cells.push_back(gate("xnor2", "Y", {"A", "B"}, "~(A ^ B)"));
  cells.push_back(gate("xor3", "X", three, "A ^ B ^ C"));
  cells.push_back(gate("xnor3", "X", three, "~(A ^ B ^ C)"));
  cells.push_back(gate("maj3", "X", three, majority));
  cells.push_back(gate("mux2", "X", {"A0", "A1", "S"}, "S ? A1 : A0"));
  cells.push_back(gate("mux2i", "Y", {"A0", "A1", "S"}, "~(S ? A1 : A0)"));
  cells.push_back(gate("mux4", "X", {"A0", "A1", "A2", "A3", "S0", "S1"},
                       "S1 ? (S0 ? A3 : A2) : (S0 ? A1 : A0)"));
  cells.push_back({"ha", {"COUT", "SUM"}, {"A", "B"}, "assign {COUT, SUM} = A + B;"});
  cells.push_back({"fa", {"COUT", "SUM"}, {"A", "B", "CIN"}, "assign {COUT, SUM} = A + B + CIN;"});
  cells.push_back({"fah", {"COUT", "SUM"}, {"A", "B", "CI"}, "assign {COUT, SUM} = A + B + CI;"});
  cells.push_back(
      {"fahcin", {"COUT", "SUM"}, {"A", "B", "CIN"}, "assign {COUT, SUM} = A + B + {1'b0, ~CIN};"});
  cells.push_back({"fahcon",
                   {"COUT_N", "SUM"},
                   {"A", "B", "CI"},
                   "assign SUM = A ^ B ^ CI; assign COUT_N = ~((A & B) | (CI & (A | B)));"});
}

/// A flip-flop: Q and perhaps Q_N; `clock` CLK, or CLK_N of the falling edge.
void add_flip_flop(std::vector<Sky130Cell>& cells, const std::string& name, bool both,
                   const std::string& clock, const Words& pins, const std::string& next) {
  std::string events = is_inverted(clock) ? "negedge CLK_N" : "posedge CLK", ways, wires;
  const auto has = [&](const char* pin) {
    return std::find(pins.begin(), pins.end(), pin) != pins.end();
  };
  // The reset wins; a set that is still there when it ends counts from then on.
  const bool two = has("RESET_B") && has("SET_B");
  const std::string set = two ? "set_n" : "SET_B";
  if (two) wires = "wire set_n = SET_B | ~RESET_B; ";
  if (has("RESET_B")) {
    events += " or negedge RESET_B";
    ways += "if (~RESET_B) q <= 1'b0; else ";
  }
  if (has("SET_B")) {
    events += " or negedge " + set;
    ways += "if (~" + set + ") q <= 1'b1; else ";
  }
  cells.push_back({name, both ? Words{"Q", "Q_N"} : Words{"Q"}, pins,
                   fmt::format("reg q; {}always @({}) {}q <= {}; assign Q = q;{}", wires, events,
                               ways, next, both ? " assign Q_N = ~q;" : "")});
}

void add_flip_flops(std::vector<Sky130Cell>& cells) {
  const std::string scan = "SCE ? SCD : D", enable = "DE ? D : q";
  for (const bool both : {false, true}) {
    const std::string p = both ? "bp" : "tp", x = both ? "xbp" : "xtp";
    add_flip_flop(cells, "df" + x, both, "CLK", {"CLK", "D"}, "D");
    add_flip_flop(cells, "dfr" + p, both, "CLK", {"CLK", "D", "RESET_B"}, "D");
    add_flip_flop(cells, "dfs" + p, both, "CLK", {"CLK", "D", "SET_B"}, "D");
    add_flip_flop(cells, "edf" + x, both, "CLK", {"CLK", "D", "DE"}, enable);
    add_flip_flop(cells, "sdf" + x, both, "CLK", {"CLK", "D", "SCD", "SCE"}, scan);
    add_flip_flop(cells, "sdfr" + p, both, "CLK", {"CLK", "D", "SCD", "SCE", "RESET_B"}, scan);
    add_flip_flop(cells, "sdfs" + p, both, "CLK", {"CLK", "D", "SCD", "SCE", "SET_B"}, scan);
    add_flip_flop(cells, "sedf" + x, both, "CLK", {"CLK", "D", "DE", "SCD", "SCE"},
                  "SCE ? SCD : " + enable);
  }
  add_flip_flop(cells, "dfrtn", false, "CLK_N", {"CLK_N", "D", "RESET_B"}, "D");
  add_flip_flop(cells, "sdfrtn", false, "CLK_N", {"CLK_N", "D", "SCD", "SCE", "RESET_B"}, scan);
  for (const char* clock : {"CLK", "CLK_N"}) {
    const std::string end = is_inverted(clock) ? "n" : "p";
    add_flip_flop(cells, "dfbb" + end, true, clock, {"D", clock, "SET_B", "RESET_B"}, "D");
    add_flip_flop(cells, "sdfbb" + end, true, clock, {"D", "SCD", "SCE", clock, "SET_B", "RESET_B"},
                  scan);
  }
}

void add_latches(std::vector<Sky130Cell>& cells) {
  for (const bool reset : {false, true})
    for (const bool both : {false, true})
      for (const bool low : {false, true}) {
        const std::string gate = low ? "GATE_N" : "GATE";
        Words pins = {"D", gate};
        if (reset) pins.insert(pins.begin(), "RESET_B");
        cells.push_back(
            {fmt::format("dl{}{}{}", reset ? 'r' : 'x', both ? 'b' : 't', low ? 'n' : 'p'),
             both ? Words{"Q", "Q_N"} : Words{"Q"}, pins,
             fmt::format("reg q; always @* {}if ({}{}) q = D; assign Q = q;{}",
                         reset ? "if (~RESET_B) q = 1'b0; else " : "", low ? "~" : "", gate,
                         both ? " assign Q_N = ~q;" : "")});
      }
  const std::string gated = "reg q; always @* if (~CLK) q = {}; assign GCLK = CLK & q;";
  cells.push_back({"dlclkp", {"GCLK"}, {"GATE", "CLK"}, fmt::format(gated, "GATE")});
  cells.push_back({"sdlclkp", {"GCLK"}, {"SCE", "GATE", "CLK"}, fmt::format(gated, "GATE | SCE")});
}

void add_cells_without_logic(std::vector<Sky130Cell>& cells) {
  cells.push_back({"conb", {"HI", "LO"}, {}, "assign HI = 1'b1; assign LO = 1'b0;"});
  cells.push_back({"diode", {}, {"DIODE"}, ""});
  for (const char* name : {"decap", "fill", "tap", "tapvgnd", "tapvgnd2", "tapvpwrvgnd"})
    cells.push_back({name, {}, {}, ""});
}

}  // namespace

const std::vector<Sky130Cell>& sky130_cells() {
  static const std::vector<Sky130Cell> cells = [] {
    std::vector<Sky130Cell> all;
    add_plain_gates(all);
    add_two_level_gates(all);
    add_buffers(all);
    add_arithmetic(all);
    add_flip_flops(all);
    add_latches(all);
    add_cells_without_logic(all);
    return all;
  }();
  return cells;
}

std::string sky130_module_name(const std::string& cell, int strength) {
  return fmt::format("sky130_fd_sc_hd__{}_{}", cell, strength);
}

std::string sky130_library() {
  std::string text;
  for (const Sky130Cell& cell : sky130_cells()) {
    Words ports = cell.outputs;
    ports.insert(ports.end(), cell.inputs.begin(), cell.inputs.end());
    for (const char* pin : {"VPWR", "VGND", "VPB", "VNB"}) ports.emplace_back(pin);
    std::string pins;
    if (!cell.outputs.empty()) pins += "output " + joined(cell.outputs, ", ") + "; ";
    if (!cell.inputs.empty()) pins += "input " + joined(cell.inputs, ", ") + "; ";
    for (const int strength : Strengths)
      text += fmt::format("module {} ({}); {}input VPWR, VGND, VPB, VNB; {} endmodule\n",
                          sky130_module_name(cell.name, strength), joined(ports, ", "), pins,
                          cell.body);
  }
  return text;
}

}  // namespace racebeam
