#pragma once
/// \file
/// What was understood of a gradation file, for who wants to see it before anything rests on it.

#include <mdm/gradation/read_gradation.hpp>

namespace mdm {

/// A line for each thing that was understood. \param file its name, as it is shown
std::string reading_text(const UnderstoodGradation &u, const std::string &file);

/// The same as JSON: mdm-reading-1.
std::string reading_json(const UnderstoodGradation &u);

} // namespace mdm
