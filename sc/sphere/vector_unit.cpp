// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/sphere/vector_unit.h"

#include "sc/sphere/vector_unit_core.h"

namespace racebeam {

vector_unit::vector_unit(const sc_core::sc_module_name& name) : vector_unit_pins(name) {
  SC_HAS_PROCESS(vector_unit);
  SC_METHOD(comb);
  sensitive << op_i << a_i.x << a_i.y << a_i.z << b_i.x << b_i.y << b_i.z << s_i;
}

void vector_unit::comb() {
  const auto o = vector_unit_core::comb(
      {op_i.value(), a_i.signed_value(), b_i.signed_value(), s_i.signed_value()});
  product_o.drive(o.product);
  sum_o.drive(static_cast<std::uint64_t>(o.sum));
  square_o.drive(static_cast<std::uint64_t>(o.square));
}

}  // namespace racebeam
