#pragma once
/// \file
/// What the shares of a sample may differ by.

#include <mdm/gradation/envelope.hpp>
#include <mdm/match/tolerance.hpp>

#include <optional>
#include <string>
#include <vector>

namespace mdm {

/// The errors of shares that a sample may have.
struct AllowedError {
  Rational most = 0; ///< of a share; 1: any
  Tolerance bounds;
  std::string within; ///< in words, where there are bounds
};

/// Tolerances on what is retained in percent are errors of shares, as none at all is; all else is bounds.
/// \throws InputError as tolerance_of
AllowedError allowed_error(const Gradation &g, const std::vector<AskedTolerance> &asked,
                           const std::optional<Envelope> &band, const Rational &size_factor);

} // namespace mdm
