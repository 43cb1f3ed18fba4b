#include "suite/numbers_apart.h"

#include <algorithm>
#include <cmath>

namespace viewing {
namespace {

struct Search {
    double tolerance;
    std::size_t most;
    std::vector<NumberChange> changes;

    void compare(const Json& expected, const Json& actual, const std::string& path) {
        if (changes.size() >= most) return;
        if (expected.is_object() && actual.is_object()) return compare_objects(expected, actual, path);
        if (expected.is_array() && actual.is_array()) return compare_arrays(expected, actual, path);
        if (!are_alike(expected, actual)) changes.push_back({path, expected, actual});
    }

private:
    bool are_alike(const Json& expected, const Json& actual) const {
        if (!expected.is_number() || !actual.is_number()) return expected == actual;
        const auto a = expected.get<double>(), b = actual.get<double>();
        return a == b || std::abs(a - b) <= tolerance * std::max(1.0, std::abs(a));
    }

    void compare_objects(const Json& expected, const Json& actual, const std::string& path) {
        const std::string front = path.empty() ? "" : path + ".";
        for (const auto& [key, value] : expected.items())
            compare(value, actual.contains(key) ? actual[key] : Json(), front + key);
        for (const auto& [key, value] : actual.items())
            if (!expected.contains(key)) compare(Json(), value, front + key);
    }

    void compare_arrays(const Json& expected, const Json& actual, const std::string& path) {
        for (std::size_t i = 0; i < std::max(expected.size(), actual.size()); ++i)
            compare(i < expected.size() ? expected[i] : Json(), i < actual.size() ? actual[i] : Json(),
                    path + "[" + std::to_string(i) + "]");
    }
};

}  // namespace

std::vector<NumberChange> numbers_apart(const Json& expected, const Json& actual, double tolerance, std::size_t most) {
    Search search{tolerance, most, {}};
    search.compare(expected, actual, "");
    return std::move(search.changes);
}

}  // namespace viewing
