#include "match/sample_notes.hpp"

#include "soil/grading_curve.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr unsigned note_digits_shown = 3;

/// The upright length of a specimen; nothing for a volume.
std::optional<Rational> height_of(const Solids &solids) {
  if (const auto *cylinder = std::get_if<Cylinder>(&solids))
    return cylinder->height;
  if (const auto *box = std::get_if<Box>(&solids))
    return box->c;
  return std::nullopt;
}

/// The coarsest class with particles.
std::size_t coarsest_of(const Match &match) {
  if (!match.gradation.materials().empty())
    return match.gradation.coarsest();
  const MatchSample &sample = *match.sample;
  std::size_t j = sample.sizes.size() - 1;
  while (!sample.sizes[j])
    --j;
  return j;
}

/// The largest size over D50, where the curve has it.
std::optional<std::string> size_ratio(const Match &match, const Enclosure &largest) {
  if (match.gradation.root() != 1 || !match.gradation.materials().empty())
    return std::nullopt;
  const GradingCurve curve(match.gradation);
  const Available<PowerProduct> d50 = curve.diameter(ratio(1, 2));
  if (!d50)
    return std::nullopt;
  const Rational in_mm_of_unit = in_mm(match.gradation.unit());
  return rounded(Real(Rational(largest.lower() * in_mm_of_unit)) / d50->real(), note_digits_shown);
}

std::string representative_note(const Match &match, const Rational &height) {
  const MatchSample &sample = *match.sample;
  const std::size_t j = coarsest_of(match);
  const Enclosure &largest = *sample.sizes[j];
  const Rational times = height / largest.upper();
  const char *const judged = times < 15   ? "below the 15 to 20"
                             : times < 20 ? "within the 15 to 20"
                                          : "above the 15 to 20";
  std::string note = fmt::format(
      "representative volume: the specimen is {} times as high as its largest particle, {} that Cantor and "
      "Ovalle (2025) found to be needed; the coarsest class has {} particle{}",
      approximate(times, note_digits_shown), judged, to_string(sample.quantities[j]),
      sample.quantities[j] == 1 ? "" : "s");
  if (const std::optional<std::string> to_d50 = size_ratio(match, largest))
    note += "; d_max / D50 = " + *to_d50;
  return note;
}

/// Certain, by the ends of the enclosure: a size is nearer to a sieve than 1e-6 of itself.
bool crowds(const Enclosure &size, const Rational &lower, const Rational &upper) {
  static const Rational near = Rational(1) + ratio(1, power_of_ten(6));
  return upper < near * size.lower() || (lower > 0 && size.upper() < near * lower);
}

std::optional<std::string> crowding_note(const Match &match) {
  // What double precision cannot hold has a note of its own.
  static const Rational double_step = ratio(1, Integer(Integer(1) << 50));
  const std::optional<MatchScale> &scale = match.sample->scale;
  if (match.gradation.root() != 1 || (scale && scale->margin < double_step))
    return std::nullopt;
  std::string classes;
  for (std::size_t j = 0; j < match.sample->sizes.size(); ++j)
    if (const std::optional<Enclosure> &size = match.sample->sizes[j])
      if (crowds(*size, match.gradation.lower(j), match.gradation.upper(j)))
        classes += (classes.empty() ? "" : ", ") + std::to_string(j + 1);
  if (classes.empty())
    return std::nullopt;
  return "sizes crowd a sieve: within 1e-6 of themselves, in class " + classes;
}

} // namespace

std::vector<std::string> sample_notes(const Match &match) {
  std::vector<std::string> notes;
  const std::optional<Rational> height =
      match.question.solids ? height_of(*match.question.solids) : std::nullopt;
  if (height)
    notes.push_back(representative_note(match, *height));
  if (const std::optional<std::string> note = crowding_note(match))
    notes.push_back(*note);
  return notes;
}

} // namespace mdm
