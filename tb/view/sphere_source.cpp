// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/sphere_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "sc/base/constants.h"
#include "sc/sphere/engine.h"

namespace racebeam {

namespace {

constexpr int Key2 = 1 << 2, Key3 = 1 << 3;

}  // namespace

SphereSource::SphereSource(const SphereProgram& program, const sphere_knobs& k, int pictures)
    : program_(program),
      knobs_(k.resolved()),
      pictures_(pictures),
      watch_(Raster(k.clocks_per_pixel)) {
  picture_.width = watch_.raster().columns;
  picture_.height = watch_.raster().rows;
  picture_.bits = knobs_.colour_bits;
  restart();
  now_ = core_->picture();
  before_ = now_;
  compose(0);
}

void SphereSource::restart() {
  sphere_board start = program_.board;
  start.sw ^= pins_.switches;
  if (pins_.keys & Key2) start.key_n &= ~Key2;
  core_.emplace(knobs_, program_, start);
  motion_.emplace(program_.moving, program_.box, knobs_.capture_guard);
  next_ = 0;
}

double SphereSource::clock_hz() const {
  constexpr double PicosecondsPerSecond = 1e12;
  const sphere_counters& n = core_->counters();
  const double hz = PicosecondsPerSecond / clock_period_ps(knobs_.clocks_per_pixel);
  const auto taken = static_cast<double>(n.clocks + n.host_clocks);
  const double frame = watch_.raster().frame_clocks();
  return taken > 0 ? hz * frame / taken : hz;
}

// KEY3 apart, which is a reset.
sphere_board SphereSource::board_now() const {
  sphere_board board = program_.board_in(next_);
  board.sw ^= pins_.switches;
  board.key_n &= ~(pins_.keys & ~Key3);
  return board;
}

// Board and CPU before a picture.
void SphereSource::begin() {
  if (program_.resets(next_) || (pins_.keys & Key3)) {
    core_->reset(board_now());
    touched_ |= (pins_.keys & Key3) != 0;
  }
  if (next_ > 0) motion_->picture(core_->inputs().rotz_q);
}

// KEY2 is held until it is pressed again.
void SphereSource::end() {
  pins_.keys &= Key2;
  ++next_;
}

void SphereSource::draw() {
  if (next_ == pictures_) restart();
  begin();
  core_->load(motion_->table());
  core_->draw(board_now());
  before_ = std::move(now_);
  now_ = core_->picture();
  end();
}

void SphereSource::skip() {
  begin();
  core_->finish(board_now());
  end();
}

void SphereSource::compose(int rows) {
  const store_knobs store = knobs_.store();
  const std::uint64_t colour = (std::uint64_t{1} << 3 * store.colour_bits) - 1;
  picture_.colours.clear();
  for (int y = 0; y < picture_.height; ++y) {
    const std::vector<std::uint64_t>& words = y < rows ? now_ : before_;
    for (int x = 0; x < picture_.width; ++x) {
      const bool shown = x < store.picture_width || store.wrap_right;
      const int column = x & ((1 << store.column_bits()) - 1);
      const auto at = static_cast<std::size_t>(y << store.column_bits() | column);
      picture_.push(shown ? static_cast<std::uint32_t>(words[at] & colour) : 0);
    }
  }
}

void SphereSource::seek(int picture) {
  if (picture < next_) restart();
  while (next_ < picture) skip();
  watch_.restart();
}

int SphereSource::advance(int clocks) {
  const int all = watch_.raster().frame_clocks(), count = std::min(clocks, clocks_left());
  if (watch_.whole() || watch_.seen() == 0) draw();
  if (count == all) {
    watch_.whole_picture(next_ - 1);
  } else {
    for (int n = 0; n < count; ++n) watch_.clock(0, next_ - 1);
  }
  const int rows = watch_.whole()
                       ? picture_.height
                       : static_cast<int>(std::int64_t{core_->rows()} * watch_.seen() / all);
  compose(rows);
  return count;
}

void SphereSource::press(BoardPins pins) {
  pins_ = pins;
  touched_ = true;
}

FrameSource::Rows SphereSource::rows() const {
  const sphere_board board = board_now();
  const frame_counts counts = counted(core_->counters());
  const auto& infos = sphere_counter_infos();
  Rows rows = {{"SW17..SW0", fmt::format("{:018b}", board.sw)},
               {"KEY3..KEY0", fmt::format("{:04b}", 15 & ~(board.key_n & ~(pins_.keys & Key3)))},
               {"", ""}};
  for (std::size_t n = 0; n < counts.counters.size(); ++n)
    if (*infos[n].title) rows.emplace_back(infos[n].title, std::to_string(counts.counters[n]));
  return rows;
}

namespace {

std::unique_ptr<FrameSource> make(const Run& run) {
  const scene_tables* const tables = run.show.tables();
  return std::make_unique<SphereSource>(
      tables ? *static_cast<const SphereProgram*>(tables) : builtin_sphere_program(), run.k,
      run.show.frames());
}

}  // namespace

SourceKind sphere_sources() { return {sphere_engine(), {LevelTlm}, KeyHelp::Board, make}; }

}  // namespace racebeam
