# One library a room, from one call in the room's CMakeLists.txt:
#
#   delone_room(NAME SOURCES a.cpp ... HEADERS a.hpp ... [PUBLIC libs ...] [PRIVATE libs ...])
#
# builds delone::NAME with the source tree (or include/delone after installation) on the include path, installs
# it with the HEADERS, which are the public ones, and writes delone-NAME.pc.
# Each room is an export set and a component of find_package(delone) of its own, so that nobody needs
# Eigen to triangulate or NetCDF to interpolate.

set(DELONE_INSTALL_CMAKEDIR "${CMAKE_INSTALL_LIBDIR}/cmake/delone")
set_property(GLOBAL PROPERTY DELONE_ROOMS "")

function(delone_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;HEADERS;PUBLIC;PRIVATE" ${ARGN})
  set(target delone_${name})
  add_library(${target} ${ROOM_SOURCES})
  add_library(delone::${name} ALIAS ${target})
  target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS "${PROJECT_SOURCE_DIR}"
                 FILES ${ROOM_HEADERS})
  set_target_properties(${target} PROPERTIES
    EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    VERIFY_INTERFACE_HEADER_SETS ON)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_link_libraries(${target} PUBLIC ${ROOM_PUBLIC} PRIVATE ${ROOM_PRIVATE})
  delone_warnings(${target})
  delone_install_room(${name} "${ROOM_PUBLIC}" "${ROOM_PRIVATE}")
endfunction()

# Adds files compiled with AVX2 to a room, where the processor family has it; which version runs is chosen
# at run time (delaunay/instruction_set.hpp).
function(delone_avx2 name)
  if(NOT CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
    return()
  endif()
  target_sources(delone_${name} PRIVATE ${ARGN})
  set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS "-mavx2;-mfma")
  target_compile_definitions(delone_${name} PRIVATE DELONE_AVX2)
endfunction()

# Contraction to fused multiply-add is off everywhere: a compiler's choice must not change a result.
# g++ 12 takes the concatenation of strings for an overlapping copy (its bug 105651): no -Wrestrict. It
# tells that four doubles are passed in memory on machines without AVX: they are only passed to functions
# that are inlined (-Wpsabi). Options are structs of which some members are set by name
# (-Wmissing-field-initializers). What -Wconversion means is g++'s: clang's asks for a cast at every index.
function(delone_warnings target)
  target_compile_options(${target} PRIVATE -ffp-contract=off
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow
    -Wno-missing-field-initializers "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-psabi>"
    $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>
    $<$<BOOL:${DELONE_WERROR}>:-Werror>)
endfunction()

function(delone_install_room name public private)
  set_property(GLOBAL APPEND PROPERTY DELONE_ROOMS ${name})
  install(TARGETS delone_${name} EXPORT delone-${name}
    FILE_SET HEADERS DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/delone")
  install(EXPORT delone-${name} NAMESPACE delone:: DESTINATION "${DELONE_INSTALL_CMAKEDIR}")
  delone_pkg_config(${name} "${public}" "${private}")
endfunction()

# A static library's users link its private parts too; a shared library's do not.
function(delone_pkg_config name public private)
  delone_pkg_config_parts(public_requires public_libs ${public})
  delone_pkg_config_parts(private_requires private_libs ${private})
  if(NOT BUILD_SHARED_LIBS)
    list(APPEND public_requires ${private_requires})
    list(APPEND public_libs ${private_libs})
    unset(private_requires)
  endif()
  list(JOIN public_requires ", " PC_REQUIRES)
  list(JOIN private_requires ", " PC_REQUIRES_PRIVATE)
  list(JOIN public_libs " " PC_LIBS)
  set(PC_NAME ${name})
  configure_file("${PROJECT_SOURCE_DIR}/cmake/delone.pc.in"
                 "${PROJECT_BINARY_DIR}/delone-${name}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/delone-${name}.pc"
          DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endfunction()

# Splits CMake targets into names of other .pc files and plain linker flags.
function(delone_pkg_config_parts out_requires out_libs)
  set(requires "")
  set(libs "")
  foreach(lib IN LISTS ARGN)
    if(lib MATCHES "^delone::(.*)$")
      list(APPEND requires "delone-${CMAKE_MATCH_1} = ${PROJECT_VERSION}")
    elseif(lib STREQUAL "Threads::Threads")
      list(APPEND libs -pthread)
    elseif(lib STREQUAL "Eigen3::Eigen")
      list(APPEND requires eigen3)
    elseif(lib MATCHES "^PkgConfig::(.*)$")
      list(APPEND requires ${${CMAKE_MATCH_1}_MODULE_NAME})
    elseif(lib MATCHES "BUILD_INTERFACE")
      continue()
    else()
      message(FATAL_ERROR "cmake/DeloneRoom.cmake does not know how pkg-config calls ${lib}")
    endif()
  endforeach()
  set(${out_requires} "${requires}" PARENT_SCOPE)
  set(${out_libs} "${libs}" PARENT_SCOPE)
endfunction()

function(delone_install_package)
  include(CMakePackageConfigHelpers)
  get_property(DELONE_ROOMS GLOBAL PROPERTY DELONE_ROOMS)
  configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/deloneConfig.cmake.in"
    "${PROJECT_BINARY_DIR}/deloneConfig.cmake" INSTALL_DESTINATION "${DELONE_INSTALL_CMAKEDIR}")
  write_basic_package_version_file("${PROJECT_BINARY_DIR}/deloneConfigVersion.cmake"
    COMPATIBILITY SameMinorVersion)
  install(FILES "${PROJECT_BINARY_DIR}/deloneConfig.cmake"
                "${PROJECT_BINARY_DIR}/deloneConfigVersion.cmake"
          DESTINATION "${DELONE_INSTALL_CMAKEDIR}")
endfunction()
