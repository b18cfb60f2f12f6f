#include "soil/describe.hpp"

#include "soil/fineness_modulus.hpp"
#include "soil/permeability.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

/// `a, b, c`.
std::string listed(const std::vector<std::string> &items) {
  std::string text;
  for (const std::string &item : items)
    text += (text.empty() ? "" : ", ") + item;
  return text;
}

/// The diameters that every description has.
constexpr std::array<unsigned, 4> usual_percents = {10, 30, 50, 60};

/// What a pan at size 0 makes of the diameters in it.
void add_diameter_notes(std::vector<std::string> &notes, const SoilDescription &d, bool extrapolate) {
  std::vector<std::pair<std::string, const Available<PowerProduct> *>> in_pan;
  const std::array<const Available<PowerProduct> *, 4> usual = {&d.d10, &d.d30, &d.d50, &d.d60};
  for (std::size_t i = 0; i < usual.size(); ++i)
    if (d.curve.in_pan(ratio(usual_percents[i], 100)))
      in_pan.emplace_back("D" + std::to_string(usual_percents[i]), usual[i]);
  for (const DiameterAt &more : d.diameters)
    if (d.curve.in_pan(more.percent / 100))
      in_pan.emplace_back("D" + to_decimal(more.percent), &more.size);
  std::vector<std::string> known, unknown;
  std::string reason;
  for (const auto &[name, size] : in_pan) {
    (*size ? known : unknown).push_back(name);
    if (!*size)
      reason = size->why().reason;
  }
  const std::string remedy = extrapolate ? ""
                                         : fmt::format(" ({} continues the curve, {} gives the pan a size)",
                                                       option("extrapolate"), option("pan-size"));
  if (!known.empty())
    notes.push_back(listed(known) + ": extrapolated along the line through the two finest sieves" + remedy);
  if (!unknown.empty())
    notes.push_back(listed(unknown) + ": " + reason + (d.d10 ? "" : "; C_u and C_c need D10") + remedy);
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

void add_aashto_notes(std::vector<std::string> &notes, const SoilDescription &d) {
  if (!d.aashto)
    notes.push_back("no group of AASHTO M 145: " + d.aashto.why().reason);
  else if (!d.aashto->index)
    notes.emplace_back(
        "the group index of AASHTO M 145 needs the limits of the fines, and what passes 0.075 mm");
}

/// What is interpolated of a fineness modulus, or why there is none.
void add_fineness_notes(std::vector<std::string> &notes, const SoilDescription &d) {
  const auto add = [&](const char *standard, const Available<Real> &modulus,
                       const std::vector<Rational> &sieves) {
    if (!modulus) {
      notes.push_back(fmt::format("no fineness modulus of {}: {}", standard, modulus.why().reason));
      return;
    }
    std::vector<std::string> between;
    for (const Rational &sieve : sieves)
      if (d.curve.interpolates(sieve))
        between.push_back(to_decimal(sieve));
    if (!between.empty())
      notes.push_back(
          fmt::format("fineness modulus of {}: interpolated, linear in log size, at {} mm, where there "
                      "is no sieve",
                      standard, listed(between)));
  };
  add("ASTM C125", d.fineness_modulus, fineness_sieves(FinenessModulus::astm));
  add("EN 12620", d.en_fineness_modulus, fineness_sieves(FinenessModulus::en));
}

void add_conductivity_notes(std::vector<std::string> &notes, const SoilDescription &d, bool extrapolate) {
  if (d.hazen && !is_hazen_soil(d.curve, extrapolate))
    notes.emplace_back(
        "k_H, Hazen's estimate, is for loose sand of D10 from 0.1 to 3 mm and C_u below 5: this soil is "
        "outside that range");
  if (!d.kozeny_carman)
    return;
  if (*d.kozeny_carman)
    notes.emplace_back("k_KC, the estimate of Kozeny and Carman after Carrier (2003), is for spheres of any "
                       "sizes within the "
                       "classes, water at 20 degrees Celsius and laminar flow, not for clay");
  else
    notes.push_back("k_KC is not available: " + d.kozeny_carman->why().reason);
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
  const auto diameter = [&](const Rational &percent) { return curve.diameter(percent / 100, extrapolate); };
  std::vector<DiameterAt> diameters;
  for (const Rational &percent : options.percents)
    if (std::find(usual_percents.begin(), usual_percents.end(), percent) == usual_percents.end())
      diameters.push_back({percent, diameter(percent)});
  const Fines fines = options.limits ? classify_fines(*options.limits) : Fines::ML;
  SoilDescription d{g.id(),
                    curve,
                    diameter(10),
                    diameter(30),
                    diameter(50),
                    diameter(60),
                    std::move(diameters),
                    uniformity(curve, extrapolate),
                    curvature(curve, extrapolate),
                    span(curve, extrapolate),
                    surface_mean(curve),
                    volume_mean(curve),
                    fineness_modulus(curve, FinenessModulus::astm),
                    fineness_modulus(curve, FinenessModulus::en),
                    hazen_conductivity(curve, extrapolate),
                    options.void_ratio ? std::optional(kozeny_carman_conductivity(curve, *options.void_ratio))
                                       : std::nullopt,
                    grain_size_index(curve),
                    curvature_index(curve),
                    finest_mass_ratio(curve),
                    coarsest_volume_ratio(curve),
                    curve.power_of(curve.coarsest() + 1),
                    fines,
                    classify_uscs(curve, fines, extrapolate),
                    classify_aashto(curve, options.limits),
                    iso_14688_name(curve),
                    uscs_fractions(curve),
                    iso_14688_fractions(curve),
                    g.notes()};
  add_diameter_notes(d.notes, d, extrapolate);
  if (!d.i_gs)
    d.notes.push_back("I_GS is not available: " + d.i_gs.why().reason);
  if (!d.i_c)
    d.notes.push_back("I_C is not available: " + d.i_c.why().reason);
  if (!d.surface_mean)
    d.notes.push_back("D[3,2] and D[4,3] are not available: " + d.surface_mean.why().reason);
  d.notes.push_back(representative_note(d));
  add_fraction_notes(d.notes, curve, "ASTM D2487", d.uscs);
  add_fraction_notes(d.notes, curve, "ISO 14688", d.iso_14688);
  add_group_notes(d.notes, d, options.limits.has_value());
  add_aashto_notes(d.notes, d);
  if (!d.iso_name)
    d.notes.push_back("no name of ISO 14688-2: " + d.iso_name.why().reason);
  add_fineness_notes(d.notes, d);
  add_conductivity_notes(d.notes, d, extrapolate);
  return d;
}

} // namespace mdm
