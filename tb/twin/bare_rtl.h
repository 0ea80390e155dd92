// RTL of a unit without SystemC around it: recorded port traffic goes into it as fast as it runs.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sc/swap/rtl_library.h"
#include "tb/twin/port_traffic.h"

namespace racebeam {

/// An output that is not as recorded.
struct TrafficDifference {
  std::uint64_t clock = 0;  ///< of the traffic
  std::size_t port = 0;     ///< number of PortTraffic::ports
  std::uint64_t expected = 0, got = 0;
};

/// One instance of a plug-in, from power-up on.
class BareRtl {
 public:
  /// Joins its ports to those of `traffic` by name; inputs that the traffic does not have stay 0
  /// until hold() says otherwise, and optional ports that the RTL does not have are left out.
  /// Throws RtlError: no plug-in, ports of the traffic that are missing or wrongly sized.
  BareRtl(const std::string& plugin, const PortTraffic& traffic);
  BareRtl(const std::string& plugin, const std::vector<PortTraffic::Port>& ports);

  /// The value of an input that the traffic does not have, such as the number of a mutant. Throws
  /// RtlError if there is no such input.
  void hold(const std::string& input, std::uint64_t value);
  /// Ports, and the signals inside of RTL that was built with them.
  const rtl_model& model() const { return library_.model(); }
  /// Goes on through the clocks `from` (included) to `to` (excluded) of traffic with the same
  /// ports, up to the first output that is not as recorded; the outputs of its first
  /// clock ever are not compared. Throws RtlFault.
  std::optional<TrafficDifference> run(const PortTraffic& traffic, std::uint64_t from,
                                       std::uint64_t to);

  /// The same of rows alone, `clocks` of them: up to a difference, with its row, in the outputs
  /// of all rows but of the first one unless that is `compared` too.
  std::optional<TrafficDifference> run(const std::uint64_t* rows, std::uint64_t clocks,
                                       bool compared);
  /// Clocks whose outputs are not compared.
  void drive(const std::uint64_t* rows, std::uint64_t clocks);

  /// One clock in two halves: the inputs of a row and what follows from them, then the edge.
  void settle(const std::uint64_t* row);
  void edge() {
    library_.rise();
    begun_ = true;
  }
  /// A signal inside was written to: the next clock is evaluated even if no input moves.
  void unsettle() { settled_ = false; }
  /// An output as it has settled, or an input; 0 of a port that the RTL does not have.
  std::uint64_t value(std::size_t port) const;

  /// Whether the RTL has a port; it may do without an optional one.
  bool has(std::size_t port) const;
  /// Those of the traffic.
  std::size_t ports() const { return ports_; }

  /// Writes a register inside of RTL that was built with its signals, or with a door to it, between
  /// clocks. Throws RtlError if there is none of this name.
  void deposit(const std::string& signal, std::uint64_t value);

  /// Gives all signals inside any values, as registers have them at power-up; of RTL that was built
  /// with its signals; those of 0 are all ones. Throws RtlError if it was not.
  void power_up(std::uint32_t seed);
  /// All of `traffic`, with what the outputs of the RTL are instead. `seeks`: by clock, the frame
  /// that a counter of frames goes to first. Throws RtlFault.
  PortTraffic answers(const PortTraffic& traffic, const std::map<std::uint64_t, int>& seeks = {});

 private:
  struct Joint {
    std::size_t port;  // of the traffic
    const rtl_port* rtl;
  };
  /// Ports of one size.
  template <class Raw>
  struct Alike {
    struct Port {
      std::size_t port;
      Raw* data;
    };
    std::vector<Port> inputs, outputs;
  };
  template <class Work>
  void each_size(const Work& work) {
    work(bytes_), work(halves_), work(words_), work(doubles_);
  }
  bool put(const std::uint64_t* row);
  bool says(const std::uint64_t* row);

  rtl_library library_;
  const std::size_t ports_;
  Alike<std::uint8_t> bytes_;
  Alike<std::uint16_t> halves_;
  Alike<std::uint32_t> words_;
  Alike<std::uint64_t> doubles_;
  bool settled_ = false;  // what follows from the inputs is there
  std::vector<Joint> inputs_, outputs_;
  bool begun_ = false;  // it has had a clock
};

}  // namespace racebeam
