# Writes the pages of the manual and the completions of the shells below SHARE, as the programs tell them: cmake -D THALWEG=PROGRAM
# -D SHARE=FOLDER -P manual.cmake
function(say_into file)
  execute_process(COMMAND "${THALWEG}" ${ARGN} OUTPUT_VARIABLE text RESULT_VARIABLE failed)
  if(failed OR text STREQUAL "")
    message(FATAL_ERROR "thalweg ${ARGN} gave nothing to write into ${file}")
  endif()
  file(WRITE "${SHARE}/${file}" "${text}")
endfunction()

file(REMOVE_RECURSE "${SHARE}/man")
say_into(bash-completion/completions/thalweg completion bash)
say_into(zsh/vendor-completions/_thalweg completion zsh)
say_into(fish/vendor_completions.d/thalweg.fish completion fish)
execute_process(COMMAND "${THALWEG}" help OUTPUT_VARIABLE overview)
string(REGEX MATCHALL "\n  [a-z]+ " lines "${overview}")
foreach(line IN LISTS lines)
  string(STRIP "${line}" command)
  say_into(man/man1/thalweg-${command}.1 help ${command} --man)
endforeach()
say_into(man/man1/thalweg.1 help --man)  # the last one: it stands for all
