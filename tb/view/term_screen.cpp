// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/term_screen.h"

#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/view/term_keys.h"
#include "tb/view/term_picture.h"

namespace racebeam {

namespace {

constexpr const char* Enter = "\x1b[?1049h\x1b[?25l";  // the other screen, no cursor
constexpr const char* Leave = "\x1b[0m\x1b[?25h\x1b[?1049l";
constexpr int HeldPolls = 18;  // a terminal does not tell of keys that go up: so long they are down
constexpr int Smallest = 8, Largest = 1000;

/// Text of its own for each picture: a file, a pipe.
class Pages : public ViewScreen {
 public:
  bool poll(ViewControl&) override { return false; }
  void show(const Viewer& viewer) override {
    print(picture_.page(viewer.bare_picture(), viewer.words(), viewer.title(), size()));
  }

 private:
  static int number(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    const int value = text ? std::atoi(text) : 0;
    return value > 0 ? std::clamp(value, Smallest, Largest) : otherwise;
  }
  static TermSize size() { return {number("COLUMNS", 80), number("LINES", 24)}; }

  TermPicture picture_;
};

class Terminal : public ViewScreen {
 public:
  Terminal() : keys_(isatty(STDIN_FILENO) && tcgetattr(STDIN_FILENO, &before_) == 0) {
    if (keys_) {
      termios raw = before_;
      raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);  // Ctrl-C stays an interrupt
      raw.c_cc[VSUSP] = _POSIX_VDISABLE;  // a stopped viewer would keep the terminal
      raw.c_cc[VMIN] = 0;
      raw.c_cc[VTIME] = 0;
      tcsetattr(STDIN_FILENO, TCSANOW, &raw);
    }
    print(Enter);
  }
  ~Terminal() override {
    const std::string_view leave = Leave;
    if (write(stdout_file(), leave.data(), leave.size()) < 0) return;
    if (keys_) tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_);
    for (const std::string& line : told_) tell(line);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  bool poll(ViewControl& control) override {
    for (auto held = held_.begin(); held != held_.end();) {
      if (--held->second > 0) {
        ++held;
        continue;
      }
      control.release(held->first);
      held = held_.erase(held);
    }
    char bytes[256];
    const ssize_t count = keys_ ? read(STDIN_FILENO, bytes, sizeof bytes) : 0;
    const std::string_view came(bytes, static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    bool stale = false;
    for (const std::string& key : term_keys(came)) {
      stale |= control.press(key);
      held_[key] = HeldPolls;
    }
    return stale;
  }
  void show(const Viewer& viewer) override {
    print(picture_.draw(viewer.bare_picture(), viewer.words(),
                        viewer.title() + " - h: keys, q: quit", size()));
  }
  void tell_user(const std::string& line) override { told_.push_back(line); }

 private:
  static TermSize size() {
    winsize size{};
    if (ioctl(stdout_file(), TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return {};
    return {std::clamp<int>(size.ws_col, Smallest, Largest),
            std::clamp<int>(size.ws_row, Smallest, Largest)};
  }

  termios before_{};
  const bool keys_;
  TermPicture picture_;
  std::map<std::string, int> held_;
  std::vector<std::string> told_;  // when the other screen is left
};

}  // namespace

std::unique_ptr<ViewScreen> open_terminal(bool endless) {
  if (isatty(stdout_file())) return std::make_unique<Terminal>();
  if (endless)
    throw UsageError("stdout is no terminal: give --frames N to write N pictures as text");
  return std::make_unique<Pages>();
}

}  // namespace racebeam
