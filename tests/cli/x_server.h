// An X server of its own for a test: Xvfb, whose screen is a file, and xdotool, which presses keys.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tb/view/view_layout.h"
#include "tests/support/scratch_folder.h"

namespace racebeam {

/// Waits for something that is bound to happen; false if it does not within half a minute.
inline bool eventually(const std::function<bool()>& happened) {
  for (int i = 0; i < 1500; ++i) {
    if (happened()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

class XServer {
 public:
  /// Starts it and points DISPLAY at it. Throws std::runtime_error if it is not installed.
  explicit XServer(int width = 1024, int height = 768) : width_(width), height_(height) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
    int pipe_ends[2];
    if (pipe(pipe_ends) != 0) throw std::runtime_error("no pipe");
    pid_ = fork();
    if (pid_ == 0) {
      const std::string number = std::to_string(pipe_ends[1]);
      // Without -noreset it refuses connections for a moment when its last client has gone: a
      // viewer that starts again has no window then.
      execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", size.c_str(), "-fbdir",
             folder_.path().c_str(), "-nolisten", "tcp", "-noreset", nullptr);
      _exit(127);
    }
    close(pipe_ends[1]);
    std::string display = ":";
    for (char c; read(pipe_ends[0], &c, 1) == 1 && c != '\n';) display += c;
    close(pipe_ends[0]);
    if (display == ":") throw std::runtime_error("Xvfb does not start; see scripts/setup");
    setenv("DISPLAY", display.c_str(), 1);
    if (xdotool("version").empty()) throw std::runtime_error("no xdotool; see scripts/setup");
  }
  ~XServer() {
    kill(pid_, SIGTERM);
    waitpid(pid_, nullptr, 0);
  }
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  /// Runs xdotool; returns what it prints.
  static std::string xdotool(const std::string& arguments) {
    std::string said;
    std::FILE* out = popen(("xdotool " + arguments + " 2>/dev/null").c_str(), "r");
    for (int c; out && (c = std::fgetc(out)) != EOF;) said += static_cast<char>(c);
    if (out) pclose(out);
    return said;
  }
  /// Moves the pointer into the program's window, once it is there.
  static void point_at_window() {
    xdotool("search --sync --onlyvisible --name '^racebeam' mousemove --window %1 200 200");
  }
  static void key(const std::string& name) { xdotool("key " + name); }

  /// Clicks on a pixel of the program's window.
  static void click_on_window(int x, int y) {
    xdotool("search --name '^racebeam' mousemove --window %1 " + std::to_string(x) + " " +
            std::to_string(y) + " click 1");
  }

  /// Where the program's window is; of no size if there is none.
  static Box window_box() {
    const std::string place = xdotool("search --name '^racebeam' getwindowgeometry --shell");
    const auto number = [&](const std::string& name) {
      const auto at = place.find(name);
      return at == std::string::npos ? 0 : std::atoi(place.c_str() + at + name.size());
    };
    return {number("\nX="), number("\nY="), {number("\nWIDTH="), number("\nHEIGHT=")}};
  }

  /// The screen inside the program's window: 3 bytes a pixel; empty if it has another size.
  std::vector<std::uint8_t> window(int width, int height) const {
    const Box box = window_box();
    if (box.size != Extent{width, height} || box.left < 0 || box.top < 0) return {};
    return pixels(box.left, box.top, width, height);
  }

  /// The whole screen.
  std::vector<std::uint8_t> screen() const { return pixels(0, 0, width_, height_); }

 private:
  // The screen is an XWD file: a header of big-endian words, colours of 32 bits after it.
  std::vector<std::uint8_t> pixels(int left, int top, int width, int height) const {
    std::FILE* file = std::fopen((folder_ / "Xvfb_screen0").c_str(), "rb");
    if (!file) return {};
    std::array<std::uint8_t, 100> header{};
    std::vector<std::uint8_t> rgb;
    if (std::fread(header.data(), 1, header.size(), file) == header.size()) {
      const auto word = [&](int index) {
        const std::uint8_t* at = &header[4 * index];
        return static_cast<long>(at[0]) << 24 | at[1] << 16 | at[2] << 8 | at[3];
      };
      const long pixels_at = word(0) + 12 * word(19), stride = word(12);
      std::vector<std::uint8_t> row(4 * width);
      for (int y = top; y < top + height; ++y) {
        std::fseek(file, pixels_at + y * stride + 4L * left, SEEK_SET);
        if (std::fread(row.data(), 1, row.size(), file) != row.size()) break;
        for (int x = 0; x < width; ++x)
          rgb.insert(rgb.end(), {row[4 * x + 2], row[4 * x + 1], row[4 * x]});
      }
    }
    std::fclose(file);
    return rgb;
  }

  const int width_, height_;
  ScratchFolder folder_;
  pid_t pid_ = -1;
};

}  // namespace racebeam
