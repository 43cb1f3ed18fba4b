// The value or message that every outer boundary (files, arguments, GL startup) returns. Inside the program, a wrong
// call is a programming error and fails an assertion instead.
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace viewing {

/// One sentence for the user: what was wrong, where, and what is allowed.
struct Error {
    std::string message;
};

/// Either a value or one sentence that says why there is none.
template <typename T>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(Error error) : content_(std::move(error)) {}

    explicit operator bool() const { return content_.index() == 0; }
    const std::string& error() const { return std::get<1>(content_).message; }

    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T operator*() && { return std::move(value()); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

private:
    T& value() {
        assert(content_.index() == 0);
        return std::get<0>(content_);
    }
    const T& value() const {
        assert(content_.index() == 0);
        return std::get<0>(content_);
    }

    std::variant<T, Error> content_;
};

/// A Result without a value: either success, or one sentence that says what went wrong.
using Status = Result<std::monostate>;

}  // namespace viewing
