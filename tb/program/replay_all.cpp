// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/replay_all.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <new>
#include <sstream>
#include <thread>

#include "tb/base/child.h"
#include "tb/base/errors.h"
#include "tb/base/file_lock.h"
#include "tb/base/guarded.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/base/progress.h"
#include "tb/base/whole_file.h"
#include "tb/program/replay_part.h"
#include "tb/program/replay_source.h"
#include "tb/program/verify_report.h"
#include "tb/twin/use_option.h"

namespace racebeam {

namespace {

constexpr int MostFrames = 64, MostPictures = 4;  // of a part
constexpr int LeastParts = 16;                    // if there are so many frames
constexpr auto Pause = std::chrono::milliseconds(20);

/// Clocks that all processes have compared.
class SharedCount {
 public:
  SharedCount()
      : count_(new (mmap(nullptr, sizeof *count_, PROT_READ | PROT_WRITE,
                         MAP_SHARED | MAP_ANONYMOUS, -1, 0)) std::atomic<std::uint64_t>(0)) {}
  ~SharedCount() { munmap(count_, sizeof *count_); }
  SharedCount(const SharedCount&) = delete;
  SharedCount& operator=(const SharedCount&) = delete;
  std::atomic<std::uint64_t>& operator*() { return *count_; }

 private:
  std::atomic<std::uint64_t>* const count_;
};

/// All parts of the replay of one unit.
class AllFramesReplay {
 public:
  AllFramesReplay(const Replay& what, int frames)
      : what_(what),
        head_(replay_head(what)),
        key_(replay_key(what, head_)),
        folder_(what.options.folder + "/" + what.dut.unit) {
    const int most = what.run.show.engine().races_beam ? MostFrames : MostPictures;
    const int step = std::clamp(frames / LeastParts, 1, most);
    for (int first = 0; first < frames; first += step)
      parts_.push_back({first, std::min(step, frames - first)});
  }

  /// Throws Interrupted: what is done is kept.
  UnitVerdict run() {
    make_folder(folder_);
    FileLock lock(folder_);
    if (!lock.take())
      throw UsageError(folder_ +
                       ": another replay is at work there; wait for it, or choose "
                       "another folder with -o");
    expect_key();
    std::vector<ReplayPart> open;
    for (const ReplayPart& part : parts_)
      if (!read_part(folder_, part, key_)) open.push_back(part);
    work(open);
    return sum();
  }

 private:
  void expect_key() const;
  void work(const std::vector<ReplayPart>& open);
  void do_part(const ReplayPart& part, std::atomic<std::uint64_t>& compared);
  UnitVerdict sum() const;

  const Replay& what_;
  const TrafficHead head_;
  const std::string key_;     // of what is compared
  const std::string folder_;  // of the parts
  std::vector<ReplayPart> parts_;
};

/// The first line of `mine` that `theirs` does not have.
std::string other_line(const std::string& mine, const std::string& theirs) {
  std::istringstream lines(mine);
  for (std::string line; std::getline(lines, line);)
    if (("\n" + theirs).find("\n" + line + "\n") == std::string::npos)
      return line.substr(0, line.find(' '));
  return "text";
}

void AllFramesReplay::expect_key() const {
  const std::string path = folder_ + "/replay.txt";
  if (!std::filesystem::exists(path)) return write_text(path, key_);
  const std::string there = whole_file(path);
  if (there == key_) return;
  throw UsageError(
      fmt::format("{} holds parts of a replay with another {}: choose another folder "
                  "with -o, or remove that",
                  folder_, other_line(key_, there)));
}

void AllFramesReplay::do_part(const ReplayPart& part, std::atomic<std::uint64_t>& compared) {
  std::string file;
  const auto source = part_source(what_, head_, part, folder_, file);
  std::uint64_t told = 0;
  Replay what = what_;
  what.captured = fmt::format("--first {} --frames {}", part.first, part.frames);
  what.folder = folder_ + "/" + std::filesystem::path(part.file()).stem().string();
  const UnitVerdict verdict = replayed(what, *source, [&](std::uint64_t clocks) {
    compared += clocks - told;
    told = clocks;
  });
  if (!file.empty()) std::filesystem::remove(file);
  write_part(folder_, part, key_, verdict);
}

// Each part in a process of its own, as many as there are processors.
void AllFramesReplay::work(const std::vector<ReplayPart>& open) {
  const std::size_t jobs = std::max(1u, std::thread::hardware_concurrency());
  const auto frame_clocks = static_cast<std::int64_t>(what_.run.raster().frame_clocks());
  std::int64_t frames = 0;
  for (const ReplayPart& part : open) frames += part.frames;
  Progress progress(frames, "frames");
  SharedCount compared;
  std::map<pid_t, bool> running;
  std::size_t next = 0;
  int failed = 0;  // exit code of a part that could not be done
  bool told = false;
  while (!running.empty() || (next < open.size() && !interrupted() && failed == 0)) {
    while (running.size() < jobs && next < open.size() && !interrupted() && failed == 0) {
      const pid_t child = fork_child();
      if (child < 0) throw MissingTool("there is no place for another process");
      if (child == 0) {
        const int code = guarded([&] {
          do_part(open[next], *compared);
          return 0;
        });
        std::fflush(nullptr);
        _exit(code);
      }
      running[child] = true;
      ++next;
    }
    if ((interrupted() || failed != 0) && !told) {
      time_to_finish();
      for (const auto& [child, runs] : running) kill(child, SIGTERM);
      told = true;
    }
    for (auto at = running.begin(); at != running.end();) {
      int status = 0;
      if (waitpid(at->first, &status, WNOHANG) == 0) {
        ++at;
        continue;
      }
      const int code = WIFEXITED(status) ? WEXITSTATUS(status) : static_cast<int>(ExitMissing);
      if (code != 0 && failed == 0) failed = code;
      at = running.erase(at);
    }
    progress.draw(static_cast<std::int64_t>(*compared) / frame_clocks, *compared, what_.dut.unit);
    std::this_thread::sleep_for(Pause);
  }
  progress.clear();
  if (interrupted()) throw Interrupted();
  if (failed == ExitUsage)
    throw UsageError(folder_ + ": the replay has ended; what is done is kept");
  if (failed != 0)
    throw MissingTool(folder_ +
                      ": a process has ended early; what is done is kept, the same "
                      "command goes on");
}

UnitVerdict AllFramesReplay::sum() const {
  UnitVerdict all{what_.dut.unit, what_.traffic, 0, 0, 0, 0, {}, {}};
  for (const ReplayPart& part : parts_) {
    const auto one = read_part(folder_, part, key_);
    if (!one)
      throw UsageError(folder_ + "/" + part.file() + " is gone; run the same command again");
    all.clocks += one->clocks;
    all.masked += one->masked;
    all.differences += one->differences;
    all.seconds += one->seconds;
    if (!all.first) all.first = one->first;
    if (all.fault.empty()) all.fault = one->fault;
  }
  return all;
}

}  // namespace

int verify_all_frames(const VerifyOptions& options) {
  const Run run = open_run(options, true);
  const long long all = run.show.frames();
  const long long frames = options.frames == VerifyOptions::UsualFrames ? all : options.frames;
  if (frames < 1 || frames > all)
    throw UsageError(fmt::format("--frames {} is out of range; the scene has {}", frames, all));
  try_folder(options.folder);
  std::vector<std::string> words;
  for (const std::string& word :
       options.units.empty() ? std::vector<std::string>{AllUnits} : options.units) {
    if (word != AllUnits) words.push_back(word);
    else
      for (const std::string& unit : run.show.engine().unit_names(run.show.tables() != nullptr))
        words.push_back(unit);
  }
  catch_interrupts();
  std::vector<UnitVerdict> verdicts;
  for (const std::string& word : words) {
    Replay what = replay_of(options, run, word, nullptr);
    what.traffic = "all";
    verdicts.push_back(AllFramesReplay(what, static_cast<int>(frames)).run());
  }
  return tell_verdicts(verdicts, options.seed, options.json);
}

}  // namespace racebeam
