// The servo guard on a Raspberry Pi Pico, with its SDK: the host at UART 0 (GP0, GP1), the bus at
// UART 1 (GP4 by a resistor of 1 kOhm to the wire, GP5 at the wire), text by USB.
// Not compiled yet: no machine that tests this folder has the SDK.
#include <hardware/irq.h>
#include <hardware/uart.h>
#include <pico/stdlib.h>

#include "run.hpp"

namespace {

struct Uart {
  Uart(uart_inst_t* which, uint send, uint receive, uint interrupt, void (*handler)())
      : uart(which) {
    uart_init(uart, 1'000'000);
    gpio_set_function(send, GPIO_FUNC_UART);
    gpio_set_function(receive, GPIO_FUNC_UART);
    irq_set_exclusive_handler(interrupt, handler);
    irq_set_enabled(interrupt, true);
    uart_set_irq_enables(uart, true, false);
  }
  bool can_read() const { return !bytes.is_empty(); }
  uint8_t read() { return bytes.take(); }
  bool can_write() const { return uart_is_writable(uart); }
  void write(uint8_t byte) {
    is_sending = true;
    uart_putc_raw(uart, static_cast<char>(byte));
  }
  void interrupt(bool is_deaf) {
    while (uart_is_readable(uart)) {
      const auto byte = static_cast<uint8_t>(uart_getc(uart));
      if (!is_deaf) {
        bytes.put(byte);
      }
    }
  }

  uart_inst_t* uart;
  volatile bool is_sending = false;
  servo::Queue<1024> bytes;
};

struct Usb {
  static bool can_read() { return false; }
  static bool can_write() { return true; }
  static void write(uint8_t byte) { putchar_raw(byte); }
};

struct Board {
  Uart host;
  Uart bus;
  Usb text;

  static uint32_t microseconds() { return time_us_32(); }
  /// The bus is one wire, and hears itself.
  void listen() {
    uart_tx_wait_blocking(bus.uart);
    bus.interrupt(true);
    bus.is_sending = false;
  }
  static void set_led(bool is_on) { gpio_put(PICO_DEFAULT_LED_PIN, is_on); }
  static constexpr servo::Times times = {};
};

Board* board;

}  // namespace

int main() {
  stdio_init_all();
  gpio_init(PICO_DEFAULT_LED_PIN);
  gpio_set_dir(PICO_DEFAULT_LED_PIN, GPIO_OUT);
  static Board all = {{uart0, 0, 1, UART0_IRQ, [] { board->host.interrupt(false); }},
                      {uart1, 4, 5, UART1_IRQ, [] { board->bus.interrupt(board->bus.is_sending); }},
                      {}};
  board = &all;
  servo::run(all);
}
