# Reports the conditions of the guard that guard_test sees both ways. It compiles the guard's sources into the test,
# in place of the library's objects, with Clang's count of each condition.
file(GLOB guarded CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/lib/src/robot/*.cpp)
list(FILTER guarded EXCLUDE REGEX "/(image|motion|robot_check|workcell)[.]cpp$")
set_source_files_properties(${guarded} PROPERTIES
  COMPILE_OPTIONS "-O0;-fprofile-instr-generate;-fcoverage-mapping"
  SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
target_sources(guard_test PRIVATE ${guarded})
target_link_options(guard_test PRIVATE -fprofile-instr-generate)

set(profile ${CMAKE_CURRENT_BINARY_DIR}/guard.profraw)
set(name "${FLASHBVH_TEST_PREFIX}/guard_test")
set_tests_properties(${name} PROPERTIES FIXTURES_SETUP guard_profile)
set_property(TEST ${name} APPEND PROPERTY ENVIRONMENT LLVM_PROFILE_FILE=${profile})
set(name "${FLASHBVH_TEST_PREFIX}/guard_test: conditions")
add_test(NAME ${name} COMMAND python3 -B ${CMAKE_CURRENT_SOURCE_DIR}/conditions.py
  $<TARGET_FILE:guard_test> ${profile} ${CMAKE_CURRENT_SOURCE_DIR}/conditions.txt)
set_tests_properties(${name} PROPERTIES FIXTURES_REQUIRED guard_profile LABELS long)
