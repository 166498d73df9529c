// INFO and CAPTURE: what a failed assertion tells besides, for as long as their scope lasts.
#ifndef FLASHBVH_SMALL_CATCH_MESSAGE_HPP
#define FLASHBVH_SMALL_CATCH_MESSAGE_HPP

#include "value.hpp"

namespace small_catch {

/// A line in the list of all that are alive, which lies on the stack.
class Message {
 public:
  using Put = void (*)(const Message& message);

  explicit Message(Put put);
  ~Message();
  Message(const Message&) = delete;
  Message& operator=(const Message&) = delete;

 private:
  friend void put_messages();

  const Message* const outer_;
  const Put put_;
};

/// A line each, the innermost first.
void put_messages();

class Info : public Message {
 public:
  explicit Info(const char* text) : Message(put), text_(text) {}

 private:
  static void put(const Message& message) {
    port::print("  ", static_cast<const Info&>(message).text_, "\n");
  }

  const char* text_;
};

/// A copy of a value; of a class, of which nothing would be printed, none.
template <class Type, bool is_class = __is_class(Type) || __is_union(Type)>
struct Kept {
  explicit Kept(const Type& original) : value(original) {}
  Type value;
};
template <class Type>
struct Kept<Type, true> {
  explicit Kept(const Type&) {}
};

template <class Type>
class Captured : public Message {
 public:
  Captured(const char* name, const Type& value) : Message(put), name_(name), kept_(value) {}

 private:
  static void put(const Message& message) {
    const auto& self = static_cast<const Captured&>(message);
    port::print("  ", self.name_, " := ");
    put_any<Type>(&self.kept_);
    port::put("\n");
  }

  const char* name_;
  Kept<Type> kept_;
};

/// An array is captured by its address.
template <class Type>
Captured(const char*, const Type&) -> Captured<Type>;
template <class Element, size_t count>
Captured(const char*, const Element (&)[count]) -> Captured<const Element*>;

}  // namespace small_catch

#endif
