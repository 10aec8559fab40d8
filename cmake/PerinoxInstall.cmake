# `cmake --install build` and `cpack --config build/CPackConfig.cmake -G DEB`.
include(GNUInstallDirs)
install(TARGETS perinox RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES README.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.svg"
                                                                   PATTERN "*.json")
install(DIRECTORY inputs studies DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.yaml" PATTERN "*.csv")
install(PROGRAMS scripts/picture.sh DESTINATION ${CMAKE_INSTALL_BINDIR} RENAME perinox-picture)

set(CPACK_PACKAGE_NAME perinox)
set(CPACK_PACKAGE_VENDOR "The perinox developers")
set(CPACK_PACKAGE_CONTACT "The perinox developers <perinox@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGE_DESCRIPTION
    "perinox computes how solids deform and yield under slowly growing loads with ordinary state-based\nperidynamics. It solves for equilibrium with Newton-Krylov methods from Trilinos, on MPI.")
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_CURRENT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)         # the libraries, by dpkg-shlibdeps
set(CPACK_DEBIAN_PACKAGE_DEPENDS openmpi-bin)  # mpirun
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox, hdf5-tools")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS paraview)
include(CPack)
