// Reads a program, one block per line: start x y z, end x y z in mm, speed in mm/s. Numbers have at
// most three decimals and are less than 10,000. The reader stores only its position in the text.
#pragma once

#include <stdint.h>

struct Place {
  int32_t axis[3];  ///< in micrometres
};

struct Block {
  Place from;
  Place to;
  int32_t speed;  ///< in micrometres per second

  bool begins_at_end_of(const Block& last) const {
    return from.axis[0] == last.to.axis[0] && from.axis[1] == last.to.axis[1] &&
           from.axis[2] == last.to.axis[2];
  }

  /// In micrometres.
  float length() const {
    float squared = 0;
    for (int i = 0; i < 3; ++i) {
      const auto along = static_cast<float>(to.axis[i] - from.axis[i]);
      squared += along * along;
    }
    return __builtin_sqrtf(squared);
  }

  Place at(float part) const {
    Place place = from;
    for (int i = 0; i < 3; ++i) {
      place.axis[i] += static_cast<int32_t>(static_cast<float>(to.axis[i] - from.axis[i]) * part);
    }
    return place;
  }
};

class ProgramText {
 public:
  ProgramText(const char* begin, const char* end) : at_(begin), end_(end) {}

  /// The number of lines that reading has begun.
  unsigned line() const { return line_; }
  bool is_at_end() const { return at_ == end_; }

  /// Reads the next line's block; false if the line is not a block or its speed is 0.
  bool read(Block& block) {
    ++line_;
    return read_place(block.from) && read_place(block.to) && read_number(block.speed) &&
           block.speed > 0 && read_end();
  }

 private:
  char next() const { return at_ == end_ ? '\n' : *at_; }
  bool is_blank() const { return next() == ' ' || next() == '\t' || next() == '\r'; }

  void skip_blanks() {
    while (is_blank()) {
      ++at_;
    }
  }

  bool read_end() {
    skip_blanks();
    const bool is_end = next() == '\n';
    at_ += at_ == end_ ? 0 : 1;
    return is_end;
  }

  /// Appends digits to `number`; returns how many it read.
  int read_digits(int32_t& number, int most) {
    int count = 0;
    for (; count < most && next() >= '0' && next() <= '9'; ++count, ++at_) {
      number = 10 * number + (*at_ - '0');
    }
    return count;
  }

  /// Reads a number, times 1,000.
  bool read_number(int32_t& number) {
    skip_blanks();
    const bool is_negative = next() == '-';
    at_ += is_negative ? 1 : 0;
    number = 0;
    const int whole = read_digits(number, 4);
    int decimals = 0;
    if (whole != 0 && next() == '.') {
      ++at_;
      decimals = read_digits(number, 3);
    }
    for (; decimals < 3; ++decimals) {
      number *= 10;
    }
    number = is_negative ? -number : number;
    return whole != 0 && (is_blank() || next() == '\n');
  }

  bool read_place(Place& place) {
    int axis = 0;
    while (axis < 3 && read_number(place.axis[axis])) {
      ++axis;
    }
    return axis == 3;
  }

  const char* at_;
  const char* end_;
  unsigned line_ = 0;
};
