// Prints text by semihosting (startup.c), which QEMU and debug probes read. Use a UART instead.
#pragma once

extern "C" void write_text(const char* text);

namespace port {

template <class... Texts>
void print(Texts... texts) {
  (write_text(texts), ...);
}

}  // namespace port
