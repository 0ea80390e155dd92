// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/sweep/unit_sources.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include "tb/base/errors.h"
#include "tb/base/whole_file.h"
#include "tb/verilate/cache_folder.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* Package = "racebeam_pkg";  // yosys is told of it with every unit

/// Words and single signs, without comments.
std::vector<std::string> tokens_of(const std::string& text) {
  const auto in_word = [&text](std::size_t i) {
    return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_');
  };
  std::vector<std::string> tokens;
  for (std::size_t i = 0, end = 0; i < text.size(); i = end) {
    end = i + 1;
    if (text.compare(i, 2, "//") == 0) {
      end = std::min(text.find('\n', i), text.size());
    } else if (text.compare(i, 2, "/*") == 0) {
      end = std::min(text.find("*/", i + 2), text.size() - 2) + 2;
    } else if (in_word(i)) {
      while (in_word(end)) ++end;
      tokens.push_back(text.substr(i, end - i));
    } else if (!std::isspace(static_cast<unsigned char>(text[i]))) {
      tokens.push_back(text.substr(i, 1));
    }
  }
  return tokens;
}

/// The name before the "=" of each "parameter int Name = ...".
std::set<std::string> parameters_in(const std::vector<std::string>& tokens) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i] != "parameter") continue;
    while (i + 1 < tokens.size() && tokens[i + 1] != "=") ++i;
    names.insert(tokens[i]);
  }
  return names;
}

/// Of SystemVerilog; constraints beside it have the same names.
std::map<std::string, std::string> files_by_stem(const std::vector<std::string>& folders) {
  std::map<std::string, std::string> files;
  for (const std::string& folder : folders)
    for (const auto& entry : fs::directory_iterator(folder))
      if (const std::string kind = entry.path().extension(); kind == ".sv" || kind == ".svh")
        files[entry.path().stem().string()] = entry.path().string();
  return files;
}

}  // namespace

UnitSources unit_sources(const std::string& unit, const std::vector<std::string>& folders) {
  const std::map<std::string, std::string> known = files_by_stem(folders);
  UnitSources sources;
  std::set<std::string> names = {unit, Package};
  for (const std::string& name : names)
    if (known.count(name) == 0)
      throw MissingTool("the RTL has no " + name + ".sv; install racebeam anew");
  std::vector<std::string> ahead(names.begin(), names.end());
  while (!ahead.empty()) {
    const std::string name = ahead.back();
    ahead.pop_back();
    const std::vector<std::string> tokens = tokens_of(whole_file(known.at(name)));
    if (name == unit) sources.parameters = parameters_in(tokens);
    for (const std::string& token : tokens)
      if (known.count(token) != 0 && names.insert(token).second) ahead.push_back(token);
  }
  std::vector<std::string> parts;
  for (const std::string& name : names) {
    sources.files.push_back(known.at(name));
    parts.insert(parts.end(), {name, whole_file(known.at(name))});
  }
  sources.key = content_key(parts);
  return sources;
}

}  // namespace racebeam
