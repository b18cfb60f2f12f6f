#pragma once

#include "certificate.hpp"
#include "certificate_lines.hpp"

namespace mdm::checker {

/// Lines `class` of a certificate, a third of the numbers of its bands (limit 5).
constexpr std::size_t most_classes = std::size_t{1} << 20U;

/// The lines of a certificate that has numbers of section 1.
class QuestionLines : public CertificateLines {
public:
  using CertificateLines::CertificateLines;

  /// The bits of the longest number so far that the limits 1 and 2 count.
  std::uint64_t longest_count() const { return longest_count_; }

  /// Reads a line: its name and a number of each kind, which may repeat. The kind `f` is the word `file`.
  void read(std::string_view name, std::string_view kinds, Numbers &numbers, bool repeat = false);
  /// The same if the line is there.
  void read_if_there(std::string_view name, std::string_view kinds, Numbers &numbers, bool repeat = false);

  /// `0`, `1` and `2` are integers from 0, 1 and 2 up, `d` is a decimal above 0, `z` one from 0 up, `p` one
  /// from 0 to 100, `t` one to 200, `r` a rational above 0, `q` one from 0 up. The limits 1 and 2 count what
  /// a digit or a capital stands for.
  Number number(char kind) { return number(kind, word()); }
  Number number(char kind, std::string_view text);
  mpz_class integer() { return number('1').value.get_num(); }
  std::uint64_t index() { return index(word()); }

protected:
  std::uint64_t index(std::string_view text) const;

private:
  std::uint64_t longest_count_ = 0;
};

/// Nodes of a law by table and terms of a law by sum.
constexpr std::size_t most_nodes = 1000, most_terms = 16;
/// What a value of a law by table counts in the limits 1 and 2: it is made of a size and two nodes.
constexpr std::uint64_t work_of_table = 5;

/// Reads the lines from `law` to `size-factor`.
void read_law_and_openings(QuestionLines &lines, Certificate &c);

/// Reads the lines from `retained` to `band`. Returns whether there is a tolerance.
bool read_tolerance(QuestionLines &lines, Certificate &c);

} // namespace mdm::checker
