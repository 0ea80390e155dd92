// tune_bars: what a track plays in a bar.
// Contract: sc/beam/tune.h; made from it by scripts/tune_tables.
//
// A bar is 16 steps of a byte, the first on top: a note (A4 is 49), 00 silence, ff goes on.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module tune_bars (
    input wire logic [6:0] bar_i,  // name, as tune_measures gives it
    output logic [127:0] steps_o
);
  typedef enum logic [6:0] {
    No, O1, O2, O3, O4, O5, O6, O7, O8, G1, G2, G3, G4, G5, G6, G7, G8, G9, T1, T2, T3, T4, T5,
    T6, T7, T8, H1, H2, H3, H4, H5, H6, H7, H8, HY, HZ, V1, V2, V3, V4, V5, V6, V7, V8, VY, VZ,
    S1, S2, S3, S4, S5, S6, S7, S8, S9, SA, SB, SC, SD, SE, SF, SG, Q1, Q2, Q3, Q4, Q5, Q6, Q7,
    Q8, E1, E2, E3, Pd, Pp, Ps, Pe, Bl, Bh, Bo, Br, Bg, Be, As, Au, Aw, A3, Ae, K1, K2, K4, KB,
    KF, N2, NB, NR, NU, X4, X8, XG, Cr, Tf, Tg
  } bar_name;

  always_comb begin
    case (bar_i)
      No: steps_o = 128'h00_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff;  // -...............
      O1: steps_o = 128'h00_ff_ff_ff_ff_ff_ff_ff_49_ff_ff_ff_52_ff_ff_ff;
      O2: steps_o = 128'h55_ff_ff_ff_ff_ff_54_ff_52_ff_ff_ff_ff_ff_ff_ff;
      O3: steps_o = 128'h00_ff_ff_ff_ff_ff_ff_ff_4a_ff_ff_ff_52_ff_ff_ff;
      O4: steps_o = 128'h55_ff_ff_ff_ff_ff_57_ff_55_ff_ff_ff_52_ff_ff_ff;
      O5: steps_o = 128'h00_ff_ff_ff_ff_ff_ff_ff_52_ff_ff_ff_57_ff_ff_ff;
      O6: steps_o = 128'h5a_ff_ff_ff_ff_ff_59_ff_57_ff_ff_ff_ff_ff_ff_ff;
      O7: steps_o = 128'h59_ff_ff_ff_ff_ff_57_ff_54_ff_ff_ff_51_ff_ff_ff;
      O8: steps_o = 128'h54_ff_ff_ff_ff_ff_ff_ff_59_ff_ff_ff_00_ff_ff_ff;
      G1: steps_o = 128'h49_ff_ff_52_ff_ff_54_ff_55_ff_ff_54_ff_ff_52_ff;
      G2: steps_o = 128'h52_ff_ff_ff_ff_ff_55_ff_52_ff_ff_50_ff_ff_4a_ff;
      G3: steps_o = 128'h50_ff_ff_55_ff_ff_57_ff_59_ff_ff_57_ff_ff_55_ff;
      G4: steps_o = 128'h57_ff_ff_ff_ff_ff_54_ff_50_ff_ff_52_ff_ff_54_ff;
      G5: steps_o = 128'h49_ff_ff_52_ff_ff_55_ff_59_ff_ff_57_ff_ff_55_ff;
      G6: steps_o = 128'h55_ff_ff_ff_52_ff_ff_ff_5a_ff_ff_59_ff_ff_57_ff;
      G7: steps_o = 128'h5a_ff_ff_59_ff_ff_57_ff_52_ff_ff_ff_57_ff_ff_ff;
      G8: steps_o = 128'h59_ff_ff_ff_57_ff_ff_ff_54_ff_ff_ff_51_ff_ff_ff;
      G9: steps_o = 128'h54_ff_ff_55_ff_ff_54_ff_51_ff_ff_54_ff_ff_59_ff;
      T1: steps_o = 128'h52_00_ff_57_00_ff_59_ff_5a_00_ff_57_ff_ff_00_ff;
      T2: steps_o = 128'h55_ff_ff_ff_ff_ff_00_ff_00_ff_52_ff_55_ff_57_ff;
      T3: steps_o = 128'h59_00_ff_55_00_ff_52_ff_55_00_ff_59_ff_ff_00_ff;
      T4: steps_o = 128'h52_ff_ff_ff_ff_ff_00_ff_00_ff_52_ff_54_ff_55_ff;
      T5: steps_o = 128'h57_00_ff_5a_00_ff_60_ff_62_00_ff_5a_ff_ff_00_ff;
      T6: steps_o = 128'h5a_ff_ff_ff_ff_ff_00_ff_00_ff_59_ff_57_ff_55_ff;
      T7: steps_o = 128'h54_00_ff_57_00_ff_60_ff_5a_00_ff_57_ff_ff_00_ff;
      T8: steps_o = 128'h59_ff_ff_ff_ff_ff_00_ff_51_ff_54_ff_57_ff_59_ff;
      H1: steps_o = 128'h52_ff_ff_ff_55_ff_ff_ff_5a_ff_ff_ff_ff_ff_59_ff;
      H2: steps_o = 128'h57_ff_ff_ff_ff_ff_54_ff_57_ff_ff_ff_60_ff_ff_ff;
      H3: steps_o = 128'h59_ff_ff_ff_ff_ff_ff_ff_55_ff_ff_ff_57_ff_59_ff;
      H4: steps_o = 128'h60_ff_ff_ff_ff_ff_59_ff_55_ff_ff_ff_ff_ff_00_ff;
      H5: steps_o = 128'h5a_ff_ff_ff_ff_ff_59_ff_57_ff_ff_ff_52_ff_ff_ff;
      H6: steps_o = 128'h55_ff_ff_ff_ff_ff_57_ff_5a_ff_ff_ff_62_ff_ff_ff;
      H7: steps_o = 128'h60_ff_ff_ff_ff_ff_5a_ff_57_ff_ff_ff_54_ff_ff_ff;
      H8: steps_o = 128'h54_ff_ff_ff_ff_ff_ff_ff_59_ff_ff_ff_61_ff_ff_ff;
      HY: steps_o = 128'h60_ff_ff_ff_ff_ff_62_ff_64_ff_ff_ff_60_ff_ff_ff;
      HZ: steps_o = 128'h62_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_00_ff_ff_ff;
      V1: steps_o = 128'h4a_ff_ff_ff_52_ff_ff_ff_55_ff_ff_ff_ff_ff_ff_ff;
      V2: steps_o = 128'h54_ff_ff_ff_ff_ff_50_ff_54_ff_ff_ff_57_ff_ff_ff;
      V3: steps_o = 128'h55_ff_ff_ff_ff_ff_ff_ff_52_ff_ff_ff_54_ff_55_ff;
      V4: steps_o = 128'h59_ff_ff_ff_ff_ff_55_ff_50_ff_ff_ff_ff_ff_00_ff;
      V5: steps_o = 128'h57_ff_ff_ff_ff_ff_55_ff_52_ff_ff_ff_4a_ff_ff_ff;
      V6: steps_o = 128'h52_ff_ff_ff_ff_ff_ff_ff_55_ff_ff_ff_5a_ff_ff_ff;
      V7: steps_o = 128'h57_ff_ff_ff_ff_ff_ff_ff_54_ff_ff_ff_50_ff_ff_ff;
      V8: steps_o = 128'h51_ff_ff_ff_ff_ff_ff_ff_54_ff_ff_ff_59_ff_ff_ff;
      VY: steps_o = 128'h57_ff_ff_ff_ff_ff_ff_ff_60_ff_ff_ff_57_ff_ff_ff;
      VZ: steps_o = 128'h55_ff_ff_ff_ff_ff_ff_ff_59_ff_ff_ff_00_ff_ff_ff;
      S1: steps_o = 128'h52_54_55_59_ff_55_ff_54_52_ff_49_ff_52_ff_54_ff;
      S2: steps_o = 128'h55_ff_54_55_ff_59_ff_57_55_ff_54_ff_52_ff_00_ff;
      S3: steps_o = 128'h50_52_54_57_ff_54_ff_52_50_ff_47_ff_50_ff_52_ff;
      S4: steps_o = 128'h54_ff_52_54_ff_57_ff_55_54_ff_52_ff_50_ff_00_ff;
      S5: steps_o = 128'h4a_50_52_55_ff_52_ff_50_4a_ff_45_ff_4a_ff_50_ff;
      S6: steps_o = 128'h52_ff_50_52_ff_55_ff_57_55_ff_52_ff_55_ff_00_ff;
      S7: steps_o = 128'h54_ff_51_54_ff_59_ff_57_54_ff_51_ff_54_ff_57_ff;
      S8: steps_o = 128'h59_ff_ff_ff_57_ff_ff_ff_54_ff_ff_ff_51_ff_ff_ff;
      S9: steps_o = 128'h5a_ff_59_57_ff_52_ff_57_5a_ff_59_ff_57_ff_52_ff;
      SA: steps_o = 128'h57_ff_59_5a_ff_62_ff_60_5a_ff_59_ff_57_ff_00_ff;
      SB: steps_o = 128'h59_ff_57_55_ff_50_ff_55_59_ff_57_ff_55_ff_50_ff;
      SC: steps_o = 128'h55_ff_57_59_ff_60_ff_5a_59_ff_57_ff_55_ff_00_ff;
      SD: steps_o = 128'h57_ff_55_53_ff_4a_ff_53_57_ff_55_ff_53_ff_4a_ff;
      SE: steps_o = 128'h53_ff_55_57_ff_5a_ff_58_57_ff_55_ff_53_ff_00_ff;
      SF: steps_o = 128'h54_55_54_51_ff_54_ff_59_57_ff_54_ff_51_ff_54_ff;
      SG: steps_o = 128'h59_ff_ff_ff_ff_ff_ff_ff_61_ff_ff_ff_64_ff_ff_ff;
      Q1: steps_o = 128'h55_ff_ff_ff_ff_ff_ff_ff_52_ff_ff_ff_ff_ff_ff_ff;
      Q2: steps_o = 128'h54_ff_ff_ff_ff_ff_ff_ff_57_ff_ff_ff_ff_ff_ff_ff;
      Q3: steps_o = 128'h59_ff_ff_ff_ff_ff_ff_ff_55_ff_ff_ff_52_ff_ff_ff;
      Q4: steps_o = 128'h50_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_49_ff_50_ff;
      Q5: steps_o = 128'h52_ff_ff_ff_ff_ff_ff_ff_57_ff_ff_ff_5a_ff_ff_ff;
      Q6: steps_o = 128'h5a_ff_ff_ff_ff_ff_ff_ff_55_ff_ff_ff_ff_ff_ff_ff;
      Q7: steps_o = 128'h57_ff_ff_ff_54_ff_ff_ff_50_ff_ff_ff_54_ff_ff_ff;
      Q8: steps_o = 128'h59_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_62_ff_ff_ff;
      E1: steps_o = 128'h62_ff_ff_ff_ff_ff_60_ff_5a_ff_ff_ff_55_ff_ff_ff;
      E2: steps_o = 128'h54_ff_ff_ff_57_ff_ff_ff_60_ff_ff_ff_64_ff_ff_ff;
      E3: steps_o = 128'h62_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff;
      Pd: steps_o = 128'h11_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff;  // 1...............
      Pp: steps_o = 128'h11_ff_ff_ff_ff_ff_ff_ff_11_ff_ff_ff_ff_ff_ff_ff;  // 1.......1.......
      Ps: steps_o = 128'h11_ff_ff_11_ff_ff_11_ff_ff_ff_11_ff_11_ff_ff_ff;  // 1..1..1...1.1...
      Pe: steps_o = 128'h11_ff_ff_ff_ff_ff_ff_ff_ff_ff_00_ff_ff_ff_ff_ff;  // 1.........-.....
      Bl: steps_o = 128'h10_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff;  // 0...............
      Bh: steps_o = 128'h10_ff_ff_ff_ff_ff_ff_ff_10_ff_ff_ff_20_ff_ff_ff;  // 0.......0...a...
      Bo: steps_o = 128'h10_ff_20_ff_10_ff_20_ff_10_ff_20_ff_10_ff_20_ff;  // 0.a.0.a.0.a.0.a.
      Br: steps_o = 128'h00_10_10_10_00_10_10_20_00_10_10_10_00_10_20_10;  // -000-00a-000-0a0
      Bg: steps_o = 128'h10_ff_ff_10_ff_ff_20_ff_00_ff_10_ff_20_ff_10_ff;  // 0..0..a.-.0.a.0.
      Be: steps_o = 128'h10_ff_ff_ff_ff_ff_ff_ff_00_ff_ff_ff_ff_ff_ff_ff;  // 0.......-.......
      As: steps_o = 128'h21_ff_ff_23_ff_ff_22_ff_24_ff_ff_23_ff_ff_22_ff;  // b..d..c.e..d..c.
      Au: steps_o = 128'h21_22_23_24_21_22_23_24_21_22_23_24_21_22_23_24;  // bcdebcdebcdebcde
      Aw: steps_o = 128'h21_23_24_22_24_23_22_23_21_23_24_22_31_24_23_22;  // bdecedcdbdecBedc
      A3: steps_o = 128'h21_22_24_21_22_24_21_22_21_22_24_21_22_24_22_24;  // bcebcebcbcebcece
      Ae: steps_o = 128'h21_ff_ff_22_ff_ff_23_ff_24_ff_00_ff_ff_ff_ff_ff;  // b..c..d.e.-.....
      K1: steps_o = 128'h13_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff;  // 3...............
      K2: steps_o = 128'h13_ff_ff_ff_ff_ff_ff_ff_ff_ff_13_ff_ff_ff_ff_ff;  // 3.........3.....
      K4: steps_o = 128'h13_ff_ff_ff_13_ff_ff_ff_13_ff_ff_ff_13_ff_ff_ff;  // 3...3...3...3...
      KB: steps_o = 128'h13_ff_ff_ff_ff_ff_13_ff_ff_ff_13_ff_ff_ff_ff_ff;  // 3.....3...3.....
      KF: steps_o = 128'h13_ff_ff_ff_13_ff_ff_ff_13_ff_13_ff_13_ff_ff_ff;  // 3...3...3.3.3...
      N2: steps_o = 128'h00_ff_ff_ff_13_ff_ff_ff_ff_ff_ff_ff_13_ff_ff_ff;  // -...3.......3...
      NB: steps_o = 128'h00_ff_ff_ff_13_ff_ff_11_ff_11_ff_ff_13_ff_ff_11;  // -...3..1.1..3..1
      NR: steps_o = 128'h00_ff_ff_ff_13_ff_ff_ff_ff_ff_ff_ff_13_12_12_13;  // -...3.......3223
      NU: steps_o = 128'h11_ff_11_ff_11_ff_12_ff_12_ff_12_12_13_13_13_13;  // 1.1.1.2.2.223333
      X4: steps_o = 128'h00_ff_12_ff_00_ff_12_ff_00_ff_12_ff_00_ff_12_ff;  // -.2.-.2.-.2.-.2.
      X8: steps_o = 128'h11_ff_12_ff_11_ff_12_ff_11_ff_12_ff_11_ff_13_ff;  // 1.2.1.2.1.2.1.3.
      XG: steps_o = 128'h12_11_12_11_12_11_12_13_12_11_12_11_12_11_12_13;  // 2121212321212123
      Cr: steps_o = 128'h13_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff;  // 3...............
      Tf: steps_o = 128'h00_ff_ff_ff_ff_ff_ff_ff_13_ff_13_12_ff_12_ff_11;  // -.......3.32.2.1
      Tg: steps_o = 128'h00_ff_ff_ff_ff_ff_13_ff_ff_ff_ff_ff_12_ff_11_ff;  // -.....3.....2.1.
      default: steps_o = {8'h00, {15{8'hff}}};
    endcase
  end
endmodule

`default_nettype wire
