# Everything Thalweg compiles is C++20, includes from the repository's root ("case/case.hpp"), and treats warnings as errors.
# Compilers that the tests do not use, and the libraries of their systems, warn of other things; there they stop nobody's build.
set(tested_compilers GNU-12 Clang-14)
string(REGEX MATCH "^[0-9]+" compiler_major "${CMAKE_CXX_COMPILER_VERSION}")
set(THALWEG_WARNINGS_ARE_ERRORS OFF)
if("${CMAKE_CXX_COMPILER_ID}-${compiler_major}" IN_LIST tested_compilers)
  set(THALWEG_WARNINGS_ARE_ERRORS ON)
else()
  message(STATUS "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} has not been tried: its warnings are no errors")
endif()
set(CMAKE_COMPILE_WARNING_AS_ERROR ${THALWEG_WARNINGS_ARE_ERRORS})
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
# Programs of a bundle (tools/bundle) find the libraries beside them, and those each other: the old kind of path is inherited.
set(CMAKE_INSTALL_RPATH "$ORIGIN/../lib")
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)  # the same path in both: CMake would leave room for another one, an empty element
add_link_options(-Wl,--disable-new-dtags)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(THALWEG_CCACHE ccache)
if(THALWEG_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${THALWEG_CCACHE}")
endif()

# All programs that a user calls, and their manual.
add_custom_target(programs)

# thalweg_library(NAME SOURCES … [LINK …]) and thalweg_program(NAME SOURCES … [LINK …]): a static library or a program
# with the project's warnings and include root.
function(thalweg_settings target)
  target_include_directories(${target} PUBLIC "${PROJECT_SOURCE_DIR}")
  # -Wno-restrict: GCC 12 reports it wrongly inside std::string (GCC bug 105329).
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-restrict
    $<$<BOOL:${THALWEG_WARNINGS_ARE_ERRORS}>:-Werror>)
endfunction()

# THALWEG_UNITY: the files of a library or a program of tests are compiled eight at a time as one, so that the headers of VTK, Eigen and fmt are read once
# for all of them, which shortens a first build. A change of one file compiles its neighbours again.
option(THALWEG_UNITY "Compile several files of a library at once" OFF)

function(thalweg_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES UNITY_BUILD ${THALWEG_UNITY} UNITY_BUILD_BATCH_SIZE 8)
  target_link_libraries(${name} PUBLIC ${ARG_LINK})
  thalweg_settings(${name})
  # GCC 12 sees uninitialised memory inside std::string wrongly where it inlines more, as in files that are compiled as one.
  target_compile_options(${name} PRIVATE $<$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>:-Wno-maybe-uninitialized>)
endfunction()

function(thalweg_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES} $<TARGET_OBJECTS:thalweg_build_version>)
  set_target_properties(${name} PROPERTIES UNITY_BUILD ${THALWEG_UNITY} UNITY_BUILD_BATCH_SIZE 8)
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  thalweg_settings(${name})
  add_dependencies(programs ${name})
  install(TARGETS ${name} RUNTIME COMPONENT programs)
endfunction()

# Version and commit, from git, for the programs (common/version.hpp).
set(THALWEG_BUILD_VERSION "${CMAKE_BINARY_DIR}/build_version.cpp")
add_custom_target(thalweg_ask_git BYPRODUCTS "${THALWEG_BUILD_VERSION}"
  COMMAND "${CMAKE_COMMAND}" -D "SOURCE=${PROJECT_SOURCE_DIR}" -D "RELEASE=${PROJECT_VERSION}" -D "OUTPUT=${THALWEG_BUILD_VERSION}"
          -P "${PROJECT_SOURCE_DIR}/cmake/build_version.cmake" VERBATIM)
add_library(thalweg_build_version OBJECT "${THALWEG_BUILD_VERSION}")
thalweg_settings(thalweg_build_version)
add_dependencies(thalweg_build_version thalweg_ask_git)

set(THALWEG_TEST_SLOWNESS 1 CACHE STRING "How many times longer tests may take, where they are sanitized")

# thalweg_test(NAME LABEL label SOURCES … [LINK …]): a GoogleTest program, every test of it registered with CTest under
# the label unit, backend, pipeline, stability or validation. FIXTURE names what another test has to set up before.
# Target tests_LABEL builds all of a label. TIMEOUT ends a test that hangs: at least five times what it takes, because
# machines that are shared are slow at times.
function(thalweg_test name)
  cmake_parse_arguments(ARG "" "LABEL;TIMEOUT;FIXTURE" "SOURCES;LINK" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 900)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  if(NOT TARGET tests_${ARG_LABEL})
    add_custom_target(tests_${ARG_LABEL})
  endif()
  add_dependencies(tests_${ARG_LABEL} ${name})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gtest_main GTest::gmock)
  thalweg_settings(${name})
  # With -O1 a file of tests compiles in half of the time (table_test.cpp 4.7 instead of 10.2 s). passes_test then runs 3.6 s
  # instead of 3.4, critical_gradient_test 8.6 instead of 8.2. The libraries keep -O3.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  # In one file with its neighbours a local name may be one that a neighbour has at namespace scope.
  target_compile_options(${name} PRIVATE $<$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>:-Wno-shadow -Wno-maybe-uninitialized>)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests"
                        UNITY_BUILD ${THALWEG_UNITY} UNITY_BUILD_BATCH_SIZE 8)
  math(EXPR ARG_TIMEOUT "${ARG_TIMEOUT} * ${THALWEG_TEST_SLOWNESS}")
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT} FIXTURES_REQUIRED "${ARG_FIXTURE}")
endfunction()
