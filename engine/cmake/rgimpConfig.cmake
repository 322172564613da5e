# find_package(rgimp CONFIG): the target rgimp::engine and what a program links with it.
include(CMakeFindDependencyMacro)

# CMake looks for HDF5 by compiling C, also in projects of C++ alone.
if(NOT CMAKE_C_COMPILER_LOADED)
  enable_language(C)
endif()

find_dependency(Eigen3)
find_dependency(TBB)
find_dependency(fmt)
find_dependency(tomlplusplus)
find_dependency(HDF5 COMPONENTS C)

include(${CMAKE_CURRENT_LIST_DIR}/rgimpTargets.cmake)
