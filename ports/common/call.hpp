// Calls any function object through a plain function pointer. So all measured code is called in one
// way, and cannot be inlined into the code that measures it.
#pragma once

namespace port {

using Call = void (*)(void* context);

/// Calls the function object at `function`.
template <class Function>
void call_object(void* function) {
  (*static_cast<Function*>(function))();
}

}  // namespace port
