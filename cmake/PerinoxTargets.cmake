# perinox_flags: include path, language level and warnings of perinox's own code.
add_library(perinox_flags INTERFACE)
target_include_directories(perinox_flags INTERFACE "${CMAKE_CURRENT_SOURCE_DIR}/include")
target_compile_definitions(perinox_flags INTERFACE PERINOX_VERSION="${PROJECT_VERSION}")
target_compile_options(perinox_flags INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion)
if(PERINOX_WARNINGS_AS_ERRORS)
  target_compile_options(perinox_flags INTERFACE -Werror)
endif()
if(PERINOX_NATIVE)
  target_compile_options(perinox_flags INTERFACE -march=native)
endif()
if(PERINOX_SANITIZE)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "the sanitised build needs clang: cmake --preset sanitize (scripts/sanitize.sh)")
  endif()
  # Tests are compiled without optimisation, in half the time of g++ or of clang's own -O1; PerinoxRooms and PerinoxKernels
  # have the options of what they run.
  target_compile_options(perinox_flags INTERFACE
    -g1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all)
  target_link_options(perinox_flags INTERFACE -fsanitize=address,undefined -fuse-ld=lld)
endif()
# The linker that g++ takes by itself needs three to eight times as long for a program of this size.
if(NOT PERINOX_SANITIZE)
  find_program(PERINOX_LINKER NAMES ld.lld ld.gold)
  if(PERINOX_LINKER)
    string(REGEX REPLACE ".*ld\\." "" perinox_linker "${PERINOX_LINKER}")
    target_link_options(perinox_flags INTERFACE -fuse-ld=${perinox_linker})
  endif()
endif()
# Headers of the standard library and of other projects, for precompiling.
set(perinox_foreign_headers
    <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <map> <memory> <numeric> <optional> <random> <set>
    <sstream> <string> <vector> <fmt/format.h> <mpi.h> <Teuchos_ParameterList.hpp> <Teuchos_RCP.hpp>
    <Tpetra_CrsGraph_fwd.hpp> <Tpetra_CrsMatrix_fwd.hpp> <Tpetra_Export_fwd.hpp> <Tpetra_Map_fwd.hpp>
    <Tpetra_MultiVector_fwd.hpp> <Tpetra_Operator_fwd.hpp> <Tpetra_Vector_fwd.hpp>)
