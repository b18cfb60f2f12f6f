#pragma once

#include "tolerant.hpp"

namespace mdm::checker::tolerant {

/// The masses M of samples with s < M <= S; S = 0 where there is no upper end.
struct Window {
  mpq_class s = 0, S = 0;
};

/// The leaves of windows of the mass (Theorem 20).
class Windows {
public:
  Windows(const Problem &problem, const Certificate &certificate);

  /// Demands that no match within the bounds on counts has its mass in the window.
  void refute(const std::vector<Multiple> &leaf, const Window &window, const CountsInForce &counts) const;

private:
  struct Sum;
  Sum add_up(const std::vector<Multiple> &leaf, const Window &window, const CountsInForce &counts) const;

  /// Bounds on the share of one class, in share units: they follow from all lines of the tolerance.
  struct OfShare {
    mpz_class l, h;
  };
  const Problem &problem_;
  const Certificate &certificate_;
  std::vector<OfShare> of_share_;
};

} // namespace mdm::checker::tolerant
