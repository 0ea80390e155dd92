// rtl_island: the RTL of several units that are wired to each other, verilated as one.
//
// Each unit keeps its pins and its place in the chip, an rtl_shell; what is behind the pins is one
// model. It is evaluated when a wire from outside changes that reaches one of its outputs, not
// whenever one of its units moves another. Wires that only units inside read carry the same values
// at the same clocks as ever, but of events they have posedge_event() only.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/swap/changed_ports.h"
#include "sc/swap/followed_inputs.h"
#include "sc/swap/rtl_back_door.h"
#include "sc/swap/rtl_library.h"
#include "sc/swap/rtl_rest.h"

namespace racebeam {

/// The module's name, that of its input in the place of the clock, and before a number that of the
/// input that changes when others of that group have.
constexpr const char* IslandTop = "racebeam_island";
constexpr const char* IslandTick = "racebeam_tick";
constexpr const char* IslandTake = "racebeam_take_";
/// Before the name of an input that reaches no output before the next edge; before the number of
/// another one's group, which "_" ends.
constexpr const char* IslandLate = "late_";
constexpr const char* IslandGroup = "group";
/// Of a unit with a back door, before its instance: its own clock, whether it has inputs of its
/// own, and before the instance and a port these.
constexpr const char* OwnTick = "tick_";
constexpr const char* OwnPins = "own_";

/// The wire at a port, as chips name theirs: without the suffix, active low ones with _n.
std::string wire_name(const std::string& port);

class rtl_island;

/// A unit of an island, by its pins.
class island_unit {
 public:
  explicit island_unit(std::string plugin) : plugin_(std::move(plugin)) {}
  virtual ~island_unit() = default;
  virtual const sc_core::sc_module& module() const = 0;
  /// Of the island.
  const std::string& plugin() const { return plugin_; }
  void join(rtl_island& island) { island_ = &island; }

 protected:
  rtl_island& island() const { return *island_; }

 private:
  const std::string plugin_;
  rtl_island* island_ = nullptr;
};

class rtl_island : public sc_core::sc_prim_channel {
 public:
  /// Of units in a chip under construction, whose ports are bound. Throws RtlError: no plug-in, or
  /// one of other units or ports.
  rtl_island(const std::string& name, const std::vector<island_unit*>& units);
  rtl_island(const rtl_island&) = delete;
  rtl_island& operator=(const rtl_island&) = delete;

  /// Registers inside one of its units.
  std::vector<probe> probes(const std::string& instance) const;
  /// Edges of one unit alone, with these inputs and the others as they are.
  void private_edges(const std::string& instance, const input_values& inputs, int edges);

 private:
  struct input {
    any_port* pin;
    const rtl_port* rtl;
  };
  struct output {
    any_port* pin;
    const rtl_port* rtl;
    wire_contents wire{};
    bool is_inner = true;                      // nobody outside reads the wire
    const racebeam::wire<1>* rises = nullptr;  // an inner wire of one bit
  };

  void join(const std::vector<island_unit*>& units);
  void find_wires();
  void comb();
  void seq();
  void update() override;
  bool settle();
  void check_late();
  bool drive();
  void show();

  // What each clock reads comes first, in few lines of the cache.
  alignas(64) rtl_library library_;
  followed_inputs wires_{library_.model()};
  changed_ports changes_;                                       // of the outputs
  std::vector<any_wire*> driven_;                               // by them; nullptr: an inner one
  std::vector<std::pair<std::size_t, std::uint64_t>> to_show_;  // inner ones that have moved
  rtl_rest rest_;
  bool settled_ = false, bound_ = false;
  // An edge is due, at once with the inputs that move after it, when the others have had theirs.
  bool due_ = false;
  bool followed_ = false;  // since the last edge inputs have moved, as they may after the next one
  std::uint64_t edges_ = 0;
  sc_core::sc_event moved_event_;  // an input that is not late has, or an edge is due
  std::vector<input> inputs_, late_;
  std::vector<output> outputs_;
  const std::vector<island_unit*> units_;
};

/// Pins of `Unit` in front of an island.
template <class Unit>
class rtl_shell : public Unit::pins, public probed, public island_unit {
 public:
  rtl_shell(const sc_core::sc_module_name& name, const std::string& plugin)
      : Unit::pins(name), island_unit(plugin) {}

  const sc_core::sc_module& module() const override { return *this; }
  std::vector<probe> probes() const override { return island().probes(this->basename()); }

  // The back doors of sequencer_pins and navigator_pins.
  void deposit(int frame) { seek_frame(edges(), frame); }
  void deposit(const vec3& position, int room) { place_camera(edges(), position, room); }

 private:
  auto edges() {
    return [this](const input_values& inputs, int count) {
      island().private_edges(this->basename(), inputs, count);
    };
  }
};

/// The islands of the shells among the units of `chip`, which is under construction.
std::vector<std::unique_ptr<rtl_island>> islands_of(const sc_core::sc_module& chip);

}  // namespace racebeam
