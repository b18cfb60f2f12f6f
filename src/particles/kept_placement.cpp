// Places of particles that a file has.

#include "particles/placement.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {

Placement::Placement(const ParticleSet &set, const KeptPlaces &places, Sides sides, bool is_repeated)
    : set_(&set), seed_(0), sides_(sides), is_kept_(true) {
  if (is_repeated)
    kept_repeated_ = places.periodic;
  check_simulated(set);
  choose_unit();
  refine_unit(exact_value(*std::max_element(places.box.begin(), places.box.end())));
  const auto in_units = [this](double length) {
    return units(exact_value(length) + ratio(1, 2) / power_of_ten(places_));
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    box_[axis] = in_units(places.box[axis]);
  std::vector<const KeptPlace *> order;
  for (const KeptPlace &place : places.particles)
    order.push_back(&place);
  std::stable_sort(order.begin(), order.end(), [](const KeptPlace *a, const KeptPlace *b) {
    return a->class_index != b->class_index ? a->class_index > b->class_index : a->size_index > b->size_index;
  });
  for (const KeptPlace *const place : order)
    spheres_.push_back({place->class_index,
                        &set.classes[place->class_index].sizes[place->size_index],
                        {in_units(place->at[0]), in_units(place->at[1]), in_units(place->at[2])}});
}

} // namespace mdm
