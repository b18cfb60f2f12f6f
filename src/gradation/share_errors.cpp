#include "gradation/share_errors.hpp"

#include <algorithm>

namespace mdm {

ShareErrors share_errors(const std::vector<Rational> &asked, const std::vector<Rational> &found) {
  ShareErrors errors;
  Rational passing = 0;
  for (std::size_t j = 0; j < asked.size(); ++j) {
    const Rational difference = found[j] - asked[j], size = abs(difference);
    passing += difference;
    errors.retained = std::max(errors.retained, size);
    errors.passing = std::max<Rational>(errors.passing, abs(passing));
    errors.total += size;
  }
  return errors;
}

} // namespace mdm
