#pragma once
/// \file
/// What a user says of a gradation file that does not say it itself.

#include <mdm/number/rational.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace mdm {

/// The two ways to read openings of fractional phi, which are irrational in mm.
enum class PhiReading {
  exact,  ///< as roots of fractions
  rounded ///< to 15 significant digits, with a note; only where the user says so
};

/// The options of reading a gradation; without any of them the file alone says what it is.
struct Reading {
  /// The sample of a file with several. In AGS4 it is LOCA_ID, SAMP_* and SPEC_* joined by `/` without the
  /// empty ones, or LOCA_ID, SAMP_ID or SAMP_REF where that is enough.
  std::optional<std::string> specimen = {};
  PhiReading phi = PhiReading::exact;
  std::optional<std::string> columns = {}; ///< `SIZE,VALUE`: names, or numbers from 1 on
  std::optional<std::string> kind = {}; ///< passing, retained, cumulative, or the name of a canonical column
  std::optional<std::string> unit = {}; ///< mm, um, m, in, phi or sieve
  std::optional<std::uint64_t> skip = {}; ///< lines (of a workbook: rows) above the table
  std::optional<std::string> sheet = {};  ///< of a workbook
  std::optional<unsigned> round = {};     ///< significant digits of all masses, at least 1
  /// Percent of a sheet's initial mass that its rows may lack, or exceed; 1 where it is not said
  std::optional<Rational> loss = {};

  /// True where the user says how a table is to be understood.
  bool describes_table() const { return columns || kind || unit || skip || loss; }
};

} // namespace mdm
