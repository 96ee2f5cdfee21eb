# Everything Thalweg compiles is C++20, includes from the repository's root ("case/case.hpp"), and treats warnings as errors.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
# Programs of a bundle (tools/bundle) find the libraries beside them, and those each other: the old kind of path is inherited.
# Written as it is installed: CMake fills up the path of a build with a colon, which would name the current directory.
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)
set(CMAKE_INSTALL_RPATH "$ORIGIN/../lib")
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)
add_link_options(-Wl,--disable-new-dtags)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(THALWEG_CCACHE ccache)
if(THALWEG_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${THALWEG_CCACHE}")
endif()

# thalweg_library(NAME SOURCES … [LINK …]) and thalweg_program(NAME SOURCES … [LINK …]): a static library or a program
# with the project's warnings and include root.
function(thalweg_settings target)
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
  # -Wno-restrict: GCC 12 reports it wrongly inside std::string (GCC bug 105329).
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-restrict -Werror)
  target_compile_definitions(${target} PRIVATE THALWEG_VERSION="${PROJECT_VERSION}")
endfunction()

function(thalweg_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC ${ARG_LINK})
  thalweg_settings(${name})
endfunction()

function(thalweg_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  thalweg_settings(${name})
  install(TARGETS ${name})
endfunction()

# thalweg_test(NAME LABEL label SOURCES … [LINK …]): a GoogleTest program, every test of it registered with CTest under
# the label unit, backend, pipeline, stability or validation. FIXTURE names what another test has to set up before.
function(thalweg_test name)
  cmake_parse_arguments(ARG "" "LABEL;TIMEOUT;FIXTURE" "SOURCES;LINK" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gtest_main GTest::gmock)
  thalweg_settings(${name})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT} FIXTURES_REQUIRED "${ARG_FIXTURE}")
endfunction()
