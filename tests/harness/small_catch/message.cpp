#include "message.hpp"

namespace small_catch {
namespace {

const Message* innermost = nullptr;

}  // namespace

Message::Message(Put put) : outer_(innermost), put_(put) {
  innermost = this;
}

Message::~Message() {
  innermost = outer_;
}

void put_messages() {
  for (const Message* message = innermost; message != nullptr; message = message->outer_) {
    message->put_(*message);
  }
}

}  // namespace small_catch
