// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/vcd_reader.h"

#include <algorithm>
#include <charconv>
#include <fstream>

#include "tb/errors.h"

namespace racebeam {

VcdReader::VcdReader(const std::string& path)
    : VcdReader(std::make_unique<std::ifstream>(path), path) {}

VcdReader::VcdReader(std::unique_ptr<std::istream> in, const std::string& name)
    : path_(name), in_(std::move(in)) {
  if (!*in_) throw UsageError("cannot read " + name);
  read_header();
}

void VcdReader::broken(const std::string& what) const {
  throw UsageError(path_ + " is no value change dump: " + what);
}

void VcdReader::read_header() {
  std::vector<std::string> scopes;
  for (std::string word; *in_ >> word;) {
    if (word == "$scope") {
      std::string name;
      *in_ >> word >> name;
      scopes.push_back(name);
    } else if (word == "$upscope") {
      if (scopes.empty()) broken("$upscope without $scope");
      scopes.pop_back();
    } else if (word == "$var") {
      read_variable(scopes);
    } else if (word == "$enddefinitions") {
      while (*in_ >> word && word[0] != '#') {
      }
      if (*in_) take(word);
      return;
    }
    while (word != "$end" && *in_ >> word) {
    }
  }
  broken("$enddefinitions is missing");
}

void VcdReader::read_variable(const std::vector<std::string>& scopes) {
  std::string kind, bits, code, path;
  *in_ >> kind >> bits >> code;
  for (const std::string& scope : scopes) path += scope + ".";
  std::string name;
  *in_ >> name;
  const auto [at, is_new] = codes_.emplace(code, static_cast<int>(bits_.size()));
  if (is_new) {
    int number = 0;
    const auto [end, error] = std::from_chars(bits.data(), bits.data() + bits.size(), number);
    if (error != std::errc{} || *end) broken("a width of '" + bits + "'");
    bits_.push_back(kind == "string" ? 0 : number);
    values_.emplace_back();
  }
  if (signals_.emplace(path + name, at->second).second) paths_.push_back(path + name);
}

// "#123": the next time.
void VcdReader::take(const std::string& word) {
  std::uint64_t time = 0;
  const auto [end, error] = std::from_chars(word.data() + 1, word.data() + word.size(), time);
  if (error != std::errc{} || *end) broken("a time of '" + word + "'");
  next_ = time;
}

const std::vector<int>& VcdReader::advance() {
  changed_.clear();
  next_.reset();
  for (std::string word; *in_ >> word;) {
    if (word[0] == '#') {
      take(word);
      break;
    }
    if (word[0] == '$') continue;  // $dumpvars, $end
    const bool vector = word[0] == 'b' || word[0] == 'r' || word[0] == 's';
    std::string value = vector ? word.substr(1) : word.substr(0, 1), code;
    if (vector) *in_ >> code;
    else code = word.substr(1);
    const auto at = codes_.find(code);
    if (at == codes_.end()) broken("a change of '" + code + "', which it does not declare");
    if (word[0] == 'b') value.erase(0, std::min(value.find_first_not_of('0'), value.size() - 1));
    values_[static_cast<std::size_t>(at->second)] = value;
    changed_.push_back(at->second);
  }
  return changed_;
}

}  // namespace racebeam
