// What `racebeam render` was asked for, and what it will do.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tb/golden/golden_picture.h"
#include "tb/judge/reference_frames.h"
#include "tb/picture/picture_format.h"
#include "tb/render/frame_plan.h"
#include "tb/report/manifest.h"
#include "tb/show/run.h"
#include "tb/tt/tt_options.h"
#include "tb/twin/channels.h"
#include "tb/twin/delays.h"
#include "tb/view/frame_maps.h"

namespace racebeam {

/// Instead of a golden tracer: chip and tracers compared.
constexpr const char* Compare = "compare";
/// What a picture may show.
constexpr const char *ShowPicture = "picture", *ShowHits = "hits";

/// The command line as it was written. An empty path: not asked for.
struct RenderOptions : RunOptions, TtOptions, ShakeOptions, DelayOptions {
  long long frames = 1, first = 0, every = 1, gif_scale = 1, jobs = 1;
  std::string at;      ///< a list of frames instead
  std::string folder;  ///< or one picture
  std::string format;  ///< of the pictures; empty: PNG
  std::string gif, wav, sheet, stats;
  std::string vcd;                    ///< waveform
  std::vector<std::string> overlays;  ///< names of maps
  std::string golden;                 ///< a golden tracer, "compare", or empty
  std::string show;                   ///< picture, hits, or empty
  std::string against;                ///< a reference to compare with, or empty
  bool crc = false, json = false;
  bool overwrite = false;            ///< the folder may have frames of another render
  std::vector<std::string> command;  ///< for the manifest
};

/// Which frames, and what is written about them. Every number is in its range.
struct OutputPlan {
  FramePlan frames;
  int gif_scale, jobs;
  std::string folder, gif, wav, sheet, stats;
  bool crc, json;
  std::vector<std::string> command;
  std::vector<MapKind> overlays{};                   ///< into the folder, for each frame
  std::string vcd{};                                 ///< of the chip's ports and wires, or empty
  bool overwrite = false;                            ///< what the folder has of another render
  std::shared_ptr<const ReferenceFrames> against{};  ///< what the frames must equal, or nothing

  std::string picture{};  ///< the only one, instead of a folder
  const PictureFormat* format = &picture_formats().front();

  /// Pictures are written.
  bool pictures() const { return !(folder + picture).empty(); }
  /// Of a picture in the folder: "frame_0000.png".
  std::string file_name(const std::string& kind, int frame) const;
  /// Checksums are computed.
  bool checksums() const { return crc || against; }
  /// Some file is.
  bool writes() const { return !(folder + picture + gif + wav + sheet + stats + vcd).empty(); }
  double frames_per_second = 60;  ///< of the chip
};

/// The chip of this project, or a golden tracer, and a show.
struct RenderPlan : Run, OutputPlan {
  std::optional<GoldenTracer> tracer;                ///< renders instead of the chip
  bool compare;                                      ///< the chip with the golden tracers
  bool hits = false;                                 ///< hit maps instead of pictures
  std::shared_ptr<const stall_plan> stalls{};        ///< of channels between units, or nothing
  std::shared_ptr<const delay_plan> delays{};        ///< the same
  std::map<std::string, ManifestUnit> unit_files{};  ///< what the units are made of

  /// What it is about.
  Manifest manifest() const;
};

/// `frames`: there are so many. Without any file asked for, the folder is "racebeam_out", unless
/// the frames are compared with a reference. Throws UsageError.
OutputPlan plan_output(const RenderOptions& options, int frames);

/// Throws UsageError for whatever cannot be done.
RenderPlan plan_render(const RenderOptions& options);

}  // namespace racebeam
