// Tools that map a whole chip and do what a test wants.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/scratch_folder.h"

namespace racebeam {

/// From now on PATH has a program of this name whose work is `work`, commands of a shell.
class FakeTool {
 public:
  FakeTool(const std::string& name, const std::string& work) {
    std::ofstream(folder_ / name) << "#!/bin/sh\n" + work;
    std::filesystem::permissions(folder_ / name, std::filesystem::perms::owner_all);
    setenv("PATH", (folder_.path() + ":" + std::getenv("PATH")).c_str(), 1);
  }

 private:
  ScratchFolder folder_;
};

/// For FakeYosys: a mapped chip of 2 flip-flops, 3 other cells or LUTs, and an area of 96; nothing
/// is in its netlist. A unit is as of FakeYosys::Counts.
inline constexpr const char* MapsAChip =
    "echo 'module racebeam_top (clk_i); input clk_i; endmodule' >out\n"
    "printf '   Number of cells:   5\\n     DFFPOSX1   2\\n     SB_LUT4  3\\n' >count\n"
    "echo \"   Chip area for module 'racebeam_top': 96.000000\" >>count\n"
    "case \"$*\" in *osu018* | *ice40*) ;; *)\n"
    "printf '=== x ===\\n   Number of cells:   5\\n     $_DFF_P_   2\\n' >out ;; esac\n";

/// For sta: a path of 22.5 ns.
inline constexpr const char* FindsAPath =
    "[ \"$1\" = -version ] && echo 9.9 && exit\n"
    "echo 'Startpoint: u_a.one_q[1]\\\\DFFPOSX1'\necho 'Endpoint: u_b.two_q\\\\DFFPOSX1'\n"
    "echo 'WORST -2.659'\n";

/// For nextpnr-ice40: one of 80 ns, from u_a.one_q[1] to u_b.two_q.
inline constexpr const char* Routes =
    "[ \"$1\" = -V ] && echo nextpnr 9.9 && exit\n"
    "while [ $# -gt 0 ]; do case $1 in --report) report=$2 ;; --write) routed=$2 ;; esac; shift; "
    "done\n"
    "echo '{\"critical_paths\": [{\"from\": \"<async>\", \"to\": \"posedge c\", \"path\": []}, "
    "{\"from\": \"posedge c\", \"to\": \"posedge c\", \"path\": ["
    "{\"delay\": 0.5, \"from\": {\"cell\": \"x\"}, \"to\": {\"cell\": \"a\"}}, "
    "{\"delay\": 79.5, \"from\": {\"cell\": \"b\"}, \"to\": {\"cell\": \"b\"}}]}]}' >$report\n"
    "echo '{\"modules\": {\"top\": {\"cells\": {\"a\": {\"connections\": {\"O\": [7]}}, "
    "\"b\": {\"connections\": {\"O\": [8]}}}, \"netnames\": {\"u_a.one_q[1]\": {\"bits\": [7]}, "
    "\"u_b.two_q\": {\"bits\": [8]}}}}}' >$routed\n";

}  // namespace racebeam
