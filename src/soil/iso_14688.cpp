#include "soil/iso_14688.hpp"

#include "soil/share_limits.hpp"

namespace mdm {
namespace {

/// Fractions of what passes 63 mm.
struct IsoParts {
  Real whole, fines, sand, gravel;
};

/// \throws NotAvailable
IsoParts iso_parts(const GradingCurve &curve) {
  const std::vector<Real> passing = shares_passing(curve, {63, 2, ratio(63, 1000)});
  if (passing[0].exact() == Rational(0))
    throw NotAvailable{"nothing passes 63 mm"};
  return {passing[0], passing[2], passing[1] - passing[2], passing[0] - passing[1]};
}

bool has_percent(const Real &part, unsigned percent, const Real &whole) {
  return is_at_least(part, ratio(percent, 100), whole);
}

/// A name that grows at its end.
void append(Iso14688Name &name, const char *symbol, const char *word) {
  name.symbol += symbol;
  name.words += (name.words.empty() ? "" : " ") + std::string(word);
}

/// Sand and gravel as adjectives, where they have 20 % and are asked for; true if both are.
bool append_adjectives(Iso14688Name &name, const IsoParts &p, bool of_sand, bool of_gravel) {
  const bool sandy = of_sand && has_percent(p.sand, 20, p.whole),
             gravelly = of_gravel && has_percent(p.gravel, 20, p.whole),
             gravel_first = gravelly && !is_at_least(p.gravel, 1, p.sand);
  if (gravelly && gravel_first)
    append(name, "gr", "gravelly");
  if (sandy)
    append(name, "sa", "sandy");
  if (gravelly && !gravel_first)
    append(name, "gr", "gravelly");
  return sandy && gravelly;
}

/// What fines are called as a noun. \throws NotAvailable
void append_fines(Iso14688Name &name, const Real &clay, const Real &fines, bool beside_both) {
  if (!has_percent(clay, 10, fines))
    append(name, "Si", "silt");
  else if (has_percent(clay, 40, fines))
    append(name, "Cl", "clay");
  else if (beside_both)
    throw NotAvailable{"its diagram names no fines of 10 to 40 % clay with 20 % of both sand and gravel"};
  else if (!has_percent(clay, 20, fines))
    append(name, "clSi", "clayey silt");
  else
    append(name, "siCl", "silty clay");
}

/// A soil of less than 40 % of fines. \throws NotAvailable
void append_coarse(Iso14688Name &name, const IsoParts &p, const GradingCurve &curve) {
  const bool is_gravel = is_at_least(p.gravel, 1, p.sand);
  const bool names_fines = has_percent(p.fines, 15, p.whole);
  const bool is_mixed = names_fines && !has_percent(is_gravel ? p.gravel : p.sand, 40, p.whole);
  append_adjectives(name, p, is_mixed || is_gravel, is_mixed || !is_gravel);
  if (names_fines) {
    const bool is_clayey = has_percent(shares_passing(curve, {ratio(2, 1000)})[0], 20, p.fines);
    append(name, is_clayey ? "cl" : "si", is_clayey ? "clayey" : "silty");
  }
  if (is_mixed)
    append(name, "S", "soil");
  else
    append(name, is_gravel ? "Gr" : "Sa", is_gravel ? "gravel" : "sand");
}

} // namespace

Available<Iso14688Name> iso_14688_name(const GradingCurve &curve) {
  try {
    const IsoParts p = iso_parts(curve);
    Iso14688Name name;
    if (has_percent(p.fines, 40, p.whole)) {
      const bool has_both = append_adjectives(name, p, true, true);
      append_fines(name, shares_passing(curve, {ratio(2, 1000)})[0], p.fines, has_both);
    } else {
      append_coarse(name, p, curve);
    }
    return name;
  } catch (const NotAvailable &why) {
    return why;
  }
}

} // namespace mdm
