// Viewer: a show that runs, with what the keys make of it. Knows no window and no clock.
//
// Whoever has both tells it how much time has passed, shows its picture and plays its sound.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tb/show/show.h"
#include "tb/view/frame_source.h"
#include "tb/view/free_flight.h"
#include "tb/view/scene_watch.h"
#include "tb/view/view_control.h"
#include "tb/view/view_picture.h"
#include "tb/view/view_recorder.h"

namespace racebeam {

/// A show that is ready to run: the source refers to the show's tables, and goes before it.
struct Stage {
  Show show;
  std::unique_ptr<FrameSource> source;
};

class Viewer {
 public:
  struct Options {
    int first = 0;              ///< frame
    std::optional<int> frames;  ///< stop after so many, and leave out none
    std::string scene_file;     ///< is loaded again when it changes; empty: the built-in demo
    std::string folder = ".";   ///< for screenshots and GIFs
    /// "explain demo --set knob=value": the command that explains a pixel; empty: there is none.
    std::string explain;
    /// Makes the stage for a scene file that has changed. Throws UsageError if that cannot be.
    std::function<Stage(const Show&)> restage;
    /// The built-in demo as a scene file, in which the camera can leave its path. Throws
    /// UsageError.
    std::function<Show()> demo_file;
  };

  Viewer(Stage stage, Options options);

  ViewControl control;

  /// `elapsed` seconds have passed. Does what the keys asked for, and simulates what is due; a
  /// source that is not fast goes on until `in_time` says no. Throws SyncError.
  void tick(double elapsed, const std::function<bool()>& in_time);

  /// What a screenshot has.
  RgbImage picture() const;
  /// The same with the message over it, if there is one.
  RgbImage picture_with_message() const;
  std::string title() const;
  /// For screens that cannot show small letters: the picture with borders, beam and map only, and
  /// what else would be on it or beside it as lines.
  RgbImage bare_picture() const;
  std::vector<std::string> words() const;
  /// Samples at FrameSource::SoundRate of the frames since the last call.
  std::vector<float> take_sound();
  /// Says something over the picture for two seconds.
  void say(const std::string& message);
  const std::string& message() const { return message_; }
  /// What happened beyond the screen since the last call, for stderr: files, commands.
  std::vector<std::string> take_news() { return std::exchange(news_, {}); }
  /// Ends what is being recorded. Returns what was written, or nothing. Throws OutputError.
  std::string end();
  /// It goes to a frame that is not whole yet.
  bool filling() const { return fill_; }
  /// The user quits.
  bool quit() const { return quit_; }
  /// Nothing is left of Options::frames.
  bool finished() const { return options_.frames && frames_shown_ >= *options_.frames; }
  /// The picture may have changed since the last call.
  bool take_changed() { return std::exchange(changed_, false); }

  const FrameSource& source() const { return *stage_.source; }
  const Show& show() const { return stage_.show; }
  const std::string& error() const { return error_; }
  std::optional<Pose> pose() const;

 private:
  void act(ViewAction action);
  void say_changes(bool acted);
  void say_and_tell(const std::string& message);
  void age_message(double elapsed);
  void explain();
  void press_inputs();
  void look_for_news(double elapsed);
  void take_scene(SceneWatch::News news);
  void set_stage(Stage stage, int frame);
  void go_to(int frame);
  int next_frame() const;
  void run(double elapsed, const std::function<bool()>& in_time);
  void show_frames(int frames);
  void play_frames(int frames);
  double frame_rate() const;
  const std::vector<std::uint8_t>& colours() const;
  bool audible() const;
  int clocks(int count);
  void finish_frame();
  void step_pixel();
  void step_lines(int lines);
  bool drawn(ViewControl::Pixel pixel) const;
  void toggle_flight();
  void fly_while_paused(double elapsed);
  void toggle_recording();
  void steer();
  std::string statistics() const;
  std::string place() const;

  Stage stage_;
  const Options options_;
  SceneWatch watch_;
  ViewRecorder recorder_;
  std::vector<float> samples_;
  std::optional<FreeFlight> flight_;
  int flight_frame_ = 0;  // whose shot is shown in a free flight
  int sound_frame_ = 0;
  double budget_ = 0;       // clocks that are due
  double since_news_ = 0;   // seconds
  double rate_ = 0;         // frames a second, smoothed
  double since_frame_ = 0;  // seconds
  double flight_time_ = 0;  // seconds since the camera was steered
  int frames_shown_ = 0;
  int passed_ = 1;    // frames of the show from the last whole frame to the next one
  bool fill_ = true;  // show the frame to its end, even when paused
  bool changed_ = true, quit_ = false;
  std::string error_, message_;
  double message_left_ = 0;          // seconds
  std::optional<ViewState> before_;  // the state at the last tick
  std::vector<std::string> news_;
};

}  // namespace racebeam
