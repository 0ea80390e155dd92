// tune_tables: what plays in each measure, and what a track plays in a bar. In sound_voice.
// Contract: sc/beam/tune.h; made from it by scripts/tune_tables.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
  typedef enum logic [2:0] {
    Dm, Bb, F, C, Gm, A7, Asus, Eb
  } chord_name;
  typedef enum logic [1:0] {
    Bell, Hollow, Bright
  } sound_name;
  typedef enum logic [6:0] {
    No, O1, O2, O3, O4, O5, O6, O7, O8, G1, G2, G3, G4, G5, G6, G7, G8, G9, T1, T2, T3, T4, T5,
    T6, T7, T8, H1, H2, H3, H4, H5, H6, H7, H8, HY, HZ, V1, V2, V3, V4, V5, V6, V7, V8, VY, VZ,
    S1, S2, S3, S4, S5, S6, S7, S8, S9, SA, SB, SC, SD, SE, SF, SG, Q1, Q2, Q3, Q4, Q5, Q6, Q7,
    Q8, E1, E2, E3, Pd, Pp, Ps, Pe, Bl, Bh, Bo, Br, Bg, Be, As, Au, Aw, A3, Ae, K1, K2, K4, KB,
    KF, N2, NB, NR, NU, X4, X8, XG, Cr, Tf, Tg
  } bar_name;

  // {chord_name, bar of the leads, their sound_name, bars of second, pad, bass, arpeggio, kick,
  // snare, hat, crash, tom, brightness of the arpeggio}, as in struct measure. Silence after the
  // last one.
  function automatic logic [78:0] measure_of(input logic [6:0] measure);
    case (measure)
      // Part 0, pillars: the arpeggio comes out of the dark, drums one by one.
      7'd0: measure_of = {Dm, No, Bell, No, Pd, No, As, No, No, No, Cr, No, 4'd0};
      7'd1: measure_of = {Dm, No, Bell, No, Pd, No, As, No, No, No, No, No, 4'd1};
      7'd2: measure_of = {Bb, No, Bell, No, Pd, No, As, No, No, No, No, No, 4'd2};
      7'd3: measure_of = {Bb, No, Bell, No, Pd, No, As, No, No, No, No, No, 4'd3};
      7'd4: measure_of = {F, No, Bell, No, Pd, Bl, Au, No, No, No, No, No, 4'd2};
      7'd5: measure_of = {F, No, Bell, No, Pd, Bl, Au, No, No, No, No, No, 4'd3};
      7'd6: measure_of = {C, No, Bell, No, Pd, Bl, Au, No, No, No, No, No, 4'd4};
      7'd7: measure_of = {C, No, Bell, No, Pd, Bl, Au, No, No, X4, No, No, 4'd5};
      7'd8: measure_of = {Dm, O1, Bell, No, Pd, Bl, Au, K1, No, X4, Cr, No, 4'd5};
      7'd9: measure_of = {Dm, O2, Bell, No, Pd, Bl, Au, K1, No, X4, No, No, 4'd5};
      7'd10: measure_of = {Bb, O3, Bell, No, Pd, Bl, Au, K1, No, X4, No, No, 4'd6};
      7'd11: measure_of = {Bb, O4, Bell, No, Pd, Bl, Au, K2, No, X4, No, No, 4'd6};
      7'd12: measure_of = {Gm, O5, Bell, No, Pd, Bh, Au, K4, No, X4, No, No, 4'd7};
      7'd13: measure_of = {Gm, O6, Bell, No, Pd, Bh, Au, K4, No, X4, No, No, 4'd8};
      7'd14: measure_of = {A7, O7, Bell, No, Pd, Bh, Au, K4, No, X8, No, No, 4'd9};
      7'd15: measure_of = {A7, O8, Bell, No, Pd, Bh, Au, K4, NU, X8, No, Tf, 4'd11};
      // Part 1, lock patterns: the groove.
      7'd16: measure_of = {Dm, G1, Hollow, No, Ps, Bo, Aw, K4, N2, X4, Cr, No, 4'd4};
      7'd17: measure_of = {Bb, G2, Hollow, No, Ps, Bo, Aw, K4, N2, X4, No, No, 4'd4};
      7'd18: measure_of = {F, G3, Hollow, No, Ps, Bo, Aw, K4, N2, X4, No, No, 4'd5};
      7'd19: measure_of = {C, G4, Hollow, No, Ps, Bo, Aw, K4, NR, X8, No, No, 4'd5};
      7'd20: measure_of = {Dm, G5, Hollow, No, Ps, Bo, Aw, K4, N2, X4, No, No, 4'd6};
      7'd21: measure_of = {Bb, G6, Hollow, No, Ps, Bo, Aw, K4, N2, X4, No, No, 4'd6};
      7'd22: measure_of = {Gm, G7, Hollow, No, Ps, Bo, Aw, K4, N2, X8, No, No, 4'd7};
      7'd23: measure_of = {A7, G8, Hollow, No, Ps, Bo, Aw, KF, NR, X8, No, Tg, 4'd8};
      7'd24: measure_of = {Dm, G1, Bright, No, Ps, Bg, A3, K4, N2, X8, Cr, No, 4'd6};
      7'd25: measure_of = {Bb, G2, Bright, No, Ps, Bg, A3, K4, N2, X8, No, No, 4'd6};
      7'd26: measure_of = {F, G3, Bright, No, Ps, Bg, A3, K4, N2, X8, No, No, 4'd7};
      7'd27: measure_of = {C, G4, Bright, No, Ps, Bg, A3, K4, NR, XG, No, No, 4'd7};
      7'd28: measure_of = {Dm, G5, Bright, No, Ps, Bg, A3, K4, N2, X8, No, No, 4'd8};
      7'd29: measure_of = {Bb, G6, Bright, No, Ps, Bg, A3, K4, N2, X8, No, No, 4'd9};
      7'd30: measure_of = {Gm, G7, Bright, No, Ps, Bg, A3, K4, NB, XG, No, No, 4'd10};
      7'd31: measure_of = {A7, G9, Bright, No, Pd, Bg, A3, K1, NU, XG, No, Tf, 4'd12};
      // Part 2, tunnel: rolling bass, short notes and echoes.
      7'd32: measure_of = {Gm, No, Hollow, No, Pd, Br, No, K4, No, X4, Cr, No, 4'd0};
      7'd33: measure_of = {Bb, No, Hollow, No, Pd, Br, No, K4, No, X4, No, No, 4'd0};
      7'd34: measure_of = {Dm, No, Hollow, No, Pd, Br, As, K4, N2, X4, No, No, 4'd2};
      7'd35: measure_of = {Dm, No, Hollow, No, Pd, Br, As, K4, N2, X4, No, Tg, 4'd3};
      7'd36: measure_of = {Gm, T1, Hollow, No, Pd, Br, As, K4, N2, X4, No, No, 4'd4};
      7'd37: measure_of = {Bb, T2, Hollow, No, Pd, Br, As, K4, N2, X4, No, No, 4'd4};
      7'd38: measure_of = {Dm, T3, Hollow, No, Pd, Br, As, K4, N2, X4, No, No, 4'd5};
      7'd39: measure_of = {Dm, T4, Hollow, No, Pd, Br, As, K4, NR, X8, No, No, 4'd5};
      7'd40: measure_of = {Gm, T5, Hollow, No, Pd, Br, As, K4, N2, X8, Cr, No, 4'd6};
      7'd41: measure_of = {Bb, T6, Hollow, No, Pd, Br, As, K4, N2, X8, No, No, 4'd6};
      7'd42: measure_of = {C, T7, Hollow, No, Pd, Br, As, K4, N2, X8, No, No, 4'd7};
      7'd43: measure_of = {A7, T8, Hollow, No, Pd, Br, As, K4, NR, X8, No, Tg, 4'd7};
      7'd44: measure_of = {Gm, T1, Bell, No, Pd, Br, Au, K4, N2, XG, No, No, 4'd8};
      7'd45: measure_of = {Bb, T2, Bell, No, Pd, Br, Au, K4, N2, XG, No, No, 4'd9};
      7'd46: measure_of = {C, T7, Bell, No, Pd, Br, Au, K4, NB, XG, No, No, 4'd10};
      7'd47: measure_of = {A7, T8, Bell, No, Pd, Br, Au, K1, NU, X8, No, Tf, 4'd12};
      // Part 3, open heights: the chorus, twice.
      7'd48: measure_of = {Bb, H1, Bright, V1, Pp, Bo, Au, K4, N2, X4, Cr, No, 4'd6};
      7'd49: measure_of = {C, H2, Bright, V2, Pp, Bo, Au, K4, N2, X4, No, No, 4'd6};
      7'd50: measure_of = {Dm, H3, Bright, V3, Pp, Bo, Au, K4, N2, X4, No, No, 4'd7};
      7'd51: measure_of = {F, H4, Bright, V4, Pp, Bo, Au, K4, NR, X8, No, No, 4'd7};
      7'd52: measure_of = {Gm, H5, Bright, V5, Pp, Bo, Au, K4, N2, X4, No, No, 4'd8};
      7'd53: measure_of = {Bb, H6, Bright, V6, Pp, Bo, Au, K4, N2, X4, No, No, 4'd8};
      7'd54: measure_of = {C, H7, Bright, V7, Pp, Bo, Au, K4, N2, X8, No, No, 4'd9};
      7'd55: measure_of = {A7, H8, Bright, V8, Pp, Bo, Au, KF, NR, X8, No, Tf, 4'd9};
      7'd56: measure_of = {Bb, H1, Bright, V1, Pp, Br, Aw, K4, N2, XG, Cr, No, 4'd8};
      7'd57: measure_of = {C, H2, Bright, V2, Pp, Br, Aw, K4, N2, XG, No, No, 4'd8};
      7'd58: measure_of = {Dm, H3, Bright, V3, Pp, Br, Aw, K4, N2, XG, No, No, 4'd9};
      7'd59: measure_of = {F, H4, Bright, V4, Pp, Br, Aw, K4, NB, XG, No, No, 4'd9};
      7'd60: measure_of = {Gm, H5, Bright, V5, Pp, Br, Aw, K4, N2, XG, No, No, 4'd10};
      7'd61: measure_of = {Bb, H6, Bright, V6, Pp, Br, Aw, K4, N2, XG, No, No, 4'd10};
      7'd62: measure_of = {C, HY, Bright, VY, Pp, Br, Aw, K4, NB, XG, No, No, 4'd11};
      7'd63: measure_of = {Dm, HZ, Bright, VZ, Pp, Bh, Aw, K2, NU, X8, No, Tf, 4'd12};
      // Part 4, a scene every two measures: the chase, with a broken beat.
      7'd64: measure_of = {Dm, S1, Hollow, No, Ps, Bg, Aw, KB, NB, X8, Cr, No, 4'd5};
      7'd65: measure_of = {Dm, S2, Hollow, No, Ps, Bg, Aw, KB, NB, X8, No, No, 4'd6};
      7'd66: measure_of = {C, S3, Hollow, No, Ps, Bg, Aw, KB, NB, X8, Cr, No, 4'd6};
      7'd67: measure_of = {C, S4, Hollow, No, Ps, Bg, Aw, KB, NB, X8, No, Tg, 4'd7};
      7'd68: measure_of = {Bb, S5, Hollow, No, Ps, Bg, Aw, KB, NB, X8, Cr, No, 4'd7};
      7'd69: measure_of = {Bb, S6, Hollow, No, Ps, Bg, Aw, KB, NB, X8, No, No, 4'd8};
      7'd70: measure_of = {A7, S7, Hollow, No, Ps, Bg, Aw, KB, NB, X8, Cr, No, 4'd8};
      7'd71: measure_of = {A7, S8, Hollow, No, Ps, Bg, Aw, KF, NR, XG, No, Tf, 4'd9};
      7'd72: measure_of = {Gm, S9, Bright, No, Ps, Bo, A3, KB, NB, XG, Cr, No, 4'd8};
      7'd73: measure_of = {Gm, SA, Bright, No, Ps, Bo, A3, KB, NB, XG, No, No, 4'd9};
      7'd74: measure_of = {F, SB, Bright, No, Ps, Bo, A3, KB, NB, XG, Cr, No, 4'd9};
      7'd75: measure_of = {F, SC, Bright, No, Ps, Bo, A3, KB, NB, XG, No, Tg, 4'd10};
      7'd76: measure_of = {Eb, SD, Bright, No, Ps, Bo, A3, KB, NB, XG, Cr, No, 4'd10};
      7'd77: measure_of = {Eb, SE, Bright, No, Ps, Bo, A3, KB, NB, XG, No, No, 4'd11};
      7'd78: measure_of = {A7, SF, Bright, No, Pd, Bo, A3, K4, NB, XG, Cr, No, 4'd11};
      7'd79: measure_of = {A7, SG, Bright, No, Pd, Bl, A3, K1, NU, XG, No, Tf, 4'd12};
      // Part 5, portals: breath, then the last chorus.
      7'd80: measure_of = {Bb, Q1, Bell, No, Pd, Bl, As, No, No, No, Cr, No, 4'd2};
      7'd81: measure_of = {C, Q2, Bell, No, Pd, Bl, As, No, No, No, No, No, 4'd2};
      7'd82: measure_of = {Dm, Q3, Bell, No, Pd, Bl, As, No, No, No, No, No, 4'd3};
      7'd83: measure_of = {F, Q4, Bell, No, Pd, Bl, As, No, No, X4, No, No, 4'd3};
      7'd84: measure_of = {Gm, Q5, Bell, V5, Pd, Bl, Au, K1, No, X4, No, No, 4'd4};
      7'd85: measure_of = {Bb, Q6, Bell, V6, Pd, Bl, Au, K1, No, X4, No, No, 4'd6};
      7'd86: measure_of = {C, Q7, Bell, V7, Pd, Bh, Au, K4, No, X8, No, No, 4'd8};
      7'd87: measure_of = {Asus, Q8, Bell, No, Pd, Bh, Au, K4, NU, X8, No, Tf, 4'd10};
      7'd88: measure_of = {Bb, H1, Bright, V1, Ps, Br, Aw, K4, N2, XG, Cr, No, 4'd9};
      7'd89: measure_of = {C, H2, Bright, V2, Ps, Br, Aw, K4, N2, XG, No, No, 4'd9};
      7'd90: measure_of = {Dm, H3, Bright, V3, Ps, Br, Aw, K4, N2, XG, No, No, 4'd10};
      7'd91: measure_of = {F, H4, Bright, V4, Ps, Br, Aw, K4, NB, XG, No, Tg, 4'd10};
      7'd92: measure_of = {Gm, H5, Bright, V5, Ps, Br, Aw, K4, N2, XG, Cr, No, 4'd11};
      7'd93: measure_of = {Bb, H6, Bright, V6, Ps, Br, Aw, K4, N2, XG, No, No, 4'd11};
      7'd94: measure_of = {C, HY, Bright, VY, Ps, Br, Aw, K4, NB, XG, No, No, 4'd12};
      7'd95: measure_of = {A7, H8, Bright, V8, Ps, Bo, Aw, KF, NR, XG, No, Tf, 4'd12};
      // Part 6, last tunnel: four measures home.
      7'd96: measure_of = {Bb, E1, Bright, V1, Pp, Bo, Au, K4, N2, X8, Cr, No, 4'd9};
      7'd97: measure_of = {C, E2, Bright, VY, Pp, Bo, Au, K4, NR, X8, No, Tf, 4'd7};
      7'd98: measure_of = {Dm, E3, Bell, VZ, Pd, Bl, As, K1, No, X4, Cr, No, 4'd4};
      7'd99: measure_of = {Dm, No, Bell, No, Pe, Be, Ae, K1, No, No, No, No, 4'd1};
      default: measure_of = '0;
    endcase
  endfunction

  // The bass note on top, then four chord notes
  function automatic logic [39:0] chord_of(input logic [2:0] chord);
    case (chord)
      Dm: chord_of = 40'h22_39_42_45_49;
      Bb: chord_of = 40'h1a_3a_42_45_49;
      F: chord_of = 40'h25_39_40_45_49;
      C: chord_of = 40'h20_37_40_44_47;
      Gm: chord_of = 40'h27_37_3a_42_47;
      A7: chord_of = 40'h19_39_41_44_47;
      Asus: chord_of = 40'h19_39_42_44_49;
      default: chord_of = 40'h23_37_3a_43_47;
    endcase
  endfunction

  // 16 steps of a byte, the first on top: a note (A4 is 49), 00 silence, ff goes on
  function automatic logic [127:0] steps_of(input logic [6:0] bar);
    case (bar)
      No: steps_of = 128'h00_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff;  // -...............
      O1: steps_of = 128'h00_ff_ff_ff_ff_ff_ff_ff_49_ff_ff_ff_52_ff_ff_ff;
      O2: steps_of = 128'h55_ff_ff_ff_ff_ff_54_ff_52_ff_ff_ff_ff_ff_ff_ff;
      O3: steps_of = 128'h00_ff_ff_ff_ff_ff_ff_ff_4a_ff_ff_ff_52_ff_ff_ff;
      O4: steps_of = 128'h55_ff_ff_ff_ff_ff_57_ff_55_ff_ff_ff_52_ff_ff_ff;
      O5: steps_of = 128'h00_ff_ff_ff_ff_ff_ff_ff_52_ff_ff_ff_57_ff_ff_ff;
      O6: steps_of = 128'h5a_ff_ff_ff_ff_ff_59_ff_57_ff_ff_ff_ff_ff_ff_ff;
      O7: steps_of = 128'h59_ff_ff_ff_ff_ff_57_ff_54_ff_ff_ff_51_ff_ff_ff;
      O8: steps_of = 128'h54_ff_ff_ff_ff_ff_ff_ff_59_ff_ff_ff_00_ff_ff_ff;
      G1: steps_of = 128'h49_ff_ff_52_ff_ff_54_ff_55_ff_ff_54_ff_ff_52_ff;
      G2: steps_of = 128'h52_ff_ff_ff_ff_ff_55_ff_52_ff_ff_50_ff_ff_4a_ff;
      G3: steps_of = 128'h50_ff_ff_55_ff_ff_57_ff_59_ff_ff_57_ff_ff_55_ff;
      G4: steps_of = 128'h57_ff_ff_ff_ff_ff_54_ff_50_ff_ff_52_ff_ff_54_ff;
      G5: steps_of = 128'h49_ff_ff_52_ff_ff_55_ff_59_ff_ff_57_ff_ff_55_ff;
      G6: steps_of = 128'h55_ff_ff_ff_52_ff_ff_ff_5a_ff_ff_59_ff_ff_57_ff;
      G7: steps_of = 128'h5a_ff_ff_59_ff_ff_57_ff_52_ff_ff_ff_57_ff_ff_ff;
      G8: steps_of = 128'h59_ff_ff_ff_57_ff_ff_ff_54_ff_ff_ff_51_ff_ff_ff;
      G9: steps_of = 128'h54_ff_ff_55_ff_ff_54_ff_51_ff_ff_54_ff_ff_59_ff;
      T1: steps_of = 128'h52_00_ff_57_00_ff_59_ff_5a_00_ff_57_ff_ff_00_ff;
      T2: steps_of = 128'h55_ff_ff_ff_ff_ff_00_ff_00_ff_52_ff_55_ff_57_ff;
      T3: steps_of = 128'h59_00_ff_55_00_ff_52_ff_55_00_ff_59_ff_ff_00_ff;
      T4: steps_of = 128'h52_ff_ff_ff_ff_ff_00_ff_00_ff_52_ff_54_ff_55_ff;
      T5: steps_of = 128'h57_00_ff_5a_00_ff_60_ff_62_00_ff_5a_ff_ff_00_ff;
      T6: steps_of = 128'h5a_ff_ff_ff_ff_ff_00_ff_00_ff_59_ff_57_ff_55_ff;
      T7: steps_of = 128'h54_00_ff_57_00_ff_60_ff_5a_00_ff_57_ff_ff_00_ff;
      T8: steps_of = 128'h59_ff_ff_ff_ff_ff_00_ff_51_ff_54_ff_57_ff_59_ff;
      H1: steps_of = 128'h52_ff_ff_ff_55_ff_ff_ff_5a_ff_ff_ff_ff_ff_59_ff;
      H2: steps_of = 128'h57_ff_ff_ff_ff_ff_54_ff_57_ff_ff_ff_60_ff_ff_ff;
      H3: steps_of = 128'h59_ff_ff_ff_ff_ff_ff_ff_55_ff_ff_ff_57_ff_59_ff;
      H4: steps_of = 128'h60_ff_ff_ff_ff_ff_59_ff_55_ff_ff_ff_ff_ff_00_ff;
      H5: steps_of = 128'h5a_ff_ff_ff_ff_ff_59_ff_57_ff_ff_ff_52_ff_ff_ff;
      H6: steps_of = 128'h55_ff_ff_ff_ff_ff_57_ff_5a_ff_ff_ff_62_ff_ff_ff;
      H7: steps_of = 128'h60_ff_ff_ff_ff_ff_5a_ff_57_ff_ff_ff_54_ff_ff_ff;
      H8: steps_of = 128'h54_ff_ff_ff_ff_ff_ff_ff_59_ff_ff_ff_61_ff_ff_ff;
      HY: steps_of = 128'h60_ff_ff_ff_ff_ff_62_ff_64_ff_ff_ff_60_ff_ff_ff;
      HZ: steps_of = 128'h62_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_00_ff_ff_ff;
      V1: steps_of = 128'h4a_ff_ff_ff_52_ff_ff_ff_55_ff_ff_ff_ff_ff_ff_ff;
      V2: steps_of = 128'h54_ff_ff_ff_ff_ff_50_ff_54_ff_ff_ff_57_ff_ff_ff;
      V3: steps_of = 128'h55_ff_ff_ff_ff_ff_ff_ff_52_ff_ff_ff_54_ff_55_ff;
      V4: steps_of = 128'h59_ff_ff_ff_ff_ff_55_ff_50_ff_ff_ff_ff_ff_00_ff;
      V5: steps_of = 128'h57_ff_ff_ff_ff_ff_55_ff_52_ff_ff_ff_4a_ff_ff_ff;
      V6: steps_of = 128'h52_ff_ff_ff_ff_ff_ff_ff_55_ff_ff_ff_5a_ff_ff_ff;
      V7: steps_of = 128'h57_ff_ff_ff_ff_ff_ff_ff_54_ff_ff_ff_50_ff_ff_ff;
      V8: steps_of = 128'h51_ff_ff_ff_ff_ff_ff_ff_54_ff_ff_ff_59_ff_ff_ff;
      VY: steps_of = 128'h57_ff_ff_ff_ff_ff_ff_ff_60_ff_ff_ff_57_ff_ff_ff;
      VZ: steps_of = 128'h55_ff_ff_ff_ff_ff_ff_ff_59_ff_ff_ff_00_ff_ff_ff;
      S1: steps_of = 128'h52_54_55_59_ff_55_ff_54_52_ff_49_ff_52_ff_54_ff;
      S2: steps_of = 128'h55_ff_54_55_ff_59_ff_57_55_ff_54_ff_52_ff_00_ff;
      S3: steps_of = 128'h50_52_54_57_ff_54_ff_52_50_ff_47_ff_50_ff_52_ff;
      S4: steps_of = 128'h54_ff_52_54_ff_57_ff_55_54_ff_52_ff_50_ff_00_ff;
      S5: steps_of = 128'h4a_50_52_55_ff_52_ff_50_4a_ff_45_ff_4a_ff_50_ff;
      S6: steps_of = 128'h52_ff_50_52_ff_55_ff_57_55_ff_52_ff_55_ff_00_ff;
      S7: steps_of = 128'h54_ff_51_54_ff_59_ff_57_54_ff_51_ff_54_ff_57_ff;
      S8: steps_of = 128'h59_ff_ff_ff_57_ff_ff_ff_54_ff_ff_ff_51_ff_ff_ff;
      S9: steps_of = 128'h5a_ff_59_57_ff_52_ff_57_5a_ff_59_ff_57_ff_52_ff;
      SA: steps_of = 128'h57_ff_59_5a_ff_62_ff_60_5a_ff_59_ff_57_ff_00_ff;
      SB: steps_of = 128'h59_ff_57_55_ff_50_ff_55_59_ff_57_ff_55_ff_50_ff;
      SC: steps_of = 128'h55_ff_57_59_ff_60_ff_5a_59_ff_57_ff_55_ff_00_ff;
      SD: steps_of = 128'h57_ff_55_53_ff_4a_ff_53_57_ff_55_ff_53_ff_4a_ff;
      SE: steps_of = 128'h53_ff_55_57_ff_5a_ff_58_57_ff_55_ff_53_ff_00_ff;
      SF: steps_of = 128'h54_55_54_51_ff_54_ff_59_57_ff_54_ff_51_ff_54_ff;
      SG: steps_of = 128'h59_ff_ff_ff_ff_ff_ff_ff_61_ff_ff_ff_64_ff_ff_ff;
      Q1: steps_of = 128'h55_ff_ff_ff_ff_ff_ff_ff_52_ff_ff_ff_ff_ff_ff_ff;
      Q2: steps_of = 128'h54_ff_ff_ff_ff_ff_ff_ff_57_ff_ff_ff_ff_ff_ff_ff;
      Q3: steps_of = 128'h59_ff_ff_ff_ff_ff_ff_ff_55_ff_ff_ff_52_ff_ff_ff;
      Q4: steps_of = 128'h50_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_49_ff_50_ff;
      Q5: steps_of = 128'h52_ff_ff_ff_ff_ff_ff_ff_57_ff_ff_ff_5a_ff_ff_ff;
      Q6: steps_of = 128'h5a_ff_ff_ff_ff_ff_ff_ff_55_ff_ff_ff_ff_ff_ff_ff;
      Q7: steps_of = 128'h57_ff_ff_ff_54_ff_ff_ff_50_ff_ff_ff_54_ff_ff_ff;
      Q8: steps_of = 128'h59_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_62_ff_ff_ff;
      E1: steps_of = 128'h62_ff_ff_ff_ff_ff_60_ff_5a_ff_ff_ff_55_ff_ff_ff;
      E2: steps_of = 128'h54_ff_ff_ff_57_ff_ff_ff_60_ff_ff_ff_64_ff_ff_ff;
      E3: steps_of = 128'h62_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff;
      Pd: steps_of = 128'h11_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff;  // 1...............
      Pp: steps_of = 128'h11_ff_ff_ff_ff_ff_ff_ff_11_ff_ff_ff_ff_ff_ff_ff;  // 1.......1.......
      Ps: steps_of = 128'h11_ff_ff_11_ff_ff_11_ff_ff_ff_11_ff_11_ff_ff_ff;  // 1..1..1...1.1...
      Pe: steps_of = 128'h11_ff_ff_ff_ff_ff_ff_ff_ff_ff_00_ff_ff_ff_ff_ff;  // 1.........-.....
      Bl: steps_of = 128'h10_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff;  // 0...............
      Bh: steps_of = 128'h10_ff_ff_ff_ff_ff_ff_ff_10_ff_ff_ff_20_ff_ff_ff;  // 0.......0...a...
      Bo: steps_of = 128'h10_ff_20_ff_10_ff_20_ff_10_ff_20_ff_10_ff_20_ff;  // 0.a.0.a.0.a.0.a.
      Br: steps_of = 128'h00_10_10_10_00_10_10_20_00_10_10_10_00_10_20_10;  // -000-00a-000-0a0
      Bg: steps_of = 128'h10_ff_ff_10_ff_ff_20_ff_00_ff_10_ff_20_ff_10_ff;  // 0..0..a.-.0.a.0.
      Be: steps_of = 128'h10_ff_ff_ff_ff_ff_ff_ff_00_ff_ff_ff_ff_ff_ff_ff;  // 0.......-.......
      As: steps_of = 128'h21_ff_ff_23_ff_ff_22_ff_24_ff_ff_23_ff_ff_22_ff;  // b..d..c.e..d..c.
      Au: steps_of = 128'h21_22_23_24_21_22_23_24_21_22_23_24_21_22_23_24;  // bcdebcdebcdebcde
      Aw: steps_of = 128'h21_23_24_22_24_23_22_23_21_23_24_22_31_24_23_22;  // bdecedcdbdecBedc
      A3: steps_of = 128'h21_22_24_21_22_24_21_22_21_22_24_21_22_24_22_24;  // bcebcebcbcebcece
      Ae: steps_of = 128'h21_ff_ff_22_ff_ff_23_ff_24_ff_00_ff_ff_ff_ff_ff;  // b..c..d.e.-.....
      K1: steps_of = 128'h13_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff;  // 3...............
      K2: steps_of = 128'h13_ff_ff_ff_ff_ff_ff_ff_ff_ff_13_ff_ff_ff_ff_ff;  // 3.........3.....
      K4: steps_of = 128'h13_ff_ff_ff_13_ff_ff_ff_13_ff_ff_ff_13_ff_ff_ff;  // 3...3...3...3...
      KB: steps_of = 128'h13_ff_ff_ff_ff_ff_13_ff_ff_ff_13_ff_ff_ff_ff_ff;  // 3.....3...3.....
      KF: steps_of = 128'h13_ff_ff_ff_13_ff_ff_ff_13_ff_13_ff_13_ff_ff_ff;  // 3...3...3.3.3...
      N2: steps_of = 128'h00_ff_ff_ff_13_ff_ff_ff_ff_ff_ff_ff_13_ff_ff_ff;  // -...3.......3...
      NB: steps_of = 128'h00_ff_ff_ff_13_ff_ff_11_ff_11_ff_ff_13_ff_ff_11;  // -...3..1.1..3..1
      NR: steps_of = 128'h00_ff_ff_ff_13_ff_ff_ff_ff_ff_ff_ff_13_12_12_13;  // -...3.......3223
      NU: steps_of = 128'h11_ff_11_ff_11_ff_12_ff_12_ff_12_12_13_13_13_13;  // 1.1.1.2.2.223333
      X4: steps_of = 128'h00_ff_12_ff_00_ff_12_ff_00_ff_12_ff_00_ff_12_ff;  // -.2.-.2.-.2.-.2.
      X8: steps_of = 128'h11_ff_12_ff_11_ff_12_ff_11_ff_12_ff_11_ff_13_ff;  // 1.2.1.2.1.2.1.3.
      XG: steps_of = 128'h12_11_12_11_12_11_12_13_12_11_12_11_12_11_12_13;  // 2121212321212123
      Cr: steps_of = 128'h13_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff_ff;  // 3...............
      Tf: steps_of = 128'h00_ff_ff_ff_ff_ff_ff_ff_13_ff_13_12_ff_12_ff_11;  // -.......3.32.2.1
      Tg: steps_of = 128'h00_ff_ff_ff_ff_ff_13_ff_ff_ff_ff_ff_12_ff_11_ff;  // -.....3.....2.1.
      default: steps_of = {8'h00, {15{8'hff}}};
    endcase
  endfunction
