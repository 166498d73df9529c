// A text file as lines of words.
#ifndef FLASHBVH_TOOLS_TEXT_TOKENS_HPP
#define FLASHBVH_TOOLS_TEXT_TOKENS_HPP

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace flashbvh::tool {

/// Letters of ASCII alone, in any locale.
std::string lower_case(std::string_view text);

/// The words between blanks.
std::vector<std::string_view> words_of(std::string_view line);

/// Goes through a text line by line. LF, CR LF and CR end a line.
class Lines {
 public:
  /// `text` must outlive the object.
  explicit Lines(std::string_view text) : rest_(text) {}

  /// Moves to the next line; false after the last.
  bool next();
  /// The same past lines that are empty or hold only a comment; a '#' ends a line.
  bool next_content();

  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }   ///< from 1
  std::string_view rest() const { return rest_; }  ///< what lies after the line

 private:
  std::string_view rest_;
  std::string_view line_;
  std::size_t number_ = 0;
};

}  // namespace flashbvh::tool

#endif
