#include "particles/placed_sink.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {

SampleSpace space_of_file(const std::optional<ParticleBox> &box) {
  SampleSpace space;
  if (box) {
    space.box = box->sides;
    space.periodic = box->periodic;
  }
  return space;
}

PlacedSink::PlacedSink(const Gradation &g, ParticleSink &next, std::optional<std::size_t> most, SpaceOf space)
    : next_(next), most_(most), space_(std::move(space)) {
  for (std::size_t i = 0; i <= g.classes(); ++i)
    openings_.push_back(g.opening(i));
  update_container();
}

void PlacedSink::update_container() {
  container_.reset();
  if (const SampleSpace space = space_(box_); space.box)
    container_.emplace(space);
}

void PlacedSink::set_box(const ParticleBox &box) {
  box_ = box;
  update_container();
}

void PlacedSink::restart() {
  next_.restart();
  sample_ = {};
  box_.reset();
  update_container();
  lacks_places_ = has_too_many_ = false;
  outside_ = 0;
  odd_.clear();
}

void PlacedSink::add(const RootSize &diameter, const Integer &quantity) {
  lacks_places_ = true;
  next_.add(diameter, quantity);
}

void PlacedSink::add(const SizeRange &diameter, const Integer &quantity) {
  lacks_places_ = true;
  next_.add(diameter, quantity);
}

void PlacedSink::add_at(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) {
  if (most_ && sample_.size() == *most_) {
    has_too_many_ = true;
    sample_ = {};
  }
  if (!has_too_many_ && !lacks_places_)
    keep(place, unit, diameter);
  if (container_ && !container_->holds(place, unit) && ++outside_ == 1)
    first_outside_ = fmt::format("{}", fmt::join(place, " "));
  next_.add(diameter, 1);
}

void PlacedSink::keep(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) {
  try {
    const std::optional<Rational> size = diameter.fraction();
    if (!size)
      throw InputError("is of a sphere whose size is no fraction: give sizes as decimals");
    sample_.add(place, unit, *size, class_of(*size));
  } catch (const InputError &error) {
    if (!most_)
      throw;
    lacks_places_ = true;
    odd_ = error.what();
  }
}

std::optional<std::string> PlacedSink::objection(const char *periodic) const {
  if (outside_ == 0)
    return std::nullopt;
  return fmt::format(
      "{} outside the space of the sample, the first at {} in the file's unit ({} says which axes "
      "are periodic)",
      outside_ == 1 ? "the centre of 1 particle is"
                    : fmt::format("the centres of {} particles are", outside_),
      printable(first_outside_), periodic);
}

const SphereSample &PlacedSink::sample() const {
  if (lacks_places_ || sample_.size() == 0)
    throw InputError("there are particles without a place of their own, x y z: give a file with x y z");
  return sample_;
}

std::uint32_t PlacedSink::class_of(const Rational &diameter) const {
  const auto above = std::partition_point(openings_.begin(), openings_.end(), [&](const RootSize &opening) {
    return compare(RootSize{diameter, 1}, opening) > 0;
  });
  const auto n = static_cast<std::size_t>(above - openings_.begin());
  return n == 0 || n == openings_.size() ? SphereSample::no_group : static_cast<std::uint32_t>(n - 1);
}

} // namespace mdm
