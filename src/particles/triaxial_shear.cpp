#include "particles/triaxial_shear.hpp"

#include "text/option_name.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mdm {
namespace {

/// A size and the mass of the grains that have it.
using MassOfSize = std::pair<double, double>;

std::vector<MassOfSize> masses_of_sizes(const ParticleSet &set) {
  std::vector<MassOfSize> all;
  for (const ParticleClass &c : set.classes)
    for (const ParticleSize &size : c.sizes) {
      const double d = size.diameter.value;
      all.emplace_back(d, std::numbers::pi / 6 * d * d * d * c.density.convert_to<double>() *
                              size.quantity.convert_to<double>());
    }
  std::sort(all.begin(), all.end());
  return all;
}

double sum_of(const std::vector<MassOfSize> &masses) {
  double sum = 0;
  for (const auto &[size, mass] : masses)
    sum += mass;
  return sum;
}

double median_of(const std::vector<MassOfSize> &masses) {
  const double half = sum_of(masses) / 2;
  double sum = 0;
  for (const auto &[size, mass] : masses) {
    sum += mass;
    if (sum >= half)
      return size;
  }
  return masses.back().first;
}

/// Of the cell when it is as dense as mixed grains hardly become.
double least_height_at_end(const SettleScript &s) {
  constexpr double least_void_ratio = 0.3;
  const double volume = (1 + least_void_ratio) * s.physics.solids;
  const double shrunk = std::cbrt(volume / (s.box.x * s.box.y * s.box.z));
  return s.box.z * shrunk * (1 - s.model.shear->axial_strain);
}

} // namespace

ShearCourse::ShearCourse(const SettleModel &model) {
  const std::vector<MassOfSize> masses = masses_of_sizes(model.set);
  const Settling physics = settling(model);
  median = median_of(masses);
  density = sum_of(masses) / physics.solids;
  axial_rate = TriaxialLimits::inertial_number / (median * std::sqrt(density / model.target->pressure));
  const double needed = std::ceil(-std::log1p(-model.shear->axial_strain) / (axial_rate * physics.step));
  steps = static_cast<std::uint64_t>(std::min<double>(needed, Settling::most_steps));
}

bool is_p_constant(const SettleScript &s) {
  return s.model.shear->constant == ConstantStress::p;
}

std::string constant_stress(const SettleScript &s) {
  return is_p_constant(s) ? "p" : "sigma_3";
}

std::string triaxial_purpose(const SettleScript &s) {
  return fmt::format(", and sheared as in a drained triaxial test at constant {} to axial strain {:.6g}",
                     constant_stress(s), s.model.shear->axial_strain);
}

namespace {

const char *faces_lines(const SettleScript &s) {
  if (s.has_six_walls())
    return "# The walls have no friction and no membrane. Grains lie looser beside them: a specimen that is "
           "few "
           "grains wide has a\n# higher void ratio than a periodic cell.\n";
  return "# The cell is periodic: it has neither walls nor a membrane. A specimen in a membrane is left to "
         "users.\n";
}

} // namespace

std::string triaxial_lines(const SettleScript &s) {
  const ShearCourse course(s.model);
  const std::string density =
      s.model.shear->void_ratio
          ? fmt::format(
                "# Void ratio {:.6g} at that pressure: while the grains are compacted the friction is "
                "lowered until it is there.\n",
                *s.model.shear->void_ratio)
          : "";
  return density +
         filled(
             R"(# Triaxial: each face is brought to @stress@ Pa; then the height shrinks by @rate@ of itself a second in some
# @steps@ steps, and a servo moves the sides so that @constant@ is constant@goal@. It is a result
# if @held@ % of the log's rows, and the last, have @constant@ within @within@ % of @stress@ Pa and are jammed.
# The inertial number rate d50 sqrt(density / p) is @inertia@ at p = @stress@ Pa, d50 = @d50@ m by mass; above @most@ it is no result.
# The log is @base@-triaxial.csv, some @rows@ rows; mdm plot draws it. Compression is positive: axial strain 1 - h/h0 and volumetric
# strain 1 - V/V0 since the shear began, p = (sigma_1 + 2 sigma_3)/3 and q = sigma_1 - sigma_3 in Pa, sigma_3 the mean of both
# sides. The grains at the end are those of its last row, still in slow motion.
@faces@)",
             {{"stress", fmt::format("{:.6g}", s.model.target->pressure)},
              {"constant", constant_stress(s)},
              {"goal", is_p_constant(s) ? ": each is to have (3 p - sigma_1)/2" : ""},
              {"rate", fmt::format("{:.4g}", course.axial_rate)},
              {"steps", std::to_string(course.steps)},
              {"held", fmt::format("{:.3g}", 100 * (1 - TriaxialLimits::rows_off))},
              {"within", fmt::format("{:.3g}", 100 * TriaxialLimits::held_within)},
              {"inertia", digits6(TriaxialLimits::inertial_number)},
              {"most", digits6(TriaxialLimits::most_inertial_number)},
              {"d50", fmt::format("{:.4g}", course.median)},
              {"rows", std::to_string(TriaxialLimits::rows)},
              {"faces", faces_lines(s)},
              {"base", s.name}});
}

void check_triaxial(const SettleScript &s) {
  const double largest = s.set.largest().diameter.value, height = least_height_at_end(s);
  const bool fits = s.has_six_walls() ? largest < height : 2 * largest < height;
  if (fits)
    return;
  throw InputError(fmt::format("the largest grain, {:.4g} m, is more than {} the height at the end, {:.4g} m "
                               "at void ratio 0.3{}: give more "
                               "grains by {}, a higher {} or less {}",
                               largest, s.has_six_walls() ? "" : "half of", height,
                               s.has_six_walls() ? "" : ", and would touch itself", option("at-least"),
                               option("box"), option("axial-strain")));
}

} // namespace mdm
