// A real GTKWave for a test: it runs on the X server of DISPLAY and is asked through its Tcl.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"

namespace racebeam {

class GtkWave {
 public:
  /// A row of its list of signals: a signal, or the begin or the end of a group.
  struct Row {
    unsigned flags;
    std::string name;   ///< "tag_i[8:0]", without its scope
    std::string value;  ///< as it is shown at the marker
    bool begins() const { return flags & 0x800000; }
    bool ends() const { return flags & 0x1000000; }
    bool folded() const { return flags & 0x400000; }
  };

  /// Starts it with these files. No settings of the user count.
  explicit GtkWave(const std::vector<std::string>& files) {
    int in[2], out[2];
    if (pipe2(in, O_CLOEXEC) != 0 || pipe2(out, O_CLOEXEC) != 0)
      throw std::runtime_error("no pipe");
    std::signal(SIGPIPE, SIG_IGN);
    pid_ = fork();
    if (pid_ == 0) become(files, in[0], out[1]);
    close(in[0]);
    close(out[1]);
    to_ = in[1];
    from_ = out[0];
  }
  ~GtkWave() {
    kill(pid_, SIGTERM);
    waitpid(pid_, nullptr, 0);
    close(to_);
    close(from_);
  }
  GtkWave(const GtkWave&) = delete;
  GtkWave& operator=(const GtkWave&) = delete;

  /// Runs a script; the lines that it puts. Throws std::runtime_error if there is no answer within
  /// half a minute.
  std::vector<std::string> run(const std::string& script) {
    const std::string all = "puts =begin\n" + script + "\nputs =end\n";
    if (write(to_, all.data(), all.size()) != static_cast<ssize_t>(all.size()))
      throw std::runtime_error("GTKWave is gone");
    while (read_line() != "=begin") {
    }
    std::vector<std::string> lines;
    for (std::string line; (line = read_line()) != "=end";) lines.push_back(line);
    return lines;
  }
  /// What one of its functions returns: ask("getNumFacs").
  std::string ask(const std::string& function) {
    const auto lines = run("puts [gtkwave::" + function + "]");
    return lines.empty() ? "" : lines.front();
  }
  double number(const std::string& function) { return std::atof(ask(function).c_str()); }

  std::vector<Row> rows() {
    const auto lines =
        run("set n [gtkwave::getTotalNumTraces]; for {set i 0} {$i < $n} {incr i} {"
            "puts [gtkwave::getTraceFlagsFromIndex $i]; puts [gtkwave::getTraceNameFromIndex $i]; "
            "puts [gtkwave::getTraceValueAtMarkerFromIndex $i]}");
    std::vector<Row> all;
    for (std::size_t n = 0; n + 2 < lines.size(); n += 3)
      all.push_back({static_cast<unsigned>(std::stoul(lines[n])), lines[n + 1], lines[n + 2]});
    return all;
  }
  void unfold(std::size_t row) {
    run("gtkwave::/Edit/UnHighlight_All; gtkwave::setTraceHighlightFromIndex " +
        std::to_string(row) + " on; gtkwave::/Edit/Toggle_Group_Open|Close");
  }

 private:
  [[noreturn]] void become(const std::vector<std::string>& files, int in, int out) {
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
    setenv("HOME", home_.path().c_str(), 1);
    setenv("GSETTINGS_BACKEND", "memory", 1);
    setenv("NO_AT_BRIDGE", "1", 1);
    std::vector<char*> words = {const_cast<char*>("gtkwave"), const_cast<char*>("-W")};
    for (const std::string& file : files) words.push_back(const_cast<char*>(file.c_str()));
    words.push_back(nullptr);
    if (chdir(home_.path().c_str()) == 0) execvp(words[0], words.data());
    _exit(127);
  }
  std::string read_line() {
    for (;;) {
      if (const auto end = read_.find('\n'); end != std::string::npos) {
        const std::string line = read_.substr(0, end);
        read_.erase(0, end + 1);
        return line;
      }
      pollfd ready{from_, POLLIN, 0};
      char some[4096];
      const ssize_t n = poll(&ready, 1, 30'000) == 1 ? read(from_, some, sizeof some) : 0;
      if (n <= 0) throw std::runtime_error("GTKWave does not answer; see scripts/setup");
      read_.append(some, static_cast<std::size_t>(n));
    }
  }

  ScratchFolder home_;
  std::string read_;
  int to_ = -1, from_ = -1;
  pid_t pid_ = -1;
};

}  // namespace racebeam
