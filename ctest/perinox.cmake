# CTest driver: configures, builds and tests; the exit status is non-zero if any of the three fails.
#   CTEST_OUTPUT_ON_FAILURE=1 ctest -S ctest/perinox.cmake -V
# Environment: PERINOX_BUILD_DIR (default build/), PERINOX_JOBS (default: the number of cores).
# To send the results to a CDash server, set CTEST_DROP_SITE and its companions in a file and name it in
# PERINOX_DASHBOARD.
cmake_minimum_required(VERSION 3.20)

get_filename_component(CTEST_SOURCE_DIRECTORY "${CMAKE_CURRENT_LIST_DIR}/.." ABSOLUTE)
set(CTEST_BINARY_DIRECTORY "$ENV{PERINOX_BUILD_DIR}")
if(NOT CTEST_BINARY_DIRECTORY)
  set(CTEST_BINARY_DIRECTORY "${CTEST_SOURCE_DIRECTORY}/build")
endif()
set(jobs "$ENV{PERINOX_JOBS}")
if(NOT jobs)
  include(ProcessorCount)
  ProcessorCount(jobs)
endif()
site_name(CTEST_SITE)
set(CTEST_BUILD_NAME "${CMAKE_HOST_SYSTEM_NAME}-${CMAKE_HOST_SYSTEM_PROCESSOR}")

# A build directory that exists keeps its generator and build type.
set(options "")
set(CTEST_CMAKE_GENERATOR Ninja)
if(EXISTS "${CTEST_BINARY_DIRECTORY}/CMakeCache.txt")
  file(STRINGS "${CTEST_BINARY_DIRECTORY}/CMakeCache.txt" generator REGEX "^CMAKE_GENERATOR:")
  string(REGEX REPLACE "^[^=]*=" "" CTEST_CMAKE_GENERATOR "${generator}")
else()
  set(options -DCMAKE_BUILD_TYPE=RelWithDebInfo)
endif()

# CTest keeps what the configuration and the compiler say to itself; on failure it is shown.
function(stop_if_failed failed what log)
  if(failed)
    file(GLOB logs "${CTEST_BINARY_DIRECTORY}/Testing/Temporary/${log}_*.log")
    list(SORT logs)
    list(POP_BACK logs newest)
    file(READ "${newest}" said)
    message("${said}")
    message(FATAL_ERROR "${what} failed, see above")
  endif()
endfunction()

ctest_start(Experimental)
ctest_configure(OPTIONS "${options}" RETURN_VALUE failed)
stop_if_failed(${failed} "the configuration" LastConfigure)
ctest_build(PARALLEL_LEVEL ${jobs} RETURN_VALUE failed)
stop_if_failed(${failed} "the build" LastBuild)

ctest_test(PARALLEL_LEVEL ${jobs} RETURN_VALUE failed)
if(NOT "$ENV{PERINOX_DASHBOARD}" STREQUAL "")
  include("$ENV{PERINOX_DASHBOARD}")
  ctest_submit()
endif()
if(failed)
  message(FATAL_ERROR "tests failed, see above")
endif()
