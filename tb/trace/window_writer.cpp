// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/trace/window_writer.h"

#include <filesystem>

#include "tb/base/console.h"
#include "tb/base/counted.h"
#include "tb/base/errors.h"
#include "tb/base/interrupt.h"
#include "tb/base/progress.h"
#include "tb/trace/line_progress.h"

namespace racebeam {

namespace {

constexpr std::int64_t OverviewLines = 100;  ///< more are an overview, unless --scope says more
constexpr int ShortTransaction = 32;         ///< clocks

}  // namespace

int WindowWriter::write(ClockedRun& run, const TraceWindow& window) const {
  const TraceAxis& raster = run.raster();
  const std::int64_t first = window.from.ordinal(raster), last = window.to.ordinal(raster);
  const bool overview =
      selection.scopes.empty() && last - first >= OverviewLines * raster.line_clocks();
  VcdWriter vcd;
  SignalTrace trace(run.signals(!overview), raster, run.period_ps(), selection, overview, part,
                    vcd);
  TraceFiles files(output, picture, "racebeam: " + name, vcd);

  announce(TraceSize::of_signals(last - first + 1, first - run.clock(), vcd.signals(), overview));
  std::int64_t end = first;
  LineProgress progress(run, last, [&] { return bytes_text(static_cast<double>(vcd.bytes())); });
  if (run.go_to(first)) {
    run.each_clock([&](std::int64_t clock) {
      trace.sample(point_at(clock, raster));
      end = clock + 1;
    });
    run.go_to(last);
    run.settle();
    run.each_clock({});
  }
  progress.end();
  if (overview && end > last)
    tell(std::string("a long window is an overview: ") + run.left_out() +
         "; --scope '*' has all signals");
  return finish(files, vcd, {window, raster, run.period_ps(), end - first, 1});
}

void WindowWriter::check(ClockedRun& run) const {
  VcdWriter vcd;
  SignalTrace(run.signals(false), run.raster(), run.period_ps(), selection, false, part, vcd);
  TraceFiles(output, picture, "", vcd);
}

int WindowWriter::write_frames(const std::function<std::unique_ptr<FramedRun>(VcdWriter&)>& make,
                               const Raster& raster, int period_ps,
                               const TraceWindow& window) const {
  VcdWriter vcd;
  const std::unique_ptr<FramedRun> run = make(vcd);
  TraceFiles files(output, picture, "racebeam: " + name, vcd);
  announce(TraceSize::of_transactions(window.to.ordinal(raster) - window.from.ordinal(raster) + 1));
  Progress progress(window.to.frame - window.from.frame + 1);
  std::int64_t frames = 0;
  const std::int64_t clocks = run->run(window, [&] {
    progress.draw(frames, static_cast<std::uint64_t>(frames * raster.frame_clocks()),
                  bytes_text(static_cast<double>(vcd.bytes())));
    ++frames;
    return interrupted();
  });
  progress.clear();
  return finish(files, vcd, {window, raster, period_ps, clocks, ShortTransaction});
}

void WindowWriter::announce(const TraceSize& size) const {
  if (output.empty() || !size.is_long()) return;
  tell(size.text(output));
  std::error_code error;
  const auto folder = std::filesystem::absolute(output, error).parent_path();
  const auto space = std::filesystem::space(folder, error);
  if (error) return;
  if (const auto text = size.room_text(output, static_cast<double>(space.available)); !text.empty())
    tell(text);
}

int WindowWriter::finish(TraceFiles& files, const VcdWriter& vcd, const Written& written) const {
  if (written.clocks == 0) {
    tell("stopped before the window; nothing is written");
    return ExitInterrupted;
  }
  const std::int64_t first = written.window.from.ordinal(written.raster);
  const std::int64_t end = first + written.clocks;
  const auto time = [&](std::int64_t clock) {
    return static_cast<std::uint64_t>(clock * written.period_ps);
  };
  GtkwWindow seen{time(first), time(end), time(written.readable), {}, written.window.differs};
  if (const auto& mark = written.window.mark) seen.marker = time(mark->ordinal(written.raster));
  files.commit(seen);
  const bool whole = end > written.window.to.ordinal(written.raster);
  tell((whole ? "wrote " : "stopped early; kept ") + files.names() + ": " +
       counted(vcd.names().size(), "signal") + ", " + counted(written.clocks, "clock"));
  return whole ? ExitGood : ExitInterrupted;
}

}  // namespace racebeam
