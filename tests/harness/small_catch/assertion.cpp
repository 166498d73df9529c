#include "assertion.hpp"

#include "message.hpp"
#include "test_case.hpp"

namespace small_catch {
namespace {

unsigned failure_count = 0;

void put_head(const Site& site) {
  ++failure_count;
  port::print(site.file, ":", site.line, ": failed in \"", running_test(), "\"\n  ", site.macro,
              "( ", site.expression, " )\n");
}

}  // namespace

void report(const Site& site, const AnyValue& left, const char* comparison, const AnyValue& right) {
  put_head(site);
  port::put("  with ");
  left.put(left.address);
  port::put(comparison);
  right.put(right.address);
  port::put("\n");
  put_messages();
}

void report(const Site& site, const AnyValue& value) {
  put_head(site);
  port::put("  with ");
  value.put(value.address);
  port::put("\n");
  put_messages();
}

void report(const Site& site) {
  put_head(site);
  put_messages();
}

unsigned failures() {
  return failure_count;
}

}  // namespace small_catch
