# How every Offing target is compiled and installed: one place for the language level, warnings, sanitizers
# and the list of what a find_package(Offing) offers.

# With OFFING_UNITY_BUILD up to eight sources of a target are compiled as one, sixteen of OFFING_HEAVY_TARGETS. These
# are not: a name that they keep to themselves is another's too ("redefinition of ..."), or they include headers whose
# macros would change others.
set(OFFING_COMPILED_ALONE
  cloud_edits_test cloud_handles_test curvature_invariance_test determinism_test direction_test embedded_scenes
  exr_image_test floating_bodies_test foam_test gerstner_surface_test gerstner_test hands handle_geometry_test
  highlight_schema keyframes_test measured_sea_test mesh_schema moving_view_test ocean_reference_test png_image_test
  post_grid query_test read_height_map_test reference_tracer_test reference_walk_test scene_images scene_meshes_test
  scene_terrain_test sky_flight_test slope_covariance_test spectrum_models_test spreading_test stream_height_map_test
  terrain_sampling_test tiled_field_test velocity_test)

# Their headers take longest to compile.
set(OFFING_HEAVY_TARGETS offing_cli offing_scene offing_mesh_tools cli_tests scene_tests)

# Compile options and includes shared by libraries, programs and tests. Includes are written from the
# repository root, so that each #include line shows which folder depends on which.
function(offing_configure target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/offing>)
  if(OFFING_UNITY_BUILD)
    set(batch_size 8)
    if(target IN_LIST OFFING_HEAVY_TARGETS)
      set(batch_size 16)
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch_size})
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
      cmake_path(GET source STEM stem)
      if(stem IN_LIST OFFING_COMPILED_ALONE)
        set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      endif()
    endforeach()
  endif()
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor -Wold-style-cast
    $<$<BOOL:${OFFING_WARNINGS_AS_ERRORS}>:-Werror>)
  if(OFFING_UNITY_BUILD)
    # What g++ takes for a header here is a source, and what its locals shadow may be another source's.
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage -Wno-shadow -Wshadow=local>)
  endif()
  # g++ 12 gives false warnings of the flow of values in <string> and <optional>, which depend on what it inlines
  # (https://gcc.gnu.org/PR105651, https://gcc.gnu.org/PR80635): they stay warnings.
  if(OFFING_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE
      $<$<CXX_COMPILER_ID:GNU>:-Wno-error=restrict -Wno-error=array-bounds -Wno-error=stringop-overflow
      -Wno-error=stringop-overread -Wno-error=maybe-uninitialized -Wno-error=uninitialized -Wno-error=nonnull
      -Wno-error=dangling-pointer -Wno-error=use-after-free -Wno-error=free-nonheap-object>)
  endif()
  if(OFFING_SANITIZE)
    target_compile_options(${target} PRIVATE
      -fsanitize=${OFFING_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=${OFFING_SANITIZE})
    # With the address sanitizer g++ 12 takes parts of <regex> for uninitialised: https://gcc.gnu.org/PR105562
    if(OFFING_SANITIZE MATCHES address)
      target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    endif()
  endif()
endfunction()

# offing_precompile(<target> HEADERS <headers...> | LIKE <target>): where OFFING_PRECOMPILE_HEADERS says so, parses
# headers that many sources include once for a target, or takes those of another one that is compiled the same way.
function(offing_precompile target)
  cmake_parse_arguments(ARG "" "LIKE" "HEADERS" ${ARGN})
  if(NOT OFFING_PRECOMPILE_HEADERS)
    return()
  endif()
  if(ARG_LIKE)
    target_precompile_headers(${target} REUSE_FROM ${ARG_LIKE})
  else()
    target_precompile_headers(${target} PRIVATE ${ARG_HEADERS})
  endif()
endfunction()

# What nearly every source includes.
set(OFFING_COMMON_HEADERS <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <limits> <memory> <optional>
    <string> <variant> <vector> <fmt/format.h> <glm/geometric.hpp>)

# What a program and the modules that it loads must agree in, as the text that module.h asks for.
# The headers are in it, since their types are in the modules' tables.
file(GLOB_RECURSE headers ${PROJECT_SOURCE_DIR}/host/*.h ${PROJECT_SOURCE_DIR}/kernels/shared/*.h)
set(header_hashes "")
foreach(header IN LISTS headers)
  file(SHA1 ${header} hash)
  string(APPEND header_hashes ${hash})
endforeach()
string(SHA1 header_hashes "${header_hashes}")
set(OFFING_BUILD "${PROJECT_VERSION}, ${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}, ${header_hashes}")

# offing_module(<name> ENTRY <file> [SOURCES <files...>] LINKS <libraries...>): makes the module <name>.so of
# host/io/module.h, whose table is in ENTRY, and of sources the static library offing_<name>, for tests of what the table
# does not show.
function(offing_module name)
  cmake_parse_arguments(ARG "" "ENTRY" "SOURCES;LINKS" ${ARGN})
  if(ARG_SOURCES)
    add_library(offing_${name} STATIC ${ARG_SOURCES})
    set_target_properties(offing_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    offing_configure(offing_${name})
    target_link_libraries(offing_${name} PUBLIC ${ARG_LINKS})
    offing_precompile(offing_${name} LIKE offing_base)
    set(ARG_LINKS offing_${name})
  endif()
  add_library(offing_${name}_module MODULE ${ARG_ENTRY})
  set_target_properties(offing_${name}_module PROPERTIES PREFIX "" OUTPUT_NAME ${name} CXX_VISIBILITY_PRESET hidden
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/offing)
  offing_configure(offing_${name}_module)
  target_compile_definitions(offing_${name}_module PRIVATE OFFING_BUILD="${OFFING_BUILD}")
  target_link_libraries(offing_${name}_module PRIVATE ${ARG_LINKS})
  # Its copies of our static libraries are its own.
  target_link_options(offing_${name}_module PRIVATE LINKER:--exclude-libs,ALL)
  set_property(GLOBAL APPEND PROPERTY OFFING_MODULES offing_${name}_module)
endfunction()

# offing_library(<name> SOURCES <files...> LINKS <public libraries...> [PRIVATE_LINKS <libraries...>] [HEADERS <files...>])
# makes offing_<name> with the alias offing::<name>, and installs it with HEADERS, or with all headers of its folder and of
# its sources' folders (for kernels, of shared/), under include/offing/ in the same tree. A library outside Offing that it links needs a row in
# host/install/dependencies.cmake. Declare a library after those it links: offing.pc lists them in that order.
function(offing_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS;HEADERS" ${ARGN})
  add_library(offing_${name} STATIC ${ARG_SOURCES})
  add_library(offing::${name} ALIAS offing_${name})
  set_target_properties(offing_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  offing_configure(offing_${name})
  target_link_libraries(offing_${name} PUBLIC ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  if(name STREQUAL base)
    offing_precompile(offing_base HEADERS ${OFFING_COMMON_HEADERS})
  elseif(TARGET offing_base)
    offing_precompile(offing_${name} LIKE offing_base)
  endif()

  set(header_files *.h shared/*.h)
  foreach(source IN LISTS ARG_SOURCES)
    get_filename_component(folder ${source} DIRECTORY)
    if(folder AND NOT IS_ABSOLUTE ${folder})
      list(APPEND header_files ${folder}/*.h)
    endif()
  endforeach()
  if(ARG_HEADERS)
    set(header_files ${ARG_HEADERS})
  endif()
  list(REMOVE_DUPLICATES header_files)
  list(TRANSFORM header_files PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  file(GLOB headers CONFIGURE_DEPENDS ${header_files})
  target_sources(offing_${name} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
  set_property(GLOBAL APPEND PROPERTY OFFING_LIBRARIES offing_${name})
endfunction()
