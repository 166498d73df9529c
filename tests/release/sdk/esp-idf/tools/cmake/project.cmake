# ESP-IDF's project(), by its documents: the components, and the code that calls app_main(). Links SOURCES, which start
# a program in QEMU.
macro(project name)
  _project(${name} C CXX)
  add_library(machine INTERFACE)
  set(PACKAGE ${EXTRA_COMPONENT_DIRS}/flashbvh)
  include($ENV{IDF_PATH}/../../firmware/esp-idf.cmake)
  add_subdirectory(main)
  add_executable(${name} $ENV{IDF_PATH}/start.c ${SOURCES})
  target_include_directories(${name} PRIVATE ${INCLUDES})
  target_link_libraries(${name} __idf_main)
endmacro()
