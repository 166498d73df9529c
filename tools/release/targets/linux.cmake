# Toolchain file: this machine's Linux, linked statically.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static -s")
