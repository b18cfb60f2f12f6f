#include "gradation/likelier_unit.hpp"

namespace mdm {

std::optional<SizeUnit> likelier_unit(const Description &d, SizeUnit unit) {
  const Gradation &g = d.gradation();
  const std::size_t finest = g.has_pan() ? 1 : 0; // a class or an opening
  for (std::size_t j = finest; j < g.classes(); ++j)
    if (d.of_class(j).count > 0)
      return std::nullopt;
  const std::optional<RootSize> &first = d.above().first   ? d.above().first
                                         : d.below().first ? d.below().first
                                                           : d.of_class(0).first;
  if (!first) // all have a range with a sieve in it
    return std::nullopt;
  for (const SizeUnit other : {SizeUnit::mm, SizeUnit::um, SizeUnit::m, SizeUnit::in}) {
    const Rational factor = in_mm(other) / in_mm(unit);
    const RootSize x{first->power * power(factor, first->degree), first->degree};
    if (other != unit && compare(x, g.opening(finest)) > 0 && compare(x, g.opening(g.classes())) <= 0)
      return other;
  }
  return std::nullopt;
}

} // namespace mdm
