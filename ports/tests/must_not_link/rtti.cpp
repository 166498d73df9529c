#include <typeinfo>

namespace {

struct Base {
  virtual int number() const { return 1; }
};

struct Derived : Base {
  int number() const override { return 2; }
};

Derived derived;
Base* volatile base = &derived;

}  // namespace

int main() {
  const Base& object = *base;
  return typeid(object) == typeid(Derived) ? 0 : 1;
}
