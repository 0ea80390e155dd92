// unit_maker: makes the units of a chip, as models or with RTL in their place.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sc/base/unit_choices.h"
#include "sc/swap/rtl_twin.h"

namespace racebeam {

class unit_maker {
 public:
  /// `parameters`: what RTL is built with. `choices` outlive it.
  unit_maker(const unit_choices& choices, std::vector<rtl_parameter> parameters)
      : choices_(choices), parameters_(std::move(parameters)) {}

  /// u_<unit>. `settings`: what the model's constructor takes. Throws RtlError.
  template <class Unit, class... Settings>
  std::unique_ptr<typename Unit::pins> make(const Settings&... settings) const {
    const std::string name = std::string("u_") + Unit::unit_name;
    const unit_choice& choice = choices_.of(Unit::unit_name);
    if (choice.driver == unit_choice::Rtl)
      return std::make_unique<rtl_twin<Unit>>(name.c_str(), parameters_, choice.plugin);
    return std::make_unique<Unit>(name.c_str(), settings...);
  }

 private:
  const unit_choices& choices_;
  const std::vector<rtl_parameter> parameters_;
};

}  // namespace racebeam
