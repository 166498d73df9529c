# The library for WebAssembly, without imports, by Clang. FLASHBVH_HAS_WASM: true if it can be built here.
include_guard()
find_program(FLASHBVH_WASM_COMPILER clang++)
find_program(FLASHBVH_WASM_OPT wasm-opt)
set(FLASHBVH_HAS_WASM OFF)
if(FLASHBVH_WASM_COMPILER AND EXISTS /usr/lib/wasm32-wasi/libc.a)
  set(FLASHBVH_HAS_WASM ON)
endif()

# flashbvh_wasm(module SOURCES source... [EXPORTS function...]): makes the file `module` in the calling folder's build
# folder. It compiles the library and the sources as one source, for size. The module exports functions marked in the
# sources and the C functions in EXPORTS. Without wasm-opt, from Debian's binaryen, it is a sixth larger.
function(flashbvh_wasm module)
  cmake_parse_arguments(arg "" "" "SOURCES;EXPORTS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${FLASHBVH_SOURCE_DIR}/lib/src/*/*.cpp)
  list(APPEND sources ${arg_SOURCES})
  list(TRANSFORM sources REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE includes)
  list(JOIN includes "" includes)
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${module}.cpp CONTENT "${includes}")
  list(TRANSFORM arg_EXPORTS PREPEND -Wl,--export= OUTPUT_VARIABLE exports)
  set(compile ${FLASHBVH_WASM_COMPILER} --target=wasm32-wasi)
  set(optimise "")
  if(FLASHBVH_WASM_OPT)
    # Chosen by measurement: more inlining makes the compressed module larger.
    set(optimise COMMAND ${FLASHBVH_WASM_OPT} --enable-bulk-memory --enable-sign-ext -Oz -Oz --low-memory-unused
      --one-caller-inline-max-function-size=60 --always-inline-max-function-size=6 ${module} -o ${module})
  endif()
  # Links without -O, because Clang would call wasm-opt in its own way. The portable forms need no 128-bit integers.
  add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${module} VERBATIM
    COMMAND ${compile} -Oz -mllvm -inline-threshold=-15 -mllvm -disable-lsr -mbulk-memory -msign-ext -std=c++17
      -fno-exceptions -fno-rtti -fvisibility=hidden -DNDEBUG -DFLASHBVH_PORTABLE -DFLASHBVH_INLINE=
      -I${FLASHBVH_SOURCE_DIR}/lib/include -c ${module}.cpp -o ${module}.o -MD -MF ${module}.d -MT ${CMAKE_CURRENT_BINARY_DIR}/${module}
    COMMAND ${compile} -nostartfiles -nostdlib++ ${exports}
      -Wl,--no-entry,--export-dynamic,--export=__heap_base,--gc-sections,--stack-first,-z,stack-size=32768,--strip-all
      ${module}.o -o ${module}
    ${optimise}
    DEPENDS ${sources} ${CMAKE_CURRENT_BINARY_DIR}/${module}.cpp DEPFILE ${module}.d
    WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} COMMENT "Compiling flashbvh for WebAssembly")
endfunction()
