# What `cmake --install` puts under the prefix, in two components, which `cpack` makes two Debian
# packages of: "development" has the static libraries, the public headers, the CMake package and the
# pkg-config file; "runtime" the commands, the Python package and the example cases.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/rgimp)
set(share ${CMAKE_INSTALL_DATADIR}/rgimp)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME runtime)

# Debian wants what people read compressed.
find_program(GZIP gzip REQUIRED)
set(compressed ${PROJECT_BINARY_DIR}/compressed)
file(MAKE_DIRECTORY ${compressed})
function(rgimp_compress from to)
  add_custom_command(OUTPUT ${compressed}/${to} DEPENDS ${from}
                     COMMAND ${GZIP} -9nc ${from} > ${compressed}/${to} VERBATIM)
endfunction()
rgimp_compress(${PROJECT_SOURCE_DIR}/engine/cli/man/rgimp.1 rgimp.1.gz)
rgimp_compress(${PROJECT_SOURCE_DIR}/CHANGELOG.md changelog.gz)
add_custom_target(rgimp_compressed ALL DEPENDS ${compressed}/rgimp.1.gz ${compressed}/changelog.gz)

# ---- development
set_target_properties(rgimp_engine PROPERTIES EXPORT_NAME engine)
set_target_properties(rgimp_kernels PROPERTIES EXPORT_NAME kernels)
install(TARGETS rgimp_engine rgimp_kernels EXPORT rgimp COMPONENT development
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/engine/include/rgimp TYPE INCLUDE COMPONENT development)

# The compatible versions: while the first number is 0, the second one breaks interfaces.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/rgimpConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(EXPORT rgimp NAMESPACE rgimp:: FILE rgimpTargets.cmake DESTINATION ${package}
        COMPONENT development)
install(FILES ${CMAKE_CURRENT_LIST_DIR}/rgimpConfig.cmake
              ${PROJECT_BINARY_DIR}/rgimpConfigVersion.cmake
        DESTINATION ${package} COMPONENT development)

# Relative to its own place, so that the tree can be moved.
file(RELATIVE_PATH to_prefix /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(${CMAKE_CURRENT_LIST_DIR}/rgimp.pc.in ${PROJECT_BINARY_DIR}/rgimp.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/rgimp.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
        COMPONENT development)

# ---- runtime
install(TARGETS rgimp)
install(FILES ${compressed}/rgimp.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/engine/cli/completion/ DESTINATION ${CMAKE_INSTALL_DATADIR})

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

# Where Debian's Python looks under /usr; elsewhere PYTHONPATH names it.
if(RGIMP_BUILD_PYTHON)
  install(TARGETS rgimp_python DESTINATION lib/python3/dist-packages/rgimp)
  install(FILES ${python}/rgimp/__init__.py DESTINATION lib/python3/dist-packages/rgimp)
endif()

install(DIRECTORY ${PROJECT_SOURCE_DIR}/examples/ DESTINATION ${share}/examples
        FILES_MATCHING PATTERN *.toml PATTERN flaw_angle.py PATTERN 0*.cpp
        PATTERN pictures EXCLUDE PATTERN verification EXCLUDE)
set(runtime_package rgimp)
set(development_package librgimp-dev)
foreach(component runtime development)
  set(documents ${CMAKE_INSTALL_DATADIR}/doc/${${component}_package})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE RENAME copyright DESTINATION ${documents}
          COMPONENT ${component})
  install(FILES ${compressed}/changelog.gz DESTINATION ${documents} COMPONENT ${component})
endforeach()

include(RgimpPackages)
