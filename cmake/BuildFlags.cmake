# One INTERFACE target carries every compile flag; no global flag is set.
set(ABBE_SANITIZE "" CACHE STRING "Comma-separated sanitizers, e.g. address,undefined or thread")
option(ABBE_TRAPS "Invalid operations, divisions by zero and overflows end the tests" OFF)

add_library(abbe_flags INTERFACE)
include(GNUInstallDirs)
target_include_directories(abbe_flags INTERFACE
  "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>" "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/abbe>")
target_compile_features(abbe_flags INTERFACE cxx_std_20)
# No contraction into fused multiply-adds: a packet and a single ray must round alike. Whoever links an
# installed abbe chooses the warnings alone.
set(warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor)
target_compile_options(abbe_flags INTERFACE "$<BUILD_INTERFACE:${warnings}>"
  -march=${ABBE_ARCH} -ffp-contract=off -fno-math-errno)
if(ABBE_TRAPS)
  target_compile_options(abbe_flags INTERFACE -ftrapping-math)
  target_compile_definitions(abbe_flags INTERFACE ABBE_TRAPS)
else()
  target_compile_options(abbe_flags INTERFACE -fno-trapping-math)
endif()
if(ABBE_SANITIZE)
  # The first finding ends the program, so that a test fails by it. The standard library checks too.
  target_compile_options(abbe_flags INTERFACE
    -fsanitize=${ABBE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -D_GLIBCXX_ASSERTIONS)
  target_link_options(abbe_flags INTERFACE -fsanitize=${ABBE_SANITIZE})
endif()

# Headers that most files read, parsed once per library: half of the time to compile is theirs.
set(ABBE_PRECOMPILED
  <algorithm> <array> <cmath> <cstdint> <filesystem> <functional> <map> <memory> <optional> <span>
  <stdexcept> <string> <variant> <vector>)

# GCC forgets that precompiled headers are the system's, and warns of overflows in the standard
# library's strings that cannot happen. Clang and the address sanitizer still look for real ones.
target_compile_options(abbe_flags INTERFACE
  $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread>)

# With CMAKE_UNITY_BUILD, as the preset fuzz and the lint set it, the sources of one room are compiled
# as one: a quarter of the time. So two sources of a room share no name that is hidden in each.
function(abbe_unite_rooms target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  foreach(source IN LISTS ARGN)
    if(IS_ABSOLUTE "${source}")
      continue() # what the build makes
    endif()
    cmake_path(GET source PARENT_PATH room)
    string(MAKE_C_IDENTIFIER "room_${room}" group)
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()

# abbe_add_library(folder source...): the static library abbe_<folder> of one folder.
function(abbe_add_library folder)
  add_library(abbe_${folder} STATIC ${ARGN})
  abbe_unite_rooms(abbe_${folder} ${ARGN})
  target_link_libraries(abbe_${folder} PUBLIC abbe_flags)
  target_precompile_headers(abbe_${folder} PRIVATE ${ABBE_PRECOMPILED})
endfunction()
