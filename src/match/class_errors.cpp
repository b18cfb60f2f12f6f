#include "match/class_errors.hpp"

#include "match/problem.hpp"

namespace mdm {

ClassErrors class_errors(const std::vector<Integer> &held, const std::vector<Integer> &target) {
  const Integer all_held = total(held);
  const Integer all_target = total(target);
  const Integer unit = all_held * all_target;
  ClassErrors errors;
  errors.of_class.reserve(held.size());
  Integer sum = 0, largest = -1;
  for (std::size_t j = 0; j < held.size(); ++j) {
    const Integer difference = target[j] * all_held - held[j] * all_target;
    const Integer size = abs(difference);
    sum += size;
    if (size > largest) {
      largest = size;
      errors.worst = j;
    }
    errors.of_class.push_back(ratio(difference, unit));
  }
  errors.total = ratio(sum, unit);
  errors.maximum = ratio(largest, unit);
  return errors;
}

} // namespace mdm
