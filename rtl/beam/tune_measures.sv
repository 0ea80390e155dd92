// tune_measures: what plays in each measure.
// Contract: sc/beam/tune.h; made from it by scripts/tune_tables.
//
// Silence after the last one. The row has the order of struct measure.
//
// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module tune_measures (
    input wire logic [6:0] measure_i,
    output logic [39:0] chord_o,  // bass note on top, then four chord notes
    output logic [1:0] sound_o,  // of the leads
    output logic [3:0] brightness_o,  // of the arpeggio
    // Bars of the tracks
    output logic [6:0] lead_o,
    output logic [6:0] second_o,
    output logic [6:0] pad_o,
    output logic [6:0] bass_o,
    output logic [6:0] arpeggio_o,
    output logic [6:0] kick_o,
    output logic [6:0] snare_o,
    output logic [6:0] hat_o,
    output logic [6:0] crash_o,
    output logic [6:0] tom_o
);
  typedef enum logic [2:0] {
    Dm, Bb, F, C, Gm, A7, Asus, Eb
  } chord_name;
  typedef enum logic [1:0] {
    Bell, Hollow, Bright
  } lead_sound;
  typedef enum logic [6:0] {
    No, O1, O2, O3, O4, O5, O6, O7, O8, G1, G2, G3, G4, G5, G6, G7, G8, G9, T1, T2, T3, T4, T5,
    T6, T7, T8, H1, H2, H3, H4, H5, H6, H7, H8, HY, HZ, V1, V2, V3, V4, V5, V6, V7, V8, VY, VZ,
    S1, S2, S3, S4, S5, S6, S7, S8, S9, SA, SB, SC, SD, SE, SF, SG, Q1, Q2, Q3, Q4, Q5, Q6, Q7,
    Q8, E1, E2, E3, Pd, Pp, Ps, Pe, Bl, Bh, Bo, Br, Bg, Be, As, Au, Aw, A3, Ae, K1, K2, K4, KB,
    KF, N2, NB, NR, NU, X4, X8, XG, Cr, Tf, Tg
  } bar_name;

  logic [78:0] row;
  always_comb begin
    case (measure_i)
      // Part 0, pillars: the arpeggio comes out of the dark, drums one by one.
      7'd0: row = {Dm, No, Bell, No, Pd, No, As, No, No, No, Cr, No, 4'd0};
      7'd1: row = {Dm, No, Bell, No, Pd, No, As, No, No, No, No, No, 4'd1};
      7'd2: row = {Bb, No, Bell, No, Pd, No, As, No, No, No, No, No, 4'd2};
      7'd3: row = {Bb, No, Bell, No, Pd, No, As, No, No, No, No, No, 4'd3};
      7'd4: row = {F, No, Bell, No, Pd, Bl, Au, No, No, No, No, No, 4'd2};
      7'd5: row = {F, No, Bell, No, Pd, Bl, Au, No, No, No, No, No, 4'd3};
      7'd6: row = {C, No, Bell, No, Pd, Bl, Au, No, No, No, No, No, 4'd4};
      7'd7: row = {C, No, Bell, No, Pd, Bl, Au, No, No, X4, No, No, 4'd5};
      7'd8: row = {Dm, O1, Bell, No, Pd, Bl, Au, K1, No, X4, Cr, No, 4'd5};
      7'd9: row = {Dm, O2, Bell, No, Pd, Bl, Au, K1, No, X4, No, No, 4'd5};
      7'd10: row = {Bb, O3, Bell, No, Pd, Bl, Au, K1, No, X4, No, No, 4'd6};
      7'd11: row = {Bb, O4, Bell, No, Pd, Bl, Au, K2, No, X4, No, No, 4'd6};
      7'd12: row = {Gm, O5, Bell, No, Pd, Bh, Au, K4, No, X4, No, No, 4'd7};
      7'd13: row = {Gm, O6, Bell, No, Pd, Bh, Au, K4, No, X4, No, No, 4'd8};
      7'd14: row = {A7, O7, Bell, No, Pd, Bh, Au, K4, No, X8, No, No, 4'd9};
      7'd15: row = {A7, O8, Bell, No, Pd, Bh, Au, K4, NU, X8, No, Tf, 4'd11};
      // Part 1, lock patterns: the groove.
      7'd16: row = {Dm, G1, Hollow, No, Ps, Bo, Aw, K4, N2, X4, Cr, No, 4'd4};
      7'd17: row = {Bb, G2, Hollow, No, Ps, Bo, Aw, K4, N2, X4, No, No, 4'd4};
      7'd18: row = {F, G3, Hollow, No, Ps, Bo, Aw, K4, N2, X4, No, No, 4'd5};
      7'd19: row = {C, G4, Hollow, No, Ps, Bo, Aw, K4, NR, X8, No, No, 4'd5};
      7'd20: row = {Dm, G5, Hollow, No, Ps, Bo, Aw, K4, N2, X4, No, No, 4'd6};
      7'd21: row = {Bb, G6, Hollow, No, Ps, Bo, Aw, K4, N2, X4, No, No, 4'd6};
      7'd22: row = {Gm, G7, Hollow, No, Ps, Bo, Aw, K4, N2, X8, No, No, 4'd7};
      7'd23: row = {A7, G8, Hollow, No, Ps, Bo, Aw, KF, NR, X8, No, Tg, 4'd8};
      7'd24: row = {Dm, G1, Bright, No, Ps, Bg, A3, K4, N2, X8, Cr, No, 4'd6};
      7'd25: row = {Bb, G2, Bright, No, Ps, Bg, A3, K4, N2, X8, No, No, 4'd6};
      7'd26: row = {F, G3, Bright, No, Ps, Bg, A3, K4, N2, X8, No, No, 4'd7};
      7'd27: row = {C, G4, Bright, No, Ps, Bg, A3, K4, NR, XG, No, No, 4'd7};
      7'd28: row = {Dm, G5, Bright, No, Ps, Bg, A3, K4, N2, X8, No, No, 4'd8};
      7'd29: row = {Bb, G6, Bright, No, Ps, Bg, A3, K4, N2, X8, No, No, 4'd9};
      7'd30: row = {Gm, G7, Bright, No, Ps, Bg, A3, K4, NB, XG, No, No, 4'd10};
      7'd31: row = {A7, G9, Bright, No, Pd, Bg, A3, K1, NU, XG, No, Tf, 4'd12};
      // Part 2, tunnel: rolling bass, short notes and echoes.
      7'd32: row = {Gm, No, Hollow, No, Pd, Br, No, K4, No, X4, Cr, No, 4'd0};
      7'd33: row = {Bb, No, Hollow, No, Pd, Br, No, K4, No, X4, No, No, 4'd0};
      7'd34: row = {Dm, No, Hollow, No, Pd, Br, As, K4, N2, X4, No, No, 4'd2};
      7'd35: row = {Dm, No, Hollow, No, Pd, Br, As, K4, N2, X4, No, Tg, 4'd3};
      7'd36: row = {Gm, T1, Hollow, No, Pd, Br, As, K4, N2, X4, No, No, 4'd4};
      7'd37: row = {Bb, T2, Hollow, No, Pd, Br, As, K4, N2, X4, No, No, 4'd4};
      7'd38: row = {Dm, T3, Hollow, No, Pd, Br, As, K4, N2, X4, No, No, 4'd5};
      7'd39: row = {Dm, T4, Hollow, No, Pd, Br, As, K4, NR, X8, No, No, 4'd5};
      7'd40: row = {Gm, T5, Hollow, No, Pd, Br, As, K4, N2, X8, Cr, No, 4'd6};
      7'd41: row = {Bb, T6, Hollow, No, Pd, Br, As, K4, N2, X8, No, No, 4'd6};
      7'd42: row = {C, T7, Hollow, No, Pd, Br, As, K4, N2, X8, No, No, 4'd7};
      7'd43: row = {A7, T8, Hollow, No, Pd, Br, As, K4, NR, X8, No, Tg, 4'd7};
      7'd44: row = {Gm, T1, Bell, No, Pd, Br, Au, K4, N2, XG, No, No, 4'd8};
      7'd45: row = {Bb, T2, Bell, No, Pd, Br, Au, K4, N2, XG, No, No, 4'd9};
      7'd46: row = {C, T7, Bell, No, Pd, Br, Au, K4, NB, XG, No, No, 4'd10};
      7'd47: row = {A7, T8, Bell, No, Pd, Br, Au, K1, NU, X8, No, Tf, 4'd12};
      // Part 3, open heights: the chorus, twice.
      7'd48: row = {Bb, H1, Bright, V1, Pp, Bo, Au, K4, N2, X4, Cr, No, 4'd6};
      7'd49: row = {C, H2, Bright, V2, Pp, Bo, Au, K4, N2, X4, No, No, 4'd6};
      7'd50: row = {Dm, H3, Bright, V3, Pp, Bo, Au, K4, N2, X4, No, No, 4'd7};
      7'd51: row = {F, H4, Bright, V4, Pp, Bo, Au, K4, NR, X8, No, No, 4'd7};
      7'd52: row = {Gm, H5, Bright, V5, Pp, Bo, Au, K4, N2, X4, No, No, 4'd8};
      7'd53: row = {Bb, H6, Bright, V6, Pp, Bo, Au, K4, N2, X4, No, No, 4'd8};
      7'd54: row = {C, H7, Bright, V7, Pp, Bo, Au, K4, N2, X8, No, No, 4'd9};
      7'd55: row = {A7, H8, Bright, V8, Pp, Bo, Au, KF, NR, X8, No, Tf, 4'd9};
      7'd56: row = {Bb, H1, Bright, V1, Pp, Br, Aw, K4, N2, XG, Cr, No, 4'd8};
      7'd57: row = {C, H2, Bright, V2, Pp, Br, Aw, K4, N2, XG, No, No, 4'd8};
      7'd58: row = {Dm, H3, Bright, V3, Pp, Br, Aw, K4, N2, XG, No, No, 4'd9};
      7'd59: row = {F, H4, Bright, V4, Pp, Br, Aw, K4, NB, XG, No, No, 4'd9};
      7'd60: row = {Gm, H5, Bright, V5, Pp, Br, Aw, K4, N2, XG, No, No, 4'd10};
      7'd61: row = {Bb, H6, Bright, V6, Pp, Br, Aw, K4, N2, XG, No, No, 4'd10};
      7'd62: row = {C, HY, Bright, VY, Pp, Br, Aw, K4, NB, XG, No, No, 4'd11};
      7'd63: row = {Dm, HZ, Bright, VZ, Pp, Bh, Aw, K2, NU, X8, No, Tf, 4'd12};
      // Part 4, a scene every two measures: the chase, with a broken beat.
      7'd64: row = {Dm, S1, Hollow, No, Ps, Bg, Aw, KB, NB, X8, Cr, No, 4'd5};
      7'd65: row = {Dm, S2, Hollow, No, Ps, Bg, Aw, KB, NB, X8, No, No, 4'd6};
      7'd66: row = {C, S3, Hollow, No, Ps, Bg, Aw, KB, NB, X8, Cr, No, 4'd6};
      7'd67: row = {C, S4, Hollow, No, Ps, Bg, Aw, KB, NB, X8, No, Tg, 4'd7};
      7'd68: row = {Bb, S5, Hollow, No, Ps, Bg, Aw, KB, NB, X8, Cr, No, 4'd7};
      7'd69: row = {Bb, S6, Hollow, No, Ps, Bg, Aw, KB, NB, X8, No, No, 4'd8};
      7'd70: row = {A7, S7, Hollow, No, Ps, Bg, Aw, KB, NB, X8, Cr, No, 4'd8};
      7'd71: row = {A7, S8, Hollow, No, Ps, Bg, Aw, KF, NR, XG, No, Tf, 4'd9};
      7'd72: row = {Gm, S9, Bright, No, Ps, Bo, A3, KB, NB, XG, Cr, No, 4'd8};
      7'd73: row = {Gm, SA, Bright, No, Ps, Bo, A3, KB, NB, XG, No, No, 4'd9};
      7'd74: row = {F, SB, Bright, No, Ps, Bo, A3, KB, NB, XG, Cr, No, 4'd9};
      7'd75: row = {F, SC, Bright, No, Ps, Bo, A3, KB, NB, XG, No, Tg, 4'd10};
      7'd76: row = {Eb, SD, Bright, No, Ps, Bo, A3, KB, NB, XG, Cr, No, 4'd10};
      7'd77: row = {Eb, SE, Bright, No, Ps, Bo, A3, KB, NB, XG, No, No, 4'd11};
      7'd78: row = {A7, SF, Bright, No, Pd, Bo, A3, K4, NB, XG, Cr, No, 4'd11};
      7'd79: row = {A7, SG, Bright, No, Pd, Bl, A3, K1, NU, XG, No, Tf, 4'd12};
      // Part 5, portals: breath, then the last chorus.
      7'd80: row = {Bb, Q1, Bell, No, Pd, Bl, As, No, No, No, Cr, No, 4'd2};
      7'd81: row = {C, Q2, Bell, No, Pd, Bl, As, No, No, No, No, No, 4'd2};
      7'd82: row = {Dm, Q3, Bell, No, Pd, Bl, As, No, No, No, No, No, 4'd3};
      7'd83: row = {F, Q4, Bell, No, Pd, Bl, As, No, No, X4, No, No, 4'd3};
      7'd84: row = {Gm, Q5, Bell, V5, Pd, Bl, Au, K1, No, X4, No, No, 4'd4};
      7'd85: row = {Bb, Q6, Bell, V6, Pd, Bl, Au, K1, No, X4, No, No, 4'd6};
      7'd86: row = {C, Q7, Bell, V7, Pd, Bh, Au, K4, No, X8, No, No, 4'd8};
      7'd87: row = {Asus, Q8, Bell, No, Pd, Bh, Au, K4, NU, X8, No, Tf, 4'd10};
      7'd88: row = {Bb, H1, Bright, V1, Ps, Br, Aw, K4, N2, XG, Cr, No, 4'd9};
      7'd89: row = {C, H2, Bright, V2, Ps, Br, Aw, K4, N2, XG, No, No, 4'd9};
      7'd90: row = {Dm, H3, Bright, V3, Ps, Br, Aw, K4, N2, XG, No, No, 4'd10};
      7'd91: row = {F, H4, Bright, V4, Ps, Br, Aw, K4, NB, XG, No, Tg, 4'd10};
      7'd92: row = {Gm, H5, Bright, V5, Ps, Br, Aw, K4, N2, XG, Cr, No, 4'd11};
      7'd93: row = {Bb, H6, Bright, V6, Ps, Br, Aw, K4, N2, XG, No, No, 4'd11};
      7'd94: row = {C, HY, Bright, VY, Ps, Br, Aw, K4, NB, XG, No, No, 4'd12};
      7'd95: row = {A7, H8, Bright, V8, Ps, Bo, Aw, KF, NR, XG, No, Tf, 4'd12};
      // Part 6, last tunnel: four measures home.
      7'd96: row = {Bb, E1, Bright, V1, Pp, Bo, Au, K4, N2, X8, Cr, No, 4'd9};
      7'd97: row = {C, E2, Bright, VY, Pp, Bo, Au, K4, NR, X8, No, Tf, 4'd7};
      7'd98: row = {Dm, E3, Bell, VZ, Pd, Bl, As, K1, No, X4, Cr, No, 4'd4};
      7'd99: row = {Dm, No, Bell, No, Pe, Be, Ae, K1, No, No, No, No, 4'd1};
      default: row = '0;
    endcase
  end

  logic [2:0] harmony;
  assign {
    harmony, lead_o, sound_o, second_o, pad_o, bass_o, arpeggio_o,
    kick_o, snare_o, hat_o, crash_o, tom_o, brightness_o
  } = row;

  always_comb begin
    unique case (harmony)
      Dm: chord_o = 40'h22_39_42_45_49;
      Bb: chord_o = 40'h1a_3a_42_45_49;
      F: chord_o = 40'h25_39_40_45_49;
      C: chord_o = 40'h20_37_40_44_47;
      Gm: chord_o = 40'h27_37_3a_42_47;
      A7: chord_o = 40'h19_39_41_44_47;
      Asus: chord_o = 40'h19_39_42_44_49;
      Eb: chord_o = 40'h23_37_3a_43_47;
    endcase
  end
endmodule

`default_nettype wire
