#include "cli/search_progress.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

namespace mdm::cli {

SearchProgress::SearchProgress(bool quiet) : line_([this] { return text(); }, quiet) {}

ProgressCall SearchProgress::call() {
  return [this](const mdm::Progress &progress) {
    const std::lock_guard lock(mutex_);
    known_ = progress;
    return !Interrupt::was_pressed();
  };
}

std::string SearchProgress::text() {
  const std::lock_guard lock(mutex_);
  if (!known_)
    return "solving";
  const std::string least = to_string(known_->lower_bound);
  if (!known_->particles)
    return fmt::format("solving, at least {} particles", least);
  const Rational gap = Rational(*known_->particles - known_->lower_bound) / Rational(*known_->particles);
  return fmt::format("solving, N in [{}, {}], gap {} %", least, to_string(*known_->particles),
                     approximate(Rational(gap * 100), 3));
}

} // namespace mdm::cli
