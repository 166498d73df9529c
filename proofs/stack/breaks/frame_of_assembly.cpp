// A frame that the compiler does not know, as in lib/src/arch/dsp.
__attribute__((naked, noinline)) void hidden() {
#if defined(__riscv)
  __asm__("addi sp, sp, -48\n addi sp, sp, 48\n ret");
#else
  __asm__("push {r4, r5, r6, r7, lr}\n pop {r4, r5, r6, r7, pc}");
#endif
}

int main() {
  hidden();
  return 0;
}
