// 640x480 at 60 Hz: pixels, lines.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`define H_DISPLAY 640
`define H_SYNC_START (640 + 16)
`define H_SYNC_END (640 + 16 + 96 - 1)
`define H_MAX 799
`define V_DISPLAY 480
`define V_SYNC_START (480 + 10)
`define V_SYNC_END (480 + 10 + 2 - 1)
`define V_MAX 524
