// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/tt/tt_options.h"

#include <fmt/format.h>

#include "tb/base/errors.h"

namespace racebeam {

namespace {

std::uint8_t input_pins(const char* option, const std::optional<long long>& value) {
  if (value && (*value < 0 || *value > 255))
    throw UsageError(fmt::format("{} {} is out of range; eight pins: 0..255", option, *value));
  return static_cast<std::uint8_t>(value.value_or(0));
}

}  // namespace

TtInputs tt_inputs(const TtOptions& options) {
  const TilePins start{input_pins("--ui", options.ui), input_pins("--uio", options.uio)};
  return options.inputs.empty() ? TtInputs(start) : TtInputs::read(options.inputs, start);
}

void refuse_tt_options(const TtOptions& options) {
  if (options.project.empty() && (options.ui || options.uio || !options.inputs.empty()))
    throw UsageError(
        "--ui, --uio and --inputs set pins of a chip that --tt names; a scene has --set");
  const TtReading& reading = options.reading;
  if (options.project.empty() && (reading.clock_hz || !reading.defines.empty() ||
                                  !reading.include_folders.empty() || reading.trust))
    throw UsageError("--clock-hz, --define, --include and --trust are about the project of --tt");
}

void refuse_with_tt(bool given, const std::string& what) {
  if (given) throw UsageError("--tt runs a chip of its own; leave out " + what);
}

}  // namespace racebeam
