// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/mutant_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <list>

#include "sc/swap/rtl_library.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/interrupt.h"
#include "tb/signoff/mutant_netlist.h"
#include "tb/signoff/shared_work.h"
#include "tb/twin/bare_rtl.h"

namespace racebeam {

namespace {

constexpr std::uint64_t Look = 50'000;  // clocks between looks for an interrupt

/// One mutant that lives, somewhere in a stream.
class Run {
 public:
  Run(const std::string& plugin, int number, const PortTraffic& traffic)
      : number_(number), rtl_(plugin, traffic) {
    if (number > 0) rtl_.hold(MutantInput, static_cast<std::uint64_t>(number));
  }

  int number() const { return number_; }
  /// Goes on through a part; its fate once it is found.
  std::optional<MutantFate> go_on(const PortTraffic& part, const std::string& stream) {
    MutantFate fate{number_, MutantFate::Found, stream, 0, "", ""};
    try {
      for (std::uint64_t from = 0; from < part.clocks();) {
        if (interrupted()) throw Interrupted();
        const std::uint64_t to = std::min(part.clocks(), from + Look);
        if (const auto found = rtl_.run(part, from, to)) {
          fate.clock = clocks_ + found->clock;
          fate.port = part.ports[found->port].name;
          fate.note = fmt::format("{:#x} instead of {:#x}", found->got, found->expected);
          return fate;
        }
        from = to;
      }
    } catch (const RtlFault& fault) {
      fate.clock = clocks_;
      fate.note = fault.what();
      return fate;
    }
    clocks_ += part.clocks();
    return {};
  }

 private:
  const int number_;
  BareRtl rtl_;
  std::uint64_t clocks_ = 0;  // of the parts before
};

/// The fates of those that the stream finds; the others are returned.
std::vector<int> run_stream(const std::string& plugin, const std::vector<int>& numbers,
                            const RecordedStream& stream,
                            const std::function<void(const MutantFate&)>& found) {
  std::list<Run> alive;
  for (std::size_t n = 0; n < stream.parts.size() && (n == 0 || !alive.empty()); ++n) {
    const PortTraffic part = read_traffic(stream.parts[n]);
    if (n == 0) {
      for (const int number : numbers) {
        alive.emplace_back(plugin, number, part);
        if (const auto fate = alive.back().go_on(part, stream.name)) {
          found(*fate);
          alive.pop_back();
        }
      }
      continue;
    }
    for (auto run = alive.begin(); run != alive.end();) {
      const auto fate = run->go_on(part, stream.name);
      if (fate) found(*fate);
      run = fate ? alive.erase(run) : std::next(run);
    }
  }
  std::vector<int> left;
  for (const Run& run : alive) left.push_back(run.number());
  return left;
}

}  // namespace

void run_mutants(const std::string& plugin, const std::vector<int>& numbers,
                 const std::vector<RecordedStream>& streams, int jobs,
                 const std::function<void(const MutantFate&)>& take) {
  share_work(
      jobs,
      [&](int share, const SayLine& say) {
        std::vector<int> left;
        for (std::size_t n = 0; n < numbers.size(); ++n)
          if (static_cast<int>(n % static_cast<std::size_t>(jobs)) == share)
            left.push_back(numbers[n]);
        for (const RecordedStream& stream : streams)
          left =
              run_stream(plugin, left, stream, [&](const MutantFate& fate) { say(line_of(fate)); });
        for (const int number : left) say(line_of({number, MutantFate::Alive, "", 0, "", ""}));
      },
      [&](const std::string& line) { take(fate_of(line)); });
}

std::optional<std::string> first_difference(const std::string& plugin,
                                            const std::vector<RecordedStream>& streams) {
  const std::string said = forked([&]() -> std::string {
    for (const RecordedStream& stream : streams) {
      std::string text;
      run_stream(plugin, {0}, stream, [&](const MutantFate& fate) {
        text = fmt::format("clock {} of {}: {} {}", fate.clock, stream.name, fate.port, fate.note);
      });
      if (!text.empty()) return text;
    }
    if (interrupted()) throw Interrupted();
    return "";
  });
  if (said.empty()) return {};
  return said;
}

}  // namespace racebeam
