# What tells a model from others: model_hash() of tb/sweep, made anew when a source of the table has
# changed. Results of sweeps are kept as long as it is the same.

# The sources that can change what a frame counts, or the picture that is meant, by engine: folders,
# and files by a pattern.
set(MODEL_ENGINES beam sphere block voxel)
set(MODEL_OF_beam
    sc/base
    sc/video
    sc/beam
    sc/beam/tlm
    tb/golden
    tb/judge/error_causes.*
    tb/judge/error_links.*
    tb/judge/picture_chain.*
    tb/judge/reference_picture.*
    tb/judge/tlm_pictures.*
    tb/judge/visible_error.*
    tb/scene/camera_path.*
    tb/scene/plan_reader.*
    tb/scene/plan_rows.*
    tb/scene/plan_style.*
    tb/scene/program_tables.*
    tb/scene/room_reader.*
    tb/scene/scene_compiler.*
    tb/scene/scene_file.*
    tb/scene/scene_reader.*
    tb/scene/shot_reader.*
    tb/scene/table_reader.*
    tb/scene/toml_tree.*
    tb/bench/tlm_bench.*
    tb/monitor/raster.*
    tb/sweep/beam_frame_judge.*
    tb/sweep/columns.*)
set(MODEL_OF_sphere
    sc/base
    sc/video
    sc/store
    sc/sphere
    tb/host/ball_motion.*
    tb/host/sphere_*
    tb/golden/sphere_golden.*
    tb/scene/sphere_scene*
    tb/scene/table_reader.*
    tb/scene/tables_reader.*
    tb/scene/toml_tree.*
    tb/bench/sphere_bench.*
    tb/bench/sphere_tlm_bench.*
    tb/bench/store_pins.*
    tb/judge/sphere_judge.*
    tb/sweep/columns.*
    tb/sweep/picture_frame_judge.*)
set(MODEL_OF_block
    sc/base
    sc/video
    sc/store
    sc/block
    tb/host/ball_motion.*
    tb/host/block_program.*
    tb/host/load_bar.*
    tb/golden/block_golden.*
    tb/scene/block_scene*
    tb/scene/table_reader.*
    tb/scene/tables_reader.*
    tb/scene/toml_tree.*
    tb/bench/block_bench.*
    tb/bench/block_tlm_bench.*
    tb/bench/store_picture.*
    tb/bench/store_pins.*
    tb/judge/block_judge.*
    tb/sweep/columns.*
    tb/sweep/picture_frame_judge.*)
set(MODEL_OF_voxel
    sc/base
    sc/video
    sc/store
    sc/voxel
    tb/host/voxel_*
    tb/golden/voxel_golden.*
    tb/picture/grey_picture.*
    tb/scene/voxel_*
    tb/scene/table_reader.*
    tb/scene/tables_reader.*
    tb/scene/toml_tree.*
    tb/bench/store_picture.*
    tb/bench/store_pins.*
    tb/bench/voxel_bench.*
    tb/bench/voxel_tlm_bench.*
    tb/judge/voxel_judge.*
    tb/sweep/columns.*
    tb/sweep/picture_frame_judge.*)

# model_sources(<engine> <root> <variable>): those files, seen from <root>
function(model_sources engine root variable)
  set(watched CONFIGURE_DEPENDS)
  if(CMAKE_SCRIPT_MODE_FILE)
    set(watched)
  endif()
  set(sources)
  foreach(entry IN LISTS MODEL_OF_${engine})
    set(patterns ${root}/${entry})
    if(NOT entry MATCHES "\\*")
      set(patterns ${root}/${entry}/*.h ${root}/${entry}/*.cpp)
    endif()
    file(GLOB found ${watched} RELATIVE ${root} ${patterns})
    if(NOT found)
      message(FATAL_ERROR "the model of ${engine} has ${entry}, which has no sources")
    endif()
    list(APPEND sources ${found})
  endforeach()
  set(${variable} ${sources} PARENT_SCOPE)
endfunction()

# model_arguments(<root> <variable>): what cmake/model_hash.cpp takes, of all engines
function(model_arguments root variable)
  set(arguments)
  foreach(engine IN LISTS MODEL_ENGINES)
    model_sources(${engine} ${root} sources)
    list(APPEND arguments --engine ${engine} ${sources})
  endforeach()
  set(${variable} ${arguments} PARENT_SCOPE)
endfunction()

# add_model_hash(<target>): the function, among the sources of a target
function(add_model_hash target)
  add_executable(racebeam_model_hash ${CMAKE_SOURCE_DIR}/cmake/model_hash.cpp)
  set_target_properties(racebeam_model_hash PROPERTIES RUNTIME_OUTPUT_DIRECTORY
                                                       ${CMAKE_BINARY_DIR}/cmake)
  target_link_libraries(racebeam_model_hash PRIVATE PkgConfig::XXHASH)
  model_arguments(${CMAKE_SOURCE_DIR} arguments)
  set(sources ${arguments})
  list(FILTER sources INCLUDE REGEX "/")
  list(TRANSFORM sources PREPEND ${CMAKE_SOURCE_DIR}/)
  set(made ${CMAKE_BINARY_DIR}/cmake/model_hash.cpp)
  add_custom_command(
    OUTPUT ${made}
    COMMAND racebeam_model_hash ${made} ${arguments}
    DEPENDS ${sources}
    WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}
    COMMENT "Hashing the model"
    VERBATIM)
  target_sources(${target} PRIVATE ${made})
  set_source_files_properties(${made} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endfunction()
