#pragma once
/// \file
/// Comparisons that are decided or end the work.

#include "number/real.hpp"
#include "soil/available.hpp"

namespace mdm {

/// True if a < b. \throws NotAvailable where no precision tells
inline bool certainly_less(const Real &a, const Real &b) {
  const Order order = compare(a, b);
  if (order == Order::undecided)
    throw NotAvailable{"1,200 digits do not tell it from its limit", true};
  return order == Order::less;
}

} // namespace mdm
