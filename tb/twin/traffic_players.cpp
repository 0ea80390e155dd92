// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "sc/swap/rtl_parameters.h"
#include "tb/scene/engines.h"
#include "tb/twin/traffic_replay.h"
#include "tb/twin/unit_bench.h"

namespace racebeam {

namespace {

constexpr const char* Clock = "clk_i";

class RtlPlayer : public TrafficPlayer {
 public:
  RtlPlayer(const std::string& plugin, const std::vector<PortTraffic::Port>& ports)
      : rtl_(plugin, ports) {}
  std::optional<TrafficDifference> run(const std::uint64_t* rows, std::uint64_t clocks,
                                       bool compared) override {
    return rtl_.run(rows, clocks, compared);
  }
  void drive(const std::uint64_t* rows, std::uint64_t clocks) override { rtl_.drive(rows, clocks); }
  void deposit(const std::string& signal, std::uint64_t value) override {
    rtl_.deposit(signal, value);
  }
  void settle(const std::uint64_t* row) override { rtl_.settle(row); }
  void edge() override { rtl_.edge(); }
  std::uint64_t value(std::size_t port) const override { return rtl_.value(port); }
  bool has(std::size_t port) const override { return rtl_.has(port); }
  std::size_t ports() const override { return rtl_.ports(); }

 private:
  BareRtl rtl_;
};

class ModelPlayer : public TrafficPlayer {
 public:
  ModelPlayer(std::unique_ptr<sc_core::sc_module> model,
              const std::vector<PortTraffic::Port>& ports)
      : model_(std::move(model)), bench_(*model_) {
    for (const PortTraffic::Port& port : ports) pins_.push_back(&bench_[port.name]);
  }
  std::optional<TrafficDifference> run(const std::uint64_t* rows, std::uint64_t clocks,
                                       bool compared) override {
    for (std::uint64_t clock = 0; clock < clocks; ++clock, rows += pins_.size()) {
      settle(rows);
      for (std::size_t n = 0; n < pins_.size() && (clock > 0 || compared); ++n)
        if (!pins_[n]->input && pins_[n]->value() != rows[n])
          return TrafficDifference{clock, n, rows[n], pins_[n]->value()};
      edge();
    }
    return std::nullopt;
  }
  void drive(const std::uint64_t* rows, std::uint64_t clocks) override {
    for (; clocks > 0; --clocks, rows += pins_.size()) {
      settle(rows);
      edge();
    }
  }
  void settle(const std::uint64_t* row) override {
    for (std::size_t n = 0; n < pins_.size(); ++n)
      if (pins_[n]->input) pins_[n]->drive(row[n]);
    bench_.settle();
  }
  void edge() override { bench_.clock(); }
  std::uint64_t value(std::size_t port) const override { return pins_[port]->value(); }
  bool has(std::size_t) const override { return true; }
  std::size_t ports() const override { return pins_.size(); }
  void deposit(const std::string& signal, std::uint64_t) override {
    throw RtlError("a model has no register " + signal + "; it is put to a frame by its pins");
  }

 private:
  const std::unique_ptr<sc_core::sc_module> model_;
  UnitBench bench_;
  std::vector<UnitBench::Pin*> pins_;
};

/// Throws RtlError if the RTL cannot stand in the unit's place.
void check(const rtl_model& model, const UnitUnderTest& dut, const TrafficHead& head) {
  if (dut.unit != model.unit)
    throw RtlError(dut.plugin + " holds the unit " + model.unit + ", not " + dut.unit);
  std::vector<rtl_pin> pins;
  for (const PortTraffic::Port& port : head.ports)
    pins.push_back({port.name, port.input, port.bits, port.optional});
  if (has_rtl_port(model, Clock)) pins.push_back({Clock, true, 1, true});
  if (const std::string faults = port_faults(model, pins); !faults.empty())
    throw RtlError(rtl_place(model) + ": this does not fit the unit " + dut.unit + ":" + faults);
  std::string other;
  for (const rtl_parameter& parameter :
       other_parameters(built_parameters(model), engine_of(dut.k).parameters(dut.k)))
    other += " " + parameter.name + "=" + std::to_string(parameter.value);
  if (!other.empty())
    throw RtlError(dut.plugin + " was built with other parameters; build it with" + other);
}

}  // namespace

std::unique_ptr<TrafficPlayer> play_rtl(const UnitUnderTest& dut, const TrafficHead& head) {
  check(rtl_library(dut.plugin).model(), dut, head);
  return std::make_unique<RtlPlayer>(dut.plugin, head.ports);
}

std::unique_ptr<TrafficPlayer> play_model(const UnitUnderTest& dut, const TrafficHead& head) {
  return std::make_unique<ModelPlayer>(
      engine_of(dut.k).unit(dut.unit)->make("model", dut.k, dut.scene), head.ports);
}

}  // namespace racebeam
