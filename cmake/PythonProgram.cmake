# thalweg_python_program(NAME MODULE:FUNCTION PACKAGES folder …): thalweg-NAME, packages in Python packed into one file beside the
# other programs, which `thalweg` finds by name.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

function(thalweg_python_program name start)
  cmake_parse_arguments(ARG "" "" "PACKAGES" ${ARGN})
  list(TRANSFORM ARG_PACKAGES PREPEND "${PROJECT_SOURCE_DIR}/")
  list(TRANSFORM ARG_PACKAGES APPEND "/*" OUTPUT_VARIABLE patterns)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${patterns})
  list(FILTER sources INCLUDE REGEX "\\.(py|toml)$")
  set(program "${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/thalweg-${name}")
  add_custom_command(OUTPUT "${program}"
    COMMAND "${Python3_EXECUTABLE}" -B "${PROJECT_SOURCE_DIR}/cmake/python_program.py" "${program}" "${start}" ${ARG_PACKAGES}
    DEPENDS ${sources} "${PROJECT_SOURCE_DIR}/cmake/python_program.py"
    VERBATIM)
  add_custom_target(thalweg-${name} ALL DEPENDS "${program}")
  add_dependencies(programs thalweg-${name})
  install(PROGRAMS "${program}" TYPE BIN COMPONENT programs)
  set_property(GLOBAL APPEND PROPERTY THALWEG_PYTHON_PROGRAMS thalweg-${name})
endfunction()
