# Exception of timing of sound_voice: what it is given stands still for more than three clocks before its
# value is taken, so a path through it has four. taken_i, its last gate, has one, as all else has.
# racebeam_top.sv asserts it; tests/beam/sound_voice_path proves it.
set_multicycle_path 4 -setup -through [get_pins {
  *u_sound_voice/voice_i* *u_sound_voice/phase_i* *u_sound_voice/frame_i* *u_sound_voice/sample_i*
}]
