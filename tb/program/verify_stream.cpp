// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/program/verify_stream.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <optional>

#include "tb/base/counted.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/scene/engines.h"
#include "tb/show/set_knob.h"
#include "tb/trace/difference_wave.h"
#include "tb/twin/lockstep_text.h"
#include "tb/twin/shrink.h"
#include "tb/twin/stream_player.h"
#include "tb/twin/twins.h"

namespace racebeam {

namespace {

constexpr std::uint64_t MostRecorded = 1 << 17;  // clocks before a difference

/// Of the inputs only those that move, of the outputs only the one that differs.
LockstepDifference focused(const LockstepDifference& d, const PortStream& stream) {
  std::vector<std::size_t> kept;
  std::size_t input = 0;
  for (std::size_t n = 0; n < d.columns.size(); ++n) {
    const auto& column = d.columns[n];
    if (column.side == LockstepDifference::Input) {
      while (stream.inputs.at(input).name != column.port) ++input;  // the RTL may do without one
      if (stream.moves(input)) kept.push_back(n);
    } else if (column.port == d.port) {
      kept.push_back(n);
    }
  }
  LockstepDifference less = d;
  less.columns.clear();
  for (const std::size_t n : kept) less.columns.push_back(d.columns[n]);
  for (auto& row : less.history) {
    std::vector<std::uint64_t> values;
    for (const std::size_t n : kept) values.push_back(row[n]);
    row = std::move(values);
  }
  return less;
}

std::string held_text(const PortStream& stream) {
  std::string text;
  std::size_t resting = 0;
  for (std::size_t input = 0; input < stream.inputs.size(); ++input) {
    if (stream.moves(input)) continue;
    const PortStream::Input& port = stream.inputs[input];
    if (stream.at(1, input) == port.rest) ++resting;
    else text += fmt::format("{} {:x}, ", port.name, stream.at(1, input));
  }
  return "held: " + text + counted(resting, "other input") + " at rest";
}

std::string head_text(const ShrunkDifference& shrunk, const PortStream& stream) {
  return fmt::format("{} after the reset, {} of {} moving", counted(shrunk.clocks, "clock"),
                     shrunk.moving, counted(stream.inputs.size(), "input"));
}

}  // namespace

void shrink_difference(FirstDifference& first, const UnitUnderTest& dut, Stimulus stimulus,
                       unsigned seed, const std::string& folder, const std::string& verify) {
  TwinBench twins(dut);
  const char* const traffic = stimulus == Stimulus::Random ? "random" : "walk";
  const StreamPlayer player(twins);
  const std::optional<ShrunkStream> small =
      shrink(player.record(stimulus, seed, first.clock + 1, MostRecorded), first.port,
             twins_of(engine_of(dut.k)).inputs(dut.k, dut.scene, dut.unit),
             [&](const std::string& port, std::size_t count, const Streams& streams) {
               return player.find(port, count, streams);
             });
  if (interrupted()) return;
  if (!small) {
    first.text +=
        fmt::format("not shrunk: {} does not differ when the last {} clocks begin in reset\n",
                    first.port, std::min(first.clock, MostRecorded));
    return;
  }
  const PortStream& stream = small->stream;
  const StreamDifference& d = small->difference;
  const std::string file =
      (std::filesystem::path(folder) / (dut.unit + "_" + traffic + ".stream")).string();
  first.shrunk = ShrunkDifference{d.clock,
                                  stream.moving(),
                                  d.expected,
                                  d.got,
                                  small->plays,
                                  file,
                                  verify + " --stream " + file};
  const std::string head = head_text(*first.shrunk, stream);
  write_text(file,
             stream_text(stream, {fmt::format("{}: port {} differs in clock {}: the model has "
                                              "{:#x}, the RTL {:#x}",
                                              dut.unit, d.port, d.clock, d.expected, d.got),
                                  fmt::format("shrunk from clock {} of the {} traffic of seed {}: "
                                              "{}",
                                              first.clock, traffic, seed, head),
                                  first.shrunk->repeat}));
  const RegisterHistory& registers = twins.remember_registers();
  const std::string table = player.tell(stream, [&](const LockstepDifference& difference) {
    return difference_table(registers.beside(focused(difference, stream))) +
           registers.text(difference);
  });
  first.text +=
      fmt::format("shrunk to {}; the model has {:#x}, the RTL {:#x}:\n{}{}\nrepeat: {}\n", head,
                  d.expected, d.got, table, held_text(stream), first.shrunk->repeat);
}

UnitVerdict verify_stream(const UnitUnderTest& dut, const std::string& file,
                          const std::string& folder, const std::string& repeat) {
  TwinBench twins(dut);
  const Lockstep& lockstep = twins.lockstep();
  const PortStream stream = read_stream(file, twins.form());
  const RegisterHistory& registers = twins.remember_registers();
  const auto start = std::chrono::steady_clock::now();
  twins.play(stream);
  UnitVerdict verdict{dut.unit,
                      "stream",
                      lockstep.clocks(),
                      lockstep.masked(),
                      lockstep.differences(),
                      0,
                      {},
                      lockstep.fault().value_or("")};
  verdict.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (const auto& d = lockstep.first())
    verdict.first =
        FirstDifference{d->port,
                        d->clock,
                        d->expected,
                        d->got,
                        {},
                        explain(*d, {"on the stream " + file, repeat, "",
                                     save_unit_window(*d, verdict.traffic, dut.k, folder),
                                     knobs_text(dut.k), &registers}),
                        {}};
  return verdict;
}

}  // namespace racebeam
