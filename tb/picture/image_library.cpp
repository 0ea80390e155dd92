// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/picture/image_library.h"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

#include "tb/base/errors.h"
#include "tb/base/project_folder.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

/// Beside the program, as it is built, or where that is installed.
fs::path library_path() {
  std::error_code error;
  const fs::path program = program_folder();
  const fs::path installed = (program / RACEBEAM_PLUGINS).lexically_normal();
  for (const fs::path& folder : {program, installed})
    if (const fs::path file = folder / ImageLibraryFile; fs::exists(file, error)) return file;
  throw MissingTool(std::string(ImageLibraryFile) + " is neither in " + program.string() +
                    " nor in " + installed.string() +
                    "; build and install it with the program: cmake --build, cmake --install");
}

const ImageLibrary* opened() {
  const fs::path path = library_path();
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* const found = library ? dlsym(library, ImageLibrarySymbol) : nullptr;
  if (!found) throw MissingTool("cannot open " + path.string() + ": " + dlerror());
  return static_cast<const ImageLibrary*>(found);
}

}  // namespace

const ImageLibrary& image_library() {
  static const ImageLibrary* const library = opened();
  return *library;
}

}  // namespace racebeam
