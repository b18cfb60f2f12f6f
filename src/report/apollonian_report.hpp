#pragma once
/// \file
/// What is known of an Apollonian packing, as text, JSON and CSV.

#include "packing/apollonian.hpp"
#include "text/sink.hpp"

namespace mdm {

/// A gasket and what was counted in it.
struct ApollonianReport {
  std::string name;  ///< `equal`, or the four curvatures
  Rational smallest; ///< radius
  ApollonianGasket gasket;
  ApollonianCensus census;

  /// The curvature of the smallest radius.
  Rational most() const { return 1 / smallest; }
};

/// For people.
std::string apollonian_text(const ApollonianReport &r);

/// One line of JSON, schema `mdm-apollonian-1`, without a newline at its end.
std::string apollonian_json(const ApollonianReport &r);

/// `p,q,x,y` of each circle below comments that say what they mean; in constant memory.
void apollonian_csv(const std::string &name, const ApollonianGasket &gasket, const Rational &most,
                    const Sink &sink);

} // namespace mdm
