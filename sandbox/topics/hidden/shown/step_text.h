// A method's step in words: Newell's ladder, the depth buffer's comparison, or a ray's hits. See order_view.cpp for
// usage.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "topics/hidden/numbers/hidden_surfaces.h"

namespace viewing {

enum class RungState { failed, decided, untried };

/// Newell's tests of the step's pair, in order.
struct Ladder {
    std::string p, q;                                      ///< names of polygons A and B; q is empty if there is no B
    std::array<RungState, newell_test_count - 1> rungs{};  ///< all untried if there is no B
    std::string action;                                    ///< what the step does, as a sentence
};

/// Returns the statement about A and B that a test checks, untranslated.
const char* newell_test_text(NewellTest test);

/// Returns what Newell's algorithm does at the current step; null for other methods, at step 0, and when the view
/// summarizes all steps.
const NewellStep* newell_step(const HiddenResult& result);
/// Returns the ladder of that step, if there is one.
std::optional<Ladder> newell_ladder(const HiddenResult& result);

/// Describes the step's depth comparison: "pixel (3, 4): polygon 12 of box, depth 0.9321 < stored 0.9518 → written".
/// Empty if the step compares no pixel.
std::string compare_sentence(const HiddenResult& result);

/// Returns a step's progress, on two levels if the method's steps have them: "triangle 3 of 9, fragment 12 of 40". A
/// negative step means the last one.
std::string progress_sentence(const HiddenResult& result, int step);
/// Returns the same progress as numbers only, for narrow views, the longest form first: "3/9 · 12/40", "3/9".
std::vector<std::string> progress_numbers(const HiddenResult& result, int step);

/// A hit of the traced ray.
struct RayHitRow {
    int fragment = -1;  ///< −1 for an exact curved shape
    int source = -1;
    double distance = 0.0;  ///< world units from the near plane
};
std::vector<RayHitRow> ray_rows(const HiddenResult& result);
/// Says what the ray hits: "The ray through pixel (3, 4) hits 3 surfaces: the first one is visible." Never empty.
std::string ray_sentence(const HiddenResult& result);

}  // namespace viewing
