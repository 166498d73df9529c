# The queries of all traversals, compiled once for all tests that run them.
include_guard(GLOBAL)

add_library(flashbvh_test_queries STATIC EXCLUDE_FROM_ALL ${CMAKE_CURRENT_LIST_DIR}/compiled_queries.cpp)
target_include_directories(flashbvh_test_queries PRIVATE ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(flashbvh_test_queries PUBLIC flashbvh::flashbvh)
flashbvh_warnings(flashbvh_test_queries)
if(FLASHBVH_FAST_BUILD)
  target_compile_options(flashbvh_test_queries PRIVATE -O1)
endif()
