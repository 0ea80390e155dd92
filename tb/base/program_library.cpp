// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/base/program_library.h"

#include <dlfcn.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "tb/base/errors.h"
#include "tb/base/project_folder.h"

namespace racebeam {

namespace fs = std::filesystem;

const void* open_program_library(const char* file, const char* symbol, const char* advice) {
  const fs::path program = program_folder();
  const fs::path installed = (program / RACEBEAM_PLUGINS).lexically_normal();
  for (const fs::path& folder : {program, installed}) {
    const fs::path path = folder / file;
    if (std::error_code error; !fs::exists(path, error)) continue;
    void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (const void* const found = library ? dlsym(library, symbol) : nullptr) return found;
    throw MissingTool("cannot open " + path.string() + ": " + dlerror() + "; " + advice);
  }
  throw MissingTool(std::string(file) + " is neither in " + program.string() + " nor in " +
                    installed.string() + "; " + advice);
}

}  // namespace racebeam
