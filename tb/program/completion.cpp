// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/completion.h"

#include <algorithm>

#include "tb/program/value_words.h"

namespace racebeam {

namespace {

bool is_option(const std::string& word) { return word.size() > 1 && word[0] == '-'; }

/// Where the command line has come to.
class Place {
 public:
  explicit Place(const CommandText& program) : command_(&program) {}

  void pass(const std::string& word) {
    if (values_ > 0) {
      --values_;
    } else if (is_option(word)) {
      option_ = named(word.substr(0, word.find('=')));
      if (option_ && word.find('=') == std::string::npos) values_ = values_of(*option_);
    } else if (const CommandText* inner = inner_command(word)) {
      command_ = inner;
      positionals_ = 0;
    } else {
      ++positionals_;
    }
  }

  std::string completions(const std::string& word) const {
    if (values_ > 0) return values(*option_, "", word);
    const auto equals = word.find('=');
    if (is_option(word) && equals != std::string::npos) {
      const OptionText* option = named(word.substr(0, equals));
      return option ? values(*option, word.substr(0, equals + 1), word) : "";
    }
    if (!word.empty() && word[0] == '-') return options(word);
    std::string text;
    for (const CommandText& inner : commands()) text += line(inner.name, inner.summary, word);
    if (const OptionText* positional = awaited()) text += values(*positional, "", word);
    return text;
  }

 private:
  static std::string line(const std::string& found, const std::string& help,
                          const std::string& word) {
    return found.rfind(word, 0) == 0 ? found + "\t" + help + "\n" : "";
  }
  // Those that repeat an option take one word each time.
  static int values_of(const OptionText& option) {
    return std::min(option.least_values, option.most_values);
  }
  static std::string values(const OptionText& option, const std::string& before,
                            const std::string& word) {
    const ValueWords all = value_words(option.type, word.substr(before.size()));
    std::string text;
    for (const std::string& one : all.words) text += line(before + one, "", word);
    if (all.paths == ValueWords::Files) text += ":files\n";
    if (all.paths == ValueWords::Folders) text += ":folders\n";
    return text;
  }

  /// Those that the next word may be.
  const std::vector<CommandText>& commands() const {
    static const std::vector<CommandText> none;
    return positionals_ > 0 ? none : command_->commands;
  }
  const CommandText* inner_command(const std::string& word) const {
    for (const CommandText& inner : commands())
      if (inner.name == word) return &inner;
    return nullptr;
  }
  /// nullptr: none.
  const OptionText* named(const std::string& name) const {
    for (const OptionText& option : command_->options)
      if (std::count(option.names.begin(), option.names.end(), name)) return &option;
    return nullptr;
  }
  std::string options(const std::string& word) const {
    std::string text;
    for (const OptionText& option : command_->options)
      for (const std::string& name : option.names)
        if (name[1] == '-') text += line(name, option.help, word);
    return text;
  }
  /// The positional that the next word is; nullptr: none.
  const OptionText* awaited() const {
    int left = positionals_;
    for (const OptionText& option : command_->options) {
      if (!option.names.empty()) continue;
      if (left < option.most_values) return &option;
      left -= option.most_values;
    }
    return nullptr;
  }

  const CommandText* command_;
  int positionals_ = 0;                 // words of the command that were passed
  const OptionText* option_ = nullptr;  // its values are awaited
  int values_ = 0;                      // as many
};

}  // namespace

std::string completions(const CommandText& program, const std::vector<std::string>& words) {
  if (words.empty()) return {};
  Place place(program);
  for (auto word = words.begin(); word + 1 != words.end(); ++word) place.pass(*word);
  return place.completions(words.back());
}

}  // namespace racebeam
