# FLASHBVH_HAS_PYTHON: true if pybind11, numpy and Python's headers exist.
#
# Prefers Debian's Python, for which Debian has pybind11 and numpy, to another one in PATH;
# -DPython3_EXECUTABLE selects another one.
if(NOT DEFINED Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3 CACHE FILEPATH "the Python that the package is built for")
endif()
find_package(Python3 QUIET COMPONENTS Interpreter Development.Module NumPy)
find_package(pybind11 QUIET)
set(FLASHBVH_HAS_PYTHON OFF)
if(Python3_Development.Module_FOUND AND Python3_NumPy_FOUND AND pybind11_FOUND)
  set(FLASHBVH_HAS_PYTHON ON)
  set(FLASHBVH_PYTHON ${Python3_EXECUTABLE} CACHE INTERNAL "")  # for the tests
else()
  message(STATUS "No Python package: apt-get install python3-dev pybind11-dev python3-numpy")
endif()
