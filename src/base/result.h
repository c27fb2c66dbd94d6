// Result<T>: a value or the reasons why there is none, with warnings beside either.
#pragma once

#include <optional>
#include <utility>

#include "base/diagnostic.h"

namespace filigree {

template <class T>
class [[nodiscard]] Result {
public:
    Result(T value, Diagnostics warnings = {})  // NOLINT(google-explicit-constructor): `return value;` is the point
        : value_(std::move(value)), diagnostics_(std::move(warnings)) {}
    Result(Diagnostic reason) { diagnostics_.push_back(std::move(reason)); }  // NOLINT(google-explicit-constructor)
    Result(Diagnostics reasons) : diagnostics_(std::move(reasons)) {}         // NOLINT(google-explicit-constructor)

    explicit operator bool() const { return value_.has_value(); }
    const T& operator*() const& { return value_.value(); }
    T& operator*() & { return value_.value(); }
    T&& operator*() && { return std::move(value_).value(); }
    const T* operator->() const { return &value_.value(); }
    T* operator->() { return &value_.value(); }

    const Diagnostics& diagnostics() const& { return diagnostics_; }
    Diagnostics&& diagnostics() && { return std::move(diagnostics_); }

private:
    std::optional<T> value_;
    Diagnostics diagnostics_;
};

}  // namespace filigree
