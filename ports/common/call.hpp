// A call of any function object through one plain function pointer: whatever is measured is then
// called in the same way, and cannot be inlined into the code that measures it.
#pragma once

namespace port {

using Call = void (*)(void* context);

/// Calls the function object at `function`.
template <class Function>
void call_object(void* function) {
  (*static_cast<Function*>(function))();
}

}  // namespace port
