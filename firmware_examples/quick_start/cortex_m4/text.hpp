// Text by semihosting (startup.c), which QEMU and debug probes read; a UART takes its place.
#pragma once

extern "C" void write_text(const char* text);

namespace port {

template <class... Texts>
void print(Texts... texts) {
  (write_text(texts), ...);
}

}  // namespace port
