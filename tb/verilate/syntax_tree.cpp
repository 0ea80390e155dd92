// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/syntax_tree.h"

#include <libxml/encoding.h>
#include <libxml/parser.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/whole_file.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

/// Verilator writes each byte of UTF-8 as a character of its own.
std::string bytes(const std::string& text) {
  std::string all(text.size(), '\0');
  int size = static_cast<int>(all.size()), read = static_cast<int>(text.size());
  const bool good = UTF8Toisolat1(reinterpret_cast<unsigned char*>(all.data()), &size,
                                  reinterpret_cast<const unsigned char*>(text.data()), &read) >= 0;
  return good ? all.substr(0, static_cast<std::size_t>(size)) : text;
}

}  // namespace

std::string name_of(Node node) { return reinterpret_cast<const char*>(node->name); }

std::string attribute(Node node, const char* name) {
  xmlChar* text = xmlGetProp(node, reinterpret_cast<const xmlChar*>(name));
  const std::string value = text ? bytes(reinterpret_cast<const char*>(text)) : "";
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

void leave_out_lists(const std::string& xml) {
  const std::string text = whole_file(xml), end = "</files>\n";
  const auto lists = text.find(end), netlist = text.rfind("<netlist>\n");
  if (lists == std::string::npos || netlist == std::string::npos || netlist < lists)
    throw RtlError("Verilator's XML cannot be read: " + xml);
  std::ofstream out(xml, std::ios::binary);
  out << text.substr(0, lists + end.size()) << text.substr(netlist);
  out.close();
  if (!out) throw RtlError("cannot write " + xml + "; is the disk full?");
}

SyntaxTree::SyntaxTree(const std::string& xml)
    : document_(xmlReadFile(xml.c_str(), nullptr, XML_PARSE_HUGE | XML_PARSE_NONET), xmlFreeDoc) {
  if (!document_) throw RtlError("Verilator's XML cannot be read: " + xml);
  walk(xmlDocGetRootElement(document_.get()), [&](Node node) {
    const std::string kind = name_of(node), inside = name_of(node->parent);
    if (kind == "netlist") netlist_ = node;
    if (inside == "typetable") types_[attribute(node, "id")] = node;
    if (kind != "file" || inside != "files") return;
    file_by_id_[attribute(node, "id")] = attribute(node, "filename");
  });
  if (!netlist_) throw RtlError("Verilator's XML has no netlist: " + xml);
  read_files();
}

// Those of a path with a blank are there whole and, for places in them, up to the blank.
void SyntaxTree::read_files() {
  std::error_code ignored;
  for (const auto& [id, path] : file_by_id_)
    if (path[0] == '/' && fs::is_regular_file(path, ignored)) files_.push_back(path);
  std::sort(files_.begin(), files_.end());
  for (auto& [id, path] : file_by_id_) {
    std::vector<std::string> whole;
    for (const std::string& file : files_)
      if (file.rfind(path + " ", 0) == 0) whole.push_back(file);
    if (whole.size() == 1 && !fs::exists(path, ignored)) path = whole[0];
  }
}

RtlSyntax::Place SyntaxTree::place(Node node, const std::string& name) const {
  std::string loc = attribute(node, "loc");  // file, line, ...
  for (; loc.empty() && node->parent; loc = attribute(node, "loc")) node = node->parent;
  std::istringstream words(loc);
  std::string file, line;
  std::getline(words, file, ',');
  std::getline(words, line, ',');
  const auto at = file_by_id_.find(file);
  return {at == file_by_id_.end() ? "" : at->second, std::atoi(line.c_str()), name};
}

Node SyntaxTree::type_of(Node node) const {
  const auto at = types_.find(attribute(node, "dtype_id"));
  return at == types_.end() ? nullptr : at->second;
}

int SyntaxTree::bits(Node node) const { return bits(attribute(node, "dtype_id")); }

int SyntaxTree::bits(const std::string& type) const {
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

}  // namespace racebeam
