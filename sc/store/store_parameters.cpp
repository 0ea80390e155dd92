// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/store_parameters.h"

namespace racebeam {

std::vector<rtl_parameter> store_parameters(const store_knobs& k) {
  return {{"WriteBufferDepth", k.write_buffer_depth, "the knob write_buffer_depth"},
          {"WritePolicy", k.write_policy, "the knob write_policy"},
          {"WhenFull", k.when_full, "the knob when_full"},
          {"WrapRight", k.wrap_right, "the knob wrap_right"},
          {"StoreFormat", k.store_format, "the format of the frame store"},
          {"ColourBits", k.colour_bits, "the bits of a colour in the frame store"},
          {"PictureWidth", k.picture_width, "the picture's width"},
          {"PictureHeight", k.picture_height, "the picture's height"},
          {"AddressBits", k.address_bits(), "the bits of an address of the frame store"},
          {"DataBits", k.data_bits(), "the bits of a word of the frame store"}};
}

}  // namespace racebeam
