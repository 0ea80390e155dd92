// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/view/view_window.h"

#include <utility>

#include "tb/base/console.h"
#include "tb/base/program_library.h"
#include "tb/view/frame_source.h"
#include "tb/view/window_library.h"

namespace racebeam {

namespace {

class Window : public ViewScreen {
 public:
  explicit Window(std::unique_ptr<LibraryWindow> window) : window_(std::move(window)) {}

  bool poll(ViewControl& control) override {
    window_->keep_mouse(control.state.flying);
    const bool stale = window_->poll(control);
    window_->fill_screen(control.state.full_screen);
    return stale;
  }
  void show(const Viewer& viewer) override {
    const RgbImage picture = viewer.picture_with_message();
    const Raster& raster = viewer.source().watch().raster();
    window_->show(picture.bytes(), {picture.width(), picture.height()},
                  {raster.columns, raster.rows}, viewer.title());
  }
  void play(const std::vector<float>& samples) override { window_->play(samples); }

 private:
  const std::unique_ptr<LibraryWindow> window_;
};

}  // namespace

const WindowLibrary& window_library() {
  static const void* const library = open_program_library(
      "libracebeam_window.so", "racebeam_window_library",
      "it is built and installed with the program where SDL2 is (apt install libsdl2-dev, then "
      "scripts/build racebeam); or watch in the terminal: racebeam view --term");
  return *static_cast<const WindowLibrary*>(library);
}

std::unique_ptr<ViewScreen> open_window(int scale) {
  return std::make_unique<Window>(window_library().open(scale, FrameSource::SoundRate, tell));
}

}  // namespace racebeam
