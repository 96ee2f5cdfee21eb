# Debian packages, made by `cpack` in the build folder: thalweg (programs, cores, manual, documents, cases) and, where it is built,
# thalweg-cuda (the core for NVIDIA GPUs). What the programs are linked with becomes their dependencies by dpkg-shlibdeps.
configure_file("${CMAKE_CURRENT_LIST_DIR}/package_config.cmake.in" "${CMAKE_BINARY_DIR}/package_config.cmake" @ONLY)
set(CPACK_PROJECT_CONFIG_FILE "${CMAKE_BINARY_DIR}/package_config.cmake")

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME thalweg)
set(CPACK_PACKAGE_VENDOR "The Thalweg developers")
set(CPACK_PACKAGE_CONTACT "The Thalweg developers <thalweg@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "scour of a sediment bed by water, from a case file to a report")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME thalweg)
set(CPACK_COMPONENT_PROGRAMS_DESCRIPTION
  "Two-phase SPH for water scouring a sediment bed: particles from geometry, solver, report, and the same scene on a mesh with OpenFOAM.")
# The units database is data of libudunits2, which no library names; validate and sweep are Python.
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "libudunits2-data, python3")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS "gnuplot-nox")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SUGGESTS "openmpi-bin, openfoam, make, g++, ffmpeg")
set(CPACK_DEBIAN_CUDA_PACKAGE_NAME thalweg-cuda)
set(CPACK_COMPONENT_CUDA_DESCRIPTION "The solver's core for NVIDIA GPUs, which --backend auto uses where a GPU and its driver are.")
set(CPACK_DEBIAN_CUDA_PACKAGE_SUGGESTS "nvidia-driver")
include(CPack)
