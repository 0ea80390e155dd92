// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/twin/stream_player.h"

#include <fmt/format.h>

#include <cstring>
#include <sstream>
#include <vector>

#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/interrupt.h"

namespace racebeam {

namespace {

/// Numbers from one process to another.
std::string packed(const std::vector<std::uint64_t>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(std::uint64_t)};
}
std::vector<std::uint64_t> unpacked(const std::string& bytes) {
  std::vector<std::uint64_t> numbers(bytes.size() / sizeof(std::uint64_t));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(std::uint64_t));
  return numbers;
}

/// What a copy says; nothing of one that RTL ends.
std::string copied(const std::function<std::string()>& work) try {
  return interrupted() ? "" : forked(work);
} catch (const ChildDied&) {
  return "";
} catch (const Interrupted&) {
  return "";
}

}  // namespace

PortStream StreamPlayer::record(Stimulus stimulus, unsigned seed, std::uint64_t clocks,
                                std::uint64_t most) const {
  const std::vector<std::uint64_t> numbers = unpacked(forked([&] {
    twins_.stimulate(stimulus, seed);
    const PortStream all = twins_.record(clocks, most);
    std::vector<std::uint64_t> sent = {all.frames.size()};
    sent.insert(sent.end(), all.frames.begin(), all.frames.end());
    sent.push_back(all.seeks.size());
    for (const auto& [clock, frame] : all.seeks) {
      sent.push_back(clock);
      sent.push_back(static_cast<std::uint64_t>(frame));
    }
    sent.insert(sent.end(), all.values.begin(), all.values.end());
    return packed(sent);
  }));
  PortStream stream = twins_.form();
  auto next = numbers.begin();
  for (std::uint64_t left = *next++; left > 0; --left)
    stream.frames.push_back(static_cast<int>(*next++));
  for (std::uint64_t left = *next++; left > 0; --left, next += 2)
    stream.seeks[*next] = static_cast<int>(next[1]);
  stream.values.assign(next, numbers.end());
  return stream;
}

std::optional<StreamDifference> StreamPlayer::play(const PortStream& stream) const {
  const std::string answer = tell(stream, [](const LockstepDifference& d) {
    return fmt::format("{} {} {} {}", d.clock, d.port, d.expected, d.got);
  });
  if (answer.empty()) return std::nullopt;
  StreamDifference d;
  std::istringstream(answer) >> d.clock >> d.port >> d.expected >> d.got;
  return d;
}

std::string StreamPlayer::tell(
    const PortStream& stream,
    const std::function<std::string(const LockstepDifference&)>& text) const {
  return copied([&] {
    twins_.play(stream);
    const auto& d = twins_.lockstep().first();
    return d ? text(*d) : "";
  });
}

std::optional<StreamHit> StreamPlayer::find(const std::string& port, std::size_t count,
                                            const Streams& streams) const {
  for (std::size_t from = 0; from < count; ++from) {
    const std::string answer = copied([&] {
      for (std::size_t number = from; number < count; ++number) {
        const PortStream stream = streams(number);
        if (stream.clocks() < 2) continue;
        twins_.play(stream);
        const auto& d = twins_.lockstep().first();
        if (d || twins_.lockstep().fault())  // from here on the sides may have other registers
          return fmt::format("{} {}", number, d ? d->port : "fault");
      }
      return fmt::format("{} none", count);
    });
    std::string differs;
    if (!(std::istringstream(answer) >> from >> differs) && interrupted()) return std::nullopt;
    if (from < count && (differs == port || answer.empty())) {
      const PortStream stream = streams(from);
      const auto d = stream.clocks() < 2 ? std::nullopt : play(stream);
      if (d && d->port == port) return StreamHit{from, *d};
    }
  }
  return std::nullopt;
}

}  // namespace racebeam
