#include "lesson/variants.h"

#include <numeric>
#include <string>
#include <utility>

namespace viewing {

std::uint64_t finalized(std::uint64_t bits) {
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31U);
}

std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t left = count; left > 1; --left) {
        seed += 0x9e3779b97f4a7c15U;
        std::swap(order[left - 1], order[finalized(seed) % left]);
    }
    return order;
}

std::size_t variant_of(std::string_view course, std::string_view student, std::string_view exercise,
                       std::size_t count) {
    std::string key(course);
    key.append("|").append(student).append("|").append(exercise);
    return finalized(fnv1a(key)) % count;
}

}  // namespace viewing
