#include "particles/line_reader.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

/// A cumulative number distribution in steps, below the heading `radius_m,cumulative_number,N particles:
/// ...`. Each step is two rows of one radius; it holds (b - a) N particles, a and b being rounded.
class MercuryReader : public LineReader {
public:
  explicit MercuryReader(ParticleSource &source) : source_(source) {}

  void line(std::string_view text) override {
    if (trimmed(text).empty())
      return;
    if (source_.line() == 1)
      read_heading(text);
    else
      read_row(text);
  }

  void end() override {
    source_.check_some();
    if (!radius_.empty() || below_ != 1)
      source_.refuse(
          "the distribution does not end with two rows of one radius, the last at 1: is the file cut "
          "off?");
  }

private:
  void read_heading(std::string_view text) {
    constexpr std::string_view begin = "radius_", middle = ",cumulative_number,", end = " particles";
    const std::size_t comma = text.find(middle);
    std::optional<SizeUnit> unit;
    if (text.starts_with(begin) && comma != std::string_view::npos)
      unit = parse_size_unit(text.substr(begin.size(), comma - begin.size()));
    if (unit) {
      text.remove_prefix(comma + middle.size());
      particles_ = parse_natural(text.substr(0, text.find(end)));
    }
    if (!unit || !particles_)
      source_.refuse(
          "the heading is not 'radius_m,cumulative_number,N particles', which says what the shares are "
          "of");
    if (source_.options().unit)
      source_.refuse("the heading names the unit: leave out " + option(source_.options().unit_option));
    source_.set_defaults(SizeMeaning::radius, *unit);
  }

  void read_row(std::string_view text) {
    const std::size_t comma = text.find(',');
    if (comma == std::string_view::npos || !particles_)
      source_.refuse("the row is not a radius and a share: write radius,cumulative");
    const std::string_view radius = trimmed(text.substr(0, comma));
    const Rational share = number(trimmed(text.substr(comma + 1)));
    if (radius_.empty()) {
      if (share != below_)
        source_.refuse("the step does not begin where the last one ended: is the file damaged?");
      radius_ = radius;
      return;
    }
    if (radius != radius_)
      source_.refuse("the step has two radii: is the file damaged?");
    const Rational count = (share - below_) * *particles_;
    const Integer quantity = floor(Rational(count + ratio(1, 2)));
    const Rational off = count - Rational(quantity);
    if (quantity < 1 || abs(off) > ratio(1, 1000))
      source_.refuse(fmt::format("the step is not that of some of {} particles: is the file damaged?",
                                 to_string(*particles_)));
    source_.particle(radius_, quantity);
    below_ = share;
    radius_.clear();
  }

  Rational number(std::string_view text) const {
    try {
      return parse_decimal(text);
    } catch (const InputError &error) {
      source_.refuse(fmt::format("cumulative {}", error.what()));
    }
  }

  ParticleSource &source_;
  std::optional<Integer> particles_;
  std::string radius_; ///< of the step that has begun
  Rational below_ = 0;
};

} // namespace

std::unique_ptr<LineReader> read_mercurydpm(ParticleSource &source) {
  return std::make_unique<MercuryReader>(source);
}

} // namespace mdm
