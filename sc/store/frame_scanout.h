// frame_scanout: the beam's side of the frame store: reads words, shows their pixels.
//
// What    counts columns, reads the words of the pixels and drives the lines of the DAC. Pixels
//         come in groups of N words: one pixel of one word, or, planar, eight pixels of three
//         words: red, green, blue. All that is shown is N clocks behind vga_timing, the syncs too:
//         the memory's clock.
//         A pixel begins in a clock with active_i = 1 after one with consume_i = 1 or active_i = 0.
//         It is shown if its column is below picture_width, or wrap_right is 1; all else is black.
//         A group begins with a pixel that is shown and whose column is a multiple of its pixels.
//         Read: word 0 in the clock in which a group begins, words 1 and 2 in the two after it.
//         read_address_o is the address of column and word in all clocks.
//         Show: N clocks after a group has begun, its last word comes from the memory; all its
//         words go on show. N clocks after another pixel has begun, the words on show are shifted
//         right by a byte.
//         DAC: the bits of a channel on top; low bits are copies of the light's bit (rgb_light), or
//         of the channel's top bits (rgb888, planar).
// Size    column_q 10 bits: 0 after a clock with line_end_i, one more after one with consume_i;
//         first_q, word_q; N stages of {group begins, pixel begins, shown, hsync, vsync}; N words
//         on show; planar, the two words that the memory gave in the last two clocks.
// Cycles  N clocks from vga_timing to the pins: 1, planar 3. Reads a word in the clocks of a pixel,
//         planar three in those of eight.
// Comb    active_i -> read_o, read_address_o; y_i -> read_address_o; mem_data_i -> red_o, green_o,
//         blue_o. hsync_no, vsync_no: registers only.
// Stall   none: the memory must read when read_o is 1, and give the word in the next clock.
// Reset   (rst_ni) column 0, nothing begins, nothing is shown. The syncs and the words go on as
//         without reset; they are 0 at power-up.
// Knobs   store_format, colour_bits, picture_width, picture_height, wrap_right.
// Twin    rtl/store/frame_scanout.sv: StoreFormat, ColourBits, PictureWidth, PictureHeight,
//         WrapRight
// Test    tests/store/frame_scanout_test.cpp
// Source  frame store of the FPGA sphere tracer; the formats of the other engines are ours.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "sc/base/constants.h"
#include "sc/base/fixed_point.h"
#include "sc/base/probe.h"
#include "sc/base/unit.h"
#include "sc/store/store_knobs.h"

namespace racebeam {

/// Behaviour of frame_scanout.
struct frame_scanout_core {
  static constexpr int MaxWords = 3;

  /// What a clock of vga_timing asks for, on its way to the pins.
  struct stage {
    bool group = false, pixel = false;  // it begins
    bool shown = false;                 // not black
    bool hsync_n = false, vsync_n = false;
  };
  int column_q = 0;
  bool first_q = true;                // an active clock is the first of its pixel
  int word_q = 0;                     // the word to be read now; 0: none, unless a group begins
  stage stages_q[MaxWords];           // the youngest first
  std::uint64_t words_q[MaxWords]{};  // of the group on show
  std::uint64_t waiting_q[MaxWords - 1]{};  // from the memory, the youngest first

  struct inputs {
    bool rst_n, consume, active, line_end;
    int y;
    bool hsync_n, vsync_n;
    std::uint64_t mem_data;
  };
  struct read {
    bool valid;
    int address;
  };
  /// DacBits each.
  struct colour {
    int red, green, blue;
  };

  /// What it reads in this clock.
  read reads(bool active, int y, const store_knobs& k) const;
  /// What the pins show.
  colour shows(std::uint64_t mem_data, const store_knobs& k) const;
  const stage& at_pins(const store_knobs& k) const { return stages_q[k.group_words() - 1]; }

  void clock(const inputs& in, const store_knobs& k);

  /// The colour of a word with a pixel of its own.
  static colour unpack(std::uint64_t word, const store_knobs& k);
  /// The colour of a pixel of a picture that the memory `words` holds, by address.
  static colour pixel(const std::vector<std::uint64_t>& words, int row, int column,
                      const store_knobs& k);
  /// The address of a word of a pixel; of its plane, if planar.
  static int address(int row, int column, int plane, const store_knobs& k);

  /// Calls visit(name, bits, read) for each register, as the RTL has them.
  template <class Visit>
  void each_register(Visit&& visit, const store_knobs& k) const {
    visit("column_q", PixelBits, [this] { return column_q; });
    visit("first_q", 1, [this] { return first_q; });
    visit("word_q", 2, [this] { return word_q; });
    for (int n = 0; n < k.group_words(); ++n) {
      visit(element("group_q", n), 1, [this, n] { return stages_q[n].group; });
      visit(element("pixel_q", n), 1, [this, n] { return stages_q[n].pixel; });
      visit(element("shown_q", n), 1, [this, n] { return stages_q[n].shown; });
      visit(element("hsync_q", n), 1, [this, n] { return stages_q[n].hsync_n; });
      visit(element("vsync_q", n), 1, [this, n] { return stages_q[n].vsync_n; });
      visit(element("words_q", n), k.data_bits(), [this, n] { return words_q[n]; });
      if (n + 1 < k.group_words())
        visit(element("waiting_q", n), k.data_bits(), [this, n] { return waiting_q[n]; });
    }
  }

 private:
  bool in_picture(const store_knobs& k) const { return column_q < k.picture_width || k.wrap_right; }
  bool group_begins(bool active, const store_knobs& k) const;
  std::uint64_t on_show(int word, std::uint64_t mem_data, const store_knobs& k) const;
};

/// Pins of frame_scanout.
class frame_scanout_pins : public sc_core::sc_module {
 public:
  // Clock and reset
  in_port<1> clk_i{"clk_i"};
  in_port<1> rst_ni{"rst_ni"};
  // vga_timing
  in_port<1> consume_i{"consume_i"};    // last clock of a visible column
  in_port<1> active_i{"active_i"};      // visible pixel
  in_port<1> line_end_i{"line_end_i"};  // last clock of a line
  in_port<10> y_i{"y_i"};               // signed, scan line, -273..251
  in_port<1> hsync_ni{"hsync_ni"};
  in_port<1> vsync_ni{"vsync_ni"};
  // store_arbiter, frame_memory
  out_port<1> read_o{"read_o"};
  out_port<StoreAddressBits> read_address_o{"read_address_o"};
  in_port<StoreDataBits> mem_data_i{"mem_data_i"};  // of the address in the clock before
  // Pins of the chip
  out_port<DacBits> red_o{"red_o"};
  out_port<DacBits> green_o{"green_o"};
  out_port<DacBits> blue_o{"blue_o"};
  out_port<1> hsync_no{"hsync_no"};
  out_port<1> vsync_no{"vsync_no"};

  explicit frame_scanout_pins(const sc_core::sc_module_name& name) : sc_module(name) {}
};

/// The model of frame_scanout: its core behind the pins.
class frame_scanout : public frame_scanout_pins, public probed {
 public:
  using pins = frame_scanout_pins;
  static constexpr const char* unit_name = "frame_scanout";

  frame_scanout(const sc_core::sc_module_name& name, const store_knobs& k);
  std::vector<probe> probes() const override { return registers_of(core_, knobs_); }

 private:
  void seq();
  void fetch();
  void show();

  const store_knobs knobs_;
  frame_scanout_core core_;
};

}  // namespace racebeam
