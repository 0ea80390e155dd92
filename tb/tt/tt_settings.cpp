// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_settings.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

namespace racebeam {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

/// The words of a value: a list of texts, or one text with blanks.
std::vector<std::string> words_of(const Json& json, const char* key) {
  std::vector<std::string> words;
  const auto add = [&](const Json& text) {
    std::istringstream in(text.is_string() ? text.get<std::string>() : "");
    for (std::string word; in >> word;) words.push_back(word);
  };
  const auto at = json.find(key);
  if (at == json.end()) return words;
  if (!at->is_array()) add(*at);
  else
    for (const Json& text : *at) add(text);
  return words;
}

}  // namespace

TtSettings read_config_json(std::istream& in, const std::string& folder) {
  const Json json = Json::parse(in, nullptr, false, true);
  if (!json.is_object()) return {};
  TtSettings settings;
  const std::string here = "dir::";  // the folder of the file
  for (std::string name : words_of(json, "VERILOG_INCLUDE_DIRS")) {
    if (name.rfind(here, 0) == 0) name.erase(0, here.size());
    const fs::path whole = (fs::path(folder) / name).lexically_normal();
    std::error_code error;
    if (fs::is_directory(whole, error)) settings.include_folders.push_back(whole.string());
  }
  for (const char* key : {"VERILOG_DEFINES", "SYNTH_DEFINES"})
    for (const std::string& define : words_of(json, key)) settings.defines.push_back(define);
  return settings;
}

std::vector<std::string> read_test_defines(std::istream& in) {
  std::vector<std::string> defines;
  struct Part {
    bool about_gates, gates;  // a condition asks for gates; it is their part
  };
  std::vector<Part> parts;  // around a line
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word.rfind("if", 0) == 0) {
      const bool about_gates = line.find("$(GATES)") != std::string::npos;
      parts.push_back({about_gates, about_gates && word == "ifeq"});
    } else if (word == "else" && !parts.empty()) {
      parts.back().gates = parts.back().about_gates && !parts.back().gates;
    } else if (word == "endif" && !parts.empty()) {
      parts.pop_back();
    }
    const bool gates =
        std::any_of(parts.begin(), parts.end(), [](Part part) { return part.gates; });
    if (word.rfind("COMPILE_ARGS", 0) != 0 || gates) continue;
    while (words >> word)
      if (word.rfind("-D", 0) == 0 && word.size() > 2) defines.push_back(word.substr(2));
  }
  return defines;
}

}  // namespace racebeam
