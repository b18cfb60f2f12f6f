#include "soil/describe.hpp"

#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

/// `a, b, c`.
std::string listed(const std::vector<std::string> &items) {
  std::string text;
  for (const std::string &item : items)
    text += (text.empty() ? "" : ", ") + item;
  return text;
}

void add_diameter_notes(std::vector<std::string> &notes, const SoilDescription &d, bool extrapolate) {
  std::vector<std::string> in_pan;
  for (const unsigned p : {10U, 30U, 50U, 60U})
    if (d.curve.in_pan(ratio(p, 100)))
      in_pan.push_back("D" + std::to_string(p));
  if (in_pan.empty())
    return;
  std::string note = listed(in_pan) + ": ";
  if (d.d10)
    note += "extrapolated along the line through the two finest sieves";
  else
    note += d.d10.why().reason + "; C_u and C_c need D10";
  if (!extrapolate)
    note += fmt::format(" ({} continues the curve, {} gives the pan a size)", option("extrapolate"),
                        option("pan-size"));
  notes.push_back(std::move(note));
}

void add_fraction_notes(std::vector<std::string> &notes, const GradingCurve &curve, const std::string &system,
                        const std::vector<Fraction> &fractions) {
  std::vector<std::string> unknown, bounds;
  for (const Fraction &f : fractions)
    if (!f.share && f.main)
      unknown.emplace_back(f.name);
  if (!unknown.empty())
    notes.push_back(system + ": " + listed(unknown) +
                    " not available: " + rounded(Real(curve.shares()[1] * 100), 3) + " % of the mass lies " +
                    fractions.back().share.why().reason);
  for (const Rational &bound : interpolated_bounds(curve, fractions))
    bounds.push_back(to_decimal(bound));
  if (!bounds.empty())
    notes.push_back(system + ": interpolated, linear in log size, at " + listed(bounds) +
                    " mm, where there is no sieve");
}

bool depends_on_fines(const UscsGroup &group) {
  return group.symbol.find_first_of("MC") != std::string::npos;
}

void add_group_notes(std::vector<std::string> &notes, const SoilDescription &d, bool limits_given) {
  if (!d.group) {
    notes.push_back("no USCS group: " + d.group.why().reason);
    return;
  }
  if (!limits_given && depends_on_fines(*d.group))
    notes.push_back(fmt::format("the fines are taken as low-plasticity silt (ML); {} and {} "
                                "classify them",
                                option("liquid-limit"), option("plastic-limit")));
  if (compare(d.curve.opening(d.curve.shares().size() - 1), RootSize{75}) > 0 &&
      compare(*d.curve.passing(75), Real(1)) == Order::less)
    notes.emplace_back("the USCS group is that of the part that passes 75 mm");
}

/// The figures by which the papers that Arnold cites tell a representative volume.
std::string representative_note(const SoilDescription &d) {
  const Real d_max = d.d_max.real();
  return fmt::format(
      "representative volume: {}a specimen 15 to 20 d_max high (Cantor and Ovalle, 2025) has {} to {} mm",
      d.d50 ? "d_max / D50 is " + rounded((d.d_max / *d.d50).real(), 3) + "; " : "",
      rounded(Real(15) * d_max, 3), rounded(Real(20) * d_max, 3));
}

} // namespace

std::vector<std::string> assumptions(const SoilDescription &d, const DescribeOptions &options) {
  std::vector<std::string> notes;
  add_diameter_notes(notes, d, options.extrapolate);
  add_group_notes(notes, d, options.limits.has_value());
  return notes;
}

SoilDescription describe(const Gradation &g, const DescribeOptions &options) {
  const GradingCurve curve(g);
  const bool extrapolate = options.extrapolate;
  const auto diameter = [&](long percent) { return curve.diameter(ratio(percent, 100), extrapolate); };
  const Fines fines = options.limits ? classify_fines(*options.limits) : Fines::ML;
  SoilDescription d{g.id(),
                    curve,
                    diameter(10),
                    diameter(30),
                    diameter(50),
                    diameter(60),
                    uniformity(curve, extrapolate),
                    curvature(curve, extrapolate),
                    grain_size_index(curve),
                    curvature_index(curve),
                    finest_mass_ratio(curve),
                    coarsest_volume_ratio(curve),
                    curve.power_of(curve.coarsest() + 1),
                    fines,
                    classify_uscs(curve, fines, extrapolate),
                    uscs_fractions(curve),
                    iso_14688_fractions(curve),
                    g.notes()};
  add_diameter_notes(d.notes, d, extrapolate);
  if (!d.i_gs)
    d.notes.push_back("I_GS is not available: " + d.i_gs.why().reason);
  if (!d.i_c)
    d.notes.push_back("I_C is not available: " + d.i_c.why().reason);
  d.notes.push_back(representative_note(d));
  add_fraction_notes(d.notes, curve, "ASTM D2487", d.uscs);
  add_fraction_notes(d.notes, curve, "ISO 14688", d.iso_14688);
  add_group_notes(d.notes, d, options.limits.has_value());
  return d;
}

} // namespace mdm
