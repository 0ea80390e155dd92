// The functions of a verilated class, as Verilator writes them.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace racebeam {

/// The body of Vrtl___024root___FUNCTION() in the text of all classes, without blanks; empty if it
/// is not there.
inline std::string class_body(const std::string& classes, const std::string& function) {
  const auto begin =
      classes.find("void Vrtl___024root___" + function + "(Vrtl___024root* vlSelf) {");
  if (begin == std::string::npos) return "";
  std::string body = classes.substr(begin, classes.find("\n}\n", begin) - begin);
  body.erase(std::remove_if(body.begin(), body.end(),
                            [](unsigned char c) { return std::isspace(c) != 0; }),
             body.end());
  return body;
}

}  // namespace racebeam
