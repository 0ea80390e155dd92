// Short streams that find mutants: made of inputs that a solver names, made small, and so few that
// each finds what the others do not.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tb/twin/legal_inputs.h"
#include "tb/twin/port_stream.h"
#include "tb/twin/port_traffic.h"
#include "tb/twin/shrink.h"

namespace racebeam {

class MutantStreams {
 public:
  /// `plugin`: the netlist of all mutants of a unit with these `ports`, without clocks of traffic.
  MutantStreams(std::string plugin, PortTraffic ports, LegalInputs legal);

  /// A stream without clocks.
  const PortStream& form() const { return form_; }
  /// Of `rows` for the inputs, in order, the first clock in reset: the smallest stream in which the
  /// mutant still differs from the unit at the same port; nothing if it does not differ.
  std::optional<ShrunkStream> smallest(int mutant,
                                       const std::vector<std::vector<std::uint64_t>>& rows) const;
  /// The first output that the mutant has otherwise than the unit's own netlist.
  std::optional<StreamDifference> difference(int mutant, const PortStream& stream) const;

 private:
  PortTraffic answers(const PortStream& stream) const;
  std::optional<StreamDifference> difference(int mutant, const PortTraffic& answers) const;

  const std::string plugin_;
  const PortTraffic ports_;
  const LegalInputs legal_;
  const PortStream form_;
};

/// A mutant that only a stream of its own finds.
struct EscapedMutant {
  int number = 0;
  PortStream stream;
};

/// Of their streams a few, by their places, that find all of them: each next one finds the most of
/// those left, of equals the shortest.
std::vector<std::size_t> covering_streams(const MutantStreams& streams,
                                          const std::vector<EscapedMutant>& escaped);

}  // namespace racebeam
