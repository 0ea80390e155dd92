// Constants and codes as they are written in C++ and SystemVerilog, to be compared.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "tb/base/text_pattern.h"

namespace racebeam {

/// Name and value, as they are written.
using NamedValues = std::map<std::string, std::string>;

/// A source file without its comments.
inline std::string source_text(const std::string& file) {
  std::ifstream in(RACEBEAM_SOURCE_DIR "/" + file);
  return TextPattern("//[^\n]*")
      .replaced(std::string(std::istreambuf_iterator<char>(in), {}),
                [](const TextPattern::Groups&) { return ""; });
}

/// All that `pattern` finds: the groups 1 and 2.
inline NamedValues named_values(const std::string& text, const std::string& pattern) {
  NamedValues all;
  for (const TextPattern::Groups& constant : TextPattern(pattern).all(text))
    EXPECT_TRUE(all.emplace(constant[1], constant[2]).second) << constant[1] << " twice";
  return all;
}
/// `constexpr int` and `localparam int`.
inline NamedValues model_constants(const std::string& text) {
  return named_values(text, R"(constexpr int (\w+) = ([^;]+);)");
}
inline NamedValues rtl_constants(const std::string& text) {
  return named_values(text, R"(localparam int (\w+) = ([^;]+);)");
}
/// Enumerators of the RTL, 4'd3, or of the model, 3, whose names begin with `prefix`.
inline NamedValues codes(const std::string& text, const std::string& prefix) {
  return named_values(text, "((?:" + prefix + R"()\w+) = (?:\d'd)?(\d+)\s*[,}\n])");
}

/// Every constant of the RTL is one of the model.
inline void expect_model_has(const NamedValues& rtl, const NamedValues& model) {
  for (const auto& [name, value] : rtl) {
    ASSERT_TRUE(model.count(name)) << name << " is not in the model";
    EXPECT_EQ(value, model.at(name)) << name;
  }
}

}  // namespace racebeam
