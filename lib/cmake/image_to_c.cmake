# cmake -DIMAGE=path/stem.fbvh -DSOURCE=stem.fbvh.c -DHEADER=stem.fbvh.h -P image_to_c.cmake
#
# A baked image as a constant array of C, <stem>_image, aligned as flashbvh_open() wants it. Words,
# not bytes: the array is read on cores that are little-endian, as the image is.
get_filename_component(stem ${IMAGE} NAME_WLE)
get_filename_component(header_name ${HEADER} NAME)
string(MAKE_C_IDENTIFIER ${stem} identifier)
string(TOUPPER FLASHBVH_BAKED_${identifier}_H guard)
file(READ ${IMAGE} words HEX)
string(LENGTH "${words}" digits)
math(EXPR count "${digits} / 8")
math(EXPR rest "${digits} % 8")
if(count EQUAL 0 OR NOT rest EQUAL 0)
  message(FATAL_ERROR "${IMAGE} is no image: its size is not a multiple of 4 bytes")
endif()
string(REGEX REPLACE "(..)(..)(..)(..)" "0x\\4\\3\\2\\1," words "${words}")
string(REPEAT "0x........," 8 line)
string(REGEX REPLACE "(${line})" "\\1\n" words "${words}")
string(REPLACE ",0x" ", 0x" words "${words}")
string(REGEX REPLACE "\n$" "" words "${words}")

file(WRITE ${HEADER} "/* Made of ${stem}.fbvh. */
#ifndef ${guard}
#define ${guard}

#include <stdint.h>

#ifdef __cplusplus
extern \"C\" {
#endif

extern const uint32_t ${identifier}_image[${count}];

#ifdef __cplusplus
}
#endif

#endif
")
file(WRITE ${SOURCE} "/* Made of ${stem}.fbvh. */
#include \"${header_name}\"

const uint32_t ${identifier}_image[${count}] = {
${words}
};
")
