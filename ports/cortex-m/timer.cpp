// SysTick as the timer of timer.hpp.
#include "timer.hpp"

#include "systick.hpp"

namespace port {
namespace {

struct Running {
  Task task;
  void* context;
  TaskTime time;
  volatile bool is_done;
};

Running running;

constexpr uint32_t instructions_of_ticks(uint32_t ticks) {
  return static_cast<uint32_t>((uint64_t{ticks} * 1000000 / FLASHBVH_CLOCK_KHZ) >>
                               FLASHBVH_ICOUNT_SHIFT);
}

}  // namespace

extern "C" void SysTick_Handler() {
  (void)systick().control;  // clears kHasWrapped
  bool is_done = false;
  running.task(running.context, &is_done);
  const uint32_t took = instructions_of_ticks(systick().reload - systick().current);
  TaskTime& time = running.time;
  ++time.periods;
  if ((systick().control & kHasWrapped) != 0) {
    ++time.late;
  } else {
    time.most = took > time.most ? took : time.most;
    time.instructions += took;
  }
  if (is_done) {
    systick().control = kStop;
    forget_tick();
    running.is_done = true;
  }
}

TaskTime run_task(uint32_t instructions_a_period, Task task, void* context) {
  const uint64_t nanoseconds = uint64_t{instructions_a_period} << FLASHBVH_ICOUNT_SHIFT;
  running = {task, context, {}, false};
  systick().control = kStop;
  systick().reload = static_cast<uint32_t>(nanoseconds * FLASHBVH_CLOCK_KHZ / 1000000) - 1;
  systick().current = 0;
  systick().control = kCount;
  while (!running.is_done) {
    __asm__ volatile("wfi");
  }
  return running.time;
}

}  // namespace port
