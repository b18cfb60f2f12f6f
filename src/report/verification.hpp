#pragma once
/// \file
/// Whether a sample matches a gradation, as text, JSON and CSV.

#include "gradation/description.hpp"
#include "match/smallest_match.hpp"
#include "packing/sphere_texture.hpp"

#include <mdm/match/solve.hpp>
#include <mdm/match/tolerance.hpp>

namespace mdm {

/// The conditions that decide whether a sample matches.
enum class Verdict {
  match,    ///< no particle lies outside all classes, and every share is within the tolerance and the bounds
  no_match, ///< the contrary
  undecided ///< a share of which an enclosure is known, which does not tell
};

/// `match`, `no match` or `undecided`.
const char *name(Verdict verdict);

/// A sample beside its gradation.
struct Verification {
  /// \param asked  what d's gradation and law are; for the report
  /// \param most_error  the tolerance
  Verification(Description d, Question asked, Rational most_error);

  Description description;
  MatchError error;
  Question question;
  Rational tolerance;                   ///< greatest error of a share that is allowed, of 1; 1: any
  Tolerance bounds;                     ///< on the shares, besides
  std::string within;                   ///< all that is allowed, in words, where there are bounds besides
  SmallestMatch smallest;               ///< N of the smallest exact match
  std::string sample;                   ///< name, for the report
  unsigned digits = 6;                  ///< significant digits of percents
  std::optional<SphereTexture> packing; ///< what places say, where that was asked
  std::vector<std::string> objections;  ///< other reasons why the sample is not what it claims to be
  std::vector<std::string> notes;

  Verdict verdict() const;
};

/// One line of JSON, schema `mdm-verify-1`, without a newline at its end. Exact numbers are strings `p/q`;
/// enclosures of irrational ones are pairs of decimals. `error` of a class is target minus found.
std::string verification_json(const Verification &v);

/// lower_<unit>,upper_<unit>,quantity,target_percent,found_percent,error_percent: a row a class. The error is
/// target minus found. Percents are cut to `digits` significant digits.
std::string verification_csv(const Verification &v);

/// The verdict in one line.
std::string headline(const Verification &v);

/// For people.
std::string verification_text(const Verification &v);

} // namespace mdm
