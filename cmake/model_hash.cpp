// Writes the source of model_hash() (tb/sweep/model_hash.h):
//   racebeam_model_hash OUTPUT --engine NAME SOURCE... [--engine NAME SOURCE...]...
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <xxhash.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Engine {
  std::string name;
  std::vector<std::string> sources;
};

/// Of the names and the contents of files, in the order of their names.
std::string hash_of(std::vector<std::string> sources) {
  std::sort(sources.begin(), sources.end());
  std::string all;
  for (const std::string& source : sources) {
    std::ifstream in(source, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + source);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    for (const std::string& part : {source, text}) all += std::to_string(part.size()) + ":" + part;
  }
  const XXH128_hash_t hash = XXH3_128bits(all.data(), all.size());
  char digits[33];
  std::snprintf(digits, sizeof digits, "%016llx%016llx",
                static_cast<unsigned long long>(hash.high64),
                static_cast<unsigned long long>(hash.low64));
  return digits;
}

std::string source_of(const std::vector<Engine>& engines) {
  std::string rows;
  for (const Engine& engine : engines)
    rows +=
        "  if (engine == \"" + engine.name + "\") return \"" + hash_of(engine.sources) + "\";\n";
  return "// Made by racebeam_model_hash.\n"
         "#include \"tb/sweep/model_hash.h\"\n\n"
         "#include <stdexcept>\n\n"
         "namespace racebeam {\n\n"
         "std::string model_hash(const std::string& engine) {\n" +
         rows +
         "  throw std::invalid_argument(\"no model of engine \" + engine);\n"
         "}\n\n"
         "}  // namespace racebeam\n";
}

}  // namespace

int main(int count, char** words) try {
  std::vector<Engine> engines;
  for (int i = 2; i < count; ++i) {
    const std::string word = words[i];
    if (word == "--engine" && i + 1 < count) engines.push_back({words[++i], {}});
    else if (!engines.empty()) engines.back().sources.push_back(word);
  }
  if (engines.empty()) throw std::runtime_error("usage: OUTPUT --engine NAME SOURCE...");
  std::ofstream out(words[1], std::ios::binary);
  out << source_of(engines);
  out.close();
  if (!out) throw std::runtime_error(std::string("cannot write ") + words[1]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "racebeam_model_hash: " << error.what() << '\n';
  return 2;
}
