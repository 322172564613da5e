# The Debian packages of `cpack` in a build directory: rgimp and librgimp-dev.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The RGIMP authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "rock fracture with the material point method")
set(CPACK_COMPONENTS_ALL runtime development)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME rgimp)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION science)
set(CPACK_DEBIAN_RUNTIME_DESCRIPTION "The command rgimp, its pictures and reports, and the Python package rgimp:
explicit dynamics in two and three dimensions, in which a crack is the trail
of particles that failed.")
# Shared libraries are found in the programs; Python's extension fits one version of it.
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS
    "python3, python3-numpy, python3-h5py, python3-matplotlib, python3-jinja2")
if(RGIMP_BUILD_PYTHON)
  math(EXPR next "${RGIMP_PYTHON_MINOR} + 1")
  string(APPEND CPACK_DEBIAN_RUNTIME_PACKAGE_DEPENDS
         ", python3 (>= 3.${RGIMP_PYTHON_MINOR}), python3 (<< 3.${next})")
endif()

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME librgimp-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "The C++20 library that the command rgimp is made of: headers, static libraries,
a CMake package and a pkg-config file.")
# Those of a static library's users, see rgimpConfig.cmake.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
    "libeigen3-dev, libtbb-dev, libfmt-dev, libhdf5-dev, libtomlplusplus-dev")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "rgimp")
include(CPack)
