#pragma once
/// \file
/// Readers of gradation files, and what a user says of a file that does not say it itself.

#include <mdm/gradation/gradation.hpp>

#include <cstdint>
#include <functional>
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

/// The most bytes that a gradation file may have.
inline constexpr std::size_t max_gradation_bytes = std::size_t{64} << 20;

/// The most sizes that a gradation file may have; it bounds the memory.
inline constexpr std::size_t max_gradation_rows = std::size_t{1} << 20;

/// A gradation with what was understood of its file.
struct UnderstoodGradation {
  Gradation gradation;
  std::string format;               ///< such as `CSV`
  std::string sizes;                ///< where the sizes stand, such as `column 'Siebweite [mm]', in mm`
  std::string masses;               ///< the same of the masses, with what they are
  std::vector<std::string> samples; ///< of a file with several
  bool is_canonical = true;         ///< the proof checker reads the same gradation from the file as it is
  std::string kind = "mass";        ///< of the masses: the name of the column of canonical CSV that means it
  std::vector<Rational> mass_roundings =
      {}; ///< of shares retained: half a unit of the last digit of each mass
};

/// Reads a gradation from the content of a file. The format (CSV, JSON, AGS4, a workbook, an instrument's) is
/// told by the content. Canonical CSV and JSON, which the proof checker reads too, have the grammar of
/// proofs/certificate-format.md, section 4; a table with other names of columns is read where they are
/// certain or `reading` says what they are. `file` names the file in messages and, without directories and
/// ending, as id; the id of a sample is its own.
/// \throws InputError `file:line: what is wrong and what to do`
UnderstoodGradation understand_gradation(std::string_view content, const std::string &file,
                                         const Reading &reading = {});

/// The gradation alone.
/// \throws InputError as above
Gradation read_gradation(std::string_view content, const std::string &file, const Reading &reading = {});

/// The gradation of the file with that path.
/// \throws InputError naming the file, also where it cannot be read
Gradation read_gradation_file(const std::string &path, const Reading &reading = {});

/// The readings that give the gradations of a file one by one: of AGS4 all specimens where `reading` names
/// none, of a workbook all sheets in which something is written where it names none, else one.
/// \throws InputError where the file does not say which there are
std::vector<Reading> readings_of(std::string_view content, const std::string &file,
                                 const Reading &reading = {});

/// One of the gradations of a file, which is still to be read.
struct UnreadGradation {
  std::string id;
  std::function<Gradation()> read; ///< \throws InputError as read_gradation
};

/// The gradations of a file, as readings_of has them. Several threads may read them.
/// \throws InputError where the file does not say which there are
std::vector<UnreadGradation> gradations_in(std::string content, const std::string &file,
                                           const Reading &reading = {});

/// A gradation of decimals, exactly, as a file has them: gradation_of({"0.075", "0.15", "0.3"}, {"3.6", "9",
/// "0"}).
/// \throws InputError naming the size or mass that is no decimal, or as Gradation
Gradation gradation_of(const std::vector<std::string> &sizes, const std::vector<std::string> &masses,
                       SizeUnit unit = SizeUnit::mm, const std::string &id = "");

/// True if the content is AGS4: a format that the proof checker does not read.
bool is_ags4(std::string_view content);

/// Reads one JSON gradation, for example a line of a suite; `where` precedes messages (`suite.jsonl:7`).
/// The id is `fallback_id` where the object has none. Cost: some 4 microseconds for 8 sizes.
Gradation read_json_gradation(std::string_view content, const std::string &where,
                              const std::string &fallback_id);

/// The id of a JSON gradation that need not be readable otherwise, for error reports; nothing if none is
/// found.
std::optional<std::string> json_gradation_id(std::string_view content);

} // namespace mdm
