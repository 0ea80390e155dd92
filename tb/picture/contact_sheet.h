// A contact sheet: many frames in one picture.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace racebeam {

/// One picture of a contact sheet.
struct SheetFrame {
  std::vector<std::uint8_t> colours;  ///< as PackedPicture has them
  std::string caption;                ///< one short line
  int bits = 2;                       ///< of a channel
};

/// Writes all frames, each width x height pixels, in rows of `columns` as one picture, of the
/// format that the name ends with, or PNG; shrunk by `downscale` in both axes (means of pixels),
/// with their captions below if a font is found. Throws OutputError, MissingTool, and
/// std::invalid_argument if the sizes disagree or there are no frames.
void write_contact_sheet(const std::string& path, const std::vector<SheetFrame>& frames, int width,
                         int height, int columns, int downscale = 2);

}  // namespace racebeam
