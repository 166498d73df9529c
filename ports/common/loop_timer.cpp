// timer.hpp with a loop in place of a timer.
#include "timer.hpp"

#include "counter.hpp"

namespace port {

TaskTime run_task(uint32_t instructions_a_period, Task task, void* context) {
  struct OneCall {
    Task task;
    void* context;
    bool is_done;
  } one = {task, context, false};
  TaskTime time = {};
  while (!one.is_done) {
    const uint32_t took = counted(
        [](void* of) {
          auto* const call = static_cast<OneCall*>(of);
          call->task(call->context, &call->is_done);
        },
        &one);
    ++time.periods;
    if (took > instructions_a_period) {
      ++time.late;
    } else {
      time.most = took > time.most ? took : time.most;
      time.instructions += took;
    }
  }
  return time;
}

}  // namespace port
