// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/wave/clocked_waves.h"

#include <fmt/format.h>

#include <map>

#include "tb/base/errors.h"
#include "tb/wave/signal_look.h"

namespace racebeam {

namespace {

constexpr const char *Beam = "beam", *ClockName = "clk_i";
constexpr int None = -1;

std::string name_of(const std::string& path) { return path.substr(path.rfind('.') + 1); }

std::string scope_of(const std::string& path) {
  const auto dot = path.rfind('.');
  return dot == std::string::npos ? "" : path.substr(0, dot);
}

int signal_of(const VcdReader& vcd, const std::string& path) {
  const auto at = vcd.signals().find(path);
  return at == vcd.signals().end() ? None : at->second;
}

int find_clock(const VcdReader& vcd) {
  for (const std::string& path : vcd.paths())
    if (name_of(path) == ClockName) return signal_of(vcd, path);
  throw UsageError(
      "a picture needs the clock, and no signal is called clk_i; draw a waveform of `racebeam "
      "trace` or `racebeam verify`");
}

/// Where the clocks of a waveform stand, as far as it says so.
class Ruler {
 public:
  explicit Ruler(const VcdReader& vcd)
      : vcd_(vcd),
        frame_(signal_of(vcd, "beam.frame")),
        line_(signal_of(vcd, "beam.line")),
        clock_(signal_of(vcd, frame_ == None ? "chip.clock" : "beam.clock")) {}

  ClockedWaves::Clock at(std::uint64_t time, std::size_t index) const {
    const bool placed = frame_ != None && line_ != None;
    return {time,
            placed ? "frame " + number(frame_, "frame") + ", line " + number(line_, "line") : "",
            clock_ == None ? std::to_string(index) : number(clock_, "clock")};
  }

 private:
  std::string number(int signal, const char* name) const {
    const int bits = vcd_.bits(signal);
    return formatted(vcd_.value(signal), format_of(name, bits), bits);
  }

  const VcdReader& vcd_;
  const int frame_, line_, clock_;
};

// The lanes, and which of them shows a signal.
std::multimap<int, std::size_t> add_lanes(const VcdReader& vcd, int clock, ClockedWaves& waves,
                                          const std::function<bool(const std::string&)>& takes) {
  std::map<std::string, int> scopes;
  std::vector<std::vector<ClockedWaves::Lane>> groups;
  bool clocked = false, chosen = false;
  for (const std::string& path : vcd.paths()) {
    const int signal = signal_of(vcd, path);
    const std::string scope = scope_of(path), name = name_of(path);
    const bool is_clock = signal == clock, is_beam = scope == Beam;
    if (is_clock ? clocked : is_beam ? name != "pixel" : !takes(path)) continue;
    clocked = clocked || is_clock;
    chosen = chosen || !(is_clock || is_beam);
    const auto [at, is_new] = scopes.emplace(scope, static_cast<int>(groups.size()));
    if (is_new) groups.emplace_back();
    auto& group = groups[static_cast<std::size_t>(at->second)];
    group.insert(is_clock ? group.begin() : group.end(),
                 {scope, name, vcd.bits(signal), is_clock, {}});
  }
  if (!chosen)
    throw UsageError("no signal is under --scope and --depth; names look like " +
                     vcd.paths().back());
  std::multimap<int, std::size_t> shown;
  for (auto& group : groups)
    for (auto& lane : group) {
      shown.emplace(signal_of(vcd, lane.path()), waves.lanes.size());
      waves.lanes.push_back(std::move(lane));
    }
  if (waves.lanes.size() > MostPictureLanes)
    throw UsageError(fmt::format(
        "a picture of {} signals cannot be read, the most is {}: choose some with --scope, "
        "'chip.u_subdivider' or '*_q', or --depth 1",
        waves.lanes.size(), MostPictureLanes));
  return shown;
}

}  // namespace

void check_picture_clocks(std::int64_t clocks) {
  if (clocks > MostPictureClocks)
    throw UsageError(fmt::format(
        "a picture of more than {} clocks cannot be read: narrow the window of `racebeam trace` "
        "with --from FRAME:LINE:CLOCK and --to FRAME:LINE:CLOCK",
        MostPictureClocks));
}

ClockedWaves read_waves(VcdReader& vcd, const std::function<bool(const std::string&)>& takes) {
  ClockedWaves waves;
  const int clock = find_clock(vcd);
  const auto shown = add_lanes(vcd, clock, waves, takes);
  const Ruler ruler(vcd);
  while (const auto time = vcd.next_time()) {
    waves.end = *time;
    for (const int signal : vcd.advance()) {
      if (signal == clock && vcd.value(signal) == "1")
        waves.clocks.push_back(ruler.at(*time, waves.clocks.size()));
      const auto [begin, end] = shown.equal_range(signal);
      for (auto lane = begin; lane != end; ++lane)
        waves.lanes[lane->second].changes.push_back({*time, vcd.value(signal)});
    }
    check_picture_clocks(static_cast<std::int64_t>(waves.clocks.size()));
  }
  if (waves.clocks.empty() || waves.end == waves.clocks.back().time)
    throw UsageError("a picture needs a whole clock, and the waveform has none");
  return waves;
}

}  // namespace racebeam
