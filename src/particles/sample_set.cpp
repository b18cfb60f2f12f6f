#include "particles/sample_set.hpp"

#include "gradation/shown.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/number/enclosure.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace mdm {
namespace {

/// A size as a number of a file, with the greatest error of the mass of it.
/// \param of_diameter  the part of the diameter that it is
WrittenNumber number_in(const SizeRange &x, const ParticleSetOptions &options, ParticleClass &c,
                        const Rational &of_diameter) {
  constexpr unsigned cube = 3;
  const Rational middle = (x.lo + x.hi) / 2;
  // Around a size that is known its mass sets the limits.
  Rational lower = x.is_point() ? Rational(0) : x.lo, upper = x.is_point() ? Rational(2 * x.hi) : x.hi;
  if (c.lower * of_diameter < middle && middle <= c.upper * of_diameter) {
    lower = std::max(lower, Rational(c.lower * of_diameter));
    upper = std::min(upper, Rational(c.upper * of_diameter));
  }
  SizeToWrite size{power(middle, cube), cube, lower, upper, options.most_mass_error};
  std::optional<WrittenNumber> n = shortest_number(size);
  if (!n) { // the range is narrower than doubles are apart
    size.lower = 0;
    size.upper = 2 * x.hi;
    n = shortest_number(size);
  }
  if (!n)
    throw InputError(fmt::format("a particle of {} {}: no double has its mass within {} of the exact one: "
                                 "allow a larger {}, or take another {}",
                                 shown(x.hi), name(options.unit), approximate(options.most_mass_error, 3),
                                 option("mass-error"), option("unit")));
  c.mass_error = std::max({c.mass_error, size.error(n->decimal()), size.error(exact_value(n->value))});
  return *std::move(n);
}

/// Upper bounds of groups with sizes up to sqrt(2) times their smallest, between sizes that are no less than
/// a millionth apart. \param sizes  the upper ends, ascending
std::vector<Rational> group_bounds(const std::vector<Rational> &sizes) {
  const Rational apart = ratio(1000001, 1000000);
  std::vector<Rational> bounds;
  Rational smallest = sizes.front();
  for (std::size_t i = 1; i < sizes.size(); ++i)
    if (sizes[i] * sizes[i] > 2 * smallest * smallest && sizes[i] > apart * sizes[i - 1]) {
      bounds.push_back((sizes[i - 1] + sizes[i]) / 2);
      smallest = sizes[i];
    }
  bounds.push_back(2 * sizes.back());
  return bounds;
}

} // namespace

void SampleSet::restart() {
  sizes_.clear();
  placed_.clear();
  box_.reset();
  classes_.clear();
  class_.reset();
  material_.clear();
  lacks_places_ = lacks_classes_ = false;
}

namespace {

/// The size, enclosed where it is irrational.
SizeRange range_of(const RootSize &diameter) {
  constexpr unsigned digits = 20;
  if (diameter.degree == 1)
    return {diameter.power, diameter.power};
  const Enclosure x =
      enclose_root(numerator(diameter.power), denominator(diameter.power), diameter.degree, digits);
  return {x.lower(), x.upper()};
}

} // namespace

SampleSet::Sizes::const_iterator SampleSet::gather(const SizeRange &diameter, const Integer &quantity) {
  gather_class(diameter);
  const auto at = sizes_.try_emplace(Size{material_, diameter.lo, diameter.hi}, 0).first;
  at->second += quantity;
  if (sizes_.size() > most_sizes)
    throw InputError(
        fmt::format("more than the {} sizes that a set can hold: leave particles out", most_sizes));
  return at;
}

void SampleSet::gather_class(const SizeRange &diameter) {
  if (!class_) {
    lacks_classes_ = true;
    return;
  }
  const std::uint64_t number = *std::exchange(class_, std::nullopt);
  Span &span = classes_.try_emplace(number, diameter.lo, diameter.hi).first->second;
  span = {std::min(span.first, diameter.lo), std::max(span.second, diameter.hi)};
}

bool SampleSet::has_classes() const {
  std::vector<Span> spans;
  for (const auto &of_class : classes_)
    spans.push_back(of_class.second);
  std::sort(spans.begin(), spans.end());
  const auto overlap = [](const Span &a, const Span &b) { return a.second >= b.first; };
  return !lacks_classes_ && spans.size() > 1 &&
         std::adjacent_find(spans.begin(), spans.end(), overlap) == spans.end();
}

void SampleSet::add(const RootSize &diameter, const Integer &quantity) {
  add(range_of(diameter), quantity);
}

void SampleSet::add(const SizeRange &diameter, const Integer &quantity) {
  lacks_places_ = true;
  gather(diameter, quantity);
}

void SampleSet::add_at(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) {
  Placed placed{gather(range_of(diameter), 1), {}};
  if (lacks_places_)
    return;
  try {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::string decimal(place[axis]);
      std::replace(decimal.begin(), decimal.end(), ',', '.');
      placed.at[axis] = parse_decimal(decimal) * unit;
    }
    placed_.push_back(std::move(placed));
  } catch (const InputError &) { // such as nan
    lacks_places_ = true;
  }
}

SampleSet::Classes SampleSet::classes(SizeUnit from, SizeUnit to, const Gradation *sieves) const {
  const Rational unit = in_mm(from) / in_mm(to);
  Classes all;
  if (sieves != nullptr) {
    for (std::size_t j = 0; j <= sieves->classes(); ++j) {
      const Interval x = bounds(sieves->opening(j));
      all.openings.push_back((j == 0 ? x.hi : x.lo) * in_mm(sieves->unit()) / in_mm(to));
    }
  } else if (has_classes()) {
    std::map<Span, std::uint64_t> spans;
    for (const auto &[number, span] : classes_)
      spans.emplace(span, number);
    Rational below = 0;
    for (const auto &[span, number] : spans) {
      all.openings.push_back((below + span.first) / 2 * unit);
      all.numbers.push_back(number);
      below = span.second;
    }
    all.openings.push_back(2 * below * unit);
  } else {
    std::vector<Rational> sizes;
    for (const auto &size : sizes_)
      sizes.push_back(size.first.hi * unit);
    std::sort(sizes.begin(), sizes.end());
    all.openings = group_bounds(sizes);
    all.openings.insert(all.openings.begin(), Rational(0));
  }
  return all;
}

ParticleSet SampleSet::set(const std::string &name, SizeUnit from, const ParticleSetOptions &options,
                           const Gradation *sieves) const {
  if (sizes_.empty())
    throw InputError("there are no particles: give a file that has some");
  const bool has_materials = !sizes_.rbegin()->first.material.empty();
  if (sieves != nullptr && has_materials)
    throw InputError("the particles are of several materials, and " + option("gradation") +
                     " has the classes of one: leave it out");
  const Rational unit = in_mm(from) / in_mm(options.unit);
  const Rational density = options.density * power(Rational(in_mm(options.unit) / 1000), 3);
  const Classes of = classes(from, options.unit, sieves);
  const std::vector<Rational> &openings = of.openings;
  ParticleSet set{name, options.unit, {}, {}, {}};
  std::size_t last = 0; // class
  for (const auto &[size, quantity] : sizes_) {
    const SizeRange diameter{size.lo * unit, size.hi * unit};
    const auto upper = std::lower_bound(openings.begin(), openings.end(), diameter.hi);
    if (upper == openings.begin() || upper == openings.end())
      throw InputError(fmt::format(
          "a particle of {} {} is outside of all classes of the gradation of {}: were sizes "
          "multiplied by {}, or is a unit wrong?",
          shown(diameter.hi), mdm::name(options.unit), option("gradation"), option("size-factor")));
    const auto n = static_cast<std::size_t>(upper - openings.begin());
    if (set.classes.empty() || last != n || set.classes.back().material != size.material) {
      const Rational factor = sieves != nullptr ? sieves->factor(n - 1) : Rational(1);
      const std::size_t number = has_materials        ? set.classes.size() + 1
                                 : of.numbers.empty() ? n
                                                      : static_cast<std::size_t>(of.numbers[n - 1]);
      set.classes.push_back({number, size.material, *(upper - 1), *upper, density * factor, {}, 0});
      last = n;
    }
    ParticleClass &c = set.classes.back();
    const SizeRange radius{diameter.lo / 2, diameter.hi / 2};
    c.sizes.push_back(
        {number_in(diameter, options, c, 1), number_in(radius, options, c, ratio(1, 2)), quantity});
  }
  return set;
}

std::optional<KeptPlaces> SampleSet::places(const ParticleSet &set, SizeUnit from) const {
  if (lacks_places_ || placed_.empty())
    return std::nullopt;
  const Rational unit = in_mm(from) / in_mm(set.unit);
  std::array<Rational, 3> low{}, high{};
  KeptPlaces kept;
  if (box_) {
    kept.has_box = true;
    kept.periodic = box_->periodic;
    low = box_->sides.low;
    high = box_->sides.high;
  } else
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto end = [axis](const Placed &p, int side) {
        return Rational(p.at[axis] + side * p.size->first.hi / 2);
      };
      low[axis] = end(placed_.front(), -1);
      high[axis] = end(placed_.front(), 1);
      for (const Placed &p : placed_) {
        low[axis] = std::min(low[axis], end(p, -1));
        high[axis] = std::max(high[axis], end(p, 1));
      }
    }
  // The map's sizes are those of the classes, in their order.
  std::map<const Rational *, std::pair<std::size_t, std::size_t>> index;
  auto size = sizes_.begin();
  for (std::size_t i = 0; i < set.classes.size(); ++i)
    for (std::size_t j = 0; j < set.classes[i].sizes.size(); ++j)
      index[&(size++)->first.lo] = {i, j};
  std::array<Rational, 3> side;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    side[axis] = high[axis] - low[axis];
    kept.box[axis] = Rational(side[axis] * unit).convert_to<double>();
  }
  for (const Placed &p : placed_) {
    const auto &[i, j] = index.at(&p.size->first.lo);
    KeptPlace place{i, j, {}};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Rational x = p.at[axis] - low[axis];
      if (kept.periodic[axis] && side[axis] > 0)
        x -= side[axis] * floor(Rational(x / side[axis]));
      if (x < 0 || x > side[axis])
        throw InputError(
            "a particle has its centre outside of the file's box: it has no place to keep: take " +
            option("start") + " mixed");
      place.at[axis] = Rational(x * unit).convert_to<double>();
    }
    kept.particles.push_back(place);
  }
  return kept;
}

} // namespace mdm
