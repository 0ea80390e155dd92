// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "sc/store/frame_scanout.h"

namespace racebeam {

namespace {

// `bits` of a word from bit `low` on, at the top of a DAC's lines.
int channel(std::uint64_t word, int low, int bits) {
  return static_cast<int>(raw_bits(word >> low, bits)) << (DacBits - bits);
}

// A byte at the top, its top bits again below it.
int byte(std::uint64_t word, int low) {
  const int top = channel(word, low, 8);
  return top | top >> 8;
}

}  // namespace

frame_scanout_core::colour frame_scanout_core::unpack(std::uint64_t word, const store_knobs& k) {
  if (k.store_format != StoreRgbLight) return {byte(word, 16), byte(word, 8), byte(word, 0)};
  const int bits = k.colour_bits;
  const int low = word >> 3 * bits & 1 ? low_bits(DacBits - bits) : 0;
  return {channel(word, 2 * bits, bits) | low, channel(word, bits, bits) | low,
          channel(word, 0, bits) | low};
}

frame_scanout_core::colour frame_scanout_core::pixel(const std::vector<std::uint64_t>& words,
                                                     int row, int column, const store_knobs& k) {
  const auto word = [&](int plane) {
    return words[static_cast<std::size_t>(address(row, column, plane, k))];
  };
  if (k.store_format != StorePlanar) return unpack(word(0), k);
  const int low = column % 8 * 8;
  return {byte(word(0), low), byte(word(1), low), byte(word(2), low)};
}

int frame_scanout_core::address(int row, int column, int plane, const store_knobs& k) {
  if (k.store_format != StorePlanar)
    return row << k.column_bits() | (column & low_bits(k.column_bits()));
  return ((plane * k.picture_height + row) * (k.picture_width / 8) + column / 8) &
         low_bits(StoreAddressBits);
}

bool frame_scanout_core::group_begins(bool active, const store_knobs& k) const {
  return active && first_q && column_q % k.group_pixels() == 0 && in_picture(k);
}

frame_scanout_core::read frame_scanout_core::reads(bool active, int y, const store_knobs& k) const {
  const bool begins = group_begins(active, k);
  return {begins || word_q != 0,
          address((y - FirstVisibleLine) & low_bits(9), column_q, begins ? 0 : word_q, k)};
}

// A word of the group on show, its pixel lowest.
std::uint64_t frame_scanout_core::on_show(int word, std::uint64_t mem_data,
                                          const store_knobs& k) const {
  if (at_pins(k).group) {
    const int waiting = k.group_words() - 2 - word;  // the last one does not wait
    return raw_bits(waiting < 0 ? mem_data : waiting_q[waiting], k.data_bits());
  }
  return at_pins(k).pixel ? words_q[word] >> 8 : words_q[word];
}

frame_scanout_core::colour frame_scanout_core::shows(std::uint64_t mem_data,
                                                     const store_knobs& k) const {
  if (!at_pins(k).shown) return {0, 0, 0};
  if (k.store_format != StorePlanar) return unpack(on_show(0, mem_data, k), k);
  return {byte(on_show(0, mem_data, k), 0), byte(on_show(1, mem_data, k), 0),
          byte(on_show(2, mem_data, k), 0)};
}

void frame_scanout_core::clock(const inputs& in, const store_knobs& k) {
  const int words = k.group_words();
  std::uint64_t show[MaxWords];
  for (int n = 0; n < words; ++n) show[n] = on_show(n, in.mem_data, k);
  for (int n = 0; n < words; ++n) words_q[n] = show[n];
  waiting_q[1] = waiting_q[0];
  waiting_q[0] = in.mem_data;

  const bool group = group_begins(in.active, k);
  for (int n = words - 1; n > 0; --n) stages_q[n] = stages_q[n - 1];
  stages_q[0] = {group, in.active && first_q, in.active && in_picture(k), in.hsync_n, in.vsync_n};
  if (group) word_q = 1;
  else if (word_q != 0) ++word_q;
  if (word_q == words) word_q = 0;
  first_q = in.consume || !in.active;
  column_q = in.line_end ? 0 : (column_q + in.consume) & low_bits(PixelBits);
  if (in.rst_n) return;
  for (stage& s : stages_q) s.group = s.pixel = s.shown = false;
  word_q = column_q = 0;
  first_q = true;
}

frame_scanout::frame_scanout(const sc_core::sc_module_name& name, const store_knobs& k)
    : frame_scanout_pins(name), knobs_(k) {
  SC_HAS_PROCESS(frame_scanout);
  SC_METHOD(seq);
  sensitive << clk_i.pos();
  dont_initialize();
  SC_METHOD(fetch);
  sensitive << active_i << y_i;
  SC_METHOD(show);
  sensitive << mem_data_i;
}

void frame_scanout::seq() {
  core_.clock(
      {rst_ni.value() != 0, consume_i.value() != 0, active_i.value() != 0, line_end_i.value() != 0,
       y_i.signed_value(), hsync_ni.value() != 0, vsync_ni.value() != 0, mem_data_i.value()},
      knobs_);
  const auto& pins = core_.at_pins(knobs_);
  hsync_no.drive(pins.hsync_n);
  vsync_no.drive(pins.vsync_n);
  fetch();
  show();
}

void frame_scanout::fetch() {
  const auto read = core_.reads(active_i.value() != 0, y_i.signed_value(), knobs_);
  read_o.drive(read.valid);
  read_address_o.drive(read.address);
}

void frame_scanout::show() {
  const auto colour = core_.shows(mem_data_i.value(), knobs_);
  red_o.drive(colour.red);
  green_o.drive(colour.green);
  blue_o.drive(colour.blue);
}

}  // namespace racebeam
