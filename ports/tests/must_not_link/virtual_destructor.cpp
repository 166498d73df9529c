namespace {

struct Base {
  virtual ~Base() {}
  virtual int number() const { return 1; }
};

Base object;
Base* volatile base = &object;

}  // namespace

int main() {
  return base->number();
}
