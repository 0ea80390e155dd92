// block_renderer: scheduler, cores and bus in one loop, without SystemC: the base of the tlm level.
// The same words in the same clocks as block_scheduler, block_cores and block_bus.
//
// The loop goes from event to event: a core offers a word, or is idle. Between them nothing but
// time passes, which block_rays knows.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <queue>
#include <utility>
#include <vector>

#include "sc/block/block_rays.h"

namespace racebeam {

class block_renderer {
 public:
  block_renderer(const block_knobs& k, const block_world& world);

  /// Draws a picture. `put(clock, word)`: the bus offers a word in this clock, the first job is
  /// dealt in clock 0; whether it was taken.
  template <class Put>
  void draw(Put&& put) {
    begin();
    while (busy()) {
      step();
      if (!asking_) continue;
      const int core = served();
      const bool taken = put(clock_, offered(core));
      n_.bus_stalls += waiting() - taken;
      if (taken) next_word(core);
    }
    end();
  }
  /// Of the picture drawn last.
  const block_counters& counters() const { return n_; }

  /// Which core drew a block, and when it was dealt.
  struct dealt {
    int core;
    std::int64_t clock;
  };
  /// What is noted of the pictures drawn from now on: of each block, and the clock in which each
  /// pixel begins, row by row; one of a block that is cleared begins with its job.
  struct notes {
    std::vector<dealt> blocks;
    std::vector<std::int64_t> begins;
  };
  void note(notes* to) { notes_ = to; }

 private:
  struct core {
    int clocks = 0;          // of its job
    std::int64_t begin = 0;  // of its job, later by what it waited
    std::size_t next = 0;    // word
    std::vector<block_word> words;
    // While it is noted:
    int x = 0, y = 0;
    std::vector<int> begins;
    std::size_t pixel = 0;  // that begins next
  };
  using event = std::pair<std::int64_t, int>;  // clock; 2 * core, + 1: it is idle

  void begin();
  bool busy() const { return jobs_left() || idle_ != all_; }
  bool jobs_left() const { return y_ < knobs_.rows(); }
  void step();
  void deal(int to);
  int served() const;
  const block_word& offered(int core) const {
    const auto& c = cores_[static_cast<std::size_t>(core)];
    return c.words[c.next];
  }
  std::uint64_t waiting() const;
  void next_word(int core);
  void note_pixels(core& c);
  void end();

  const block_knobs knobs_;
  const std::uint64_t all_;
  block_rays rays_;
  std::vector<core> cores_;
  std::priority_queue<event, std::vector<event>, std::greater<event>> events_;
  std::uint64_t idle_ = 0, asking_ = 0;  // a bit a core
  std::uint64_t later_ = 0;              // the cores after the one that was served last
  std::int64_t clock_ = 0;
  int x_ = 0, y_ = 0;  // of the next job
  notes* notes_ = nullptr;
  block_counters n_;
};

}  // namespace racebeam
