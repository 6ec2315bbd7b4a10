# cmake --install: the program with its man page and completions, the scenes, the documents, and the
# libraries with a CMake package, so that another project can say
#   find_package(abbe REQUIRED)
#   target_link_libraries(mine PRIVATE abbe::core)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The program tells its own man page and completions, so that none of them can be out of date.
set(manual "${PROJECT_BINARY_DIR}/manual")
file(MAKE_DIRECTORY "${manual}")
foreach(page man:abbe.1 bash:abbe.bash zsh:_abbe fish:abbe.fish)
  string(REPLACE ":" ";" page "${page}")
  list(GET page 0 kind)
  list(GET page 1 file)
  add_custom_command(OUTPUT "${manual}/${file}" DEPENDS abbe VERBATIM
    COMMAND sh -c "\"$0\" manual \"$1\" > \"$2\"" "$<TARGET_FILE:abbe>" "${kind}" "${manual}/${file}")
  list(APPEND manual_pages "${manual}/${file}")
endforeach()
add_custom_target(abbe_manual ALL DEPENDS ${manual_pages})

install(TARGETS abbe RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
if(TARGET abbe_mpi)
  install(TARGETS abbe_mpi RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()
install(FILES "${manual}/abbe.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
install(FILES "${manual}/abbe.bash" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" RENAME abbe)
install(FILES "${manual}/_abbe" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/site-functions")
install(FILES "${manual}/abbe.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
install(DIRECTORY scenes DESTINATION "${CMAKE_INSTALL_DATADIR}/abbe")
install(FILES README.md LICENSE spectral/data/README.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(DIRECTORY docs/ DESTINATION "${CMAKE_INSTALL_DOCDIR}/docs")

set(package "${CMAKE_INSTALL_LIBDIR}/cmake/abbe")
foreach(floor spectral geometry core io)
  set_target_properties(abbe_${floor} PROPERTIES EXPORT_NAME ${floor})
  install(DIRECTORY ${floor} DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/abbe" FILES_MATCHING PATTERN "*.h" PATTERN data EXCLUDE)
endforeach()
set_target_properties(abbe_flags PROPERTIES EXPORT_NAME flags)
install(TARGETS abbe_flags abbe_spectral abbe_geometry abbe_core abbe_io EXPORT abbe
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(EXPORT abbe NAMESPACE abbe:: FILE abbeTargets.cmake DESTINATION "${package}")
configure_package_config_file(cmake/abbeConfig.cmake.in "${PROJECT_BINARY_DIR}/abbeConfig.cmake"
  INSTALL_DESTINATION "${package}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/abbeConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/abbeConfig.cmake" "${PROJECT_BINARY_DIR}/abbeConfigVersion.cmake"
  cmake/ThirdParty.cmake DESTINATION "${package}")
