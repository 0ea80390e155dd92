// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/command_options.h"

#include <CLI/CLI.hpp>

namespace racebeam {

const CommandOption& CommandOption::type_name(const std::string& name) const {
  option_->type_name(name);
  return *this;
}

const CommandOption& CommandOption::check(const CheckWord& check) const {
  option_->check(check);
  return *this;
}

const CommandOption& CommandOption::required() const {
  option_->required();
  return *this;
}

const CommandOption& CommandOption::default_str(const std::string& text) const {
  option_->default_str(text);
  return *this;
}

const CommandOption& CommandOption::capture_default_str() const {
  option_->capture_default_str();
  return *this;
}

const CommandOption& CommandOption::expected(int words) const {
  option_->expected(words);
  return *this;
}

const CommandOption& CommandOption::repeatable() const {
  option_->allow_extra_args(false);
  return *this;
}

const CommandOption& CommandOption::needs(const CommandOption& other) const {
  option_->needs(other.option_);
  return *this;
}

const CommandOption& CommandOption::excludes(const CommandOption& other) const {
  option_->excludes(other.option_);
  return *this;
}

CommandOption CommandOptions::add_option(const char* names, std::string& to,
                                         const std::string& help) const {
  return CommandOption(*app_->add_option(names, to, help));
}

CommandOption CommandOptions::add_option(const char* names, std::vector<std::string>& to,
                                         const std::string& help) const {
  return CommandOption(*app_->add_option(names, to, help));
}

CommandOption CommandOptions::add_option(const char* names, int& to,
                                         const std::string& help) const {
  return CommandOption(*app_->add_option(names, to, help));
}

CommandOption CommandOptions::add_option(const char* names, long long& to,
                                         const std::string& help) const {
  return CommandOption(*app_->add_option(names, to, help));
}

CommandOption CommandOptions::add_option(const char* names, std::optional<long long>& to,
                                         const std::string& help) const {
  return CommandOption(*app_->add_option(names, to, help));
}

CommandOption CommandOptions::add_flag(const char* names, bool& to, const std::string& help) const {
  return CommandOption(*app_->add_flag(names, to, help));
}

CommandOptions CommandOptions::add_subcommand(const char* name, const char* help,
                                              const std::function<void()>& chosen) const {
  app_->require_subcommand(1);
  CLI::App* one = app_->add_subcommand(name, help);
  one->callback(chosen);
  return CommandOptions(*one);
}

}  // namespace racebeam
