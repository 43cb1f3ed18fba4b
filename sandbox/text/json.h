// The JSON library, for the files that build or read trees. When a key is read from a constant object, the library only
// asserts that the key exists; here, reading a missing key throws in every build, so that guarded() reports it and no
// build reads freed memory. Include this only where a tree is needed, because the library's header compiles slowly.
#pragma once

#include <stdexcept>
#include <string>

namespace viewing {

/// Bad input, described in a complete sentence for the user. The readers throw it; guarded() catches it at their
/// boundary.
struct Refusal : std::runtime_error {
    using std::runtime_error::runtime_error;
};

inline void check_json(bool is_true, const char* condition) {
    if (!is_true) throw Refusal(std::string("is incomplete: ") + condition + " failed");
}

}  // namespace viewing

#define JSON_ASSERT(condition) viewing::check_json(static_cast<bool>(condition), #condition)
#include <nlohmann/json.hpp>

// Compiled once, in json.cpp. Otherwise each program gets the copy of one of its sources, which may not be optimized.
extern template class nlohmann::basic_json<nlohmann::ordered_map>;
extern template class nlohmann::detail::serializer<nlohmann::ordered_json>;
extern template class std::vector<nlohmann::ordered_json>;
