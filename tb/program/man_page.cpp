// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/man_page.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

#include "tb/base/version.h"

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
  explicit Page(const CommandText& program) : program_(program) {}

  std::string text() {
    const std::string& name = program_.name;
    out_ << ".TH " << quoted(upper(name)) << " 1 \"\" " << quoted(name + " " + program_version())
         << " " << quoted("User Commands") << "\n";
    section("Name", plain(name) + " \\- " + plain(program_.summary) + "\n");
    section("Synopsis",
            bold(name) + " " + italic("command") + " [" + italic("option or argument") + " ...]\n");
    section("Options", "");
    options(program_);
    section("Commands", "");
    for (const CommandText& command : program_.commands) add(command, name, true);
    section("Exit status", lines(program_.footer));
    section("See also", bold("verilator") + "(1), " + bold("gtkwave") + "(1)\n");
    return out_.str();
  }

 private:
  void section(const std::string& heading, const std::string& text) {
    out_ << ".SH " << quoted(upper(heading)) << "\n" << text;
  }

  void add(const CommandText& command, const std::string& before, bool with_example) {
    const std::string name = before + " " + command.name;
    out_ << ".SS " << quoted(name) << "\n" << lines(command.summary + ".");
    options(command);
    for (const CommandText& inner : command.commands) add(inner, name, false);
    if (const std::string example = example_of(command); !example.empty() && with_example)
      out_ << ".PP\nExample:\n.PP\n.nf\n" << plain(example) << "\n.fi\n";
  }

  // Positionals first; --help once for all.
  void options(const CommandText& command) {
    std::string rest;
    for (const OptionText& option : command.options) {
      if (option.is_help && &command != &program_) continue;
      const std::string entry =
          ".TP\n" + bold(option.shown) + italic(option.values) + "\n" + lines(option.help);
      if (option.names.empty()) out_ << entry;
      else rest += entry;
    }
    out_ << rest;
  }

  static std::string example_of(const CommandText& command) {
    std::istringstream footer(command.footer);
    std::string line;
    if (!std::getline(footer, line) || line != "Example:" || !std::getline(footer, line)) return {};
    return line.substr(std::min(line.find_first_not_of(' '), line.size()));
  }

  const CommandText& program_;
  std::ostringstream out_;
};

}  // namespace

std::string man_page(const CommandText& program) { return Page(program).text(); }

}  // namespace racebeam
