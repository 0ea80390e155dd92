// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/rtl_behaviour.h"

#include <algorithm>
#include <map>
#include <set>

namespace racebeam {

namespace {

/// The text of a constant, which is "\"text\"" or a number such as 16'h6162; of all else empty.
std::string text_of(Node node) {
  const std::string name = attribute(node, "name");
  if (name_of(node) != "const") return "";
  if (name.size() >= 2 && name.front() == '"') return name.substr(1, name.size() - 2);
  std::string digits = name.substr(std::min(name.size(), name.find("'h") + 2)), text;
  if (name.find("'h") == std::string::npos) return "";
  if (digits.size() % 2 != 0) digits.insert(0, "0");
  for (std::size_t at = 0; at < digits.size(); at += 2)
    text += static_cast<char>(std::stoi(digits.substr(at, 2), nullptr, 16));
  return text;
}

class BehaviourReader {
 public:
  BehaviourReader(const SyntaxTree& tree, RtlSyntax& syntax) : tree_(tree), syntax_(syntax) {}
  void read() {
    walk(tree_.netlist(), [&](Node node) {
      if (name_of(node) == "while") return read_loop(node);
      read_call(node);
      read_speech(node);
      read_state(node);
    });
  }

 private:
  void read_call(Node node);
  void read_loop(Node loop);
  void read_speech(Node node);
  void read_state(Node node);

  const SyntaxTree& tree_;
  RtlSyntax& syntax_;
};

void BehaviourReader::read_call(Node node) {
  static const std::map<std::string, std::string> Reaching = {{"systemt", "$system"},
                                                              {"systemf", "$system"},
                                                              {"ucstmt", "$c"},
                                                              {"ucfunc", "$c"},
                                                              {"fopenmcd", "$fopen"},
                                                              {"writemem", "$writememh"},
                                                              {"scctor", "`systemc_ctor"},
                                                              {"scdtor", "`systemc_dtor"},
                                                              {"schdr", "`systemc_header"},
                                                              {"scimp", "`systemc_implementation"},
                                                              {"scimphdr", "`systemc_imp_header"},
                                                              {"scint", "`systemc_interface"}};
  const std::string kind = name_of(node);
  if (const auto at = Reaching.find(kind); at != Reaching.end())
    syntax_.calls.push_back(tree_.place(node, at->second));
  if (kind == "fopen") {  // the mode, last: "r" or "rb" in ASCII
    const std::string mode = attribute(children(node).back(), "name");
    if (mode != "8'h72" && mode != "16'h7262") syntax_.calls.push_back(tree_.place(node, "$fopen"));
  }
  if (kind == "readmem")
    syntax_.reads.push_back(tree_.place(node, text_of(children(node).front())));
  if (kind != "func" && kind != "task") return;
  if (attribute(node, "name") == "new" && name_of(node->parent) == "class") return;
  const std::vector<Node> parts = children(node);
  if (std::all_of(parts.begin(), parts.end(), [](Node part) { return name_of(part) == "var"; }))
    syntax_.calls.push_back(tree_.place(node, attribute(node, "name")));
}

// An <always> with a <sentree> waits for an edge, an <initial> speaks once; a function, anywhere.
void BehaviourReader::read_speech(Node node) {
  static const std::set<std::string> Speech = {"display", "stop", "finish"};
  if (Speech.count(name_of(node)) == 0) return;
  static const std::set<std::string> Processes = {"always", "initial", "final"};
  Node process = node->parent;
  while (process != tree_.netlist() && Processes.count(name_of(process)) == 0)
    process = process->parent;
  if (name_of(process) == "initial" || name_of(process) == "final") return;
  const bool anywhere = process == tree_.netlist();
  const std::vector<Node> parts = anywhere ? std::vector<Node>() : children(process);
  syntax_.speaks_between_edges |= parts.empty() || name_of(parts.front()) != "sentree";
}

// What a function of the system gives may differ each time (not $time: it stands still); what a
// variable without a fixed size holds does not lie in its place.
void BehaviourReader::read_state(Node node) {
  static const std::set<std::string> Moving = {
      "rand",    "randrng", "urandomrange", "fopen", "fopenmcd",     "fgetc", "fgets",
      "fungetc", "fscanf",  "fread",        "feof",  "ferror",       "ftell", "fseek",
      "frewind", "fork",    "delay",        "wait",  "eventcontrol", "new",   "fireevent"};
  static const std::set<std::string> Elsewhere = {"queuedtype",      "dynarraydtype",
                                                  "assocarraydtype", "wildcardarraydtype",
                                                  "classrefdtype",   "unsizedarraydtype"};
  bool elsewhere = Moving.count(name_of(node)) != 0 || Elsewhere.count(name_of(node)) != 0;
  if (name_of(node) == "var")
    if (Node type = tree_.type_of(node)) {
      const std::string name = attribute(type, "name");
      elsewhere |= name_of(type) == "basicdtype" &&
                   (name == "string" || name == "event" || name == "chandle");
    }
  syntax_.state_elsewhere |= elsewhere;
}

// <while> before, condition, body: counted if a variable is compared with a constant and changed.
void BehaviourReader::read_loop(Node loop) {
  const std::vector<Node> parts = children(loop);
  std::set<std::string> compared;
  bool constant = false;
  if (parts.size() > 1)
    walk(parts[1], [&](Node node) {
      if (name_of(node) == "varref") compared.insert(attribute(node, "name"));
      else constant |= name_of(node) == "const";
    });
  bool counted = false;
  walk(loop, [&](Node node) {
    if (name_of(node) != "assign") return;
    const std::vector<Node> sides = children(node);
    const std::string value = name_of(sides[0]);
    counted |= constant && compared.size() == 1 && (value == "add" || value == "sub") &&
               name_of(sides[1]) == "varref" && compared.count(attribute(sides[1], "name")) != 0;
  });
  if (!counted) syntax_.loops.push_back(tree_.place(loop, compared.empty() ? "forever" : "while"));
}

}  // namespace

void read_behaviour(const SyntaxTree& tree, RtlSyntax& syntax) {
  BehaviourReader(tree, syntax).read();
  syntax.state_elsewhere |= !syntax.calls.empty();
}

}  // namespace racebeam
