// What a method did at the step, in words: Newell's ladder, the compare of the depth buffer, the hits of a ray. Read
// order_view.cpp for its use.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "frame/hidden/hidden_surfaces.h"

namespace viewing {

enum class RungState { failed, decided, untried };

/// Newell's tests for the pair of the step, in their order.
struct Ladder {
    std::string p, q;                                      ///< the polygons' names; q is empty when there is none
    std::array<RungState, newell_test_count - 1> rungs{};  ///< all untried when there is no B
    std::string action;                                    ///< a sentence
};

/// The sentence that a test claims, of A and B; not yet looked up.
const char* newell_test_text(NewellTest test);

/// None without a step of Newell's: at the beginning, and at the end, where all steps are told together.
std::optional<Ladder> newell_ladder(const HiddenResult& result);

/// "pixel (3, 4): polygon 12 of box, depth 0.9321 < stored 0.9518 → written". Empty without such a step.
std::string compare_sentence(const HiddenResult& result);

/// How far a step has come, in two levels: "triangle 3 of 9, fragment 12 of 40". A negative one is the last.
std::string progress_sentence(const HiddenResult& result, int step);
/// The same where there is no room for words: "3/9 · 12/40".
std::string progress_numbers(const HiddenResult& result, int step);

/// What a ray met, nearest first.
struct RayHitRow {
    int fragment = -1;  ///< −1 for an exact curved shape
    int source = -1;
    double distance = 0.0;  ///< world units from the near plane
};
std::vector<RayHitRow> ray_rows(const HiddenResult& result);
/// "The ray through pixel (3, 4) meets 3 surfaces: the first is seen." Always a sentence.
std::string ray_sentence(const HiddenResult& result);

}  // namespace viewing
