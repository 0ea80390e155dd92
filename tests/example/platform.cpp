// A virtual platform with racebeam's chip in it: a memory as its display, a host that reads a
// register when a frame is whole.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <sc/beam/tlm/tlm_chip.h>

#include <algorithm>
#include <array>
#include <iostream>

namespace {

struct Display : sc_core::sc_module {
  tlm_utils::simple_target_socket<Display> socket{"socket"};
  std::array<unsigned char, racebeam::DisplayFrame + 4> memory{};

  explicit Display(const sc_core::sc_module_name& name) : sc_module(name) {
    socket.register_b_transport(this, &Display::write);
  }
  void write(tlm::tlm_generic_payload& payload, sc_core::sc_time&) {
    std::copy_n(payload.get_data_ptr(), payload.get_data_length(),
                memory.begin() + static_cast<std::ptrdiff_t>(payload.get_address()));
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }
};

struct Host : sc_core::sc_module {
  tlm_utils::simple_initiator_socket<Host> socket{"socket"};

  explicit Host(const sc_core::sc_module_name& name) : sc_module(name) {}
  unsigned read(std::uint64_t address) {
    unsigned char bytes[4] = {};
    tlm::tlm_generic_payload payload;
    payload.set_read();
    payload.set_address(address);
    payload.set_data_ptr(bytes);
    payload.set_data_length(sizeof bytes);
    payload.set_streaming_width(sizeof bytes);
    sc_core::sc_time delay;
    socket->b_transport(payload, delay);
    return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | bytes[3] << 24;
  }
};

}  // namespace

int sc_main(int, char**) {
  racebeam::tlm_chip chip("chip", {});
  Display display("display");
  Host host("host");
  chip.display_socket.bind(display.socket);
  host.socket.bind(chip.register_socket);
  sc_core::sc_start(17, sc_core::SC_MS);  // a frame is 16.67 ms

  const auto lit = std::count_if(display.memory.begin(), display.memory.end() - 4,
                                 [](unsigned char colour) { return colour != 0; });
  std::cout << host.read(racebeam::RegisterFrames) << " frame, " << lit
            << " pixels are not black\n";
  return host.read(racebeam::RegisterFrames) == 1 && lit > 0 ? 0 : 1;
}
