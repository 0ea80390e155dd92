// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/swap/rtl_coverage.h"

#include <dlfcn.h>

#include <filesystem>
#include <memory>

#include "sc/swap/rtl_library.h"

namespace racebeam {

void write_rtl_coverage(const std::string& plugin, const std::string& path) {
  const std::string whole = std::filesystem::absolute(plugin).string();
  const std::unique_ptr<void, int (*)(void*)> library(dlopen(whole.c_str(), RTLD_NOW | RTLD_NOLOAD),
                                                      dlclose);
  if (!library) throw RtlError(plugin + " is not loaded: there is nothing that was counted");
  const auto write =
      reinterpret_cast<rtl_coverage_writer>(dlsym(library.get(), "rtl_write_coverage_1"));
  if (!write) throw RtlError(plugin + " counts nothing: it was built without coverage");
  if (write(path.c_str()) == 0)
    throw RtlError("the counts of the RTL cannot be written to " + path);
}

}  // namespace racebeam
