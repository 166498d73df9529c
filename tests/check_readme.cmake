# The README's C++ is the part of the quick start between its README marks, line by line.
set(root ${CMAKE_CURRENT_LIST_DIR}/..)
file(READ ${root}/README.md readme)
file(READ ${root}/firmware_examples/quick_start/main.cpp example)
string(REGEX MATCH "```cpp\n(.*)\n```" found "${readme}")
set(shown "${CMAKE_MATCH_1}")
string(REGEX MATCH "// README: begin\n(.*)\n// README: end" found "${example}")
set(compiled "${CMAKE_MATCH_1}")
if(shown STREQUAL "" OR NOT shown STREQUAL compiled)
  message(FATAL_ERROR "README.md and firmware_examples/quick_start/main.cpp differ; README shows:\n"
    "${shown}\nthe example has:\n${compiled}")
endif()
