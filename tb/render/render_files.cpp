// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/render_files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "tb/base/console.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

constexpr const char* StatsName = "stats.json";
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

}  // namespace

RenderFiles::RenderFiles(const OutputPlan& plan, Manifest manifest)
    : plan_(plan), what_(std::move(manifest)) {
  what_.command = plan_.command;
  what_.first_frame = plan_.frames.first();
  what_.every = plan_.frames.every();
  what_.frames_wanted = plan_.frames.count();
  if (!plan_.folder.empty()) {
    folder_ = std::make_unique<OutputFolder>(plan_.folder, what_, plan_.overwrite);
    try_writing(folder_->file(plan_.file_name("frame", plan_.frames.first())));
  }
  for (const std::string& path : {plan_.picture, plan_.gif, plan_.wav, plan_.sheet, plan_.stats})
    try_writing(path);
  if (folder_) folder_->start();
}

void RenderFiles::add(const RenderedFrame& frame, const std::string& part) {
  ++what_.frames_rendered;
  what_.frames.insert(frame.number);
  for (const PictureFile& file : frame.files) {
    what_.files.push_back(file.name);
    write_text(folder_ ? folder_->file(file.name) : file.name, file.bytes);
  }
  width_ = frame.picture.width;
  height_ = frame.picture.height;
  if (!plan_.gif.empty() && !gif_)
    gif_ = std::make_unique<GifWriter>(
        plan_.gif, width_, height_,
        std::max(plan_.frames_per_second / std::max(plan_.frames.every(), 1), SlowestGif),
        plan_.gif_scale, frame.picture.bits);
  if (gif_) gif_->add(frame.picture.colours);
  if (!plan_.sheet.empty())
    sheet_.push_back(
        {frame.picture.colours, fmt::format("{} {}", frame.number, part), frame.picture.bits});
}

void RenderFiles::add(int frame, const std::string& part, const VgaFrame& picture) {
  RenderedFrame rendered{frame, picture, {}, {}, {}};
  if (plan_.pictures()) rendered.files.push_back(picture_file(plan_, frame, picture));
  add(rendered, part);
}

void RenderFiles::run(const std::function<void()>& render, const SoundMonitor* sound,
                      const std::function<std::string()>& stats) {
  std::exception_ptr failure;
  bool quiet = false;
  try {
    render();
  } catch (const Interrupted&) {
    // fewer frames
  } catch (const ClosedPipe&) {
    failure = std::current_exception();
    quiet = true;
  } catch (...) {
    failure = std::current_exception();
  }
  time_to_finish();
  try {
    finish(sound, stats());  // what belongs to the whole frames so far
  } catch (const OutputError&) {
    if (!failure) throw;
    std::rethrow_exception(failure);
  }
  if (!failure) return;
  if (!quiet) tell("stopped early; kept " + summary());
  std::rethrow_exception(failure);
}

void RenderFiles::finish(const SoundMonitor* sound, const std::string& stats) {
  const bool any = what_.frames_rendered > 0;
  // What tells about the pictures comes first: on a full disk it is the best to have.
  if (folder_ && any) {
    write_text(folder_->file(StatsName), stats);
    what_.files.push_back(StatsName);
    folder_->write(what_);
  } else if (folder_) {
    folder_->abandon();
  }
  if (!plan_.stats.empty() && any) write_text(plan_.stats, stats);
  if (gif_ && any) gif_->close();
  gif_.reset();
  if (!sheet_.empty()) write_contact_sheet(plan_.sheet, sheet_, width_, height_, SheetColumns);
  if (!plan_.wav.empty() && sound && any) sound->write_wav(plan_.wav);
  if (folder_ && any) list_outputs();
}

void RenderFiles::list_outputs() {
  const std::size_t before = what_.files.size();
  for (const std::string& path : {plan_.gif, plan_.wav, plan_.sheet, plan_.stats, plan_.vcd}) {
    if (path.empty()) continue;
    const std::string name = folder_->name_of(path);
    if (name != StatsName) what_.files.push_back(name);
  }
  if (what_.files.size() > before) folder_->write(what_);
}

std::string RenderFiles::summary() const {
  std::string text = counted(what_.frames_rendered, "frame");
  if (!plan_.folder.empty()) text += " in " + plan_.folder;
  for (const std::string& path : {plan_.picture, plan_.gif, plan_.wav, plan_.sheet, plan_.vcd})
    if (!path.empty() && what_.frames_rendered > 0) text += ", " + path;
  if (!plan_.stats.empty()) text += ", " + plan_.stats;
  return text;
}

}  // namespace racebeam
