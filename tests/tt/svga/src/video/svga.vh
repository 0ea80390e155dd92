// 800x600 at 60 Hz: pixels, lines. A project may be built for another mode.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`ifndef H_BACK
`define H_BACK 88
`endif
`define H_DISPLAY 800
`define H_SYNC_START (800 + 40)
`define H_SYNC_END (800 + 40 + 128)
`define H_TOTAL (800 + 40 + 128 + `H_BACK)
`define V_DISPLAY 600
`define V_SYNC_START (600 + 1)
`define V_SYNC_END (600 + 1 + 4)
`define V_TOTAL (600 + 1 + 4 + 23)
