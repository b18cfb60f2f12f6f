#pragma once
/// \file
/// The fineness moduli of the standards.

#include <optional>
#include <string_view>

namespace mdm {

/// A fineness modulus: the sum, over the sieves of a standard, of the share of the mass on and above each.
enum class FinenessModulus {
  astm, ///< of ASTM C125, 11 sieves
  en    ///< of EN 12620, 6 sieves
};

/// `FM` or `FM-EN`.
std::string_view name(FinenessModulus modulus);
/// The modulus of that name; nothing if there is none.
std::optional<FinenessModulus> fineness_modulus_named(std::string_view text);

} // namespace mdm
