// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/report/notes_markdown.h"

#include <fmt/format.h>

#include <filesystem>

#include "tb/base/version.h"
#include "tb/scene/scene_check.h"
#include "tb/scene/scene_sight.h"

namespace racebeam {

namespace {

constexpr double FramesPerSecond = 60;
constexpr int FramePixels = VisibleColumns * VisibleRows;

constexpr const char* Head = R"(<!-- made by `racebeam scene notes`, do not edit -->
# The scenes in numbers

racebeam {}: `{}`

Up to {} frames spread evenly over each scene, by the chip's cores with its own knobs{}. The tracer has about {} clocks for a
line; it is busy until it is done or the line ends. The estimate is the worst line of all frames and counts on beyond that. A
frame with the ray pattern disturbs the tracer, but hides what it draws. A pixel that differs from `trace4`, the chip's way
without its limits, has one cause: the first ones below add up. `trace2` knows no intervals, `geometry` no rounding, but the
chip's parabolas for sine and cosine; the causes on the way to them stand for themselves.
)";

/// A word of the command line in a code span.
std::string word(const std::string& scene) {
  std::string name = std::filesystem::path(scene).filename().string();
  for (char& c : name)
    if (c == '`' || static_cast<unsigned char>(c) < ' ') c = '?';
  return name;
}

std::string crossings(const CameraPath& path) {
  std::string text;
  for (int face = 0; face < FaceCount; ++face)
    text += fmt::format("{} {} {}", face ? "," : "", path.crossings[face], face_name(face));
  return text;
}

std::string facts(const SceneNotes& notes) {
  const Show& show = notes.show();
  const std::string time =
      fmt::format("{} frames, {:.1f} s", show.frames(), show.frames() / FramesPerSecond);
  const int bits = notes.set_knobs().corner_bits;
  if (!show.scene())
    return fmt::format(
        "The built-in demo: rooms from logic instead of a table, at most 1 portal in a face; {}; "
        "{} corner bits.",
        time, bits);
  const SceneFile& scene = *show.scene();
  const SceneWidths widths = scene_widths(scene);
  return fmt::format(
      "{} rooms, {} portals, at most {} in a face; {}; the camera passes portals:{}; {} corner "
      "bits{}; deepest view {} portals.",
      scene.rooms.size(), count_portals(scene), widths.portals_per_face, time,
      crossings(*show.path()), bits,
      widths.corner_bits > bits ? fmt::format(" of {} needed", widths.corner_bits) : "",
      deepest_view(scene));
}

std::string frame_list(const SceneNotes& notes) {
  std::string text;
  for (const int frame : notes.frames()) {
    text += (text.empty() ? "" : ", ") + std::to_string(frame);
    if (notes.show().golden_world(frame, notes.set_knobs()).lock != GoldenLock::None)
      text += " (ray pattern)";
  }
  return text;
}

std::string counter(const char* name, const FrameCounter& of, std::size_t frames) {
  return fmt::format("| {} | {:.1f} | {} | {} |\n", name,
                     static_cast<double>(of.sum) / static_cast<double>(frames), of.worst,
                     of.worst ? fmt::format("frame {}", of.worst_frame) : "");
}

std::string counters(const SceneNotes& notes) {
  const LineSpread& busy = notes.busy_clocks();
  const LineEstimate& estimate = notes.estimate();
  const std::size_t frames = notes.frames().size();
  return "| counter | mean | worst | where |\n|---|--:|--:|---|\n" +
         fmt::format("| busy clocks of a line, of about {} | {:.1f} | {} | frame {}, y {} |\n",
                     LineEstimate::budget(notes.set_knobs()), busy.clocks.mean(), busy.worst,
                     busy.worst_frame, busy.worst_line) +
         fmt::format("| worst line, estimated | | {} | frame {}, y {} |\n", estimate.clocks,
                     estimate.frame, estimate.y) +
         counter("restarts in a frame", notes.restarts(), frames) +
         counter("starved pixels in a frame", notes.starved_pixels(), frames) +
         counter("give-ups in a frame", notes.give_ups(), frames);
}

std::string pixels(const SceneNotes& notes) {
  const GoldenCounts& golden = notes.golden();
  const std::vector<ErrorCause>& causes = golden_causes();
  const double all = FramePixels * static_cast<double>(notes.frames().size());
  std::string text = "| differing pixels | sum | share | what it is |\n|---|--:|--:|---|\n";
  const auto row = [&](const std::string& name, int count, const std::string& meaning) {
    text += fmt::format("| {} | {} | {:.2f} % | {} |\n", name, count, 100 * count / all, meaning);
  };
  for (std::size_t i = 0; i < causes.size(); ++i) {
    row(fmt::format("`{}`", causes[i].name), golden.by_cause[i], causes[i].meaning);
    if (static_cast<int>(i) + 1 != golden_limits()) continue;
    row("**chip, `trace4`**", golden.by_tracer[int(GoldenTracer::Trace4)], "the sum of the above");
  }
  row("**chip, `trace2`**", golden.by_tracer[int(GoldenTracer::Trace2)], "");
  row("**chip, `geometry`**", golden.by_tracer[int(GoldenTracer::Geometry)],
      "boxes without rounding, to the depth limit; sine and cosine as the chip makes them");
  return text;
}

}  // namespace

std::string markdown_text(const std::string& text) {
  std::string line;
  for (const char c : text) {
    if (std::string("\\`*_[]<>#|&~").find(c) != std::string::npos) line += '\\';
    line += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return line;
}

std::string notes_command(const NotesCommand& command) {
  std::string text = "racebeam scene notes";
  for (const std::string& scene : command.scenes) text += " " + word(scene);
  return text + fmt::format("{} --frames {}", command.set, command.frames);
}

std::string notes_head(const std::string& command, int frames, bool set, int budget) {
  return fmt::format(Head, program_version(), command, frames, set ? " but those set here" : "",
                     budget);
}

std::string notes_section(const SceneNotes& notes) {
  return fmt::format(
      "\n## {}\n\n{}\n\nFrames {}.\n\n{}\n{}\n"
      "With cut, shift, hurry and stack limits switched off: {} pixels differ from `trace4`.\n",
      markdown_text(notes.show().name()), facts(notes), frame_list(notes), counters(notes),
      pixels(notes), notes.unexplained());
}

}  // namespace racebeam
