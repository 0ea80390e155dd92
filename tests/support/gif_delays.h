// How long each picture of a GIF is shown, read back by giflib.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gif_lib.h>

#include <string>
#include <vector>

namespace racebeam {

/// In 1/100 s, picture by picture; empty if it is no whole GIF.
inline std::vector<int> gif_delays(const std::string& path) {
  int error = 0;
  GifFileType* gif = DGifOpenFileName(path.c_str(), &error);
  std::vector<int> delays;
  if (gif && DGifSlurp(gif) == GIF_OK)
    for (int i = 0; i < gif->ImageCount; ++i) {
      GraphicsControlBlock control{};
      if (DGifSavedExtensionToGCB(gif, i, &control) == GIF_OK) delays.push_back(control.DelayTime);
    }
  if (gif) DGifCloseFile(gif, &error);
  return delays;
}

}  // namespace racebeam
