#pragma once
/// \file
/// The distance that a sample's shares may have from those of a gradation.

#include <mdm/gradation/envelope.hpp>
#include <mdm/gradation/gradation.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// A tolerance as a user asks for it; percentages are percentage points of the sample's own mass.
struct AskedTolerance {
  enum class Kind {
    retained,      ///< the share of each class within `percent` (maximum norm)
    passing,       ///< what passes each sieve within `percent`
    total,         ///< the sum of the shares' deviations up to `percent` (1-norm)
    retained_file, ///< the share retained on each sieve within the file's tolerance_percent
    passing_file,  ///< what passes each sieve within the file's tolerance_percent
    laboratory,    ///< what passes, X, within the reproducibility of sieve tests, 0.05 sqrt(X (100 - X))
    rounding       ///< what passes within half a unit of the last digit that the file has
  };
  Kind kind = Kind::retained;
  Rational percent = 0;

  bool operator==(const AskedTolerance &) const = default;
};

/// Reads `retained:1%`, `passing:0.5%`, `total:1%`, `retained:file`, `passing:file`, `laboratory` or
/// `rounding`. The sign may be left out, and `retained:` too: `1`, `file`.
/// \throws InputError for anything else, and for less than 0% or more than 100%, of total 200%
AskedTolerance parse_tolerance(std::string_view text);

/// `retained:1%` and so on.
std::string to_string(const AskedTolerance &asked);

/// lo <= share <= hi, both closed, lo >= 0, hi <= 1; lo > hi cannot be met.
struct ShareBounds {
  Rational lo = 0;
  Rational hi = 1;

  bool is_point() const { return lo == hi; }
};

/// The bounds on the shares t_j / M of a sample with mass t_j in class j and M = t_1 + ... + t_k. Of each
/// kind there is none (empty) or one entry a class.
struct Tolerance {
  std::vector<ShareBounds> retained; ///< of t_j / M
  std::vector<ShareBounds> passing;  ///< of (t_1 + ... + t_j) / M, what passes the upper sieve of class j
  std::optional<Rational> total;     ///< most that sum |t_j / M - g_j| may be
};

/// The bounds that are asked for around the shares of g, its sizes already multiplied by `size_factor`.
/// Laboratory tolerances are rounded outwards to 6 digits after the point.
/// \throws InputError where g does not have what they need: a column of tolerances, values of what passes with
/// their last digits, or a sieve of the envelope
Tolerance tolerance_of(const Gradation &g, const std::vector<AskedTolerance> &asked,
                       const std::optional<Envelope> &envelope, const Rational &size_factor);

/// The tolerance on what passes, in percentage points, of each sieve from the second on to the last but one,
/// as `laboratory` and `rounding` make it.
std::vector<Rational> passing_tolerances(const Gradation &g, AskedTolerance::Kind kind);

/// The gradation in the middle of an envelope, of which no sample is farther than it must be; where the
/// envelope contradicts itself, that of its lower bounds. With a pan of size 0 where something passes the
/// finest sieve.
/// \throws InputError if the envelope does not let all pass its largest sieve
Gradation middle_of(const Envelope &envelope);

/// g_j = m_j / sum m.
std::vector<Rational> shares(const Gradation &g);

/// The share that passes the upper sieve of each class, from the classes' shares.
std::vector<Rational> accumulated(std::vector<Rational> shares);

} // namespace mdm
