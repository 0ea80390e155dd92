// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/picture/image_library.h"

#include "tb/base/program_library.h"

namespace racebeam {

const ImageLibrary& image_library() {
  static const void* const library =
      open_program_library("libracebeam_images.so", "racebeam_image_library",
                           "build and install it with the program: cmake --build, cmake --install");
  return *static_cast<const ImageLibrary*>(library);
}

}  // namespace racebeam
