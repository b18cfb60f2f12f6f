#pragma once
/// \file
/// Packing files, written.

#include "packing/packing.hpp"
#include "text/sink.hpp"

namespace mdm {

/// Lines of text: the header, a name and a value each,
///
///     mdm-packing 1
///     unit mm            of lengths, or `any`
///     places 12          lengths below are whole numbers of 10^-places of that unit
///     width 1234567      of the box
///     sides periodic     or walls
///     rule lowest        or drop, or apollonian
///     floor centred      or left
///     seed 1
///     front 7654321      height of the lowest centre among the discs that nothing covers
///     radii 0123456789abcdef    Packing::radii_hash()
///     discs 25000
///     x y r left right
///
/// then a line a disc in the order of the deposit: centre, radius, and what carries it on its left and on its
/// right: an earlier disc by its number, from 0, or `floor`, `left-wall`, `right-wall`, `none`. In each name
/// and value are one space apart.
void write_packing(const Packing &packing, const Sink &out);

/// The word for a support that is no disc.
std::string_view name(Support support);
/// `lowest`, `drop` or `apollonian`.
std::string_view name(DepositRule rule);
/// `left` or `centred`.
std::string_view name(FloorRule rule);

} // namespace mdm
