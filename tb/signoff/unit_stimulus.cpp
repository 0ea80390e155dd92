// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/unit_stimulus.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "sc/base/engine.h"
#include "tb/base/errors.h"
#include "tb/base/forked.h"
#include "tb/base/interrupt.h"
#include "tb/base/output_file.h"
#include "tb/base/whole_file.h"
#include "tb/scene/engines.h"
#include "tb/twin/random_episodes.h"
#include "tb/twin/twins.h"

namespace racebeam {

namespace {

constexpr std::uint64_t FirstPart = 500, LargestPart = 100'000, Growth = 4;  // clocks
constexpr std::uint64_t Look = 1024;                                         // clocks

using Json = nlohmann::json;

/// The model alone on a bench. One in a process.
class ModelBench {
 public:
  explicit ModelBench(const UnitUnderTest& dut)
      : model_(engine_of(dut.k).unit(dut.unit)->make("model", dut.k, dut.scene)),
        bench_(*model_),
        traffic_(traffic_of(dut.unit, bench_)) {}

  UnitBench& bench() { return bench_; }
  PortTraffic& traffic() { return traffic_; }
  void clock() {
    bench_.settle();
    traffic_.append(bench_);
    bench_.clock();
  }

 private:
  std::unique_ptr<sc_core::sc_module> model_;
  UnitBench bench_;
  PortTraffic traffic_;
};

RecordedStream record(const UnitUnderTest& dut, const std::string& name, std::uint64_t clocks,
                      const std::function<std::function<void()>(UnitBench&)>& begin,
                      const std::string& folder) {
  ModelBench model(dut);
  const std::function<void()> next = begin(model.bench());
  RecordedStream stream{name, {}, clocks};
  std::uint64_t length = FirstPart;
  for (std::uint64_t done = 0; done < clocks;) {
    for (const std::uint64_t end = std::min(clocks, done + length); done < end; ++done) {
      if (done > 0) next();
      if (done % Look == 0 && interrupted()) throw Interrupted();
      model.clock();
    }
    stream.parts.push_back(fmt::format("{}/{}.{}.{}", folder, dut.unit, name, stream.parts.size()));
    write_traffic(model.traffic(), stream.parts.back());
    model.traffic().values.clear();
    length = std::min(LargestPart, length * Growth);
  }
  return stream;
}

/// In a process of its own.
RecordedStream recorded(const UnitUnderTest& dut, const std::string& name, std::uint64_t clocks,
                        const std::function<std::function<void()>(UnitBench&)>& begin,
                        const std::string& folder) {
  const Json parts = Json::parse(
      forked([&] { return Json(record(dut, name, clocks, begin, folder).parts).dump(); }));
  return {name, parts.get<std::vector<std::string>>(), clocks};
}

}  // namespace

std::vector<RecordedStream> record_stimulus(const UnitUnderTest& dut, std::uint64_t random,
                                            unsigned seed, const std::string& folder) {
  const Twins& row = twins_of(engine_of(dut.k));
  std::vector<RecordedStream> streams;
  if (random > 0)
    streams.push_back(recorded(
        dut, RandomStream, random,
        [&](UnitBench& bench) -> std::function<void()> {
          const auto traffic = random_traffic(dut, bench, seed);
          return [traffic] { traffic->next(); };
        },
        folder));
  if (const UnitWalk* walk = row.walk(dut.unit))
    streams.push_back(recorded(
        dut, "walk", walk->clocks,
        [&](UnitBench& bench) {
          const auto next = walk->begin(bench, dut.k, seed);
          next();  // its first clock is that in reset
          return next;
        },
        folder));
  return streams;
}

PortTraffic whole_traffic(const RecordedStream& stream) {
  PortTraffic all;
  for (const std::string& file : stream.parts) {
    PortTraffic part = read_traffic(file);
    if (all.ports.empty()) all = std::move(part);
    else all.values.insert(all.values.end(), part.values.begin(), part.values.end());
  }
  return all;
}

std::vector<std::vector<std::uint64_t>> input_rows(const PortTraffic& traffic,
                                                   std::uint64_t clock) {
  std::vector<std::vector<std::uint64_t>> rows;
  for (std::uint64_t n = 0; n <= clock && n < traffic.clocks(); ++n) {
    rows.emplace_back();
    for (std::size_t port = 0; port < traffic.ports.size(); ++port)
      if (traffic.ports[port].input) rows.back().push_back(traffic.row(n)[port]);
  }
  return rows;
}

PortTraffic model_answers(const UnitUnderTest& dut, const PortStream& stream) {
  ModelBench model(dut);
  for (std::uint64_t clock = 0; clock < stream.clocks(); ++clock) {
    std::size_t input = 0;
    for (UnitBench::Pin* pin : model.bench().pins())
      if (pin->input) pin->drive(stream.at(clock, input++));
    model.clock();
  }
  return model.traffic();
}

PortTraffic ports_of(const UnitUnderTest& dut) { return ModelBench(dut).traffic(); }

void write_traffic(const PortTraffic& traffic, const std::string& path) {
  Json ports = Json::array();
  for (const PortTraffic::Port& port : traffic.ports)
    ports.push_back({port.name, port.bits, port.input});
  const std::string head =
      Json{{"unit", traffic.unit}, {"ports", ports}, {"clocks", traffic.clocks()}}.dump() + "\n";
  OutputFile file(path);
  file.write(head.data(), head.size());
  file.write(traffic.values.data(), traffic.values.size() * sizeof(std::uint64_t));
  file.commit();
}

PortTraffic read_traffic(const std::string& path) {
  const std::string bytes = whole_file(path);
  const std::size_t end = bytes.find('\n');
  if (end == std::string::npos) throw std::runtime_error(path + " is no traffic of ports");
  const Json head = Json::parse(bytes.substr(0, end));
  PortTraffic traffic;
  traffic.unit = head.at("unit");
  for (const Json& port : head.at("ports"))
    traffic.ports.push_back({port.at(0), port.at(1), port.at(2)});
  const std::size_t count = head.at("clocks").get<std::size_t>() * traffic.ports.size();
  if (bytes.size() != end + 1 + count * sizeof(std::uint64_t))
    throw std::runtime_error(path + " is not whole");
  traffic.values.resize(count);
  if (count > 0)
    std::memcpy(traffic.values.data(), bytes.data() + end + 1, count * sizeof(std::uint64_t));
  return traffic;
}

}  // namespace racebeam
