#include "render/shared_tests.h"

#include <algorithm>

namespace viewing {
namespace {

/// Returns the highest region that the stencil may contain after a pass; the highest possible one if that is unknown.
int highest_after(const Pass& pass, int highest) {
    const StencilState& stencil = pass.stencil;
    const int written = stencil.write_bits & stencil_region_bits;
    if (!stencil.test || stencil.on_pass == StencilOp::keep || written == 0) return highest;
    if (written == stencil_region_bits && !pass.marks_objects) {
        if (stencil.on_pass == StencilOp::replace) return std::max(highest, stencil.reference & stencil_region_bits);
        if (stencil.on_pass == StencilOp::increment) return std::min(highest + 1, stencil_region_bits);
    }
    return stencil_region_bits;
}

StencilState at_least(int region) {
    StencilState state = inside(region);
    state.func = CompareFunc::lequal;  // GL tests reference ≤ stencil
    return state;
}

bool is_drawn_alike(const Pass& pass, const Pass& other) {
    return pass.subject == other.subject && pass.shading == other.shading && pass.blend == other.blend &&
           pass.color_write == other.color_write && pass.depth == other.depth;
}

}  // namespace

std::vector<StencilState> shared_stencil_tests(std::span<const Pass> passes) {
    std::vector<StencilState> tests;
    std::vector<bool> is_in_highest;
    int highest = 0;
    for (const Pass& pass : passes) {
        tests.push_back(pass.stencil);
        is_in_highest.push_back(pass.stencil == inside(highest));
        highest = highest_after(pass, highest);
    }
    for (std::size_t i = 0; i < passes.size(); ++i) {
        if (passes[i].stencil.test) continue;
        for (std::size_t other = 0; other < passes.size(); ++other) {
            if (!is_in_highest[other] || !is_drawn_alike(passes[i], passes[other])) continue;
            tests[i] = at_least(0);
            tests[other] = at_least(passes[other].stencil.reference);
        }
    }
    return tests;
}

}  // namespace viewing
