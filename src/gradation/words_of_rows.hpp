#pragma once
/// \file
/// Rows of words behind the first sieve of a table: what may follow them.

#include "gradation/cells.hpp"

#include <string>
#include <vector>

namespace mdm {

/// The rows of words that were met since the header. They must outlive the object.
class WordsOfRows {
public:
  /// A row below a gap that is none of the table, or one that names a sample.
  void add_below(const CellRow &row) { below_.push_back(&row); }
  /// A row behind a sieve, with no gap above it.
  void add_among(const CellRow &row) { among_ = &row; }

  /// Words that another row of the table follows may head a part of it, or be a sieve that is not known.
  /// \throws InputError with their line
  void check_among(const Source &source) const;
  /// A sieve's row below words may be of another table.
  /// \throws InputError with its line
  void check_sieve(const CellRow &row, std::string_view size, const Source &source) const;

  /// The words that a second header stands below; empty where there are none but the number of a page.
  std::string_view between_tables() const;
  /// True where words below a gap speak of a sample, or of a part of one.
  bool are_of_others() const;

private:
  std::vector<const CellRow *> below_;
  const CellRow *among_ = nullptr;
};

/// `Sample B`, `BH 2`.
bool names_sample(std::string_view cell);

} // namespace mdm
