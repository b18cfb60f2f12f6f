#pragma once

#include <mdm/checker.hpp>

#include <gmpxx.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace mdm::checker {

/// Particles of a sample, each of a size whose N-th power is from lo to hi, above lo if that is open; in the
/// gradation's unit.
struct SampleRow {
  mpq_class lo, hi;
  mpz_class quantity = 1;
  bool is_open = false;
};

/// Reads a sample file (section 12) row by row: memory is that of a line. Throws Malformed, which has no
/// place; line() is that of the file.
class SampleReader {
public:
  /// Reads the header. \param unit  the gradation's: mm, um or m
  SampleReader(Pieces pieces, const std::string &unit);

  /// N of the header; 1 where sizes are no powers.
  unsigned long power() const { return power_; }
  /// The next row; false at the end.
  bool next(SampleRow &row);
  /// The number of the line that was read last.
  std::uint64_t line() const { return line_; }

private:
  bool next_line();
  void read_header(const std::string &unit);
  mpq_class size(std::string_view text) const;

  Pieces pieces_;
  std::string_view piece_;
  std::string text_; ///< the line
  std::uint64_t line_ = 0;
  bool has_range_ = false, has_quantity_ = false;
  unsigned long power_ = 1;
  mpq_class factor_ = 1; ///< of what is read to the gradation's unit
};

} // namespace mdm::checker
