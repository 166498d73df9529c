# Catch2 as the harness, natively and on the boards that it fits.
if(CMAKE_CROSSCOMPILING)
  # The host's include folder must not come into a cross build; only catch2/ in it may.
  get_target_property(host_headers Catch2::Catch2 INTERFACE_INCLUDE_DIRECTORIES)
  set(catch_headers ${CMAKE_CURRENT_BINARY_DIR}/catch2-headers)
  file(MAKE_DIRECTORY ${catch_headers})
  file(CREATE_LINK ${host_headers}/catch2 ${catch_headers}/catch2 SYMBOLIC)
  target_include_directories(flashbvh_harness_options SYSTEM INTERFACE ${catch_headers})
  target_compile_definitions(flashbvh_harness_options INTERFACE
    CATCH_CONFIG_NO_POSIX_SIGNALS CATCH_CONFIG_DISABLE_EXCEPTIONS_CUSTOM_HANDLER)
  target_link_libraries(flashbvh_harness_options INTERFACE flashbvh_hosted)
else()
  target_link_libraries(flashbvh_harness_options INTERFACE Catch2::Catch2)
endif()

target_sources(flashbvh_harness PRIVATE main.cpp)
# Catch2 itself takes a minute or more to optimise, and on a board it has to be small.
set_source_files_properties(main.cpp PROPERTIES
  COMPILE_OPTIONS "-g0;$<IF:$<BOOL:${CMAKE_CROSSCOMPILING}>,-Os,-O0>")
