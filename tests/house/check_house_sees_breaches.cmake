# Writes small trees with one breach each and asks that check_house.cmake refuses them with the right sentence, and
# that it accepts the tree without a breach. Run by ctest with -DCHECK=<check_house.cmake> -DSCRATCH=<folder>.
cmake_minimum_required(VERSION 3.20)

function(try_tree expected)
  execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${SCRATCH} -P ${CHECK} RESULT_VARIABLE status OUTPUT_VARIABLE said
                  ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")  # CMake folds long lines of messages
  if(expected STREQUAL "" AND NOT status EQUAL 0)
    message(FATAL_ERROR "a tree without a breach was refused: ${said}")
  elseif(NOT expected STREQUAL "" AND (status EQUAL 0 OR NOT said MATCHES "${expected}"))
    message(FATAL_ERROR "status ${status}; '${expected}' was expected, but the check said: ${said}")
  endif()
endfunction()

function(fresh_tree)
  file(REMOVE_RECURSE "${SCRATCH}")
  file(WRITE "${SCRATCH}/src/stepping/a.cpp" "#include \"perinox/core/error.hpp\"\n")
endfunction()

fresh_tree()
try_tree("")
file(WRITE "${SCRATCH}/include/perinox/stepping/a.hpp" "#include \"perinox/output/b.hpp\"\n")
try_tree("stepping may not include output")
fresh_tree()
file(WRITE "${SCRATCH}/src/materials/a.cpp" "# include <perinox/mechanics/b.hpp>\n")
try_tree("materials may not include mechanics")
fresh_tree()
file(WRITE "${SCRATCH}/src/core/a.cpp" "#include \"perinox/helpers/b.hpp\"\n")
try_tree("helpers is not a room")
fresh_tree()
file(WRITE "${SCRATCH}/src/helpers/a.cpp" "int a;\n")
try_tree("src/helpers is not a room")
fresh_tree()
string(REPEAT "// a; line [with] brackets\n" 601 text)
file(WRITE "${SCRATCH}/src/core/a.cpp" "${text}")
try_tree("has 601 lines")
file(REMOVE_RECURSE "${SCRATCH}")
