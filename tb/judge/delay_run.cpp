// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/judge/delay_run.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "sc/swap/channel_delays.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/interrupt.h"
#include "tb/bench/benches.h"
#include "tb/bench/wired_bench.h"
#include "tb/show/level.h"
#include "tb/twin/delays.h"

namespace racebeam {

namespace {

/// A picture, as a child tells of it.
struct Seen {
  std::uint64_t clocks, starved;
  std::vector<std::uint32_t> colours;
};

std::uint64_t counter(const engine& built, const frame_counts& counts, const std::string& name) {
  for (std::size_t n = 0; n < built.counters.size(); ++n)
    if (built.counters[n].name == name) return counts.counters[n];
  return 0;
}

/// Of a frame that races the beam, the clocks of its lines in which the tracer did something.
std::uint64_t busy_clocks(const engine& built, const frame_counts& counts) {
  std::uint64_t sum = 0;
  for (std::size_t n = 0; n < built.lines.size(); ++n)
    if (built.lines[n].name == std::string("busy_clocks"))
      for (const int clocks : counts.lines[n]) sum += static_cast<std::uint64_t>(clocks);
  return sum;
}

/// The pictures of a chip with a plan, or without: as many numbers for each as Seen has.
std::string show_all(const Run& run, const std::shared_ptr<const delay_plan>& plan,
                     const std::vector<int>& numbers) {
  const engine& built = run.show.engine();
  const planned_delays delays(plan);
  const auto bench = bench_of(built).make(
      LevelSignal, {built, run.k, run.show.tables(), run.show.frames(), run.units}, {});
  const auto& wired = dynamic_cast<const WiredBench&>(*bench);
  if (const channel_delays* const put = channel_delays::of(wired.dut()))
    for (const std::string& port : put->missing())
      throw std::logic_error("the chip has no registers at " + port);
  std::string bytes;
  const auto add = [&](std::uint64_t value, int count) {
    for (int n = 0; n < count; ++n) bytes += static_cast<char>(value >> 8 * n);
  };
  for (const int number : numbers) {
    if (interrupted()) throw Interrupted();
    bench->seek(number);
    const ChipBench::Frame frame = bench->render();
    add(built.races_beam ? busy_clocks(built, *frame.stats) : frame.time.clocks, 8);
    add(counter(built, *frame.stats, "starved_pixels"), 8);
    add(frame.picture.pixels(), 8);
    for (std::size_t n = 0; n < frame.picture.pixels(); ++n) add(frame.picture.colour(n), 4);
  }
  return bytes;
}

std::vector<Seen> seen_of(const std::string& bytes) {
  std::size_t at = 0;
  const auto take = [&](int count) {
    std::uint64_t value = 0;
    for (int n = 0; n < count; ++n)
      value |= std::uint64_t{static_cast<unsigned char>(bytes.at(at++))} << 8 * n;
    return value;
  };
  std::vector<Seen> all;
  while (at < bytes.size()) {
    Seen one{take(8), take(8), {}};
    for (std::uint64_t left = take(8); left > 0; --left)
      one.colours.push_back(static_cast<std::uint32_t>(take(4)));
    all.push_back(one);
  }
  return all;
}

DelayedPictures beside(const std::vector<Seen>& expected, const std::vector<Seen>& got) {
  DelayedPictures sum;
  for (std::size_t n = 0; n < got.size(); ++n) {
    sum.clocks += got[n].clocks;
    sum.starved += got[n].starved;
    for (std::size_t at = 0; at < got[n].colours.size(); ++at)
      sum.pixels += got[n].colours[at] != expected.at(n).colours.at(at);
  }
  return sum;
}

template <class Good>
int slack_of(const std::vector<DelayedPictures>& by_latency, const Good& good) {
  int latency = 0;
  while (latency + 1 < static_cast<int>(by_latency.size()) &&
         good(by_latency[static_cast<std::size_t>(latency) + 1]))
    ++latency;
  return latency;
}

/// Calls `work` with 0, 1, ... `count` - 1 in so many threads, each of which waits for a child.
void spread_over(int jobs, int count, const std::function<void(int)>& work) {
  std::atomic<int> next{0};
  std::mutex one_at_a_time;
  std::exception_ptr thrown;
  std::vector<std::thread> threads;
  for (int job = 0; job < std::min(jobs, count); ++job)
    threads.emplace_back([&] {
      for (int n = next++; n < count; n = next++) {
        try {
          if (interrupted()) throw Interrupted();
          work(n);
        } catch (...) {
          const std::lock_guard lock(one_at_a_time);
          if (!thrown) thrown = std::current_exception();
          next = count;
        }
      }
    });
  for (std::thread& thread : threads) thread.join();
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace

int ChannelSlack::starving_slack() const {
  return slack_of(by_latency, [this](const DelayedPictures& one) {
    return one.starved <= by_latency[0].starved;
  });
}

int ChannelSlack::colour_slack() const {
  return slack_of(by_latency, [](const DelayedPictures& one) { return one.pixels == 0; });
}

std::vector<ChannelSlack> measure_slack(const Run& run, const std::vector<std::string>& channels,
                                        const std::vector<int>& numbers, int most, int jobs,
                                        const std::function<void(int)>& done) {
  std::vector<ChannelSlack> all;
  for (const std::string& channel : channels)
    all.push_back({channel, std::vector<DelayedPictures>(static_cast<std::size_t>(most) + 1)});
  const std::vector<Seen> expected =
      seen_of(forked([&] { return show_all(run, nullptr, numbers); }));
  int whole = 1;
  done(whole);
  std::mutex one_at_a_time;
  spread_over(jobs, static_cast<int>(channels.size()) * most, [&](int n) {
    ChannelSlack& slack = all[static_cast<std::size_t>(n / most)];
    const int latency = n % most + 1;
    const auto plan = std::make_shared<delay_plan>();
    plan->channels.push_back(delayed_channel(run.show.engine(), slack.channel, latency));
    const auto got = seen_of(forked([&] { return show_all(run, plan, numbers); }));
    if (got.size() != expected.size()) throw Interrupted();
    slack.by_latency[static_cast<std::size_t>(latency)] = beside(expected, got);
    const std::lock_guard lock(one_at_a_time);
    done(++whole);
  });
  for (ChannelSlack& slack : all) slack.by_latency[0] = beside(expected, expected);
  return all;
}

}  // namespace racebeam
