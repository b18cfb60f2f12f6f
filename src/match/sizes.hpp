#pragma once
/// \file
/// Particle sizes of a match: f^-1.

#include "match/problem.hpp"

#include <mdm/number/enclosure.hpp>

namespace mdm {

/// Encloses the size x of each class's particles at the scale S: x^(a d) = S m^p / (q c)^p, p the scale power
/// b d (Arnold, Eq. 19), or f(x) = S m / (q c) under a law by table or sum. Every enclosure lies inside its
/// class, x_j < lo and hi <= x_{j+1}, for which digits are raised where the size is close to the sieve
/// (Theorem 9). One entry for each class of the problem. `margin` is size_margin at S.
/// \pre S is in the window of q
/// \throws InputError if a size is an opening that is no decimal
std::vector<Enclosure> enclose_sizes(const Gradation &g, const Problem &problem,
                                     const std::vector<Integer> &q, const Rational &scale,
                                     const Rational &margin, unsigned digits);

/// Encloses the size x of class j's particles where x^degree = n / d, or f(x) = n / d under a law by table or
/// sum; the same promises.
Enclosure enclose_size(const Gradation &g, std::size_t j, const MassLaw &law, unsigned degree,
                       const Integer &n, const Integer &d, unsigned digits);

/// The distance of the sizes from the sieves: the least of x / lower and upper / x, minus 1, cut to three
/// certain digits. Scales are sizes to the power `degree`, a d, times a constant; `above` and `up_to` are the
/// window's ends that q gives.
Rational size_margin(unsigned degree, const Rational &above, const Rational &up_to, const Rational &scale);
/// The same by the enclosures of the problem's sizes.
Rational size_margin(const Gradation &g, const Problem &problem, const std::vector<Enclosure> &sizes);

} // namespace mdm
