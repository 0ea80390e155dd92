// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/parallel_gates.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <tuple>
#include <unordered_map>

#include "sc/swap/rtl_library.h"

namespace racebeam {

/// Reads BLIF with yosys' own cells, and puts gates in the order of evaluation.
class ParallelGates::Reader {
 public:
  Reader(const std::string& netlist, ParallelGates& to) : text_(netlist), to_(to) {}
  void read() {
    name("$false");  // number 0: what a pin is joined to that a gate does not have
    std::istringstream lines(text_);
    for (std::string line; std::getline(lines, line);) take(line);
    if (!ended_) throw RtlError("the netlist has no end");
    place_ports();
    place_registers();
    place_gates();
  }

 private:
  using Name = std::uint32_t;  // number of a name
  struct Cell {
    Kind kind;
    Name a, b, select, out;
  };

  void take(const std::string& line);
  void take_gate(std::istringstream& words);
  void take_buffer(const std::string& from, const std::string& to);
  void place_ports();
  void place_registers();
  void place_gates();
  void level(std::size_t first);

  Name name(const std::string& text) {
    const auto [at, fresh] = names_.emplace(text, static_cast<Name>(names_.size()));
    if (fresh) nets_.push_back(None);
    return at->second;
  }
  /// One that nothing drives has 0, as for Verilator.
  std::uint32_t net(Name name) const { return nets_[name] == None ? nets_[0] : nets_[name]; }
  std::uint32_t add_net(Word value = 0) {
    to_.values_.push_back(value);
    return static_cast<std::uint32_t>(to_.values_.size() - 1);
  }
  static std::vector<Name> inputs(const Cell& cell) {
    switch (cell.kind) {
      case Kind::Buffer:
      case Kind::Not: return {cell.a};
      case Kind::Mux: return {cell.a, cell.b, cell.select};
      default: return {cell.a, cell.b};
    }
  }

  static constexpr std::uint32_t None = ~std::uint32_t{0};
  const std::string& text_;
  ParallelGates& to_;
  std::unordered_map<std::string, Name> names_;
  std::vector<std::uint32_t> nets_;  // by name
  std::vector<std::string> inputs_, outputs_;
  std::vector<Cell> cells_;
  std::vector<std::pair<Name, Name>> registers_;  // D, Q
  std::set<std::string> clocks_;
  std::unordered_map<Name, std::size_t> driver_;  // the cell of a name
  std::vector<int> levels_;                       // of cells; 0: not known yet
  bool ended_ = false;
};

void ParallelGates::Reader::take(const std::string& line) {
  std::istringstream words(line);
  std::string word;
  if (!(words >> word) || word[0] == '#') return;
  if (word == ".inputs" || word == ".outputs") {
    auto& names = word == ".inputs" ? inputs_ : outputs_;
    while (words >> word) names.push_back(word);
  } else if (word == ".names") {
    std::vector<std::string> nets;
    while (words >> word) nets.push_back(word);
    if (nets.size() == 2) take_buffer(nets[0], nets[1]);
    else if (nets.size() != 1 || nets[0][0] != '$') throw RtlError("unknown line: " + line);
  } else if (word == ".gate") {
    take_gate(words);
  } else if (word == ".end") {
    ended_ = true;
  } else if (word != ".model" && word != "1") {
    throw RtlError("unknown line: " + line);
  }
}

void ParallelGates::Reader::take_buffer(const std::string& from, const std::string& to) {
  cells_.push_back({Kind::Buffer, name(from), 0, 0, name(to)});
}

void ParallelGates::Reader::take_gate(std::istringstream& words) {
  static const std::map<std::string, Kind> Kinds = {
      {"$_NOT_", Kind::Not}, {"$_AND_", Kind::And}, {"$_OR_", Kind::Or},
      {"$_XOR_", Kind::Xor}, {"$_MUX_", Kind::Mux}, {"$_BUF_", Kind::Buffer}};
  std::string type, pin;
  words >> type;
  std::map<char, std::string> pins;
  while (words >> pin) pins[pin[0]] = pin.substr(2);
  if (type == "$_DFF_P_") {
    clocks_.insert(pins['C']);
    registers_.emplace_back(name(pins['D']), name(pins['Q']));
    return;
  }
  const auto kind = Kinds.find(type);
  if (kind == Kinds.end()) throw RtlError("unknown gate " + type);
  Cell cell{kind->second, name(pins['A']), 0, 0, name(pins['Y'])};
  if (pins.count('B')) cell.b = name(pins['B']);
  if (pins.count('S')) cell.select = name(pins['S']);
  cells_.push_back(cell);
}

void ParallelGates::Reader::place_ports() {
  nets_[name("$false")] = nets_[name("$undef")] = add_net();
  nets_[name("$true")] = add_net(~Word{0});
  if (clocks_.size() > 1)
    throw RtlError(fmt::format("{} clocks, such as {} and {}", clocks_.size(), *clocks_.begin(),
                               *clocks_.rbegin()));
  for (const std::string& input : inputs_) nets_[name(input)] = add_net();
}

void ParallelGates::Reader::place_registers() {
  to_.first_register_ = to_.values_.size();
  for (const auto& [d, q] : registers_) nets_[q] = add_net();
}

// Depth first, without recursion: netlists are deep.
void ParallelGates::Reader::level(std::size_t first) {
  constexpr int Open = -1;
  std::vector<std::size_t> path = {first};
  while (!path.empty()) {
    const std::size_t at = path.back();
    int& own = levels_[at];
    int deepest = 0;
    bool ready = true;
    for (const Name in : inputs(cells_[at])) {
      const auto from = driver_.find(in);
      if (from == driver_.end()) continue;
      const int other = levels_[from->second];
      if (other == Open) throw RtlError("gates depend on each other in a loop");
      if (other == 0) {
        path.push_back(from->second);
        ready = false;
      }
      deepest = std::max(deepest, other);
    }
    own = ready ? deepest + 1 : Open;
    if (ready) path.pop_back();
  }
}

void ParallelGates::Reader::place_gates() {
  levels_.assign(cells_.size(), 0);
  for (std::size_t n = 0; n < cells_.size(); ++n) driver_[cells_[n].out] = n;
  for (std::size_t n = 0; n < cells_.size(); ++n)
    if (levels_[n] == 0) level(n);
  std::vector<std::size_t> order(cells_.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
  std::stable_sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
    return std::tuple(levels_[a], cells_[a].kind) < std::tuple(levels_[b], cells_[b].kind);
  });
  for (const std::size_t n : order) {
    const Cell& cell = cells_[n];
    if (to_.runs_.empty() || to_.runs_.back().kind != cell.kind ||
        levels_[n] != levels_[order[to_.inputs_of_.size() - 1]])
      to_.runs_.push_back({cell.kind, to_.inputs_of_.size(), 0, to_.values_.size()});
    to_.inputs_of_.push_back({net(cell.a), net(cell.b), net(cell.select)});
    to_.runs_.back().end = to_.inputs_of_.size();
    nets_[cell.out] = add_net();
  }
  to_.gates_ = cells_.size();
  for (const auto& [d, q] : registers_) to_.next_.push_back(net(d));
  to_.taken_.resize(to_.next_.size());
  for (const auto* side : {&inputs_, &outputs_})
    for (const std::string& bit : *side) {
      if (clocks_.count(bit)) continue;
      Port& port = to_.ports_[bit.substr(0, bit.find('['))];
      port.input = side == &inputs_;
      port.nets.push_back(net(name(bit)));
    }
}

ParallelGates::ParallelGates(const std::string& netlist) { Reader(netlist, *this).read(); }

void ParallelGates::settle() {
  Word* const value = values_.data();
  for (const Run& run : runs_) {
    const auto each = [&](const auto& gate) {
      Word* out = value + run.out;
      for (std::size_t n = run.begin; n < run.end; ++n) *out++ = gate(inputs_of_[n]);
    };
    switch (run.kind) {
      case Kind::Buffer: each([=](const Gate& g) { return value[g.a]; }); break;
      case Kind::Not: each([=](const Gate& g) { return ~value[g.a]; }); break;
      case Kind::And: each([=](const Gate& g) { return value[g.a] & value[g.b]; }); break;
      case Kind::Or: each([=](const Gate& g) { return value[g.a] | value[g.b]; }); break;
      case Kind::Xor: each([=](const Gate& g) { return value[g.a] ^ value[g.b]; }); break;
      case Kind::Mux:
        each([=](const Gate& g) {
          return (value[g.a] & ~value[g.select]) | (value[g.b] & value[g.select]);
        });
        break;
    }
  }
}

void ParallelGates::edge() {
  for (std::size_t n = 0; n < next_.size(); ++n) taken_[n] = values_[next_[n]];
  std::copy(taken_.begin(), taken_.end(),
            values_.begin() + static_cast<std::ptrdiff_t>(first_register_));
}

}  // namespace racebeam
