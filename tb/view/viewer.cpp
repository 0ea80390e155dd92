// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tb/base/errors.h"

namespace racebeam {

namespace {

constexpr int Leap = 60;              // frames of the arrow keys
constexpr int Slice = 20'000;         // clocks between two looks at the time
constexpr double LongestLag = 0.25;   // seconds that are caught up at most
constexpr double NewsInterval = 0.2;  // seconds between two looks at the scene file
constexpr int MostSound = 4;          // frames in one tick

}  // namespace

Viewer::Viewer(Stage stage, Options options)
    : stage_(std::move(stage)),
      options_(std::move(options)),
      watch_(options_.scene_file),
      recorder_(options_.folder) {
  go_to(options_.first);
  control.state.beam = !stage_.source->fast();
  control.state.inputs = stage_.source->inputs();
  control.state.board = stage_.source->board();
  control.state.plain = stage_.source->plain();
}

// What the keys made of the inputs. While a frame is filled they wait: it has its own.
void Viewer::press_inputs() {
  if (fill_) return;
  FrameSource& source = *stage_.source;
  if (control.state.inputs != source.inputs()) source.press(*control.state.inputs);
  else if (control.state.board != source.board()) source.press(*control.state.board);
  else return;
  changed_ = true;
}

int Viewer::next_frame() const {
  return (stage_.source->watch().frame() + 1) % stage_.show.frames();
}

// The frame is shown to its end at once, or as soon as the source can.
void Viewer::go_to(int frame) {
  const int frames = stage_.show.frames();
  sound_frame_ = ((frame % frames) + frames) % frames;
  stage_.source->seek(sound_frame_);
  flight_.reset();
  control.state.flying = false;
  fill_ = true;
  budget_ = 0;
}

// All simulation goes through here: at most to the end of the frame.
int Viewer::clocks(int count) {
  FrameSource& source = *stage_.source;
  if (flight_ && (source.watch().whole() || source.watch().seen() == 0)) {
    steer();
    source.fly(flight_frame_, flight_->pose());
  }
  const int done = source.advance(count);
  changed_ = true;
  if (!source.watch().whole()) return done;
  fill_ = false;
  ++frames_shown_;
  if (since_frame_ > 1e-3) rate_ += (1 / since_frame_ - rate_) * (rate_ > 0 ? 0.1 : 1);
  since_frame_ = 0;
  recorder_.add(colours(), std::exchange(passed_, 1));
  return done;
}

// Of the picture on show.
const std::vector<std::uint8_t>& Viewer::colours() const {
  const PackedPicture* const deep = stage_.source->picture();
  return deep ? deep->colours : stage_.source->watch().screen().colours();
}

void Viewer::finish_frame() {
  while (!stage_.source->watch().whole()) clocks(stage_.source->clocks_left());
}

void Viewer::step_pixel() {
  const FrameWatch& watch = stage_.source->watch();
  bool last = false;
  while (!last) {
    last = watch.raster().clocks[watch.screen().clock_of_line()].last;
    clocks(1);
  }
}

// Up to the end of lines that show something: the next visible ones, or the last of the frame.
void Viewer::step_lines(int lines) {
  const FrameWatch& watch = stage_.source->watch();
  do {
    const int y = watch.screen().y();
    clocks(watch.raster().line_clocks() - watch.screen().clock_of_line());
    if (watch.raster().visible_line(y)) --lines;
  } while (lines > 0 && !watch.whole());
}

void Viewer::act(ViewAction action) {
  const int frame = stage_.source->watch().frame();
  switch (action) {
    case ViewAction::StepFrame: clocks(stage_.source->clocks_left()); return say(place());
    case ViewAction::StepLine: step_lines(1); return say(place());
    case ViewAction::StepTenLines: step_lines(10); return say(place());
    case ViewAction::StepPixel: step_pixel(); return say(place());
    case ViewAction::StepClock: clocks(1); return say(place());
    case ViewAction::Rewind: go_to(options_.first); return say(place());
    case ViewAction::Back: go_to(std::max(frame - Leap, 0)); return say(place());
    case ViewAction::Forward: go_to(frame + Leap); return say(place());
    case ViewAction::Screenshot:
      return say_and_tell("wrote " + recorder_.screenshot(picture(), frame));
    case ViewAction::Record: return toggle_recording();
    case ViewAction::Fly: return toggle_flight();
    case ViewAction::FlightHint: return say("that key flies, but only in a free flight: f");
    case ViewAction::Explain: return explain();
    case ViewAction::Reload:
      if (options_.scene_file.empty()) return say("the built-in demo has no file to load again");
      return take_scene(watch_.read());
    case ViewAction::WriteInputs:
      return say_and_tell("wrote " + recorder_.inputs(stage_.source->inputs_text(), frame));
    case ViewAction::ModelOnly:
      return say("maps, intervals, gauges, flight and scene files are of the model only");
    case ViewAction::Quit: quit_ = true; return;
  }
}

// A GIF begins with the frame on show.
void Viewer::toggle_recording() {
  const FrameWatch& watch = stage_.source->watch();
  if (recorder_.recording()) return say_and_tell(recorder_.stop());
  const PackedPicture* const deep = stage_.source->picture();
  recorder_.start(watch.frame(), watch.raster().columns, watch.raster().rows, frame_rate(),
                  deep ? deep->bits : 2);
  say("recording " + recorder_.gif_name() + "; v: stop");
  if (watch.whole()) recorder_.add(colours(), 1);
}

std::string Viewer::end() { return recorder_.recording() ? recorder_.stop() : ""; }

void Viewer::set_stage(Stage stage, int frame) {
  stage_.source.reset();  // refers to the old show
  stage_ = std::move(stage);
  go_to(std::min(frame, stage_.show.frames() - 1));
}

void Viewer::take_scene(SceneWatch::News news) {
  changed_ = true;
  error_ = news.error;
  if (!news.show) return;
  try {
    const bool flying = flight_.has_value();
    const int frame = flying ? flight_frame_ : stage_.source->watch().frame();
    set_stage(options_.restage(*news.show), frame);
    if (flying) toggle_flight();
    say("the scene file was loaded again");
  } catch (const UsageError& error) {
    error_ = error.what();
  }
}

void Viewer::look_for_news(double elapsed) {
  since_news_ += elapsed;
  if (since_news_ < NewsInterval) return;
  since_news_ = 0;
  if (auto news = watch_.look()) take_scene(std::move(*news));
}

// Of the chip itself, a second.
double Viewer::frame_rate() const {
  return stage_.source->clock_hz() / stage_.source->watch().raster().frame_clocks();
}

bool Viewer::audible() const { return control.state.speed == 0 && !control.state.muted; }

void Viewer::play_frames(int frames) {
  if (audible())
    for (int i = 0; i < std::min(frames, MostSound); ++i) {
      const std::vector<float> more = stage_.source->play(
          (sound_frame_ + std::max(frames - MostSound, 0) + i) % stage_.show.frames());
      samples_.insert(samples_.end(), more.begin(), more.end());
    }
  sound_frame_ = (sound_frame_ + frames) % stage_.show.frames();
}

// The last of so many frames; the sound of all.
void Viewer::show_frames(int frames) {
  finish_frame();
  if (!flight_ && frames > 1)
    stage_.source->seek((next_frame() + frames - 1) % stage_.show.frames());
  play_frames(frames);
  passed_ = frames;
  clocks(stage_.source->clocks_left());
}

void Viewer::run(double elapsed, const std::function<bool()>& in_time) {
  const Raster& raster = stage_.source->watch().raster();
  const int speed = control.state.speed;
  const double clock_rate = stage_.source->clock_hz() * std::exp2(speed);
  budget_ = std::min(budget_ + elapsed * clock_rate, LongestLag * clock_rate);
  if (!stage_.source->fast() || speed < 0) {
    while (budget_ >= 1 && !finished()) {
      budget_ -= clocks(std::min(Slice, static_cast<int>(budget_)));
      if (!in_time()) break;
      if (stage_.source->watch().whole() && budget_ < raster.frame_clocks()) break;
    }
    return;
  }
  const int due = static_cast<int>(budget_ / raster.frame_clocks());
  if (due == 0 && !options_.frames) return;
  budget_ = std::max(0.0, budget_ - due * static_cast<double>(raster.frame_clocks()));
  show_frames(options_.frames ? 1 : due);
}

void Viewer::tick(double elapsed, const std::function<bool()>& in_time) {
  since_frame_ += elapsed;
  flight_time_ = control.steered() ? flight_time_ + elapsed : 0;
  age_message(elapsed);
  look_for_news(elapsed);
  press_inputs();
  bool acted = false;
  const bool filled = fill_;
  if (fill_ && stage_.source->fast()) clocks(stage_.source->clocks_left());
  while (fill_ && !stage_.source->fast()) {
    clocks(Slice);
    if (!in_time()) return;
  }
  while (const auto action = control.take_action()) {
    act(*action);
    acted = changed_ = true;
  }
  say_changes(acted);
  if (fill_ && stage_.source->fast()) clocks(stage_.source->clocks_left());
  const bool news = filled || acted;  // a new picture is seen before it runs on
  if (!news && !control.state.paused && !finished()) run(elapsed, in_time);
  if (!news && control.state.paused && flight_ && control.steered()) fly_while_paused(elapsed);
  if (fill_) return;
  control.state.inputs = stage_.source->inputs();
  control.state.board = stage_.source->board();
  control.state.plain = stage_.source->plain();
}

std::vector<float> Viewer::take_sound() {
  const std::vector<float> own = stage_.source->take_sound();
  if (audible()) samples_.insert(samples_.end(), own.begin(), own.end());
  return std::exchange(samples_, {});
}

}  // namespace racebeam
