#pragma once
/// \file
/// Values that a gradation may not have.

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace mdm {

/// Why a value is not available.
struct NotAvailable {
  std::string reason;   ///< for people, without a full stop
  bool limited = false; ///< the data suffice, but a limit of precision was reached
};

/// A value, or the reason why there is none.
template <class T>
class Available {
public:
  Available(T value) : content_(std::move(value)) {}
  Available(NotAvailable why) : content_(std::move(why)) {}

  explicit operator bool() const { return content_.index() == 0; }
  /// \pre it is available
  const T &operator*() const {
    assert(*this);
    return std::get<0>(content_);
  }
  const T *operator->() const { return &**this; }
  /// \pre it is not available
  const NotAvailable &why() const {
    assert(!*this);
    return std::get<1>(content_);
  }

private:
  std::variant<T, NotAvailable> content_;
};

} // namespace mdm
