#pragma once
/// \file
/// The answers to many gradations as one table.

#include <mdm/match/match.hpp>

#include <string>

namespace mdm {

/// id,class,lower_<unit>,upper_<unit>,share_percent,quantity,size_lo_<unit>,size_hi_<unit>.
std::string batch_csv_header(std::string_view unit);

/// A row a class, empty ones included, from the finest up; classes are counted from 1. The share is that of
/// the match, cut to 15 digits; without an answer the gradation's, with no quantity.
std::string batch_csv(const Match &m);

} // namespace mdm
