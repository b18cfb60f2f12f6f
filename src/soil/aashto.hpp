#pragma once
/// \file
/// The classification of soils for highways, AASHTO M 145 (ASTM D3282).

#include "soil/uscs.hpp"

namespace mdm {

/// A group such as `A-2-4`, with what it usually is and its group index.
struct AashtoGroup {
  std::string symbol, name;
  std::optional<Integer> index; ///< nothing where it needs Atterberg limits that are not known
  bool operator==(const AashtoGroup &) const = default;
};

/// The group of the part that passes 75 mm, from what passes 2, 0.425 and 0.075 mm and the limits of the
/// fines. As the standard has it, percents and limits are whole numbers: each is rounded to the nearest,
/// halves to the even one (AASHTO R 11), which is decided exactly. The plasticity index is the difference of
/// the rounded limits (ASTM D4318, AASHTO T 90), and 0 is nonplastic. Without limits the fines are nonplastic
/// with a liquid limit of at most 40, and an index that depends on it is not known. Where 0.075 mm lies in a
/// pan at size 0 there is a group only if all its mass may be finer or none without a change; then without an
/// index that this would change.
Available<AashtoGroup> classify_aashto(const GradingCurve &curve,
                                       const std::optional<AtterbergLimits> &limits);

} // namespace mdm
