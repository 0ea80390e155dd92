// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/speed/block_rows.h"

#include <fmt/format.h>

#include "sc/block/block_machine.h"
#include "tb/host/block_program.h"
#include "tb/show/open_show.h"

namespace racebeam {

namespace {

constexpr int Cores[] = {1,  2,  4,  8,
                         16, 35, 36, 64};  // the source's machine has 36, one of them asks
constexpr int Pictures = 900, Every = 30;
constexpr double BlockClock = 50.4e6;

std::string with_commas(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, ",");
  return text;
}

}  // namespace

nlohmann::json core_rows() {
  auto all = nlohmann::json::array();
  const Show show = open_show(scene_path("block/forty"));
  for (const int cores : Cores) {
    block_knobs k;
    k.cores = cores;
    block_machine machine(k);
    machine.draw(block_program_of(show.tables()));
    const block_counters& n = machine.counters();
    const auto clocks = static_cast<double>(n.clocks);
    all.push_back({{"cores", cores},
                   {"clocks", n.clocks},
                   {"busy", static_cast<double>(n.busy_clocks) / (clocks * cores)},
                   {"bus_stalls", n.bus_stalls},
                   {"pictures_per_second", BlockClock / clocks}});
  }
  return all;
}

std::string core_text(const nlohmann::json& rows) {
  std::string text =
      "| cores | clocks | busy | waits for the bus | pictures a second at 50.4 MHz |\n"
      "|--:|--:|--:|--:|--:|\n";
  for (const auto& row : rows)
    text +=
        fmt::format("| {} | {} | {:.1f} % | {} | {:.2f} |\n", row.at("cores").get<int>(),
                    with_commas(row.at("clocks")), 100 * row.at("busy").get<double>(),
                    with_commas(row.at("bus_stalls")), row.at("pictures_per_second").get<double>());
  return text;
}

nlohmann::json picture_rows() {
  auto all = nlohmann::json::array();
  const Show show = open_show(scene_path("block/bounce"));
  const block_knobs k;
  BlockMotion motion(block_program_of(show.tables()), k);
  block_machine machine(k);
  double sum = 0;
  for (int picture = 0; picture < Pictures; ++picture) {
    if (picture > 0) motion.picture();
    machine.await_frame();
    machine.draw(motion.tables());
    const double milliseconds = static_cast<double>(machine.counters().clocks) / BlockClock * 1e3;
    sum += milliseconds;
    if (picture % Every == 0) all.push_back({{"picture", picture}, {"milliseconds", milliseconds}});
  }
  all.push_back({{"pictures", Pictures}, {"milliseconds", sum}});
  return all;
}

std::string picture_text(const nlohmann::json& rows) {
  std::string text = "picture  ms at 50.4 MHz\n";
  for (const auto& row : rows) {
    const bool total = row.contains("pictures");
    text += fmt::format("{:>7}  {:14.4f}\n", total ? "all 900" : row.at("picture").dump(),
                        row.at("milliseconds").get<double>());
  }
  return text;
}

}  // namespace racebeam
