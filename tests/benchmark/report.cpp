#include "report.hpp"

#include "text.hpp"

namespace benchmark {
namespace {

uint32_t width_of(uint32_t value) {
  uint32_t width = 1;
  for (; value >= 10; value /= 10) {
    ++width;
  }
  return width;
}

void put_blanks(uint32_t count) {
  for (; count != 0; --count) {
    port::put(" ");
  }
}

void put_left(const char* text, uint32_t width) {
  port::put(text);
  for (; *text != '\0' && width != 0; ++text) {
    --width;
  }
  put_blanks(width);
}

void put_right(uint32_t value, uint32_t width) {
  const uint32_t used = width_of(value);
  put_blanks(width > used ? width - used : 0);
  port::put(value);
}

/// part / whole with `digits` after the point, rounded.
void put_quotient(uint32_t part, uint32_t whole, uint32_t digits, uint32_t width) {
  uint32_t scale = 1;
  for (uint32_t i = 0; i < digits; ++i) {
    scale *= 10;
  }
  const auto scaled = static_cast<uint32_t>((uint64_t{part} * scale + whole / 2) / whole);
  put_right(scaled / scale, width - 1 - digits);
  port::put(".");
  for (uint32_t i = width_of(scaled % scale); i < digits; ++i) {
    port::put("0");
  }
  port::put(scaled % scale);
}

void put_head(const char* kind, const Head& head) {
  port::print(kind, " number=", head.number, " table=", head.table, " title=\"", head.title,
              "\" setup=\"", head.name, "\"");
}

void put_table(const Row (&rows)[kRows]) {
  port::put(
      "algorithm          iterations   overlaps  leaf overlaps  instructions  per iteration"
      "  of volume-stack\n");
  for (const Row& row : rows) {
    put_left(row.algorithm, 18);
    put_right(row.walked.visits, 11);
    put_right(row.walked.overlaps, 11);
    put_right(row.walked.leaf_overlaps, 15);
    put_right(row.walked.instructions, 14);
    put_quotient(row.walked.instructions, row.walked.visits, 1, 15);
    put_quotient(row.walked.instructions, rows[kFirstRow].walked.instructions, 3, 17);
    port::put("\n");
  }
}

void put_row(const Setup& setup, const Row& row) {
  put_head("row", setup.head);
  port::print(" faces_a=", setup.a.faces, " faces_b=", setup.b.faces, " algorithm=", row.algorithm,
              " visits=", row.walked.visits, " overlaps=", row.walked.overlaps,
              " leaf_overlaps=", row.walked.leaf_overlaps);
  port::print(" instructions=", row.walked.instructions, "\n");
}

}  // namespace

void report_setup(const Setup& setup, const Row (&rows)[kRows]) {
  port::print("\nTable ", setup.head.table, ": ", setup.head.title, ". ", setup.head.name, "\n");
  put_table(rows);
  for (const Row& row : rows) {
    put_row(setup, row);
  }
}

void report_query(const Setup& setup, const char* algorithm, const Queried& queried) {
  port::print("Whole query, ", algorithm, ": ", queried.counts.triangle_pairs,
              " geometry overlaps, ", queried.instructions, " instructions\n");
  put_head("query", setup.head);
  port::print(" algorithm=", algorithm, " visits=", queried.counts.visits,
              " leaf_overlaps=", queried.counts.leaf_pairs,
              " geometry_overlaps=", queried.counts.triangle_pairs);
  port::print(" instructions=", queried.instructions, "\n");
}

void report_left_out(const Head& head) {
  put_head("left_out", head);
  port::put("\n");
}

void report_totals(const Row (&sums)[kRows]) {
  port::put("\nAll setups of this image with more than ten iterations\n");
  put_table(sums);
}

}  // namespace benchmark
