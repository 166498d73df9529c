// What the benchmark prints: tables to read, and lines for results.py:
//     core Cortex-M0
//     row number=0 table=2 title="..." setup="..." algorithm=ranked visits=... instructions=...
//     query number=0 table=2 title="..." setup="..." algorithm=ranked visits=... instructions=...
//     left_out number=14 table=6 title="..." setup="..."
#ifndef FLASHBVH_TESTS_BENCHMARK_REPORT_HPP
#define FLASHBVH_TESTS_BENCHMARK_REPORT_HPP

#include <stdint.h>

#include "measure.hpp"
#include "setups.hpp"

namespace benchmark {

/// A row of a setup, or a sum of rows.
struct Row {
  const char* algorithm;
  Walked walked;
};

constexpr uint32_t kRows = 7;
constexpr uint32_t kFirstRow = 0;  ///< volume-stack, which the others are compared with

void report_setup(const Setup& setup, const Row (&rows)[kRows]);
void report_query(const Setup& setup, const char* algorithm, const Queried& queried);
void report_left_out(const Head& head);
/// Sums over setups of more than ten visits.
void report_totals(const Row (&sums)[kRows]);

}  // namespace benchmark

#endif
