#pragma once
/// \file
/// What a specification asks of the percent that passes its sieves, and what is certain of it.

#include <mdm/gradation/envelope.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// A requirement holds for all curves that a report may mean, fails for all of them, or holds for some and
/// fails for others. Undecided where a limit of precision came first.
enum class Compliance { holds, fails, hangs, undecided };

/// `pass`, `fail`, `hangs`, `undecided`.
std::string_view name(Compliance verdict);

/// The limits at one sieve: least <= percent passing <= most.
struct PassingLimits {
  Rational size; ///< mm
  Rational least, most;
};

/// A specification that does not contradict itself.
struct Specification {
  std::string id;
  std::vector<std::string> about;    ///< where its limits are from, in its own words
  std::vector<PassingLimits> sieves; ///< ascending
  std::vector<std::string> notes;    ///< of its reading
};

/// The limits as an envelope.
Envelope envelope_of(const Specification &specification);

/// Reads the limits from the content of a file as read_envelope does, with the comments above them.
/// \throws InputError as read_envelope, and where no curve keeps the limits
Specification read_specification(std::string_view content, const std::string &file);

/// Names of the specifications that come with the program.
std::vector<std::string> shipped_specifications();
/// The one of that name; nothing if there is none.
std::optional<Specification> shipped_specification(std::string_view name);

} // namespace mdm
