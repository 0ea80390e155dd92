// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_run.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sc/base/constants.h"

namespace racebeam {

namespace {

constexpr int ResetClocks = 10;
constexpr std::uint64_t SearchStep = 105'000;  // clocks

}  // namespace

TtRun::TtRun(const TtProject& project, const std::string& plugin, TtInputs inputs)
    : project_(project), plugin_(plugin), inputs_(std::move(inputs)), found_(find()) {
  schedule();
  if (!times_.empty() && times_.front() < chip_->clock()) restart();
}

void TtRun::reset_chip() {
  chip_.reset();  // before the next: they share their library
  chip_ = std::make_unique<TtChip>(plugin_, project_.source_folder, inputs_.start());
  chip_->reset(ResetClocks);
  ahead_.clear();
  next_ = 0;
}

FoundFrames TtRun::find() {
  reset_chip();
  for (;;) {
    chip_->run(SearchStep, ahead_);
    if (const auto found = find_frames(ahead_, chip_->clock(),
                                       static_cast<double>(project_.clock_hz), project_.clock_sure))
      return *found;
  }
}

void TtRun::schedule() {
  times_ = inputs_.clocks(found_.raster);
  for (std::uint64_t& time : times_) time += found_.first;
}

void TtRun::restart() {
  reset_chip();
  clock_ = 0;
}

// The chip, up to that clock, with the inputs of that clock.
void TtRun::simulate(std::uint64_t until) {
  for (;;) {
    for (; next_ < times_.size() && times_[next_] <= chip_->clock(); ++next_)
      chip_->set_inputs(inputs_.changes()[next_].pins);
    if (chip_->clock() >= until) return;
    std::uint64_t end = until;
    if (next_ < times_.size()) end = std::min(end, times_[next_]);
    if (look_) {
      look_(chip_->clock());
      end = chip_->clock() + 1;
    }
    chip_->run(end - chip_->clock(), ahead_);
  }
}

void TtRun::run(std::uint64_t until, std::vector<PinChange>& changes) {
  simulate(until);
  clock_ = until;
  const auto seen = std::find_if(ahead_.begin(), ahead_.end(),
                                 [&](const PinChange& change) { return change.clock >= until; });
  changes.insert(changes.end(), ahead_.begin(), seen);
  ahead_.erase(ahead_.begin(), seen);
}

void TtRun::each_clock(std::function<void(std::uint64_t clock)> look) {
  stand();
  look_ = std::move(look);
}

void TtRun::stand() {
  if (chip_->clock() == clock_) return;
  reset_chip();
  simulate(clock_);
  ahead_.clear();
}

void TtRun::press(TilePins pins) {
  if (clock_ < found_.first) throw std::logic_error("TtRun: inputs change from frame 0 on");
  const std::uint64_t at = clock_ - found_.first;
  const auto frame = static_cast<std::uint64_t>(found_.raster.frame_clocks());
  const int in_frame = static_cast<int>(at % frame), line = found_.raster.line_clocks();
  const bool ahead = chip_->clock() > clock_;
  inputs_.change({static_cast<int>(at / frame), found_.raster.first_line + in_frame / line,
                  in_frame % line, pins});
  schedule();
  next_ = std::min(next_, times_.size() - 1);
  if (ahead) stand();
}

TilePins TtRun::pins_at(std::uint64_t clock) const {
  const auto later = std::upper_bound(times_.begin(), times_.end(), clock);
  return later == times_.begin() ? inputs_.start()
                                 : inputs_.changes()[later - times_.begin() - 1].pins;
}

}  // namespace racebeam
