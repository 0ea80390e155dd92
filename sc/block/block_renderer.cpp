// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/block/block_renderer.h"

namespace racebeam {

namespace {

std::uint64_t bit(int core) { return std::uint64_t{1} << core; }
int lowest(std::uint64_t cores) { return __builtin_ctzll(cores); }

}  // namespace

block_renderer::block_renderer(const block_knobs& k, const block_world& world)
    : knobs_(k),
      all_(~std::uint64_t{0} >> (BlockCores - k.cores)),
      rays_(k, world),
      cores_(static_cast<std::size_t>(k.cores)) {}

void block_renderer::begin() {
  n_ = {};
  if (notes_) {
    notes_->blocks.clear();
    notes_->begins.assign(static_cast<std::size_t>(knobs_.columns() * knobs_.rows()), 0);
  }
  idle_ = all_;
  clock_ = -1;
  x_ = y_ = 0;
}

void block_renderer::step() {
  ++clock_;
  if (!asking_ && !(idle_ && jobs_left())) clock_ = events_.top().first;
  for (; !events_.empty() && events_.top().first == clock_; events_.pop()) {
    const int what = events_.top().second;
    (what % 2 ? idle_ : asking_) |= bit(what / 2);
  }
  if (idle_ && jobs_left()) deal(lowest(idle_));
}

void block_renderer::deal(int to) {
  const block_job& job = rays_.job(x_, y_);
  core& c = cores_[static_cast<std::size_t>(to)];
  c.clocks = job.clocks;
  c.words = job.words;
  c.next = 0;
  c.begin = clock_ + 1;
  idle_ &= ~bit(to);
  events_.emplace(c.begin + c.words.front().clock, 2 * to);
  n_.busy_by_core[static_cast<std::size_t>(to)] += static_cast<unsigned>(job.clocks);
  if (notes_) {
    notes_->blocks.push_back({to, clock_});
    c.x = x_;
    c.y = y_;
    c.begins = job.begins;
    c.pixel = 0;
    note_pixels(c);
  }
  x_ += BlockSide;
  if (x_ < knobs_.columns()) return;
  x_ = 0;
  y_ += BlockSide;
}

int block_renderer::served() const { return lowest(asking_ & later_ ? asking_ & later_ : asking_); }

std::uint64_t block_renderer::waiting() const {
  return static_cast<std::uint64_t>(__builtin_popcountll(asking_));
}

void block_renderer::next_word(int served) {
  core& c = cores_[static_cast<std::size_t>(served)];
  c.begin = clock_ - c.words[c.next].clock;
  ++c.next;
  if (c.next < c.words.size()) events_.emplace(c.begin + c.words[c.next].clock, 2 * served);
  else events_.emplace(c.begin + c.clocks, 2 * served + 1);
  if (notes_) note_pixels(c);
  asking_ &= ~bit(served);
  later_ = ~(bit(served) | (bit(served) - 1));
}

// Those that no word still to come can put off.
void block_renderer::note_pixels(core& c) {
  const int known = c.next < c.words.size() ? c.words[c.next].clock : c.clocks;
  for (; c.pixel < c.begins.size() && c.begins[c.pixel] <= known; ++c.pixel) {
    const int x = c.x + static_cast<int>(c.pixel) % BlockSide;
    const int y = c.y + static_cast<int>(c.pixel) / BlockSide;
    notes_->begins[static_cast<std::size_t>(y * knobs_.columns() + x)] =
        c.begin + c.begins[c.pixel];
  }
}

void block_renderer::end() {
  rays_.take(n_);
  n_.clocks = static_cast<std::uint64_t>(clock_);
}

}  // namespace racebeam
