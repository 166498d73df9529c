# The golden images as a library, and the common checks of queries on any image.
include_guard(GLOBAL)
set(embedded ${CMAKE_CURRENT_BINARY_DIR}/kept_images.cpp)
file(GLOB kept CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*.fbvh)
add_custom_command(OUTPUT ${embedded}
  COMMAND ${CMAKE_COMMAND} -DFOLDER=${CMAKE_CURRENT_LIST_DIR} -DOUT=${embedded}
    -P ${CMAKE_CURRENT_LIST_DIR}/embed.cmake
  DEPENDS ${CMAKE_CURRENT_LIST_DIR}/embed.cmake ${kept}
  VERBATIM)
include(${CMAKE_CURRENT_LIST_DIR}/../../tools/rooms.cmake)
flashbvh_need_room(bake)
include(${CMAKE_CURRENT_LIST_DIR}/../support/queries.cmake)
add_library(flashbvh_kept_images STATIC EXCLUDE_FROM_ALL ${embedded} ${CMAKE_CURRENT_LIST_DIR}/exercise.cpp)
target_include_directories(flashbvh_kept_images PUBLIC ${CMAKE_CURRENT_LIST_DIR}/..)
target_link_libraries(flashbvh_kept_images PUBLIC flashbvh_bake flashbvh_test_queries)
flashbvh_warnings(flashbvh_kept_images)
