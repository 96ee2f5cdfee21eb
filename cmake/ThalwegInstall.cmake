# What is installed besides the programs and their cores: manual, completions, documents, cases. The tree may be moved: the programs
# find the rest from where they lie themselves (common/installation.hpp).
set(manual "${CMAKE_BINARY_DIR}/manual")
get_property(python_programs GLOBAL PROPERTY THALWEG_PYTHON_PROGRAMS)
set(programs thalweg thalweg-gencase thalweg-solver thalweg-postproc thalweg-foam ${python_programs})
add_custom_command(OUTPUT "${manual}/man/man1/thalweg.1"
  COMMAND "${CMAKE_COMMAND}" -D "THALWEG=$<TARGET_FILE:thalweg>" -D "SHARE=${manual}" -P "${PROJECT_SOURCE_DIR}/cmake/manual.cmake"
  DEPENDS ${programs} "${PROJECT_SOURCE_DIR}/cmake/manual.cmake"
  COMMENT "Writing manual and completions" VERBATIM)
add_custom_target(manual ALL DEPENDS "${manual}/man/man1/thalweg.1")
add_dependencies(programs manual)

install(DIRECTORY "${manual}/" DESTINATION share COMPONENT programs)
install(DIRECTORY cases DESTINATION share/thalweg COMPONENT programs)
install(DIRECTORY docs DESTINATION share/doc/thalweg COMPONENT programs)
install(FILES README.md CHANGELOG.md CITATION.cff LICENSE LICENSES.md DESTINATION share/doc/thalweg COMPONENT programs)
# The documents name cases by their place in the repository.
install(CODE "file(MAKE_DIRECTORY \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share/doc/thalweg\")
file(CREATE_LINK ../../thalweg/cases \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share/doc/thalweg/cases\" SYMBOLIC)" COMPONENT programs)
