/* Start-up of a Cortex-M4F: vectors, FPU, .data, .bss, constructors; main()'s status ends QEMU. */
#include <stdint.h>

extern uint32_t data_load[], data_start[], data_end[], bss_start[], bss_end[], stack_top[];
extern void (*constructors_start[])(void);
extern void (*constructors_end[])(void);
int main(void);
void write_text(const char* text);
void reset(void);
void initialise_monitor_handles(void) __attribute__((weak)); /* newlib's, for printf() */

/* Arm, "Semihosting for AArch32 and AArch64": a debug probe or QEMU answers the breakpoint. */
static void call_host(uint32_t call, const void* argument) {
  register uint32_t r0 __asm__("r0") = call;
  register const void* r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

void write_text(const char* text) {
  call_host(0x04, text); /* SYS_WRITE0 */
}

static void end(uint32_t status) {
  const uint32_t block[] = {0x20026, status}; /* ADP_Stopped_ApplicationExit */
  call_host(0x20, block);                     /* SYS_EXIT_EXTENDED */
  for (;;) {
  }
}

static void fault(void) {
  write_text("fault\n");
  end(123);
}

void reset(void) {
  *(volatile uint32_t*)0xE000ED88 |= 0xFu << 20; /* CPACR: the FPU on */
  __asm__ volatile("dsb\n isb" ::: "memory");
  for (uint32_t *from = data_load, *to = data_start; to < data_end;) {
    *to++ = *from++;
  }
  for (uint32_t* to = bss_start; to < bss_end;) {
    *to++ = 0;
  }
  if (initialise_monitor_handles) {
    initialise_monitor_handles();
  }
  for (void (**constructor)(void) = constructors_start; constructor < constructors_end;) {
    (*constructor++)();
  }
  end((uint32_t)main());
}

/* The core's own exceptions; interrupts of peripherals follow these. */
__attribute__((section(".vectors"), used)) static const struct {
  uint32_t* stack;
  void (*handlers[15])(void);
} vectors = {stack_top,
             {reset, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, fault, 0, fault, fault}};
