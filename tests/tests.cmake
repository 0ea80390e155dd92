# The tests: one program each, one process per case (SystemC elaborates once).
find_package(GTest REQUIRED)
enable_testing()
include(GoogleTest)

# add_racebeam_test(<stem> <label> [libraries...]) builds tests/<stem>_test.cpp; its cases are
# called <stem>/<Suite>.<Case> in ctest.
add_library(racebeam_test_main OBJECT tests/sc_main.cpp)
target_link_libraries(racebeam_test_main PRIVATE PkgConfig::SYSTEMC)
function(add_racebeam_test stem label)
  add_executable(${stem}_test tests/${stem}_test.cpp)
  target_link_libraries(${stem}_test PRIVATE racebeam_test_main)
  target_link_libraries(${stem}_test PRIVATE racebeam_verilate ${ARGN} GTest::gtest_main)
  target_precompile_headers(${stem}_test REUSE_FROM racebeam_hardware)
  gtest_discover_tests(
    ${stem}_test
    TEST_PREFIX ${stem}/
    PROPERTIES LABELS ${label} TIMEOUT 600 ENVIRONMENT SYSTEMC_DISABLE_COPYRIGHT_MESSAGE=1
    DISCOVERY_TIMEOUT 60)
endfunction()

# add_unit(<name> [TESTS <subject>...]): tests/<name>_test.cpp and the tests/<name>_<subject>_test.cpp,
# one program, hold the model sc/<name>.cpp and its twin rtl/<name>.sv to the header.
function(add_unit name)
  cmake_parse_arguments(PARSE_ARGV 1 unit "" "" "TESTS")
  add_racebeam_test(${name} unit)
  foreach(subject IN LISTS unit_TESTS)
    target_sources(${name}_test PRIVATE tests/${name}_${subject}_test.cpp)
  endforeach()
endfunction()

add_unit(vga_timing)
add_unit(sequencer)
add_unit(timeline TESTS turns)
target_link_libraries(timeline_test PRIVATE racebeam_scene)
target_compile_definitions(timeline_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
add_unit(camera_unit TESTS trace)
target_link_libraries(camera_unit_test PRIVATE racebeam_golden)
add_unit(ray_stepper TESTS knob)
add_unit(subdivider TESTS offer portals trace walk)
add_unit(stacks)
add_unit(decision_datapath TESTS beside decision nav_line portals shared_edges walk)
add_unit(scene)
add_unit(scene_rom)
target_compile_definitions(scene_rom_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
target_link_libraries(scene_rom_test PRIVATE racebeam_scene)
add_unit(navigator TESTS flight free_flight portals)
add_unit(interval_fifo TESTS lines trace)
add_unit(pixel_output TESTS colours)
add_unit(pwm_sound TESTS pins voices)
add_racebeam_test(tune unit)
add_test(NAME tune/RtlTables COMMAND ${CMAKE_SOURCE_DIR}/scripts/tune_tables --check)
set_tests_properties(tune/RtlTables PROPERTIES LABELS unit TIMEOUT 60)

# The test bench
add_racebeam_test(vga_monitor unit)
add_racebeam_test(frame_finder unit GTest::gmock)
add_racebeam_test(sky130_cells unit fmt::fmt)
target_sources(sky130_cells_test PRIVATE tb/sky130_cells.cpp)
add_racebeam_test(pin_stats unit)
add_racebeam_test(sound_monitor unit PkgConfig::SNDFILE)
add_racebeam_test(output_file unit)
add_racebeam_test(view_control unit racebeam_view_parts)
target_sources(view_control_test PRIVATE tests/tile_keys_test.cpp)
target_compile_definitions(view_control_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
add_racebeam_test(view_layout unit racebeam_view_parts)
add_racebeam_test(viewer frame racebeam_view)
add_racebeam_test(free_flight frame racebeam_view_parts)
target_compile_definitions(free_flight_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
add_racebeam_test(term_picture unit racebeam_view_parts)
add_racebeam_test(viewer_scene frame racebeam_view)
add_racebeam_test(view_window_missing unit racebeam_view)
target_sources(view_window_missing_test PRIVATE tb/view/view_window_missing.cpp)
add_racebeam_test(frame_maps frame)
add_racebeam_test(frame_source frame)
add_racebeam_test(tt_source frame)
target_compile_definitions(tt_source_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
add_racebeam_test(pin_probe unit)
add_racebeam_test(vcd_writer unit)
add_racebeam_test(vcd_diff unit racebeam_trace GTest::gmock)
add_racebeam_test(flight_recorder unit racebeam_trace)
add_racebeam_test(condition unit racebeam_trace)
add_racebeam_test(wave_picture unit racebeam_trace LibXml2::LibXml2 GTest::gmock)
add_racebeam_test(rtl_syntax unit racebeam_scene GTest::gmock)
target_compile_definitions(rtl_syntax_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
add_racebeam_test(lockstep unit racebeam_trace fmt::fmt GTest::gmock)
target_compile_definitions(lockstep_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
add_racebeam_test(lockstep_text unit racebeam_trace GTest::gmock)
add_racebeam_test(image_files unit racebeam_images PkgConfig::OIIO)

add_racebeam_test(stats_json unit racebeam_report)
add_racebeam_test(demo_parts unit racebeam_report)

add_racebeam_test(readme unit racebeam_scene)
target_compile_definitions(readme_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")

# The whole chip
add_racebeam_test(chip frame)
add_racebeam_test(chip_knobs frame racebeam_settings)
add_racebeam_test(chip_reset frame)
add_racebeam_test(chip_mix frame)
add_racebeam_test(chip_lines frame racebeam_golden)
add_racebeam_test(chip_observer frame)
add_racebeam_test(tlm_chip frame)
add_racebeam_test(tlm_registers frame)
add_racebeam_test(tlm_closed_forms unit)
add_racebeam_test(tlm_equality frame racebeam_golden)
target_compile_definitions(tlm_equality_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")

# The whole chip in RTL
add_racebeam_test(racebeam_top frame)

# Scene files on the chip
add_racebeam_test(demo_equality frame racebeam_golden)
add_racebeam_test(scene_chip frame racebeam_golden)
add_racebeam_test(scene_random frame racebeam_golden)
foreach(stem demo_equality scene_chip)
  target_compile_definitions(${stem}_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
endforeach()

# Scene files: without SystemC
foreach(stem scene_file scene_faults scene_timeline scene_plan scene_check)
  add_executable(${stem}_test tests/${stem}_test.cpp)
  target_link_libraries(${stem}_test PRIVATE racebeam_scene GTest::gmock GTest::gtest_main)
  target_compile_definitions(${stem}_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  gtest_discover_tests(${stem}_test TEST_PREFIX ${stem}/ PROPERTIES LABELS unit TIMEOUT 600)
endforeach()

# Scene files against the chip
add_racebeam_test(demo_scene unit racebeam_scene GTest::gmock)
target_sources(demo_scene_test PRIVATE tests/demo_scene_files_test.cpp)
target_compile_definitions(demo_scene_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")

# The golden tracers
add_racebeam_test(golden_camera unit racebeam_report)
add_racebeam_test(golden frame racebeam_report)
target_sources(golden_test PRIVATE tests/golden_compare_test.cpp)
add_racebeam_test(golden_scene frame racebeam_golden GTest::gmock)
target_sources(golden_scene_test PRIVATE tests/golden_scene_agree_test.cpp
                                         tests/golden_scene_look_test.cpp)
target_compile_definitions(golden_scene_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")

add_racebeam_test(explain frame racebeam_report)
target_sources(explain_test PRIVATE tests/explain_golden_test.cpp)
target_compile_definitions(explain_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
add_racebeam_test(line_estimate frame racebeam_golden GTest::gmock)
target_compile_definitions(line_estimate_test PRIVATE RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")

# The program through its command line; view needs SDL2 for its window
if(SDL2_FOUND)
  set(WINDOW_TEST cli_view)
endif()
foreach(
  stem
  ${WINDOW_TEST}
  cli
  cli_against
  cli_difference
  cli_explain
  cli_folder
  cli_golden
  cli_gtkwave
  cli_interrupt
  cli_jobs
  cli_overlay
  cli_progress
  cli_render
  cli_rtl
  cli_rtl_faults
  cli_scene
  cli_trace
  cli_trace_around
  cli_trace_diff
  cli_trace_event
  cli_trace_files
  cli_trace_picture
  cli_trace_refused
  cli_trace_tlm
  cli_trace_windows
  cli_tt
  cli_tt_inputs
  cli_tt_trace
  cli_tt_traits
  cli_tt_view
  cli_verify
  cli_view_term)
  add_racebeam_test(${stem} cli nlohmann_json::nlohmann_json GTest::gmock)
  target_compile_definitions(${stem}_test PRIVATE RACEBEAM_BINARY="$<TARGET_FILE:racebeam>"
                                                  RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}"
                                                  RACEBEAM_VERSION="${PROJECT_VERSION}")
  add_dependencies(${stem}_test racebeam)
endforeach()
target_link_libraries(cli_gtkwave_test PRIVATE PkgConfig::OIIO)
target_link_libraries(cli_trace_picture_test PRIVATE LibXml2::LibXml2)
target_link_libraries(cli_tt_test PRIVATE PkgConfig::OIIO)
target_link_libraries(cli_tt_inputs_test PRIVATE PkgConfig::OIIO)
target_link_libraries(cli_tt_traits_test PRIVATE PkgConfig::OIIO)
target_link_libraries(cli_tt_view_test PRIVATE PkgConfig::OIIO)
if(SDL2_FOUND)
  target_compile_definitions(cli_tt_view_test PRIVATE RACEBEAM_WINDOW)
endif()
target_link_libraries(cli_overlay_test PRIVATE PkgConfig::OIIO)
target_link_libraries(cli_trace_event_test PRIVATE racebeam_trace)
target_link_libraries(cli_trace_windows_test PRIVATE racebeam_golden)
target_link_libraries(cli_trace_files_test PRIVATE racebeam_trace)
if(SDL2_FOUND)
  target_compile_definitions(cli_rtl_faults_test PRIVATE RACEBEAM_WINDOW)
  target_link_libraries(cli_view_test PRIVATE racebeam_view_parts PkgConfig::OIIO)
endif()

# Netlists by yosys
add_racebeam_test(netlist cli racebeam_scene nlohmann_json::nlohmann_json GTest::gmock)
add_racebeam_test(netlist_gates long racebeam_scene nlohmann_json::nlohmann_json GTest::gmock)
foreach(stem netlist netlist_gates)
  target_compile_definitions(${stem}_test PRIVATE RACEBEAM_BINARY="$<TARGET_FILE:racebeam>"
                                                  RACEBEAM_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  add_dependencies(${stem}_test racebeam)
endforeach()

# All frames of the demo are the taped-out chip's; two minutes
add_test(NAME reference/AllFramesOfTheDemo COMMAND racebeam render demo --frames 12799 --jobs 2
                                                   --against demo)
set_tests_properties(reference/AllFramesOfTheDemo PROPERTIES LABELS long TIMEOUT 3600)

# The museum of bugs: verify finds each as its row in tests/museum/README.md says
file(GLOB MUSEUM CONFIGURE_DEPENDS RELATIVE ${CMAKE_SOURCE_DIR}/tests/museum tests/museum/*.patch)
list(TRANSFORM MUSEUM REPLACE "\\.patch$" "")
foreach(exhibit IN LISTS MUSEUM ITEMS intact rows)
  add_test(NAME museum/${exhibit} COMMAND ${CMAKE_SOURCE_DIR}/scripts/museum --check ${exhibit}
                                          $<TARGET_FILE:racebeam>)
  set_tests_properties(museum/${exhibit} PROPERTIES LABELS cli TIMEOUT 600)
endforeach()

# What synthesis says of the RTL
add_test(NAME area/ReadmeHasTheFigures COMMAND ${CMAKE_SOURCE_DIR}/scripts/area --check)
set_tests_properties(area/ReadmeHasTheFigures PROPERTIES LABELS unit TIMEOUT 600)

# The command lines that scripts/demo and the README tell
add_test(NAME commands/NextAfterTheDemo COMMAND ${CMAKE_SOURCE_DIR}/tests/commands demo
                                                ${CMAKE_BINARY_DIR})
set_tests_properties(commands/NextAfterTheDemo PROPERTIES LABELS cli TIMEOUT 600)
add_test(NAME commands/Readme COMMAND ${CMAKE_SOURCE_DIR}/tests/commands readme ${CMAKE_BINARY_DIR})
set_tests_properties(commands/Readme PROPERTIES LABELS long TIMEOUT 3000)

# Another project's RTL, with what cmake --install gives it
add_test(NAME example/OwnRtl COMMAND ${CMAKE_SOURCE_DIR}/tests/example/run ${CMAKE_BINARY_DIR})
set_tests_properties(example/OwnRtl PROPERTIES LABELS cli TIMEOUT 600)

# --- Fuzzing: the scene reader under clang's libFuzzer, ASan and UBSan ---------------------------
# A test of a minute, where clang is; longer: FUZZ_SECONDS=3600 tests/fuzz/run build/scene_fuzz
find_program(FUZZ_CXX clang++)
if(FUZZ_CXX)
  set(FUZZ_FLAGS -std=c++17 -O1 -g -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=all)
  foreach(source tests/fuzz/scene_fuzz.cpp ${SCENE_SOURCES})
    string(REPLACE "/" "_" object fuzz_${source}.o)
    add_custom_command(
      OUTPUT ${object}
      COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} ${FUZZ_CXX} ${FUZZ_FLAGS} -I${CMAKE_SOURCE_DIR} -MMD
              -MF ${object}.d -c ${CMAKE_SOURCE_DIR}/${source} -o ${object}
      DEPENDS ${CMAKE_SOURCE_DIR}/${source}
      DEPFILE ${object}.d
      VERBATIM)
    list(APPEND FUZZ_OBJECTS ${object})
  endforeach()
  add_custom_command(
    OUTPUT scene_fuzz
    COMMAND ${FUZZ_CXX} ${FUZZ_FLAGS} ${FUZZ_OBJECTS} -o scene_fuzz
    DEPENDS ${FUZZ_OBJECTS}
    VERBATIM)
  add_custom_target(fuzz ALL DEPENDS scene_fuzz)
  add_test(NAME fuzz/SceneReader COMMAND ${CMAKE_SOURCE_DIR}/tests/fuzz/run ./scene_fuzz)
  set_tests_properties(fuzz/SceneReader PROPERTIES LABELS long TIMEOUT 600)
else()
  message(STATUS "no clang++: the scene reader is not fuzzed")
endif()
