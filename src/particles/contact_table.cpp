#include "particles/contact_table.hpp"

#include <fmt/core.h>

#include <numbers>

namespace mdm {
namespace {

std::string row(const char *property, const std::string &text) {
  return fmt::format("#   {:<17}{}\n", property, text);
}

std::string stiffness_row(const SettleScript &s) {
  if (!s.model.materials.empty())
    return row("stiffness", "of each class its own, see below");
  const Elasticity &e = s.physics.elasticity;
  std::string text = row("stiffness", fmt::format("E = {:.4g} Pa, nu = {}", e.young.convert_to<double>(),
                                                  e.poisson.convert_to<double>()));
  if (!s.model.young)
    text +=
        row("", "(softer than rock to save steps: 10^4 times the weight of a column as high as the box,") +
        row("", "2000 times the pressure asked for, 5 MPa at least)");
  return text;
}

std::string friction_row(const SettleScript &s) {
  std::string text = s.model.materials.empty() ? digits6(s.model.friction) : "of each class its own";
  if (s.has_six_walls())
    text += "; of the walls 0";
  else if (!s.model.materials.empty() || s.friction_while_filling() != s.model.friction)
    text += fmt::format("; {} while filling and compacting, and of the walls",
                        (s.keeps_friction() ? "at most " : "") + digits6(s.friction_while_filling()));
  return row("friction", text);
}

std::string rolling_row(const SettleScript &s, const char *engines_model) {
  if (!s.model.resists_rolling())
    return row("rolling friction", "none");
  return row("rolling friction",
             fmt::format("{}, by its model {}: the most moment of a contact over its normal force and",
                         s.model.materials.empty() ? digits6(s.model.rolling_friction)
                                                   : "of each class its own",
                         engines_model)) +
         row("", "effective radius");
}

/// \pre there is a law where the model has cohesion
std::string cohesion_row(const SettleScript &s, const CohesionLaw *law) {
  if (s.model.cohesion == 0)
    return row("cohesion", "none");
  const double r = s.set.smallest().radius.value;
  const CohesiveContact contact = smallest_contact(s.model, s.physics.elasticity, *law);
  const double weight = 4.0 / 3 * std::numbers::pi * r * r * r *
                        s.set.classes.front().density.convert_to<double>() * Settling::gravity;
  return row("cohesion", fmt::format("{} {}, by its model {}, of grains alone: walls have none",
                                     digits6(s.model.cohesion), law->unit, law->model)) +
         row("",
             fmt::format("(two of the smallest part at {:.3g} N, {:.3g} times the weight of one, and overlap "
                         "by {:.2g} % of",
                         contact.pull_off, contact.pull_off / weight, 100 * contact.overlap / (2 * r))) +
         row("", "their diameter where nothing presses)");
}

std::string time_row(const SettleScript &s) {
  return row("time step", fmt::format("{} s, a fifth of the Rayleigh time of the smallest grain, {:.4g} s =",
                                      digits6(s.physics.step), s.physics.rayleigh)) +
         row("", "pi R sqrt(rho/G) / (0.1631 nu + 0.8766) with G = E / (2 (1 + nu))");
}

} // namespace

std::string restitution_of(const SettleScript &s) {
  return "restitution " + (s.model.materials.empty()
                               ? digits6(Settling::restitution)
                               : "of each class its own; of the walls " + digits6(Settling::restitution));
}

std::string contact_table(const SettleScript &s, const ContactWords &words) {
  return row("contact", words.contact) + stiffness_row(s) + row("damping", words.damping) + friction_row(s) +
         rolling_row(s, words.rolling) + cohesion_row(s, words.cohesion) + time_row(s);
}

} // namespace mdm
