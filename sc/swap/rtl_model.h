// What a plug-in of verilated RTL offers to the SystemC chip: a table of ports, and evaluation.
//
// Plain C, so that it does not matter which compiler made the plug-in. tb/verilate makes one.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdarg.h>
#include <stdint.h>

extern "C" {

/// A port of the top module. Its value lies in `bytes` bytes at `data`, upper bits 0, of an object
/// that fills whole words of eight bytes.
struct rtl_port {
  const char* name;
  int bits, bytes, is_input;
  void* data;
  /// Of an input that follows a wire: where that is put; `data` itself, or what copy_quiet() copies
  /// to it. Whoever puts another value there sets these bits of rtl_model::moved. nullptr: none.
  void* place;
  uint32_t moved;
};

/// In rtl_model::moved.
enum { RtlQuiet = 31 };

/// One instance.
struct rtl_model {
  const char* unit;        ///< name of the top module
  const char* parameters;  ///< "Name=value Name=value ": the defaults, then what was set
  const rtl_port* ports;
  int port_count;
  const rtl_port* signals;  ///< inside, by names such as "u_stacks.sp_i"; where they are public
  int signal_count;
  /// Registers inside that can be written to, by names such as "u_stacks.sp_q"; few RTL has any.
  const rtl_port* doors;
  int door_count;
  uint32_t* knock;  ///< bit N: the next eval() gives the register of door N what lies there
  /// Of the source, one a line, "KIND FILE:LINE NAME": `top` module; `file` read; `falling`: a
  /// register on the falling edge of the clock; `loop` that no constant ends; `call` of what
  /// reaches beyond the simulation; `circular` signal; `quiet` input, which reaches no output
  /// before the next edge.
  const char* remarks;
  void* top;
  /// Bit RtlQuiet: a quiet input has moved in its place. Others: inputs that reach an output before
  /// the next edge, by groups; eval() and its relatives clear these.
  uint32_t* moved;
  /// What quiet inputs have in their places, and clears the bit. Whoever calls it gives them other
  /// values by it and by eval() only.
  void (*copy_quiet)(void* top);
  void (*eval)(void* top);        ///< the inputs have changed
  void (*eval_moved)(void* top);  ///< those have whose bits are set
  /// A whole clock, from its rising edge on, of a module with a clock `clk_i` or `clk`; it alone
  /// writes the clock's pin. Inputs have what they had in the last eval(); quiet ones, what they
  /// have now. nullptr: there is none.
  void (*rise)(void* top);
  /// rise() and eval_moved() in one: registers take what inputs had before. nullptr: not known.
  void (*rise_and_eval)(void* top);
  /// Whether all that it holds, and what it has said, is as at the last call, before which a
  /// rise() came: so the next one changes nothing if no input does. nullptr: that is not known.
  int (*rests)(void* top);
  void (*destroy)(rtl_model* model);
};

/// How RTL ends its own simulation.
enum rtl_end { RtlFinish, RtlStop, RtlFatal };

/// What RTL asks of the program that has loaded it; both may throw.
struct rtl_host {
  /// $display and its relatives.
  void (*print)(const char* format, va_list values);
  /// Where, and what Verilator says. Does not return.
  void (*end)(rtl_end how, const char* file, int line, const char* message);
};

/// The one symbol of a plug-in, "rtl_make_7": a new instance. The number is that of this interface.
typedef rtl_model* (*rtl_maker)(const rtl_host* host);
}
