#include "report.hpp"

#include "text.hpp"

namespace figures {
namespace {

#if defined(FLASHBVH_CORE)
constexpr const char* kCore = FLASHBVH_CORE;
#else
constexpr const char* kCore = nullptr;
#endif

void put_name(const char* kind, const Name& name) {
  port::put(kind);
  const char* before = " ";
  for (const char* word : name.word) {
    if (word != nullptr) {
      port::print(before, word);
      before = ".";
    }
  }
  port::put(" ");
}

/// The name with one word more.
Name with(Name name, const char* last) {
  for (const char*& word : name.word) {
    if (word == nullptr) {
      word = last;
      break;
    }
  }
  return name;
}

}  // namespace

void print_core() {
  if (kCore != nullptr) {
    port::print("core ", kCore, "\n");
  }
}

void print_count(const Name& name, uint32_t value) {
  put_name("count", name);
  port::print(value, "\n");
}

void print_figure(const Name& name, uint32_t value) {
  if (kCore != nullptr) {
    put_name("figure", name);
    port::print(value, "\n");
  }
}

void print_quotient(const Name& name, uint64_t part, uint64_t whole) {
  if (kCore == nullptr || whole == 0) {
    return;
  }
  const auto hundredths = static_cast<uint32_t>((part * 100 + whole / 2) / whole);
  put_name("figure", name);
  port::print(hundredths / 100, hundredths % 100 < 10 ? ".0" : ".", hundredths % 100, "\n");
}

void print_counts(Name name, const Spread& spread) {
  print_count(with(name, "mean"), spread.mean());
  print_count(with(name, "max"), spread.most());
}

void print_figures(Name name, const Spread& spread) {
  print_figure(with(name, "mean"), spread.mean());
  print_figure(with(name, "max"), spread.most());
}

}  // namespace figures
