# Writes OUTPUT, a C++ file with version and commit of the source tree SOURCE, if they have changed. A build calls it each time.
include("${CMAKE_CURRENT_LIST_DIR}/version_of.cmake")
thalweg_version_of("${SOURCE}" "${RELEASE}" version commit)
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT [[
#include "common/version.hpp"
namespace thalweg {
const char* build_version() { return "@version@"; }
const char* build_commit() { return "@commit@"; }
}  // namespace thalweg
]] @ONLY)
