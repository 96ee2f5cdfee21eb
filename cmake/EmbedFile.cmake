# thalweg_embed(TARGET SYMBOL FILE): compiles a text file into a target as `const std::string_view thalweg::embedded::SYMBOL`,
# so that the program needs no file beside itself. An empty FILE gives an empty text.
function(thalweg_embed target symbol file)
  set(source "${CMAKE_CURRENT_BINARY_DIR}/embedded_${symbol}.cpp")
  add_custom_command(OUTPUT "${source}"
    COMMAND ${CMAKE_COMMAND} -D "SYMBOL=${symbol}" -D "FILE=${file}" -D "SOURCE=${source}" -P "${PROJECT_SOURCE_DIR}/cmake/embed.cmake"
    DEPENDS ${file} "${PROJECT_SOURCE_DIR}/cmake/embed.cmake"
    VERBATIM)
  target_sources(${target} PRIVATE "${source}")
endfunction()
