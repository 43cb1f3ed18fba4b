// An array with one value for each value of an enumeration.
#pragma once

#include <array>
#include <cstddef>

namespace viewing {

/// An array that the values of an enumeration index, which counts from 0.
template <typename Enum, typename Value, std::size_t count>
struct PerEnum : std::array<Value, count> {
    using Values = std::array<Value, count>;
    using Values::operator[];
    constexpr Value& operator[](Enum value) { return Values::operator[](static_cast<std::size_t>(value)); }
    constexpr const Value& operator[](Enum value) const { return Values::operator[](static_cast<std::size_t>(value)); }
};

/// Returns the values in the order of `Enum`.
template <typename Enum, typename Value, typename... More>
constexpr PerEnum<Enum, Value, 1 + sizeof...(More)> per_enum(Value first, More... more) {
    return {{first, more...}};
}

}  // namespace viewing
