// The files that a render leaves: pictures as they come, the rest at the end.
//
// Each appears whole or not at all, whatever happens in between.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tb/monitor/sound_monitor.h"
#include "tb/picture/contact_sheet.h"
#include "tb/picture/gif_writer.h"
#include "tb/render/output_folder.h"
#include "tb/render/render_options.h"
#include "tb/render/rendered_frame.h"
#include "tb/report/manifest.h"

namespace racebeam {

class RenderFiles {
 public:
  /// Takes the folder and tries whether every file can be written. `manifest` says what is
  /// rendered; what belongs to the plan and to the files is added. Throws OutputError, and
  /// UsageError as OutputFolder does.
  RenderFiles(const OutputPlan& plan, Manifest manifest);

  /// A whole frame; its files go into the folder. Throws OutputError.
  void add(const RenderedFrame& frame, const std::string& part);
  /// A frame of which there is the picture alone. Throws OutputError.
  void add(int frame, const std::string& part, const VgaFrame& picture);

  /// Calls `render`, which adds frames, and then finish(). If either throws, what belongs to the
  /// whole frames is kept, which is told, and that is thrown on; but Interrupted is a good end.
  void run(const std::function<void()>& render, const SoundMonitor* sound,
           const std::function<std::string()>& stats);

  /// Writes what belongs to the frames added so far, which may be fewer than planned. `sound` may
  /// be nullptr. Throws OutputError.
  void finish(const SoundMonitor* sound, const std::string& stats);

  /// What was written, for a message: "3 pictures in DIR, F.gif".
  std::string summary() const;

 private:
  void list_outputs();

  const OutputPlan plan_;
  Manifest what_;
  std::unique_ptr<OutputFolder> folder_;
  int width_ = 0, height_ = 0;  // of the pictures
  std::vector<SheetFrame> sheet_;
  std::unique_ptr<GifWriter> gif_;
};

}  // namespace racebeam
