// `racebeam view --term`: on a terminal, and into a file.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>
#include <utmp.h>

#include <functional>

#include "tb/bench/core_bench.h"
#include "tests/cli/program.h"
#include "tests/support/ansi_terminal.h"

namespace racebeam {
namespace {

using testing::HasSubstr;

constexpr int Columns = 80, Rows = 31;
constexpr const char* Leave = "\x1b[?25h\x1b[?1049l";

/// The program on a terminal of its own.
class OnTerminal {
 public:
  explicit OnTerminal(std::vector<std::string> words) {
    const winsize size{Rows, Columns, 0, 0};
    if (openpty(&master_, &slave_, nullptr, nullptr, &size) != 0)
      throw std::runtime_error("no terminal");
    before_ = settings();
    words.insert(words.begin(), {"racebeam", "view"});
    pid_ = fork();
    if (pid_ != 0) return;
    login_tty(slave_);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(RACEBEAM_BINARY, arguments.data());
    _exit(127);
  }
  ~OnTerminal() {
    if (pid_ > 0) kill(pid_, SIGKILL), waitpid(pid_, nullptr, 0);
    close(master_);
    close(slave_);
  }

  /// Reads until the text has something; false after half a minute.
  bool says(const std::string& what) {
    for (int i = 0; i < 1500 && said.find(what) == std::string::npos; ++i) read_some(20);
    return said.find(what) != std::string::npos;
  }
  void type(const std::string& keys) const {
    ASSERT_EQ(write(master_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  int wait() {
    int status = 0;
    while (waitpid(pid_, &status, WNOHANG) == 0) read_some(20);
    read_some(0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }
  bool restored() const { return settings() == before_; }

  std::string said;

 private:
  std::string settings() const {
    termios now{};
    tcgetattr(slave_, &now);
    return std::to_string(now.c_lflag) + " " + std::to_string(now.c_iflag) + " " +
           std::to_string(now.c_oflag) + " " + std::to_string(now.c_cc[VMIN]);
  }
  void read_some(int milliseconds) {
    pollfd ready{master_, POLLIN, 0};
    char some[65536];
    while (poll(&ready, 1, milliseconds) > 0 && (ready.revents & POLLIN)) {
      const ssize_t count = read(master_, some, sizeof some);
      if (count <= 0) return;
      said.append(some, count);
      milliseconds = 0;
    }
  }

  int master_ = -1, slave_ = -1;
  pid_t pid_ = -1;
  std::string before_;
};

/// Whether the terminal shows a frame of the demo: the mean of its 8 x 8 pixels in each half.
void expect_frame(const AnsiTerminal& screen, int number) {
  const std::vector<std::uint8_t> frame = CoreBench({}, number).picture();
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x) {
      int sum = 0;
      for (int i = 0; i < 64; ++i)
        sum += rgb_of(frame[(8 * y + i / 8) * VisibleColumns + 8 * x + i % 8]).b;
      const AnsiTerminal::Cell& cell = screen.at(x, y / 2);
      ASSERT_EQ((y % 2 ? cell.paper : cell.ink).b, (sum + 32) / 64) << x << ',' << y;
    }
}

TEST(CliViewTerm, ShowsTheFrameObeysKeysAndGivesTheTerminalBack) {
  OnTerminal program({"demo", "--first", "7223", "--paused", "--term"});
  ASSERT_TRUE(program.says("paused"));
  AnsiTerminal screen(Columns, Rows);
  screen.take(program.said);
  expect_frame(screen, 7223);
  EXPECT_THAT(screen.row(Rows - 1), HasSubstr("racebeam: demo 7223 heights - paused"));
  program.type("h");
  EXPECT_TRUE(program.says("this help"));
  program.type("q");
  EXPECT_EQ(program.wait(), 0);
  EXPECT_THAT(program.said, HasSubstr(Leave));
  EXPECT_TRUE(program.restored());
}

TEST(CliViewTerm, CtrlCGivesTheTerminalBackAndEndsWith130) {
  OnTerminal program({"demo", "--first", "60", "--term"});
  ASSERT_TRUE(program.says("racebeam: demo"));
  program.type("\x03");
  EXPECT_EQ(program.wait(), 130);
  EXPECT_THAT(program.said, HasSubstr(Leave));
  EXPECT_TRUE(program.restored());
}

TEST(CliViewTerm, WithoutATerminalItNeedsANumberOfFrames) {
  const ScratchFolder folder;
  Program program(folder.path(), {"view", "demo", "--term"});
  EXPECT_EQ(program.wait(), 2);
  EXPECT_THAT(program.err(), HasSubstr("--frames N"));
  EXPECT_EQ(program.out(), "");
}

TEST(CliViewTerm, IntoAFileItWritesSoManyFramesAsText) {
  const ScratchFolder folder;
  setenv("COLUMNS", "80", 1);
  setenv("LINES", "31", 1);
  Program program(folder.path(), {"view", "demo", "--term", "--first", "7223", "--frames", "2"});
  ASSERT_EQ(program.wait(), 0) << program.err();
  const std::string text = program.out();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2 * Rows);
  std::size_t half = 0;
  for (int line = 0; line < Rows; ++line) half = text.find('\n', half) + 1;
  AnsiTerminal first(Columns, Rows), second(Columns, Rows);
  first.take(text.substr(0, half));
  second.take(text.substr(half));
  expect_frame(first, 7223);
  expect_frame(second, 7224);
}

}  // namespace
}  // namespace racebeam
