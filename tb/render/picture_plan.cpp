// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/render/picture_plan.h"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "tb/base/errors.h"

namespace racebeam {

namespace {

constexpr const char* DefaultFolder = "racebeam_out";

void plan_one_picture(OutputPlan& plan, const RenderOptions& options, const PictureFormat& format) {
  const std::string advice = fmt::format("name a folder, -o DIR --format {}", format.name);
  if (!options.format.empty())
    throw UsageError(
        fmt::format("-o {} says the format; leave out --format, or {}", options.folder, advice));
  if (plan.frames.count() > 1)
    throw UsageError(fmt::format("-o {} is one picture; for {} frames {}", options.folder,
                                 plan.frames.count(), advice));
  if (!plan.overlays.empty())
    throw UsageError(fmt::format("-o {} is one picture; for --overlay {}", options.folder, advice));
  plan.picture = options.folder;
  plan.format = &format;
}

}  // namespace

std::string OutputPlan::file_name(const std::string& kind, int frame) const {
  return fmt::format("{}_{:04}.{}", kind, frame, format->name);
}

void plan_pictures(OutputPlan& plan, const RenderOptions& options) {
  std::error_code ignored;
  const PictureFormat* const named = format_of_file(options.folder);
  if (named && !std::filesystem::is_directory(options.folder, ignored))
    return plan_one_picture(plan, options, *named);
  if (!options.format.empty()) plan.format = &picture_format(options.format);
  plan.folder = options.folder;
  if (!plan.folder.empty()) return;
  const bool something = plan.writes() || plan.against;
  if (something && plan.overlays.empty() && !options.format.empty())
    throw UsageError("--format is of the pictures in a folder; add -o DIR, or leave it out");
  if (!something || !plan.overlays.empty()) plan.folder = DefaultFolder;
}

}  // namespace racebeam
