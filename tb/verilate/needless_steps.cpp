// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/needless_steps.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "tb/base/text_pattern.h"
#include "tb/verilate/class_body.h"

namespace racebeam {

namespace {

constexpr int FewStatements = 100;  // are done sooner than it is known whether they are needed
constexpr std::size_t MostCompared = 6;
constexpr std::size_t MostText = 4'000'000;  // bytes; gates of a large unit gain nothing

using Names = std::set<std::string>;

/// Members that one value of the machine holds.
Names scalars_in(const std::string& header) {
  static const TextPattern Declared(
      R"((?:[CSIQ]Data/\*[0-9:]+\*/ |VL_(?:IN|OUT)(?:8|16|64)?\(&?)(\w+)[;,])");
  Names names;
  for (const auto& found : Declared.all(header)) names.insert(found[1]);
  return names;
}

/// What a function does to members, but for the arguments and variables of functions in it, which
/// it writes before it reads them.
struct Deeds {
  Names reads, writes;
  int statements = 0;
  bool only_computes = true;
};

/// Behind an index, or several.
std::size_t behind_index(const std::string& body, std::size_t at) {
  while (at < body.size() && body[at] == '[') {
    int open = 0;
    do {
      open += body[at] == '[';
      open -= body[at] == ']';
    } while (++at < body.size() && open > 0);
  }
  return at;
}

Deeds deeds_of(const std::string& function, const Names& scalars) {
  const auto begin = function.rfind("//Body");
  const std::string body =
      begin == std::string::npos ? "Vrtl___024root___" : function.substr(begin);
  static const TextPattern Unknown(R"(VL_ASSIGN|&vlSelf|\+\+|--|[-+|&^]=)"),
      Effect(R"(VL_WRITE|VL_RAND|VL_TIME|VL_STOP|VL_FATAL|vlSymsp->|Vrtl___024root___|Verilated)");
  Deeds deeds;
  deeds.only_computes = Effect.search(body).empty();
  deeds.statements = static_cast<int>(std::count(body.begin(), body.end(), ';'));
  const bool unknown = !Unknown.search(body).empty();
  const std::string member = "vlSelf->";
  for (std::size_t at = 0; (at = body.find(member, at)) != std::string::npos;) {
    const std::size_t begin = at + member.size();
    at = begin;
    while (at < body.size() &&
           (std::isalnum(static_cast<unsigned char>(body[at])) || body[at] == '_'))
      ++at;
    const std::string name = body.substr(begin, at - begin);
    if (name.find("__Vfunc_") != std::string::npos || name.find("__Vtask_") != std::string::npos)
      continue;
    const std::size_t next = behind_index(body, at);
    const bool writes = body.compare(next, 1, "=") == 0 && body.compare(next, 2, "==") != 0;
    const bool both = unknown || next != at || scalars.count(name) == 0;
    if (writes || both) deeds.writes.insert(name);
    if (!writes || both) deeds.reads.insert(name);
  }
  return deeds;
}

bool includes(const Names& all, const Names& some) {
  return std::includes(all.begin(), all.end(), some.begin(), some.end());
}

}  // namespace

void find_needless(const std::string& classes, const std::string& header, DirectSteps& steps) {
  if (classes.size() > MostText) return;
  const Names scalars = scalars_in(header);
  Names settled;  // what all combinational logic is computed to at the beginning
  static const TextPattern Settles(R"(Vrtl___024root___(stl_\w+)\(Vrtl___024root\* vlSelf\) \{)");
  for (const auto& found : Settles.all(classes))
    settled.merge(deeds_of(class_body(classes, found[1]), scalars).writes);
  std::vector<Deeds> deeds;
  std::map<std::string, std::vector<std::size_t>> writers;
  for (const DirectStep& step : steps.registers) {
    deeds.push_back(deeds_of(class_body(classes, step.function), scalars));
    if (!step.at_tick) continue;
    for (const std::string& name : deeds.back().writes) writers[name].push_back(deeds.size() - 1);
  }
  for (std::size_t n = 0; n < deeds.size(); ++n) {
    DirectStep& step = steps.registers[n];
    const Deeds& own = deeds[n];
    if (!step.at_tick || !own.only_computes || own.statements < FewStatements ||
        !includes(settled, own.writes))
      continue;
    Names changed, called;
    bool known = true;
    for (const Names* names : {&own.reads, &own.writes})
      for (const std::string& name : *names)
        for (const std::size_t writer : writers[name]) {
          if (writer == n) continue;
          const DirectStep& other = steps.registers[writer];
          known &= writer < n && own.writes.count(name) == 0;
          if (!other.always) called.insert(other.function);
          else if (scalars.count(name) != 0) changed.insert(name);
          else known = false;
        }
    if (!known || changed.size() > MostCompared) continue;
    step.always = false;
    step.changed.assign(changed.begin(), changed.end());
    step.called.assign(called.begin(), called.end());
  }
}

}  // namespace racebeam
