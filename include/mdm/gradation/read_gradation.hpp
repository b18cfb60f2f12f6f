#pragma once
/// \file
/// Readers of gradation files.

#include <mdm/gradation/gradation.hpp>

#include <functional>
#include <optional>

namespace mdm {

/// The most bytes that a gradation file may have.
inline constexpr std::size_t max_gradation_bytes = std::size_t{64} << 20;

/// The most sizes that a gradation file may have; it bounds the memory.
inline constexpr std::size_t max_gradation_rows = std::size_t{1} << 20;

/// The two ways to read openings of fractional phi, which are irrational in mm.
enum class PhiReading {
  exact,  ///< as roots of fractions
  rounded ///< to 15 significant digits, with a note; only where the user says so
};

/// Reads a gradation from the content of a file. The format (CSV, JSON or AGS4) is told by the content; the
/// grammar is in proofs/certificate-format.md, section 4. `file` names it in messages and, without
/// directories and ending, as id; the id of AGS4 is the specimen's. `specimen`, for AGS4 only, is the one to
/// read where the file has several: its LOCA_ID, SAMP_* and SPEC_* joined by `/` without the empty ones, or
/// its LOCA_ID where that is enough.
/// \throws InputError `file:line: what is wrong and what to do`
Gradation read_gradation(std::string_view content, const std::string &file,
                         const std::optional<std::string> &specimen = std::nullopt,
                         PhiReading phi = PhiReading::exact);

/// The same of the file with that path.
/// \throws InputError naming the file, also where it cannot be read
Gradation read_gradation_file(const std::string &path,
                              const std::optional<std::string> &specimen = std::nullopt,
                              PhiReading phi = PhiReading::exact);

/// One of the gradations of a file, which is still to be read.
struct UnreadGradation {
  std::string id;
  std::function<Gradation()> read; ///< \throws InputError as read_gradation
};

/// The gradations of a file: of AGS4 all specimens, else one. Several threads may read them.
/// \throws InputError where the file does not say which there are
std::vector<UnreadGradation> gradations_in(std::string content, const std::string &file);

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
