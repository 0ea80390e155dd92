// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/man_page.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

#include "tb/base/version.h"
#include "tb/program/help_text.h"

namespace racebeam {

namespace {

/// A text as it is, whatever troff makes of its letters.
std::string plain(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '\\') out += "\\e";
    else if (letter == '-') out += "\\-";
    else if (letter == '\'') out += "\\(aq";
    else if (letter == '`') out += "\\(ga";
    else if (letter == '~') out += "\\(ti";
    else if (letter == '^') out += "\\(ha";
    else out += letter;
  }
  return out;
}

/// Text that is filled, in lines that an editor shows; none of them a request.
std::string lines(const std::string& text) {
  constexpr std::size_t Columns = 80;
  std::string out, line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    word = plain(word);
    if (!line.empty() && line.size() + 1 + word.size() > Columns) {
      out += line + "\n";
      line.clear();
    }
    if (!line.empty()) line += " ";
    else if (word[0] == '.') line = "\\&";
    line += word;
  }
  return out + line + "\n";
}

std::string bold(const std::string& text) { return "\\fB" + plain(text) + "\\fR"; }
std::string italic(const std::string& text) {
  return text.empty() ? text : "\\fI" + plain(text) + "\\fR";
}

std::string quoted(const std::string& heading) { return "\"" + plain(heading) + "\""; }

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return std::toupper(letter); });
  return text;
}

class Page {
 public:
  explicit Page(const CLI::App& app) : app_(app) {}

  std::string text() {
    const std::string& name = app_.get_name();
    out_ << ".TH " << quoted(upper(name)) << " 1 \"\" " << quoted(name + " " + program_version())
         << " " << quoted("User Commands") << "\n";
    section("Name", plain(name) + " \\- " + plain(app_.get_description()) + "\n");
    section("Synopsis",
            bold(name) + " " + italic("command") + " [" + italic("option or argument") + " ...]\n");
    section("Options", "");
    options(app_);
    section("Commands", "");
    for (const CLI::App* command : app_.get_subcommands(nullptr)) add(*command, name);
    section("Exit status", lines(app_.get_footer()));
    section("See also", bold("verilator") + "(1), " + bold("gtkwave") + "(1)\n");
    return out_.str();
  }

 private:
  void section(const std::string& heading, const std::string& text) {
    out_ << ".SH " << quoted(upper(heading)) << "\n" << text;
  }

  void add(const CLI::App& command, const std::string& before) {
    const std::string name = before + " " + command.get_name();
    out_ << ".SS " << quoted(name) << "\n" << lines(command.get_description() + ".");
    options(command);
    for (const CLI::App* inner : command.get_subcommands(nullptr)) add(*inner, name);
    if (const std::string example = example_of(command);
        !example.empty() && command.get_parent() == &app_)
      out_ << ".PP\nExample:\n.PP\n.nf\n" << plain(example) << "\n.fi\n";
  }

  // Positionals first; --help once for all.
  void options(const CLI::App& command) {
    std::string rest;
    for (const CLI::Option* option : command.get_options()) {
      if (option == command.get_help_ptr() && &command != &app_) continue;
      const bool positional = !option->nonpositional();
      const std::string entry = ".TP\n" + bold(help_.make_option_name(option, positional)) +
                                italic(help_.make_option_opts(option)) + "\n" +
                                lines(help_.make_option_desc(option));
      if (positional) out_ << entry;
      else rest += entry;
    }
    out_ << rest;
  }

  static std::string example_of(const CLI::App& command) {
    std::istringstream footer(command.get_footer());
    std::string line;
    if (!std::getline(footer, line) || line != "Example:" || !std::getline(footer, line)) return {};
    return line.substr(std::min(line.find_first_not_of(' '), line.size()));
  }

  const CLI::App& app_;
  const HelpText help_;
  std::ostringstream out_;
};

}  // namespace

std::string man_page(const CLI::App& app) { return Page(app).text(); }

}  // namespace racebeam
