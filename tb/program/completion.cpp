// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/completion.h"

#include "tb/program/value_words.h"

namespace racebeam {

namespace {

bool is_option(const std::string& word) { return word.size() > 1 && word[0] == '-'; }

/// Where the command line has come to.
class Place {
 public:
  explicit Place(const CLI::App& app) : command_(&app) {}

  void pass(const std::string& word) {
    if (values_ > 0) {
      --values_;
    } else if (is_option(word)) {
      option_ = command_->get_option_no_throw(word.substr(0, word.find('=')));
      if (option_ && word.find('=') == std::string::npos) values_ = values_of(*option_);
    } else if (const CLI::App* inner = inner_command(word)) {
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
      const CLI::Option* option = command_->get_option_no_throw(word.substr(0, equals));
      return option ? values(*option, word.substr(0, equals + 1), word) : "";
    }
    if (!word.empty() && word[0] == '-') return options(word);
    std::string text;
    for (const CLI::App* inner : commands())
      text += line(inner->get_name(), inner->get_description(), word);
    if (const CLI::Option* positional = awaited()) text += values(*positional, "", word);
    return text;
  }

 private:
  static std::string line(const std::string& found, const std::string& help,
                          const std::string& word) {
    return found.rfind(word, 0) == 0 ? found + "\t" + help + "\n" : "";
  }
  // Those that repeat an option take one word each time.
  static int values_of(const CLI::Option& option) {
    return std::min(option.get_items_expected_min(), option.get_items_expected_max());
  }
  static std::string values(const CLI::Option& option, const std::string& before,
                            const std::string& word) {
    const ValueWords all = value_words(option.get_type_name(), word.substr(before.size()));
    std::string text;
    for (const std::string& one : all.words) text += line(before + one, "", word);
    if (all.paths == ValueWords::Files) text += ":files\n";
    if (all.paths == ValueWords::Folders) text += ":folders\n";
    return text;
  }

  /// Those that the next word may be.
  std::vector<const CLI::App*> commands() const {
    if (positionals_ > 0) return {};
    return command_->get_subcommands(nullptr);
  }
  const CLI::App* inner_command(const std::string& word) const {
    for (const CLI::App* inner : commands())
      if (inner->get_name() == word) return inner;
    return nullptr;
  }
  std::string options(const std::string& word) const {
    std::string text;
    for (const CLI::Option* option : command_->get_options())
      for (const std::string& name : option->get_lnames())
        text += line("--" + name, option->get_description(), word);
    return text;
  }
  /// The positional that the next word is; nullptr: none.
  const CLI::Option* awaited() const {
    int left = positionals_;
    for (const CLI::Option* option : command_->get_options()) {
      if (!option->get_positional()) continue;
      if (left < option->get_items_expected_max()) return option;
      left -= option->get_items_expected_max();
    }
    return nullptr;
  }

  const CLI::App* command_;
  int positionals_ = 0;                  // words of the command that were passed
  const CLI::Option* option_ = nullptr;  // its values are awaited
  int values_ = 0;                       // as many
};

}  // namespace

std::string completions(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty()) return {};
  Place place(app);
  for (auto word = words.begin(); word + 1 != words.end(); ++word) place.pass(*word);
  return place.completions(words.back());
}

}  // namespace racebeam
