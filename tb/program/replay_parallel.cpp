// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/replay_parallel.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <deque>
#include <memory>

#include "tb/base/child.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/guarded.h"
#include "tb/base/interrupt.h"
#include "tb/base/whole_file.h"
#include "tb/twin/parallel_player.h"

namespace racebeam {

namespace {

using Time = std::chrono::steady_clock;

constexpr int PipeBytes = 1 << 20;
constexpr std::uint32_t End = ~std::uint32_t{0};

/// Before the rows of a block in a pipe.
struct Head {
  std::uint32_t unit;  // or End
  std::uint32_t is_private;
  std::uint64_t clocks;
};

/// Writes the blocks of a unit to a pipe.
class Sending : public BlockSink {
 public:
  Sending(int pipe, std::uint32_t unit, const std::vector<PortTraffic::Port>& ports)
      : BlockSink(ports.size()), pipe_(pipe), unit_(unit), row_(ports) {}

  void take(const TrafficBlock& block) override {
    const std::uint64_t clocks = block.values.size() / ports();
    if (clocks == 0) return;
    const Head head{unit_, block.is_private, clocks};
    std::string bytes(sizeof head + clocks * row_.bytes(), '\0');
    std::memcpy(bytes.data(), &head, sizeof head);
    char* to = bytes.data() + sizeof head;
    for (std::uint64_t n = 0; n < clocks; ++n, to += row_.bytes())
      row_.pack(block.values.data() + n * ports(), to);
    if (!write_all(pipe_, bytes)) throw Interrupted();  // nobody listens any more
  }

 private:
  const int pipe_;
  const std::uint32_t unit_;
  const PackedRow row_;
};

/// Rows of a unit that have come.
struct Rows {
  bool is_private;
  std::uint64_t clocks;
  std::string bytes;
};

/// The traffic of a part, as its process makes it.
class ComingPart {
 public:
  ComingPart(const std::vector<ReplayUnit>& units, const ReplayPart& part)
      : waiting_(units.size()) {
    for (const ReplayUnit& unit : units) row_bytes_.push_back(PackedRow(unit.head->ports).bytes());
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw MissingTool("there is no place for another pipe");
    fcntl(ends[1], F_SETPIPE_SZ, PipeBytes);  // slower without
    child_ = fork_child();
    if (child_ == 0) {
      close(ends[0]);
      const int code = guarded([&] {
        send(units, part, ends[1]);
        return 0;
      });
      _exit(code);
    }
    close(ends[1]);
    pipe_ = ends[0];
    if (child_ >= 0) return;
    close(pipe_);
    throw MissingTool("there is no place for another process");
  }
  ~ComingPart() {
    close(pipe_);
    kill(child_, SIGKILL);  // its brothers have our end of the pipe too: it may wait for ever
    wait_for_child(child_);
  }
  ComingPart(const ComingPart&) = delete;
  ComingPart& operator=(const ComingPart&) = delete;

  /// The next rows of a unit; nullptr: there are no more.
  const Rows* front(std::size_t unit) {
    while (waiting_[unit].empty() && !ended_) receive();
    return waiting_[unit].empty() ? nullptr : &waiting_[unit].front();
  }
  void pop(std::size_t unit) { waiting_[unit].pop_front(); }

 private:
  static void send(const std::vector<ReplayUnit>& units, const ReplayPart& part, int pipe) {
    std::vector<std::unique_ptr<Sending>> all;
    std::vector<BlockSink*> sinks;
    for (std::size_t n = 0; n < units.size(); ++n) {
      all.push_back(
          std::make_unique<Sending>(pipe, static_cast<std::uint32_t>(n), units[n].head->ports));
      sinks.push_back(all.back().get());
    }
    make_traffic(units, part, sinks);
    const Head head{End, 0, 0};
    write_all(pipe, std::string(reinterpret_cast<const char*>(&head), sizeof head));
  }
  void receive() {
    Head head{};
    take(&head, sizeof head);
    if (head.unit == End) {
      ended_ = true;
      return;
    }
    Rows rows{head.is_private != 0, head.clocks,
              std::string(head.clocks * row_bytes_[head.unit], '\0')};
    take(rows.bytes.data(), rows.bytes.size());
    waiting_[head.unit].push_back(std::move(rows));
  }
  void take(void* to, std::size_t bytes) {
    auto* next = static_cast<char*>(to);
    while (bytes > 0) {
      const ssize_t got = read(pipe_, next, bytes);
      if (interrupted()) throw Interrupted();
      if (got == 0) throw MissingTool("a process that made traffic has ended early");
      if (got < 0) continue;
      next += got;
      bytes -= static_cast<std::size_t>(got);
    }
  }

  std::vector<std::size_t> row_bytes_;
  std::vector<std::deque<Rows>> waiting_;  // by unit
  pid_t child_;
  int pipe_;
  bool ended_ = false;
};

/// A unit's instances, one for each part.
class ParallelUnit {
 public:
  ParallelUnit(const ReplayUnit& unit, std::size_t number, std::size_t parts)
      : unit_(unit),
        number_(number),
        player_(whole_file(unit.what->gates), unit.head->ports),
        instances_(parts),
        rest_(player_.row().bytes(), '\0') {}

  /// As many clocks as all parts have at hand; 0: all have ended.
  std::uint64_t go_on(const std::vector<std::unique_ptr<ComingPart>>& parts) {
    std::uint64_t clocks = ~std::uint64_t{0};
    std::vector<const Rows*> fronts;
    for (std::size_t n = 0; n < parts.size(); ++n) {
      fronts.push_back(parts[n]->front(number_));
      if (fronts[n]) clocks = std::min(clocks, fronts[n]->clocks - instances_[n].done);
    }
    if (clocks == ~std::uint64_t{0}) return 0;
    const auto start = Time::now();
    run(fronts, clocks);
    seconds_ += std::chrono::duration<double>(Time::now() - start).count();
    std::uint64_t compared = 0;
    for (std::size_t n = 0; n < parts.size(); ++n) {
      if (!fronts[n]) continue;
      Instance& one = instances_[n];
      if (!fronts[n]->is_private) {
        compared += clocks;
        one.compared += clocks;
      }
      one.done += clocks;
      if (one.done < fronts[n]->clocks) continue;
      parts[n]->pop(number_);
      one.done = 0;
    }
    return std::max<std::uint64_t>(compared, 1);
  }

  /// Nothing if the part differs.
  std::optional<UnitVerdict> verdict(std::size_t part) const {
    if (other_ >> part & 1) return {};
    UnitVerdict all{unit_.what->dut.unit,
                    unit_.what->traffic,
                    instances_[part].compared,
                    0,
                    0,
                    seconds_ / static_cast<double>(instances_.size()),
                    {},
                    {}};
    for (const PortTraffic::Port& port : unit_.head->ports) all.masked += !port.input;
    return all;
  }

 private:
  struct Instance {
    std::uint64_t done = 0;      // clocks of the rows at the front
    std::uint64_t compared = 0;  // that are not private
  };

  void run(const std::vector<const Rows*>& fronts, std::uint64_t clocks) {
    ParallelPlayer::Rows rows;
    rows.fill(rest_.data());  // of what has ended, and of nobody
    ParallelPlayer::Word compared = 0, begun = 0;
    for (std::size_t n = 0; n < fronts.size(); ++n) {
      if (!fronts[n]) continue;
      rows[n] = fronts[n]->bytes.data() + instances_[n].done * player_.row().bytes();
      const ParallelPlayer::Word bit = ParallelPlayer::Word{1} << n;
      if (fronts[n]->is_private) continue;
      compared |= bit;
      if (instances_[n].compared > 0) begun |= bit;
    }
    for (std::uint64_t clock = 0; clock < clocks; ++clock) {
      other_ |= player_.clock(rows, clock > 0 ? compared : begun);
      for (std::size_t n = 0; n < fronts.size(); ++n)
        if (fronts[n]) rows[n] += player_.row().bytes();
    }
  }

  const ReplayUnit& unit_;
  const std::size_t number_;
  ParallelPlayer player_;
  std::vector<Instance> instances_;
  const std::string rest_;
  ParallelPlayer::Word other_ = 0;  // instances that differ
  double seconds_ = 0;
};

}  // namespace

std::vector<std::vector<std::optional<UnitVerdict>>> replayed_in_parallel(
    const std::vector<ReplayUnit>& units, const std::vector<ReplayPart>& parts,
    const std::function<void(std::uint64_t)>& compared) {
  std::vector<std::unique_ptr<ParallelUnit>> players;
  for (std::size_t n = 0; n < units.size(); ++n)
    players.push_back(std::make_unique<ParallelUnit>(units[n], n, parts.size()));
  std::vector<std::unique_ptr<ComingPart>> coming;
  for (const ReplayPart& part : parts) coming.push_back(std::make_unique<ComingPart>(units, part));
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const auto& player : players)
      if (const std::uint64_t clocks = player->go_on(coming)) {
        goes_on = true;
        compared(clocks);
      }
  }
  std::vector<std::vector<std::optional<UnitVerdict>>> verdicts(parts.size());
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (const auto& player : players) verdicts[part].push_back(player->verdict(part));
  return verdicts;
}

}  // namespace racebeam
