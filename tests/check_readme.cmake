# The README's C++ is the part of the quick start between its README marks, line by line, and its C
# that of the C example.
set(root ${CMAKE_CURRENT_LIST_DIR}/..)
file(READ ${root}/README.md readme)

# Sets `part` to what lies between the first `begin` and the next `end`.
function(text_between text begin end part)
  string(FIND "${text}" "${begin}" start)
  set(found "")
  if(NOT start EQUAL -1)
    string(LENGTH "${begin}" length)
    math(EXPR start "${start} + ${length}")
    string(SUBSTRING "${text}" ${start} -1 rest)
    string(FIND "${rest}" "${end}" length)
    string(SUBSTRING "${rest}" 0 ${length} found)
  endif()
  set(${part} "${found}" PARENT_SCOPE)
endfunction()

function(check_block language example begin end)
  file(READ ${root}/${example} source)
  text_between("${readme}" "\n```${language}\n" "\n```\n" shown)
  text_between("${source}" "\n${begin}\n" "\n${end}\n" compiled)
  if(shown STREQUAL "" OR NOT shown STREQUAL compiled)
    message(FATAL_ERROR "README.md and ${example} differ; README shows:\n"
      "${shown}\nthe example has:\n${compiled}")
  endif()
endfunction()

check_block(cpp firmware_examples/quick_start/main.cpp "// README: begin" "// README: end")
check_block(c firmware_examples/c_query/main.c "/* README: begin */" "/* README: end */")
