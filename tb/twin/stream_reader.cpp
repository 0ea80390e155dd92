// The file of a stream, read line by line.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "tb/base/errors.h"
#include "tb/base/nearest.h"
#include "tb/twin/port_stream.h"

namespace racebeam {

namespace {

using Words = std::vector<std::string>;

constexpr const char* Head = "# racebeam-stream 1";
constexpr std::uint64_t MostClocks = 1'000'000;

class StreamReader {
 public:
  explicit StreamReader(const std::string& path) : path_(path) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
      throw UsageError(path + " is a folder; name a .stream file in it");
    in_.open(path);
    if (!in_)
      throw UsageError("there is no file " + path +
                       "; `racebeam verify` writes one beside the waveform of a difference");
    std::string first;
    std::getline(in_, first);
    ++line_;
    if (!first.empty() && first.back() == '\r') first.pop_back();
    if (first != Head)
      fail(fmt::format("this is no stream of this racebeam; the first line must be '{}'", Head));
  }

  std::string unit() {
    const std::optional<Words> words = next();
    if (!words || words->size() != 2 || words->front() != "unit")
      fail("the first words must be 'unit NAME'");
    return words->back();
  }

  std::vector<PortStream> read(const PortStream& form) {
    begin(form);
    if (const std::string name = unit(); name != form.unit)
      fail(fmt::format("this is a stream for {}, not for {}; name that unit", name, form.unit));
    std::vector<PortStream> episodes;
    while (const std::optional<Words> words = next()) {
      if (words->front() == "unit") fail("a second unit; a stream is for one");
      else if (words->front() == "hold") hold(*words);
      else if (words->front() == "clock") name_moving(*words);
      else if (words->front() == "frame") seek(*words);
      else if (words->front() != "episode") clocks(*words);
      else if (words->size() > 1) fail("episode stands alone");
      else if (begun_) {
        episodes.push_back(ended());
        begin(form);
      }
      begun_ = true;
    }
    episodes.push_back(ended());
    return episodes;
  }

 private:
  [[noreturn]] void fail(const std::string& text) const {
    throw UsageError(fmt::format("{}:{}: {}", path_, line_, text));
  }

  void begin(const PortStream& form) {
    stream_ = form;
    stream_.values.clear();
    stream_.seeks.clear();
    row_.clear();
    for (const PortStream::Input& input : form.inputs) row_.push_back(input.rest);
    moving_.clear();
    named_ = false;
  }
  PortStream ended() {
    if (stream_.clocks() == 0) fail("there is no clock; add a line such as '1', with its values");
    if (frame_) fail("no clock follows the last frame; add one, or remove it");
    before_ += stream_.clocks();
    stream_.begin_in_reset();
    return std::move(stream_);
  }

  /// Those of the next line that has some.
  std::optional<Words> next() {
    for (std::string line; std::getline(in_, line);) {
      ++line_;
      std::istringstream in(line.substr(0, line.find('#')));
      Words words;
      for (std::string word; in >> word;) words.push_back(word);
      if (!words.empty()) return words;
    }
    return std::nullopt;
  }

  std::size_t input(const std::string& name) const {
    Words names;
    for (std::size_t n = 0; n < stream_.inputs.size(); ++n) {
      if (stream_.inputs[n].name == name) return n;
      names.push_back(stream_.inputs[n].name);
    }
    fail(unknown_name("input of " + stream_.unit, name, names).what());
  }

  std::uint64_t number(std::string word, int base, const char* what) const {
    if (base == 16 && word.rfind("0x", 0) == 0) word.erase(0, 2);
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, base);
    if (word.empty() || error != std::errc() || end != word.data() + word.size())
      fail(fmt::format("'{}' is not {}", word, what));
    return value;
  }

  std::uint64_t value(const std::string& word, std::size_t input) const {
    const PortStream::Input& port = stream_.inputs[input];
    const std::uint64_t value = number(word, 16, "a hexadecimal number");
    if (value != raw_bits(value, port.bits))
      fail(fmt::format("{} does not fit {}, which has {}; {:x} is the largest value", word,
                       port.name, port.bits == 1 ? "1 bit" : fmt::format("{} bits", port.bits),
                       raw_bits(~std::uint64_t{0}, port.bits)));
    return value;
  }

  void hold(const Words& words) {
    if (words.size() != 3) fail("hold takes an input and its value, as in 'hold NAME 1f'");
    if (named_) fail("hold stands before the line that begins with 'clock'");
    const std::size_t port = input(words[1]);
    row_[port] = value(words[2], port);
  }

  void name_moving(const Words& words) {
    if (named_) fail("a second line 'clock'; the inputs that move are named once");
    named_ = true;
    for (std::size_t n = 1; n < words.size(); ++n) moving_.push_back(input(words[n]));
  }

  void seek(const Words& words) {
    if (words.size() != 2) fail("frame takes a number, as in 'frame 9599'");
    if (!stream_.counts_frames) fail(stream_.unit + " counts no frames; remove this line");
    const std::uint64_t frame = number(words[1], 10, "the number of a frame");
    if (frame > LastFrame) fail(fmt::format("frame {} is out of range; 0..{}", frame, LastFrame));
    frame_ = static_cast<int>(frame);
  }

  /// "3 0 1f", or "3..7 0 1f".
  void clocks(const Words& words) {
    if (!named_)
      fail(fmt::format("'{}' is not known here; the line 'clock NAME ...' comes before the clocks",
                       words[0]));
    const auto dots = words[0].find("..");
    const auto clock = [&](const std::string& word) {
      return number(word, 10, "the number of a clock, nor 'hold', 'clock' or 'frame'");
    };
    const std::uint64_t first = clock(words[0].substr(0, dots));
    const std::uint64_t last = dots == std::string::npos ? first : clock(words[0].substr(dots + 2));
    const std::uint64_t expected = std::max<std::uint64_t>(1, stream_.clocks());
    if (first != expected || last < first)
      fail(fmt::format("'{}' stands where clock {} must; clocks are numbered from 1 on", words[0],
                       expected));
    if (before_ + last > MostClocks)
      fail(fmt::format("a stream has {} clocks at most", MostClocks));
    if (words.size() != moving_.size() + 1)
      fail(fmt::format("{} values for {} inputs; give one for each name after 'clock'",
                       words.size() - 1, moving_.size()));
    for (std::size_t n = 0; n < moving_.size(); ++n)
      row_[moving_[n]] = value(words[n + 1], moving_[n]);
    if (stream_.clocks() == 0) stream_.values = row_;  // of the clock in reset
    if (frame_) stream_.seeks[first] = *frame_;
    frame_.reset();
    for (std::uint64_t n = first; n <= last; ++n)
      stream_.values.insert(stream_.values.end(), row_.begin(), row_.end());
  }

  static constexpr std::uint64_t LastFrame = 16'383;

  const std::string path_;
  std::ifstream in_;
  int line_ = 0;
  PortStream stream_;
  std::vector<std::uint64_t> row_;
  std::vector<std::size_t> moving_;
  bool begun_ = false, named_ = false;
  std::uint64_t before_ = 0;  // clocks of the episodes before
  std::optional<int> frame_;
};

}  // namespace

std::string unit_of_stream(const std::string& path) { return StreamReader(path).unit(); }

std::vector<PortStream> read_episodes(const std::string& path, const PortStream& form) {
  return StreamReader(path).read(form);
}

PortStream read_stream(const std::string& path, const PortStream& form) {
  std::vector<PortStream> episodes = read_episodes(path, form);
  PortStream all = std::move(episodes.front());
  for (auto episode = episodes.begin() + 1; episode != episodes.end(); ++episode) {
    for (const auto& [clock, frame] : episode->seeks) all.seeks[all.clocks() + clock] = frame;
    all.values.insert(all.values.end(), episode->values.begin(), episode->values.end());
  }
  return all;
}

}  // namespace racebeam
