// What a command says of its options. CLI11 reads them; it takes each source that includes it six
// seconds more to compile, so that only command_options.cpp and command_line.cpp do.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace racebeam {

/// What is wrong with a word of the command line; empty: nothing. May throw UsageError.
using CheckWord = std::function<std::string(const std::string& word)>;

/// An option, or an argument; the names of CLI::Option.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option& option) : option_(&option) {}

  const CommandOption& type_name(const std::string& name) const;
  const CommandOption& check(const CheckWord& check) const;
  const CommandOption& required() const;
  const CommandOption& default_str(const std::string& text) const;
  const CommandOption& capture_default_str() const;
  const CommandOption& expected(int words) const;
  /// One word each time that it is given.
  const CommandOption& repeatable() const;
  const CommandOption& needs(const CommandOption& other) const;
  const CommandOption& excludes(const CommandOption& other) const;

 private:
  CLI::Option* option_;
};

/// The options of a command; the names of CLI::App. What they are read into must outlive them.
class CommandOptions {
 public:
  explicit CommandOptions(CLI::App& app) : app_(&app) {}

  CommandOption add_option(const char* names, std::string& to, const std::string& help) const;
  CommandOption add_option(const char* names, std::vector<std::string>& to,
                           const std::string& help) const;
  CommandOption add_option(const char* names, int& to, const std::string& help) const;
  CommandOption add_option(const char* names, long long& to, const std::string& help) const;
  CommandOption add_option(const char* names, std::optional<long long>& to,
                           const std::string& help) const;
  CommandOption add_flag(const char* names, bool& to, const std::string& help) const;

  /// One of the commands that it has, and must have then; `chosen` is called if that was given.
  CommandOptions add_subcommand(const char* name, const char* help,
                                const std::function<void()>& chosen) const;

 private:
  CLI::App* app_;
};

}  // namespace racebeam
