// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "tb/console.h"
#include "tb/counted.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* StatsName = "stats.json";
constexpr const char* ManifestName = "manifest.json";
constexpr double SlowestGif = 5;  // frames per second, however few of the demo's are shown
constexpr int SheetColumns = 4;

// Writes a byte and takes it back.
void try_writing(const std::string& path) {
  if (path.empty()) return;
  OutputFile file(path);
  std::error_code error;
  if (!fs::exists(path, error) || fs::is_regular_file(path, error)) file.write("", 1);
  else if (access(path.c_str(), W_OK) != 0)  // a device or a pipe, which takes no byte back
    throw OutputError(path, errno, "");
}

// Makes the folder and those above it; returns the new ones, innermost first.
std::vector<fs::path> make_folder(const std::string& folder) {
  std::error_code error, ignored;
  std::vector<fs::path> made;
  for (fs::path level = fs::absolute(folder).lexically_normal();
       !level.empty() && !fs::exists(level, ignored); level = level.parent_path())
    if (level.has_filename()) made.push_back(level);
  fs::create_directories(folder, error);
  if (error && !fs::is_directory(folder, ignored)) {
    for (const auto& level : made) fs::remove(level, ignored);
    throw OutputError(folder, error.value(), "");
  }
  return made;
}

}  // namespace

RenderFiles::RenderFiles(const OutputPlan& plan, Manifest manifest)
    : plan_(plan), what_(std::move(manifest)) {
  std::vector<fs::path> made;
  if (!plan_.folder.empty()) made = make_folder(plan_.folder);
  try {
    if (!plan_.folder.empty()) try_writing(in_folder(fmt::format("frame_{:04}.png", plan_.first)));
    for (const std::string& path : {plan_.gif, plan_.wav, plan_.sheet, plan_.stats})
      try_writing(path);
  } catch (const OutputError&) {
    std::error_code ignored;
    for (const auto& level : made) fs::remove(level, ignored);
    throw;
  }
}

std::string RenderFiles::in_folder(const std::string& name) const {
  return (fs::path(plan_.folder) / name).string();
}

void RenderFiles::add(const RenderedFrame& frame, const std::string& part) {
  ++frames_;
  for (const PictureFile& file : frame.files) {
    in_folder_.push_back(file.name);
    write_text(in_folder(file.name), file.bytes);
  }
  width_ = frame.picture.width;
  height_ = frame.picture.height;
  if (!plan_.gif.empty() && !gif_)
    gif_ = std::make_unique<GifWriter>(plan_.gif, width_, height_,
                                       std::max(plan_.frames_per_second / plan_.every, SlowestGif),
                                       plan_.gif_scale);
  if (gif_) gif_->add(frame.picture.colours);
  if (!plan_.sheet.empty())
    sheet_.push_back({frame.picture.colours, fmt::format("{} {}", frame.number, part)});
}

void RenderFiles::add(int frame, const std::string& part, const VgaFrame& picture) {
  RenderedFrame rendered{frame, picture, {}, {}, {}};
  if (!plan_.folder.empty())
    rendered.files.push_back(
        picture_file("frame", frame, picture.colours, picture.width, picture.height));
  add(rendered, part);
}

void RenderFiles::run(const std::function<void()>& render, const SoundMonitor* sound,
                      const std::function<std::string()>& stats) {
  std::exception_ptr failure;
  try {
    render();
  } catch (const SyncError&) {
    failure = std::current_exception();
  } catch (const OutputError&) {
    failure = std::current_exception();
  }
  try {
    finish(sound, stats());  // what belongs to the whole frames so far
  } catch (const OutputError&) {
    if (!failure) throw;
    std::rethrow_exception(failure);
  }
  if (!failure) return;
  tell("stopped early; kept " + summary());
  std::rethrow_exception(failure);
}

void RenderFiles::finish(const SoundMonitor* sound, const std::string& stats) {
  // What tells about the pictures comes first: on a full disk it is the best to have.
  if (!plan_.folder.empty() && frames_ > 0) {
    write_text(in_folder(StatsName), stats);
    in_folder_.push_back(StatsName);
    write_text(in_folder(ManifestName), manifest());
  }
  if (!plan_.stats.empty() && frames_ > 0) write_text(plan_.stats, stats);
  if (gif_ && frames_ > 0) gif_->close();
  gif_.reset();
  if (!sheet_.empty()) write_contact_sheet(plan_.sheet, sheet_, width_, height_, SheetColumns);
  if (!plan_.wav.empty() && sound && frames_ > 0) sound->write_wav(plan_.wav);
}

std::string RenderFiles::manifest() const {
  Manifest manifest = what_;
  manifest.command = plan_.command;
  manifest.first_frame = plan_.first;
  manifest.every = plan_.every;
  manifest.frames_wanted = plan_.frames;
  manifest.frames_rendered = frames_;
  manifest.files = in_folder_;
  return manifest.text();
}

std::string RenderFiles::summary() const {
  std::string text = counted(frames_, "frame");
  if (!plan_.folder.empty()) text += " in " + plan_.folder;
  for (const std::string& path : {plan_.gif, plan_.wav, plan_.sheet, plan_.vcd})
    if (!path.empty() && frames_ > 0) text += ", " + path;
  if (!plan_.stats.empty()) text += ", " + plan_.stats;
  return text;
}

}  // namespace racebeam
