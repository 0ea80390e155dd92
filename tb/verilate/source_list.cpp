// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/verilate/source_list.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/verilate/rtl_syntax.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

bool is_rtl(const fs::path& path) { return path.extension() == ".sv" || path.extension() == ".v"; }

std::vector<std::string> split(const std::string& text, char between) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, between);) parts.push_back(part);
  return parts;
}

/// `text` whole, if there is such a file; else its parts between '+'.
std::vector<std::string> names_in(const std::string& text) {
  std::error_code error;
  return fs::exists(text, error) ? std::vector<std::string>{text} : split(text, '+');
}

class Reader {
 public:
  explicit Reader(const std::string& top) { sources_.top = top; }

  void read(const std::string& name) {
    // The system would take what is before it for the name.
    if (name.find('\0') != std::string::npos)
      throw UsageError("a zero byte in the name of a file for the unit " + sources_.top);
    const fs::path path(name);
    std::error_code error;
    named_.push_back(name);
    if (fs::is_directory(path, error)) return read_folder(path);
    if (!fs::is_regular_file(path, error))
      throw UsageError("there is no file '" + name + "' for the unit " + sources_.top);
    if (path.extension() == ".f") return read_file_list(path);
    if (!is_rtl(path))
      throw UsageError("'" + name + "' is no RTL; it is a .sv, a .v, a list .f or a folder");
    sources_.files.push_back(name);
  }
  const RtlSources& sources() const { return sources_; }
  const std::vector<std::string>& named() const { return named_; }

 private:
  static constexpr int MostLists = 20;  // inside each other

  void read_folder(const fs::path& folder) {
    std::vector<std::string> files;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
      if (is_rtl(at->path())) files.push_back(at->path().string());
    if (error)
      throw UsageError("cannot read the folder " + folder.string() + ": " + error.message());
    if (files.empty()) throw UsageError("the folder " + folder.string() + " has no .sv or .v file");
    std::sort(files.begin(), files.end());
    // Packages are compiled before what uses them.
    std::stable_partition(files.begin(), files.end(), [](const std::string& file) {
      return fs::path(file).stem().string().find("pkg") != std::string::npos;
    });
    sources_.files.insert(sources_.files.end(), files.begin(), files.end());
  }

  void read_file_list(const fs::path& list) {
    if (++depth_ > MostLists) throw UsageError(list.string() + " names itself");
    std::ifstream in(list);
    int number = 0;
    for (std::string line; std::getline(in, line);) {
      const std::string where = list.string() + ":" + std::to_string(++number) + ": ";
      std::istringstream words(line);
      for (std::string word; next(words, word);) read_word(word, words, list.parent_path(), where);
    }
    --depth_;
  }

  /// A comment begins where a word could, and ends with the line.
  static bool next(std::istringstream& words, std::string& word) {
    return (words >> word) && word[0] != '#' && word.rfind("//", 0) != 0;
  }

  void read_word(const std::string& word, std::istringstream& rest, const fs::path& folder,
                 const std::string& where) {
    const auto path = [&](const std::string& name) { return (folder / name).string(); };
    if (word[0] == '+') {
      const std::vector<std::string> parts = split(word.substr(1), '+');
      if (parts.empty() || (parts[0] != "incdir" && parts[0] != "define" && parts[0] != "libext"))
        throw UsageError(where + "what is " + word + "? (there is +incdir+, +define+, +libext+)");
      for (std::size_t n = 1; n < parts.size(); ++n) {
        if (parts[0] == "incdir") sources_.include_folders.push_back(path(parts[n]));
        if (parts[0] == "define") sources_.defines.push_back(parts[n]);
      }
      return;
    }
    if (word[0] != '-') {
      try {
        return read(path(word));
      } catch (const UsageError& error) {
        throw UsageError(where + error.what());
      }
    }
    static const std::string Known = "fFvyIDG";
    if (word.size() < 2 || Known.find(word[1]) == std::string::npos)
      throw UsageError(where + "what is " + word + "? (there is -f, -v, -y, -I, -D, -G)");
    std::string value = word.substr(2);
    if (value.empty() && !next(rest, value)) throw UsageError(where + word + " of what?");
    switch (word[1]) {
      case 'v': sources_.libraries.push_back(path(value)); break;
      case 'y': sources_.libraries.push_back(path(value)); break;
      case 'I': sources_.include_folders.push_back(path(value)); break;
      case 'D': sources_.defines.push_back(value); break;
      case 'G': sources_.parameters.push_back(value); break;
      default: read(path(value));
    }
  }

  RtlSources sources_;
  std::vector<std::string> named_;
  int depth_ = 0;
};

Reader read_all(const std::string& top, const std::string& text) {
  Reader reader(top);
  for (const std::string& name : names_in(text)) reader.read(name);
  return reader;
}

}  // namespace

bool is_source_list(const std::string& text) {
  std::error_code error;
  const std::vector<std::string> names = names_in(text);
  return !names.empty() && std::all_of(names.begin(), names.end(), [&](const fs::path& name) {
    return is_rtl(name) || name.extension() == ".f" || fs::is_directory(name, error);
  });
}

RtlSources read_source_list(const std::string& top, const std::string& text) {
  return read_all(top, text).sources();
}

std::vector<std::string> files_of_list(const std::string& top, const std::string& text) {
  const auto read = read_all(top, text);
  std::vector<std::string> files = read.named();
  try {
    for (const std::string& file : read_rtl_syntax(read.sources()).files) files.push_back(file);
  } catch (const RtlError&) {  // who verilates it says what is wrong
  }
  return files;
}

}  // namespace racebeam
