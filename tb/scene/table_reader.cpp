// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/table_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "tb/base/nearest.h"

namespace racebeam {

namespace {

constexpr std::size_t LongestText = 64;

// Red, green and blue of "RGB" or [r, g, b]; false if there are not three of 0..3.
bool take_colour(const TomlNode& node, std::array<std::int64_t, 3>& parts) {
  if (node.kind == TomlNode::String && node.text.size() == parts.size()) {
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = node.text[i] - '0';
  } else if (node.kind == TomlNode::Array && node.items.size() == parts.size()) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      parts[i] = node.items[i].kind == TomlNode::Integer ? node.items[i].integer : -1;
  } else {
    return false;
  }
  return std::all_of(parts.begin(), parts.end(),
                     [](std::int64_t part) { return part >= 0 && part <= 3; });
}

bool read_colour(const TomlNode& node, const std::string& name, std::uint8_t& to, Faults& faults) {
  std::array<std::int64_t, 3> parts;
  if (!take_colour(node, parts)) {
    faults.add(node.place, "a colour of '" + name + "' is not three digits 0..3",
               "write red, green and blue: \"300\" or [3, 0, 0] is red, \"333\" white");
    return false;
  }
  to = static_cast<std::uint8_t>(parts[0] * 16 + parts[1] * 4 + parts[2]);
  return true;
}

}  // namespace

void wrong_type(const TomlNode& node, const std::string& name, const std::string& wanted,
                Faults& faults) {
  faults.add(node.place, "'" + name + "' is " + node.kind_name(), "it must be " + wanted);
}

std::string name_help(const std::string& name, const std::vector<std::string>& known) {
  constexpr std::size_t Listed = 12, LongestName = 256;
  const std::string meant = name.size() > LongestName ? "" : nearest(name, known);
  if (!meant.empty()) return "did you mean " + quoted(meant) + "?";
  std::string all;
  for (std::size_t i = 0; i < std::min(known.size(), Listed); ++i)
    all += (i ? ", " : "") + known[i];
  return known.empty() ? "there is none"
                       : "there is: " + all + (known.size() > Listed ? ", ..." : "");
}

bool read_number(const TomlNode& node, const std::string& name, int low, int high, int& to,
                 Faults& faults, const std::string& why) {
  const std::string range =
      std::to_string(low) + ".." + std::to_string(high) + (why.empty() ? "" : ": " + why);
  if (node.kind == TomlNode::Float && !std::isfinite(node.number)) {
    faults.add(node.place, "'" + name + "' is not a finite number",
               "it must be a whole number " + range);
    return false;
  }
  if (node.kind != TomlNode::Integer) {
    wrong_type(node, name, "a whole number " + range, faults);
    return false;
  }
  if (node.integer < low || node.integer > high) {
    faults.add(node.place, "'" + name + "' is " + std::to_string(node.integer),
               "it must be in " + range);
    return false;
  }
  to = static_cast<int>(node.integer);
  return true;
}

bool read_decimal(const TomlNode& node, const std::string& name, double low, double high,
                  double& to, Faults& faults) {
  const std::string range = fmt::format("{}..{}", low, high);
  const bool whole = node.kind == TomlNode::Integer;
  if (!whole && node.kind != TomlNode::Float) {
    wrong_type(node, name, "a number " + range, faults);
    return false;
  }
  const double number = whole ? static_cast<double>(node.integer) : node.number;
  if (!std::isfinite(number)) {
    faults.add(node.place, "'" + name + "' is not a finite number", "it must be in " + range);
    return false;
  }
  if (number < low || number > high) {
    faults.add(node.place, fmt::format("'{}' is {}", name, number), "it must be in " + range);
    return false;
  }
  to = number;
  return true;
}

bool read_text(const TomlNode& node, const std::string& name, std::string& to, Faults& faults) {
  if (node.kind != TomlNode::String) {
    wrong_type(node, name, "a text in quotes", faults);
    return false;
  }
  const bool printable = std::all_of(node.text.begin(), node.text.end(),
                                     [](unsigned char c) { return c >= 32 && c != 127; });
  if (node.text.size() > LongestText || !printable) {
    faults.add(node.place, "'" + name + "' is too long or has control characters",
               "write at most 64 letters, digits and signs in one line");
    return false;
  }
  to = node.text;
  return true;
}

bool read_word(const TomlNode& node, const std::string& name, const std::vector<std::string>& words,
               int& to, Faults& faults) {
  std::string word;
  if (!read_text(node, name, word, faults)) return false;
  const auto at = std::find(words.begin(), words.end(), word);
  if (at == words.end()) {
    std::string all;
    for (const std::string& one : words) all += (all.empty() ? "" : ", ") + one;
    faults.add(node.place, "'" + name + "' is " + quoted(word), "it must be one of " + all);
    return false;
  }
  to = static_cast<int>(at - words.begin());
  return true;
}

TableReader::TableReader(const TomlNode& node, const std::string& kind, Faults& faults,
                         const std::vector<FileKey>& keys)
    : node_(node), kind_(kind), faults_(faults) {
  const std::string name = kind.empty() ? "the file" : "'" + kind + "'";
  if (node.kind != TomlNode::Table) {
    faults.add(node.place, name + " is " + node.kind_name(), "it must be a table of keys");
    return;
  }
  const std::vector<std::string> known = keys_of(kind, keys);
  for (const TomlEntry& entry : node.entries)
    if (std::find(known.begin(), known.end(), entry.key) == known.end())
      faults.add(entry.place, "unknown key " + quoted(entry.key) + " in " + name,
                 name_help(entry.key, known));
}

const TomlNode* TableReader::require(const std::string& key, const std::string& help) const {
  const TomlNode* node = find(key);
  if (!node && node_.kind == TomlNode::Table)
    faults_.add(node_.place, "'" + kind_ + "' has no '" + key + "'", help);
  return node;
}

bool TableReader::read(const std::string& key, int low, int high, int& to,
                       const std::string& why) const {
  const TomlNode* node = find(key);
  return node && read_number(*node, key, low, high, to, faults_, why);
}

bool TableReader::read(const std::string& key, bool& to) const {
  const TomlNode* node = find(key);
  if (!node) return false;
  if (node->kind != TomlNode::Boolean) {
    wrong_type(*node, key, "true or false", faults_);
    return false;
  }
  to = node->integer != 0;
  return true;
}

bool TableReader::read(const std::string& key, std::string& to, bool may_be_empty) const {
  const TomlNode* node = find(key);
  if (!node) return false;
  if (node->kind == TomlNode::String && node->text.empty() && !may_be_empty) {
    faults_.add(node->place, "'" + key + "' is empty", "write a name");
    return false;
  }
  return read_text(*node, key, to, faults_);
}

bool TableReader::read(const std::string& key, int low, int high, Vector& to) const {
  const TomlNode* node = find(key);
  if (!node) return false;
  if (node->kind != TomlNode::Array || node->items.size() != 3) {
    wrong_type(*node, key, "three whole numbers, [x, y, z]", faults_);
    return false;
  }
  Vector read = to;
  bool good = true;
  for (int axis = 0; axis < 3; ++axis)
    good = read_number(node->items[axis], key, low, high, read[axis], faults_) && good;
  if (good) to = read;
  return good;
}

bool TableReader::read(const std::string& key, double low, double high, double& to) const {
  const TomlNode* node = find(key);
  return node && read_decimal(*node, key, low, high, to, faults_);
}

bool TableReader::read(const std::string& key, double low, double high,
                       std::array<double, 3>& to) const {
  const TomlNode* node = find(key);
  if (!node) return false;
  if (node->kind != TomlNode::Array || node->items.size() != to.size()) {
    wrong_type(*node, key, "three numbers, [x, y, z]", faults_);
    return false;
  }
  std::array<double, 3> read = to;
  bool good = true;
  for (std::size_t axis = 0; axis < to.size(); ++axis)
    good = read_decimal(node->items[axis], key, low, high, read[axis], faults_) && good;
  if (good) to = read;
  return good;
}

bool TableReader::read_rgb(const std::string& key, std::uint32_t& to) const {
  constexpr std::size_t Digits = 6;
  const TomlNode* node = find(key);
  if (!node) return false;
  if (node->kind != TomlNode::String) {
    wrong_type(*node, key, "a colour, \"#ff8000\"", faults_);
    return false;
  }
  const std::string& text = node->text;
  std::uint32_t colour = 0;
  if (text.size() == Digits + 1 && text[0] == '#') {
    const auto [end, error] =
        std::from_chars(text.data() + 1, text.data() + text.size(), colour, 16);
    if (error == std::errc() && end == text.data() + text.size()) {
      to = colour;
      return true;
    }
  }
  faults_.add(node->place, "'" + key + "' is " + quoted(text),
              "write red, green and blue with two digits 0..f each: \"#ff8000\" is orange");
  return false;
}

bool TableReader::read_choice(const std::string& key, const std::vector<std::string>& words,
                              int& to) const {
  const TomlNode* node = find(key);
  return node && read_word(*node, key, words, to, faults_);
}

bool TableReader::read(const std::string& key, Palette& to) const {
  const TomlNode* node = find(key);
  if (!node) return false;
  if (node->kind != TomlNode::Array || node->items.size() != to.size()) {
    wrong_type(*node, key, "four colours, [\"000\", \"111\", \"222\", \"333\"]", faults_);
    return false;
  }
  Palette read = to;
  bool good = true;
  for (std::size_t i = 0; i < to.size(); ++i)
    good = read_colour(node->items[i], key, read[i], faults_) && good;
  if (good) to = read;
  return good;
}

}  // namespace racebeam
