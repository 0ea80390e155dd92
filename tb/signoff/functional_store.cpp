// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include "tb/signoff/functional_tables.h"

namespace racebeam {

namespace {

FunctionalAxis flag(const std::string& name, const std::string& port) {
  return axis_of_flag(name, port + " == 1");
}

}  // namespace

std::vector<FunctionalCross> store_crosses() {
  return {
      {"write_buffer",
       "handshake",
       "rst_ni == 1",
       {{"fill", {{"empty", "take_valid_o == 0"}, {"full", "full_q == 1"}, {"some", ""}}},
        flag("put", "put_valid_i"),
        flag("take", "take_ready_i")},
       {}},
      {"store_arbiter",
       "grant",
       "",
       {flag("ready", "take_ready_o"), flag("read", "read_i"), flag("sync", "sync_i"),
        flag("blank", "blank_i"), flag("valid", "take_valid_i")},
       {{{"yes", "yes", "*", "*", "*"}, "the beam goes first"},
        {{"yes", "no", "no", "*", "*"}, "it writes in syncs", true, "WritePolicy == 0"},
        {{"no", "no", "yes", "*", "*"}, "it writes in all syncs", true, "WritePolicy == 0"},
        {{"yes", "no", "*", "no", "*"}, "it writes in blanking", true, "WritePolicy == 1"},
        {{"no", "no", "*", "yes", "*"}, "it writes in all of it", true, "WritePolicy == 1"},
        {{"no", "no", "*", "*", "*"}, "it writes whenever", true, "WritePolicy == 2"}}},
      {"frame_scanout",
       "words",
       "rst_ni == 1",
       {axis_of_values("word", "word_q", {"none", "second", "third"}), flag("active", "active_i"),
        flag("first", "first_q"), flag("read", "read_o")},
       {{{"second|third", "*", "*", "*"}, "a pixel is a word", true, "StoreFormat != 2"},
        {{"second|third", "*", "*", "no"}, "the words of a group are read at once"},
        {{"none", "no", "*", "yes"}, "nothing begins"},
        {{"none", "*", "no", "yes"}, "nothing begins"}}},
      {"frame_scanout",
       "columns",
       "rst_ni == 1",
       {{"column", {{"0", "column_q == 0"}, {"some", ""}}},
        flag("consume", "consume_i"),
        flag("line_end", "line_end_i"),
        flag("active", "active_i")},
       {}},
  };
}

}  // namespace racebeam
