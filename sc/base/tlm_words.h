// What TLM-2.0 targets that are words of 32 bits share: bytes of words, and what they refuse.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <tlm>

namespace racebeam {

constexpr int WordBytes = 4;

/// Little endian.
inline void put_word(std::uint8_t* to, std::uint32_t value) {
  for (int i = 0; i < WordBytes; ++i) to[i] = static_cast<std::uint8_t>(value >> (8 * i));
}

inline std::uint32_t get_word(const std::uint8_t* from) {
  std::uint32_t value = 0;
  for (int i = 0; i < WordBytes; ++i) value |= std::uint32_t{from[i]} << (8 * i);
  return value;
}

/// Whether it is of whole aligned words, without byte enables: OK, or the error.
inline tlm::tlm_response_status whole_words(const tlm::tlm_generic_payload& payload) {
  const unsigned bytes = payload.get_data_length();
  if (payload.get_byte_enable_ptr()) return tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE;
  if (bytes == 0 || bytes % WordBytes || payload.get_streaming_width() < bytes)
    return tlm::TLM_BURST_ERROR_RESPONSE;
  if (payload.get_address() % WordBytes) return tlm::TLM_ADDRESS_ERROR_RESPONSE;
  return tlm::TLM_OK_RESPONSE;
}

/// No direct memory, for any address.
inline bool no_direct_memory(tlm::tlm_dmi& memory) {
  memory.init();
  memory.set_start_address(0);
  memory.set_end_address(~std::uint64_t{0});
  memory.allow_none();
  return false;
}

/// A write of these bytes; a target does not write to them.
inline void prepare_write(tlm::tlm_generic_payload& payload, std::uint64_t address,
                          const std::uint8_t* data, std::size_t bytes) {
  payload.set_command(tlm::TLM_WRITE_COMMAND);
  payload.set_address(address);
  payload.set_data_ptr(const_cast<std::uint8_t*>(data));
  payload.set_data_length(static_cast<unsigned>(bytes));
  payload.set_streaming_width(static_cast<unsigned>(bytes));
  payload.set_byte_enable_ptr(nullptr);
  payload.set_dmi_allowed(false);
  payload.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
}

}  // namespace racebeam
