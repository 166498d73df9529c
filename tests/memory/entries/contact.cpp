// contact_of() of two placed triangles.
#include "flashbvh/contact.hpp"
#include "memory/arguments.hpp"

using namespace flashbvh;

extern "C" void contact(void* arguments) {
  auto& in = *static_cast<memory::Arguments*>(arguments);
  new (MemoryPlace{&in.contact}) Contact(contact_of(in.triangles[0], in.triangles[1]));
}
