# Fetches the packages of package-lock.json into WORK, bundles scene.js there and writes OUTPUT. Without npm or network
# OUTPUT is empty, and `thalweg postproc --3d` says so: the build goes on.
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
file(WRITE "${OUTPUT}" "")
set(reason "npm or node is not installed")
if(NPM AND NODE)
  file(COPY "${SOURCE}/" DESTINATION "${WORK}")
  execute_process(COMMAND "${NPM}" ci --ignore-scripts --no-audit --no-fund --loglevel=error WORKING_DIRECTORY "${WORK}"
    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE reason TIMEOUT 300)
  if(status EQUAL 0)
    execute_process(COMMAND "${NODE}" bundle.mjs "${OUTPUT}" WORKING_DIRECTORY "${WORK}"
      RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE reason TIMEOUT 120)
  endif()
  if(status EQUAL 0)
    return()
  endif()
  file(WRITE "${OUTPUT}" "")
endif()
string(STRIP "${reason}" reason)
string(REGEX REPLACE "\n.*" "" reason "${reason}")
message("The report's 3-D view is left out: ${reason}. To try again, remove ${OUTPUT} and build.")
