// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/table_file.h"

#include <fstream>

#include "sc/swap/rtl_library.h"
#include "tb/verilate/cache_folder.h"

namespace racebeam {

std::string table_file(const std::string& text) {
  const std::string file = cached(content_key({text}) + ".hex", [&](const std::string& fresh) {
    std::ofstream out(fresh);
    out << text;
    out.close();
    if (!out) throw RtlError("cannot write " + fresh + "; is the disk full?");
  });
  return "\"" + file + "\"";
}

}  // namespace racebeam
