// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/doctor_checks.h"

#include <fmt/format.h>
#include <sndfile.h>
#include <sys/utsname.h>
#include <sysc/kernel/sc_ver.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <sstream>
#include <system_error>
#include <thread>

#include "sc/base/constants.h"
#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/project_folder.h"
#include "tb/base/version.h"
#include "tb/monitor/sound_monitor.h"
#include "tb/picture/contact_sheet.h"
#include "tb/picture/gif_writer.h"
#include "tb/picture/image_library.h"
#include "tb/picture/png_file.h"
#include "tb/sweep/nsga2_library.h"
#include "tb/verilate/rtl_plugin.h"
#include "tb/view/window_library.h"

namespace racebeam {

namespace fs = std::filesystem;

namespace {

/// A folder that goes away with its contents.
class TemporaryFolder {
 public:
  /// Throws std::system_error or fs::filesystem_error.
  TemporaryFolder() {
    std::string name = (fs::temp_directory_path() / "racebeam-doctor-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), name);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

Check check(const char* name, const std::function<void()>& action) {
  try {
    action();
    return {name, true, "good"};
  } catch (const std::exception& error) {
    return {name, false, error.what()};
  }
}

/// A check tells what does not work without it.
std::string version_of(const std::function<std::string()>& library) {
  try {
    return library();
  } catch (const MissingTool&) {
    return "not found";
  }
}

std::string find_in_path(const std::string& tool) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const std::string candidate = (fs::path(folder) / tool).string();
    if (fs::is_regular_file(fs::status(candidate)) && access(candidate.c_str(), X_OK) == 0)
      return candidate;
  }
  return {};
}

}  // namespace

std::vector<Fact> versions() {
  std::string sndfile = sf_version_string();  // "libsndfile-1.2.0"
  sndfile.erase(0, sndfile.find('-') + 1);
  return {{"racebeam", program_version()},
          {"compiler", __VERSION__},
          {"SystemC", sc_core::sc_release()},
          {"OpenImageIO", version_of([] { return image_library().version; })},
          {"zlib", zlibVersion()},
          {"libsndfile", sndfile},
          {"SDL2", version_of([] { return window_library().version(); })},
          {"pagmo", version_of([] { return nsga2_library().version(); })}};
}

std::vector<Fact> machine() {
  utsname system{};
  uname(&system);
  const double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * sysconf(_SC_PAGESIZE);
  return {{"system", fmt::format("{} {} {}", system.sysname, system.release, system.machine)},
          {"cores", std::to_string(std::thread::hardware_concurrency())},
          {"memory", fmt::format("{:.1f} GiB", bytes / (1 << 30))}};
}

std::vector<Check> check_files() {
  std::unique_ptr<TemporaryFolder> folder;
  std::vector<Check> checks = {
      check("temporary folder", [&] { folder = std::make_unique<TemporaryFolder>(); })};
  if (!folder) return checks;
  const std::vector<std::uint8_t> picture(VisibleColumns * VisibleRows, 0x2a);
  checks.push_back(check("write PNG", [&] {
    write_png(folder->file("a.png"), picture, VisibleColumns, VisibleRows);
  }));
  checks.push_back(check("caption a picture", [&] {
    write_contact_sheet(folder->file("b.png"), {{picture, "caption"}}, VisibleColumns, VisibleRows,
                        1);
  }));
  checks.push_back(check("write GIF", [&] {
    GifWriter gif(folder->file("a.gif"), VisibleColumns, VisibleRows, 60);
    gif.add(picture);
    gif.close();
  }));
  checks.push_back(check("write WAV", [&] {
    SoundMonitor sound;
    sound.advance(static_cast<std::uint64_t>(2 * PixelClockHz / 10));  // 0.1 s
    sound.write_wav(folder->file("a.wav"));
  }));
  checks.push_back(check("find RTL", [] { rtl_folder(); }));
  if (checks.back().good && !find_in_path("verilator").empty())
    checks.push_back(check("verilate RTL", [&] {
      rtl_library(rtl_plugin({"stacks", {rtl_file("stacks")}}));
    }));
  return checks;
}

std::vector<OptionalTool> find_tools() {
  std::vector<OptionalTool> tools = {
      {"verilator", "verilator", "runs RTL: render --use, render --tt, verify", ""},
      {"gtkwave", "gtkwave", "shows waveforms", ""},
      {"yosys", "yosys", "makes gates: UNIT=gates, units --area; sweeps with silicon", ""},
      {"sta", "opensta", "finds the longest path: units --area, sweeps with timing", ""},
      {"nextpnr-ice40", "nextpnr-ice40", "places and routes an FPGA: sweeps with timing", ""},
      {"sox", "sox", "plays sound and draws spectrograms", ""},
  };
  for (OptionalTool& tool : tools) tool.path = find_in_path(tool.name);
  return tools;
}

}  // namespace racebeam
