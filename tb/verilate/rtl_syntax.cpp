// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/rtl_syntax.h"

#include <cstdint>
#include <map>
#include <set>

#include "sc/swap/rtl_library.h"
#include "tb/verilate/elaborated.h"
#include "tb/verilate/rtl_behaviour.h"
#include "tb/verilate/syntax_tree.h"

namespace racebeam {

namespace {

/// One module or interface of the tree and the names of the clock in it.
struct Module {
  Node node = nullptr;
  std::set<std::string> clocks;
};

class SyntaxReader {
 public:
  SyntaxReader(const SyntaxTree& tree, const std::string& top);
  RtlSyntax read();

 private:
  void read_top();
  void follow_clock();
  bool follow_clock(Module& module);
  void read_module(const Module& module);
  void read_edge(Node item);

  const SyntaxTree& tree_;
  RtlSyntax syntax_;
  std::map<std::string, Module> modules_;  // by name
  Node top_ = nullptr;
};

SyntaxReader::SyntaxReader(const SyntaxTree& tree, const std::string& top) : tree_(tree) {
  syntax_.files = tree.files();
  for (Node node : children(tree.netlist())) {
    if (name_of(node) != "module" && name_of(node) != "iface") continue;
    modules_[attribute(node, "name")].node = node;
    if (attribute(node, "topModule") == "1") top_ = node;
  }
  if (!top_) throw RtlError("Verilator's XML has no module " + top);
}

RtlSyntax SyntaxReader::read() {
  read_top();
  follow_clock();
  syntax_.rising_only = !syntax_.clock.empty();
  for (const auto& [name, module] : modules_) read_module(module);
  read_behaviour(tree_, syntax_);
  return syntax_;
}

void SyntaxReader::read_top() {
  syntax_.top = tree_.place(top_, attribute(top_, "origName"));
  for (Node node : children(top_)) {
    if (name_of(node) != "var") continue;
    const std::string name = attribute(node, "name"), direction = attribute(node, "dir");
    if (!direction.empty()) {
      const RtlSyntax::Place place = tree_.place(node, syntax_.top.name + "." + name);
      syntax_.ports.push_back({name, direction, tree_.bits(node), place});
      if (direction == "input" && (name == "clk_i" || name == "clk")) syntax_.clock = name;
    }
    if (attribute(node, "param") != "true") continue;
    long long value = 0;
    const std::vector<Node> values = children(node);
    const bool whole = !values.empty() && is_number(attribute(values[0], "name"), value);
    Node type = tree_.type_of(node);
    const bool wraps = type && attribute(type, "signed") == "true" && tree_.bits(node) == 32;
    if (wraps) value = static_cast<std::int32_t>(value);
    syntax_.parameters.push_back({name, whole ? std::to_string(value) : ""});
  }
}

// From the top's pin through the pins of instances and plain assignments, until no name is new.
void SyntaxReader::follow_clock() {
  if (syntax_.clock.empty()) return;
  modules_[attribute(top_, "name")].clocks.insert(syntax_.clock);
  for (bool more = true; more;) {
    more = false;
    for (auto& [name, module] : modules_) more |= follow_clock(module);
  }
}

bool SyntaxReader::follow_clock(Module& module) {
  bool more = false;
  const auto is_clock = [&](Node node) {
    return name_of(node) == "varref" && module.clocks.count(attribute(node, "name")) != 0;
  };
  walk(module.node, [&](Node node) {
    const std::vector<Node> parts = children(node);
    if (parts.empty() || !is_clock(parts[0])) return;
    if (name_of(node) == "contassign" && name_of(parts[1]) == "varref")
      more |= module.clocks.insert(attribute(parts[1], "name")).second;
    if (name_of(node) != "port") return;
    const auto inside = modules_.find(attribute(node->parent, "defName"));
    if (inside == modules_.end()) return;
    for (Node pin : children(inside->second.node))  // by name or by place
      if (attribute(pin, "name") == attribute(node, "name") ||
          (attribute(node, "name").rfind("__pinNumber", 0) == 0 &&
           attribute(pin, "pinIndex") == attribute(node, "portIndex")))
        more |= inside->second.clocks.insert(attribute(pin, "name")).second;
  });
  return more;
}

void SyntaxReader::read_module(const Module& module) {
  walk(module.node, [&](Node node) {
    if (name_of(node) != "varref" || module.clocks.count(attribute(node, "name")) == 0) return;
    Node parent = node->parent;
    const std::string edge = attribute(parent, "edgeType"), use = name_of(parent);
    const bool alias = use == "contassign" && name_of(children(parent)[0]) == "varref";
    if (edge == "POS" || use == "port" || alias) return;
    syntax_.rising_only = false;
    if (edge == "NEG") read_edge(parent);
  });
}

/// The registers that the process with this sensitivity writes.
void SyntaxReader::read_edge(Node item) {
  std::set<std::string> told;
  walk(item->parent->parent, [&](Node node) {
    if (name_of(node) != "assigndly" && name_of(node) != "assign") return;
    std::string target;
    const auto look = [&](Node part) {
      if (target.empty() && name_of(part) == "varref") target = attribute(part, "name");
    };
    look(children(node).back());
    walk(children(node).back(), look);
    if (told.insert(target).second) syntax_.falling.push_back(tree_.place(item, target));
  });
}

}  // namespace

RtlSyntax read_rtl_syntax(const RtlSources& sources) {
  const SyntaxTree tree(elaborated(sources).xml);
  return SyntaxReader(tree, sources.top).read();
}

}  // namespace racebeam
