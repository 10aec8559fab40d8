# Every package perinox builds against. A missing one ends the configuration with one sentence that names the
# Debian package to install.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
endif()

function(perinox_require found package sentence)
  if(NOT ${found})
    message(FATAL_ERROR "perinox needs ${sentence}: install the Debian package ${package} "
                        "(scripts/quickstart.sh installs everything that is missing).")
  endif()
endfunction()

find_package(MPI QUIET COMPONENTS C CXX)
perinox_require(MPI_CXX_FOUND libopenmpi-dev "an MPI compiler and library (Open MPI)")

# One call for all: Trilinos' configuration fills its list of libraries the first time only.
set(perinox_trilinos_packages Tpetra NOX Belos Ifpack2 Zoltan2 Stratimikos Thyra Sacado)
find_package(Trilinos QUIET COMPONENTS ${perinox_trilinos_packages})
perinox_require(Trilinos_FOUND trilinos-all-dev "the Trilinos libraries")
foreach(component IN LISTS perinox_trilinos_packages)
  perinox_require(Trilinos_${component}_FOUND trilinos-all-dev "the Trilinos package ${component}")
endforeach()
find_library(PTSCOTCH_LIBRARY ptscotch PATH_SUFFIXES scotch-int32 scotch-int64 scotch-long)
perinox_require(PTSCOTCH_LIBRARY libptscotch-dev "the PT-Scotch library (Trilinos' exported link line names it)")
find_path(PTSCOTCH_INCLUDE_DIR ptscotch.h PATH_SUFFIXES scotch-int32 scotch scotch-int64 scotch-long)
perinox_require(PTSCOTCH_INCLUDE_DIR libptscotch-dev "the PT-Scotch headers (Zoltan2's partitioning header includes them)")

find_package(Eigen3 QUIET NO_MODULE)
perinox_require(Eigen3_FOUND libeigen3-dev "the Eigen headers")
find_package(yaml-cpp QUIET)
perinox_require(yaml-cpp_FOUND libyaml-cpp-dev "the yaml-cpp library")
find_package(fmt QUIET)
perinox_require(fmt_FOUND libfmt-dev "the fmt library")
find_package(CLI11 QUIET)
perinox_require(CLI11_FOUND libcli11-dev "the CLI11 headers")
find_path(NANOFLANN_INCLUDE_DIR nanoflann.hpp)
perinox_require(NANOFLANN_INCLUDE_DIR libnanoflann-dev "the nanoflann headers")
find_package(PkgConfig QUIET)
perinox_require(PkgConfig_FOUND pkg-config "pkg-config")
pkg_check_modules(MUPARSER QUIET IMPORTED_TARGET muparser)
perinox_require(MUPARSER_FOUND libmuparser-dev "the muParser library")
pkg_check_modules(CAIRO QUIET IMPORTED_TARGET cairo-svg cairo-png)
perinox_require(CAIRO_FOUND libcairo2-dev "the cairo library")
set(HDF5_PREFER_PARALLEL ON)
find_package(HDF5 QUIET COMPONENTS C)
perinox_require(HDF5_IS_PARALLEL libhdf5-openmpi-dev "the HDF5 library built for MPI")

# Heavy third-party headers come in as SYSTEM: warnings are for perinox's own code.
add_library(perinox_dependencies INTERFACE)
target_include_directories(perinox_dependencies SYSTEM INTERFACE
  ${Trilinos_INCLUDE_DIRS} ${Trilinos_TPL_INCLUDE_DIRS} ${HDF5_C_INCLUDE_DIRS} ${NANOFLANN_INCLUDE_DIR}
  ${PTSCOTCH_INCLUDE_DIR})
target_compile_definitions(perinox_dependencies INTERFACE ${HDF5_C_DEFINITIONS})
target_link_libraries(perinox_dependencies INTERFACE
  ${Trilinos_LIBRARIES} ${Trilinos_TPL_LIBRARIES} ${HDF5_C_LIBRARIES} MPI::MPI_CXX MPI::MPI_C
  Eigen3::Eigen yaml-cpp fmt::fmt CLI11::CLI11 PkgConfig::MUPARSER $<LINK_ONLY:PkgConfig::CAIRO>)
