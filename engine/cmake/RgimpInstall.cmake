# What `cmake --install` puts under the prefix: the static libraries, the public headers, the CMake
# package, the commands and the example cases.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/rgimp)
set(share ${CMAKE_INSTALL_DATADIR}/rgimp)

set_target_properties(rgimp_engine PROPERTIES EXPORT_NAME engine)
set_target_properties(rgimp_kernels PROPERTIES EXPORT_NAME kernels)
install(TARGETS rgimp_engine rgimp_kernels EXPORT rgimp
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/engine/include/rgimp TYPE INCLUDE)

# The compatible versions: while the first number is 0, the second one breaks interfaces.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rgimpConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(EXPORT rgimp NAMESPACE rgimp:: FILE rgimpTargets.cmake DESTINATION ${package})
install(FILES ${CMAKE_CURRENT_LIST_DIR}/rgimpConfig.cmake
              ${PROJECT_BINARY_DIR}/rgimpConfigVersion.cmake DESTINATION ${package})

install(TARGETS rgimp)
install(FILES ${PROJECT_SOURCE_DIR}/engine/cli/man/rgimp.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_SOURCE_DIR}/engine/cli/completion/rgimp.bash
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME rgimp)

# Programs in Python find their modules beside the file that a link to them leads to.
set(python ${PROJECT_SOURCE_DIR}/engine/python)
foreach(program rgimp-plot rgimp-report)
  install(PROGRAMS ${python}/${program} DESTINATION ${share}/python)
  file(RELATIVE_PATH target ${CMAKE_INSTALL_FULL_BINDIR}
       ${CMAKE_INSTALL_FULL_DATADIR}/rgimp/python/${program})
  file(CREATE_LINK ${target} ${PROJECT_BINARY_DIR}/${program} SYMBOLIC)
  install(FILES ${PROJECT_BINARY_DIR}/${program} TYPE BIN)
endforeach()
install(DIRECTORY ${python}/rgimp_plot ${python}/rgimp_report DESTINATION ${share}/python
        FILES_MATCHING PATTERN *.py PATTERN *.jinja PATTERN *.css PATTERN *.js
        PATTERN __pycache__ EXCLUDE)

# Where Debian's Python looks under /usr and /usr/local; elsewhere PYTHONPATH names it.
if(RGIMP_BUILD_PYTHON)
  install(TARGETS rgimp_python DESTINATION lib/python3/dist-packages/rgimp)
  install(FILES ${python}/rgimp/__init__.py DESTINATION lib/python3/dist-packages/rgimp)
endif()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/ DESTINATION ${share}/examples
        FILES_MATCHING PATTERN *.toml PATTERN pictures EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE TYPE DOC)
