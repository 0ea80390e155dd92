// Verilator's XML: elaborated RTL as a tree.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <libxml/tree.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tb/verilate/rtl_syntax.h"

namespace racebeam {

using Node = xmlNode*;

std::string name_of(Node node);
/// Empty if there is none.
std::string attribute(Node node, const char* name);
std::vector<Node> children(Node node);
/// All below `node`, parents first.
void walk(Node node, const std::function<void(Node)>& visit);

/// The value of "8'sh7f"; false if it is no whole number.
bool is_number(const std::string& text, long long& value);

/// Leaves out of the file `xml` what Verilator writes into it as it stands, '&' and '<' too: lists
/// of modules and cells, which nobody reads. Throws RtlError.
void leave_out_lists(const std::string& xml);

class SyntaxTree {
 public:
  /// Of the file `xml`. Throws RtlError.
  explicit SyntaxTree(const std::string& xml);

  /// Modules, packages, interfaces, classes and types.
  Node netlist() const { return netlist_; }
  /// All files that were read, includes too, as absolute paths.
  const std::vector<std::string>& files() const { return files_; }
  /// Where `node` is, under the name `name`.
  RtlSyntax::Place place(Node node, const std::string& name) const;
  /// The type of `node`; nullptr: it has none.
  Node type_of(Node node) const;
  /// The width of the type of `node`.
  int bits(Node node) const;

 private:
  void read_files();
  int bits(const std::string& type) const;

  std::unique_ptr<xmlDoc, void (*)(xmlDoc*)> document_;
  Node netlist_ = nullptr;
  std::vector<std::string> files_;
  std::map<std::string, std::string> file_by_id_;
  std::map<std::string, Node> types_;  // by id
};

}  // namespace racebeam
