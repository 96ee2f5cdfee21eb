# Writes SOURCE, a C++ file that holds the text of FILE under the name SYMBOL.
set(text "")
if(FILE)
  file(READ "${FILE}" text)
endif()
file(WRITE "${SOURCE}"
  "#include \"postproc/embedded.hpp\"\n"
  "namespace thalweg::embedded {\nconst std::string_view ${SYMBOL} = R\"embedded(${text})embedded\";\n}\n")
