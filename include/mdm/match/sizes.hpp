#pragma once
/// \file
/// Particle sizes of a match: f^-1.

#include <mdm/match/problem.hpp>
#include <mdm/number/enclosure.hpp>

namespace mdm {

/// Encloses the size x of each class's particles at the scale S: f(x)^b = x^a = S m^b / (q c)^b (Arnold, Eq.
/// 19). Every enclosure lies inside its class, x_j < lo and hi <= x_{j+1}, for which digits are raised where
/// the size is close to the sieve (Theorem 9). One entry for each class of the problem. `margin` is
/// size_margin at S.
/// \pre S is in the window of q
/// \throws InputError if a size is an opening that is no decimal (1/3), which gradation files cannot have
std::vector<Enclosure> enclose_sizes(const Gradation &g, const Problem &problem,
                                     const std::vector<Integer> &q, const Rational &scale,
                                     const Rational &margin, unsigned digits);

/// Encloses the size x of class j's particles where x^a = n / d; the same promises.
Enclosure enclose_size(const Gradation &g, std::size_t j, const MassLaw &law, const Integer &n,
                       const Integer &d, unsigned digits);

/// How far the sizes are from the sieves: the least of x / lower and upper / x, minus 1, cut to three certain
/// digits. `above` and `up_to` are the window's ends that q gives.
Rational size_margin(const MassLaw &law, const Rational &above, const Rational &up_to, const Rational &scale);

} // namespace mdm
