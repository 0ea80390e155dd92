// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/rtl_syntax.h"

#include <libxml/parser.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/verilate/elaborated.h"

namespace racebeam {

namespace {

using Node = xmlNode*;

std::string name_of(Node node) { return reinterpret_cast<const char*>(node->name); }

std::string attribute(Node node, const char* name) {
  xmlChar* text = xmlGetProp(node, reinterpret_cast<const xmlChar*>(name));
  const std::string value = text ? reinterpret_cast<const char*>(text) : "";
  xmlFree(text);
  return value;
}

std::vector<Node> children(Node node) {
  std::vector<Node> all;
  for (Node child = node->children; child; child = child->next)
    if (child->type == XML_ELEMENT_NODE) all.push_back(child);
  return all;
}

void walk(Node node, const std::function<void(Node)>& visit) {
  for (Node child : children(node)) {
    visit(child);
    walk(child, visit);
  }
}

/// The value of "8'sh7f"; false if it is no whole number.
bool is_number(const std::string& text, long long& value) {
  const auto quote = text.find('\'');
  if (quote == std::string::npos) return false;
  const int bits = std::atoi(text.c_str());
  const bool is_signed = text.compare(quote, 2, "'s") == 0;
  const std::string digits = text.substr(quote + (is_signed ? 3 : 2));
  if (bits < 1 || bits > 64 || digits.empty() ||
      digits.find_first_not_of("0123456789abcdef") != std::string::npos)
    return false;
  const std::uint64_t raw = std::strtoull(digits.c_str(), nullptr, 16);
  const bool negative = is_signed && (raw >> (bits - 1) & 1);
  value = static_cast<long long>(negative && bits < 64 ? raw | ~0ULL << bits : raw);
  return true;
}

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

/// One module of the tree and the names of the clock in it.
struct Module {
  Node node = nullptr;
  std::set<std::string> clocks;
};

class SyntaxReader {
 public:
  SyntaxReader(Node root, const std::string& top);
  RtlSyntax read();

 private:
  RtlSyntax::Place place(Node node, const std::string& name) const;
  int bits(const std::string& type) const;
  void read_top();
  void follow_clock();
  bool follow_clock(Module& module);
  void read_module(const Module& module);
  void read_edge(Node item);
  void read_call(Node node);
  void read_loop(Node loop);

  RtlSyntax syntax_;
  std::map<std::string, std::string> files_;  // by id
  std::map<std::string, Node> types_;         // by id
  std::map<std::string, Module> modules_;     // by name
  Node top_ = nullptr;
};

SyntaxReader::SyntaxReader(Node root, const std::string& top) {
  walk(root, [&](Node node) {
    const std::string kind = name_of(node);
    if (kind == "file" && name_of(node->parent) == "files") {
      const std::string path = attribute(node, "filename");
      files_[attribute(node, "id")] = path;
      if (path[0] != '<') syntax_.files.push_back(path);
    } else if (kind == "module") {
      modules_[attribute(node, "name")].node = node;
      if (attribute(node, "topModule") == "1") top_ = node;
    } else if (name_of(node->parent) == "typetable") {
      types_[attribute(node, "id")] = node;
    }
  });
  if (!top_) throw RtlError("Verilator's XML has no module " + top);
}

RtlSyntax SyntaxReader::read() {
  read_top();
  follow_clock();
  syntax_.rising_only = !syntax_.clock.empty();
  for (const auto& [name, module] : modules_) read_module(module);
  return syntax_;
}

RtlSyntax::Place SyntaxReader::place(Node node, const std::string& name) const {
  std::string loc = attribute(node, "loc");  // file, line, ...
  for (; loc.empty() && node->parent; loc = attribute(node, "loc")) node = node->parent;
  std::istringstream words(loc);
  std::string file, line;
  std::getline(words, file, ',');
  std::getline(words, line, ',');
  const auto at = files_.find(file);
  return {at == files_.end() ? "" : at->second, std::atoi(line.c_str()), name};
}

int SyntaxReader::bits(const std::string& type) const {
  const auto at = types_.find(type);
  if (at == types_.end()) return 1;
  Node node = at->second;
  const std::string kind = name_of(node), left = attribute(node, "left");
  if (kind == "basicdtype")
    return left.empty() ? 1 : std::abs(std::stoi(left) - std::stoi(attribute(node, "right"))) + 1;
  int all = 0;
  if (kind == "structdtype" || kind == "uniondtype") {
    for (Node member : children(node)) {
      const int own = bits(attribute(member, "sub_dtype_id"));
      all = kind == "structdtype" ? all + own : std::max(all, own);
    }
    return all;
  }
  all = bits(attribute(node, "sub_dtype_id"));
  for (Node range : children(node)) {
    if (name_of(range) != "range") continue;
    long long ends[2] = {};
    for (int n = 0; n < 2; ++n) is_number(attribute(children(range)[n], "name"), ends[n]);
    all *= static_cast<int>(std::abs(ends[0] - ends[1])) + 1;
  }
  return all;
}

void SyntaxReader::read_top() {
  syntax_.top = place(top_, attribute(top_, "origName"));
  for (Node node : children(top_)) {
    if (name_of(node) != "var") continue;
    const std::string name = attribute(node, "name"), direction = attribute(node, "dir");
    if (!direction.empty()) {
      syntax_.ports.push_back({name, direction, bits(attribute(node, "dtype_id"))});
      if (direction == "input" && (name == "clk_i" || name == "clk")) syntax_.clock = name;
    }
    if (attribute(node, "param") != "true") continue;
    long long value = 0;
    const std::vector<Node> values = children(node);
    const bool whole = !values.empty() && is_number(attribute(values[0], "name"), value);
    const auto type = types_.find(attribute(node, "dtype_id"));
    const bool wraps = type != types_.end() && attribute(type->second, "signed") == "true" &&
                       bits(attribute(node, "dtype_id")) == 32;
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
    const std::string kind = name_of(node);
    if (kind == "while") read_loop(node);
    else read_call(node);
    if (kind != "varref" || module.clocks.count(attribute(node, "name")) == 0) return;
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
    if (told.insert(target).second) syntax_.falling.push_back(place(item, target));
  });
}

void SyntaxReader::read_call(Node node) {
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
    syntax_.calls.push_back(place(node, at->second));
  if (kind == "fopen") {  // the mode, last: "r" or "rb" in ASCII
    const std::string mode = attribute(children(node).back(), "name");
    if (mode != "8'h72" && mode != "16'h7262") syntax_.calls.push_back(place(node, "$fopen"));
  }
  if (kind == "readmem") syntax_.reads.push_back(place(node, text_of(children(node).front())));
  if (kind != "func" && kind != "task") return;
  const std::vector<Node> parts = children(node);
  if (std::all_of(parts.begin(), parts.end(), [](Node part) { return name_of(part) == "var"; }))
    syntax_.calls.push_back(place(node, attribute(node, "name")));
}

// <while> before, condition, body: counted if a variable is compared with a constant and changed.
void SyntaxReader::read_loop(Node loop) {
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
  if (!counted) syntax_.loops.push_back(place(loop, compared.empty() ? "forever" : "while"));
}

}  // namespace

RtlSyntax read_rtl_syntax(const RtlSources& sources) {
  const std::string xml = elaborated(sources).xml;
  const std::unique_ptr<xmlDoc, void (*)(xmlDoc*)> document(
      xmlReadFile(xml.c_str(), nullptr, XML_PARSE_HUGE | XML_PARSE_NONET), xmlFreeDoc);
  if (!document) throw RtlError("Verilator's XML cannot be read: " + xml);
  return SyntaxReader(xmlDocGetRootElement(document.get()), sources.top).read();
}

}  // namespace racebeam
