# The rooms of src/, lowest first: a room uses those before it and none after it (docs/architecture.md).
set(perinox_rooms core deck body bonds grid materials medium linear loads equilibrium mechanics fracture motion stepping output
                  study app)

# perinox_<room>: the objects of one room. Object libraries, not archives: materials register themselves, and a linker
# drops members of an archive that nobody names.
# perinox_up_to_<room>: what a program links to use a room, its objects and those of all rooms before it.
# link_<room>: a program of these objects and nothing else. The linker refuses it where a room uses a later one.
file(WRITE "${CMAKE_BINARY_DIR}/link_room.cpp" "int main() { return 0; }\n")
set(before "")
set_source_files_properties(src/study/chart.cpp PROPERTIES INCLUDE_DIRECTORIES "${CAIRO_INCLUDE_DIRS}")
foreach(room IN LISTS perinox_rooms)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/src/${room}/*.cpp")
  list(FILTER sources EXCLUDE REGEX "/src/app/main.cpp$")
  list(FILTER sources EXCLUDE REGEX "${perinox_unused_kernels}")
  add_library(perinox_${room} OBJECT ${sources})
  target_link_libraries(perinox_${room} PUBLIC perinox_flags perinox_dependencies)
  if(PERINOX_SANITIZE)
    # The tests spend their time here: docs/testing.md. The ordinary build precompiles nothing of src/ and so finds an
    # include that is missing.
    target_compile_options(perinox_${room} PRIVATE -O2)
    if(room STREQUAL core)
      target_precompile_headers(perinox_core PRIVATE ${perinox_foreign_headers})
    else()
      target_precompile_headers(perinox_${room} REUSE_FROM perinox_core)
    endif()
  endif()
  add_library(perinox_up_to_${room} INTERFACE)
  target_sources(perinox_up_to_${room} INTERFACE $<TARGET_OBJECTS:perinox_${room}>)
  target_link_libraries(perinox_up_to_${room} INTERFACE perinox_flags perinox_dependencies ${before})
  set(before perinox_up_to_${room})
  add_executable(link_${room} "${CMAKE_BINARY_DIR}/link_room.cpp")
  target_link_libraries(link_${room} PRIVATE perinox_up_to_${room})
  set_target_properties(link_${room} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/link")
endforeach()
