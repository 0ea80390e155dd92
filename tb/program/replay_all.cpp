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
#include <memory>
#include <new>
#include <set>
#include <sstream>
#include <thread>

#include "tb/base/child.h"
#include "tb/base/console.h"
#include "tb/base/errors.h"
#include "tb/base/file_lock.h"
#include "tb/base/guarded.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/base/progress.h"
#include "tb/base/whole_file.h"
#include "tb/program/replay_job.h"
#include "tb/program/replay_part.h"
#include "tb/program/replay_record.h"
#include "tb/program/replay_source.h"
#include "tb/program/verify_report.h"
#include "tb/twin/use_option.h"
#include "tb/verilate/gate_netlist.h"

namespace racebeam {

namespace {

constexpr int MostFrames = 64, MostPictures = 1;  // of a part
constexpr int LeastParts = 16;                    // if there are so many frames
constexpr auto Pause = std::chrono::milliseconds(20);

/// "stacks"; netlists have their own, "stacks.gates".
std::string folder_name(const std::string& word) {
  const auto equals = word.find('=');
  const std::string unit = word.substr(0, equals);
  if (equals == std::string::npos || !gate_word(word.substr(equals + 1))) return unit;
  std::string gates = word.substr(equals + 1);
  std::replace_if(
      gates.begin(), gates.end(), [](char c) { return c == ':' || c == '/'; }, '.');
  return unit + "." + gates;
}

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

/// All parts of the replay of units.
class AllFramesReplay {
 public:
  AllFramesReplay(const VerifyOptions& options, const Run& run, std::vector<Replay> units,
                  std::vector<ReplayPart> parts)
      : options_(options), run_(run), parts_(std::move(parts)) {
    units_.reserve(units.size());
    for (Replay& what : units) {
      TrafficHead head = replay_head(what);
      std::string key = replay_key(what, head);
      std::string folder = options.folder + "/" + folder_name(what.word);
      units_.push_back({std::move(what), std::move(head), std::move(key), std::move(folder), {}});
    }
  }

  /// Throws Interrupted: what is done is kept.
  std::vector<UnitVerdict> run() {
    for (KeptUnit& unit : units_) {
      make_folder(unit.folder);
      unit.lock = std::make_unique<FileLock>(unit.folder);
      if (!unit.lock->take())
        throw UsageError(unit.folder +
                         ": another replay is at work there; wait for it, or choose "
                         "another folder with -o");
      expect_key(unit);
    }
    const std::vector<ReplayJob> jobs = open_jobs(units_, parts_, processes());
    for (KeptUnit& unit : units_)
      if (std::any_of(jobs.begin(), jobs.end(), [&](const ReplayJob& job) {
            return !job.in_parallel && std::count(job.units.begin(), job.units.end(), &unit) != 0;
          }))
        verilate(unit.what);
    work(jobs);
    std::vector<UnitVerdict> verdicts;
    for (const KeptUnit& unit : units_) verdicts.push_back(sum(unit));
    if (!options_.record.empty()) record(verdicts);
    return verdicts;
  }

 private:
  static void expect_key(const KeptUnit& unit);
  std::size_t processes() const {
    return options_.jobs > 0 ? static_cast<std::size_t>(options_.jobs)
                             : std::max(1u, std::thread::hardware_concurrency());
  }
  void work(const std::vector<ReplayJob>& open);
  UnitVerdict sum(const KeptUnit& unit) const;
  void record(const std::vector<UnitVerdict>& verdicts) const;

  const VerifyOptions& options_;
  const Run& run_;
  std::vector<KeptUnit> units_;
  const std::vector<ReplayPart> parts_;
};

/// The first line of `mine` that `theirs` does not have.
std::string other_line(const std::string& mine, const std::string& theirs) {
  std::istringstream lines(mine);
  for (std::string line; std::getline(lines, line);)
    if (("\n" + theirs).find("\n" + line + "\n") == std::string::npos)
      return line.substr(0, line.find(' '));
  return "text";
}

void AllFramesReplay::expect_key(const KeptUnit& unit) {
  const std::string path = unit.folder + "/replay.txt";
  if (!std::filesystem::exists(path)) return write_text(path, unit.key);
  const std::string there = whole_file(path);
  if (there == unit.key) return;
  throw UsageError(
      fmt::format("{} holds parts of a replay with another {}: choose another folder "
                  "with -o, or remove that",
                  unit.folder, other_line(unit.key, there)));
}

// Each job in a process of its own, as many as there are to be.
void AllFramesReplay::work(const std::vector<ReplayJob>& open) {
  const auto start = std::chrono::steady_clock::now();
  const std::size_t jobs = processes();
  const auto frame_clocks = static_cast<std::int64_t>(run_.raster().frame_clocks());
  std::int64_t frames = 0;  // of all units
  for (const ReplayJob& one : open)
    for (const ReplayPart& part : one.parts)
      frames += part.frames * static_cast<std::int64_t>(one.units.size());
  Progress progress(frames, "frames of units");
  SharedCount compared;
  std::map<pid_t, bool> running;
  std::size_t next = 0;
  int failed = 0;  // exit code of a part that could not be done
  bool told = false;
  const auto late = [&] {
    return options_.minutes > 0 &&
           std::chrono::steady_clock::now() - start >= std::chrono::minutes(options_.minutes);
  };
  const auto goes_on = [&] {
    return next < open.size() && !interrupted() && failed == 0 && !late();
  };
  while (!running.empty() || goes_on()) {
    while (running.size() < jobs && goes_on()) {
      const pid_t child = fork_child();
      if (child < 0) throw MissingTool("there is no place for another process");
      if (child == 0) {
        const int code = guarded([&] {
          do_job(open[next], *compared);
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
    progress.draw(static_cast<std::int64_t>(*compared) / frame_clocks, *compared);
    std::this_thread::sleep_for(Pause);
  }
  progress.clear();
  if (interrupted()) throw Interrupted();
  if (failed == ExitUsage)
    throw UsageError(options_.folder + ": the replay has ended; what is done is kept");
  if (failed != 0)
    throw MissingTool(options_.folder +
                      ": a process has ended early; what is done is kept, the same "
                      "command goes on");
  if (next < open.size()) {
    std::set<int> left;  // their first frames
    for (; next < open.size(); ++next)
      for (const ReplayPart& part : open[next].parts) left.insert(part.first);
    tell(fmt::format("{}: {} of {} parts are not done after {} minutes; the same command goes on",
                     options_.folder, left.size(), parts_.size(), options_.minutes));
    throw Interrupted();
  }
}

UnitVerdict AllFramesReplay::sum(const KeptUnit& unit) const {
  UnitVerdict all{unit.what.dut.unit, unit.what.traffic, 0, 0, 0, 0, {}, {}};
  for (const ReplayPart& part : parts_) {
    const auto one = read_part(unit.folder, part, unit.key);
    if (!one)
      throw UsageError(unit.folder + "/" + part.file() + " is gone; run the same command again");
    all.clocks += one->clocks;
    all.masked += one->masked;
    all.differences += one->differences;
    all.seconds += one->seconds;
    if (!all.first) all.first = one->first;
    if (all.fault.empty()) all.fault = one->fault;
  }
  return all;
}

void AllFramesReplay::record(const std::vector<UnitVerdict>& verdicts) const {
  int frames = 0;
  for (const ReplayPart& part : parts_) frames += part.frames;
  std::string run_text = " --scene " + options_.scene + options_.set_text() + " --replay all";
  if (options_.first != VerifyOptions::Spread)
    run_text += fmt::format(" --first {}", parts_[0].first);
  if (frames < run_.show.frames()) run_text += fmt::format(" --frames {}", frames);
  std::vector<ReplayRow> rows;
  for (std::size_t n = 0; n < units_.size(); ++n) {
    const KeptUnit& unit = units_[n];
    rows.push_back(replay_row(unit.head, unit.what.word, unit.key, frames, verdicts[n], run_text));
  }
  write_replay_record(options_.record, rows);
}

/// Of the frames that are asked for. Throws UsageError: the scene does not have them.
std::vector<ReplayPart> parts_of(const VerifyOptions& options, const Run& run) {
  const long long all = run.show.frames();
  const bool spread = options.first == VerifyOptions::Spread;
  const long long begin = spread ? 0 : options.first;
  const long long frames =
      options.frames == VerifyOptions::UsualFrames ? all - begin : options.frames;
  if (frames < 1 || begin + frames > all)
    throw UsageError(spread
                         ? fmt::format("--frames {} is out of range; the scene has {}", frames, all)
                         : fmt::format("--first {} --frames {} is out of range; the scene has {}",
                                       begin, std::max(frames, 0LL), all));
  const long long most = run.show.engine().races_beam ? MostFrames : MostPictures;
  const long long step = std::clamp(frames / LeastParts, 1LL, most);
  const long long count = (frames + step - 1) / step, others = spread ? all - frames : 0;
  std::vector<ReplayPart> parts;
  for (long long n = 0; n < count; ++n)
    parts.push_back({static_cast<int>(begin + n * step + others * (2 * n + 1) / (2 * count)),
                     static_cast<int>(std::min(step, frames - n * step))});
  return parts;
}

/// Of each unit, with "all" written out. Throws UsageError: two go to one folder.
std::vector<std::string> words_of(const VerifyOptions& options, const Run& run) {
  std::vector<std::string> words;
  for (const std::string& word :
       options.units.empty() ? std::vector<std::string>{AllUnits} : options.units) {
    const auto equals = word.find('=');
    if (word.substr(0, equals) != AllUnits) {
      words.push_back(word);
      continue;
    }
    for (const std::string& unit : run.show.engine().unit_names(run.show.tables() != nullptr))
      words.push_back(unit + (equals == std::string::npos ? "" : word.substr(equals)));
  }
  std::map<std::string, std::string> folders;
  for (const std::string& word : words)
    if (const auto [at, fresh] = folders.emplace(folder_name(word), word); !fresh)
      throw UsageError(
          fmt::format("{} and {} would be kept in one folder; replay them one after "
                      "the other, each with its own -o",
                      at->second, word));
  return words;
}

}  // namespace

int verify_all_frames(const VerifyOptions& options) {
  const Run run = open_run(options, true);
  std::vector<ReplayPart> parts = parts_of(options, run);
  try_folder(options.folder);
  const std::vector<std::string> words = words_of(options, run);
  catch_interrupts();
  std::vector<Replay> units;
  units.reserve(words.size());
  for (const std::string& word : words) {
    units.push_back(replay_of(options, run, word, nullptr));
    units.back().traffic = "all";
  }
  AllFramesReplay replay(options, run, std::move(units), std::move(parts));
  return tell_verdicts(replay.run(), options.seed, options.json);
}

}  // namespace racebeam
