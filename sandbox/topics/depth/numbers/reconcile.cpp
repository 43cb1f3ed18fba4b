#include "topics/depth/numbers/reconcile.h"

#include <algorithm>
#include <cmath>

#include "state/compare_func.h"

namespace viewing {
namespace {

/// Returns whether GL's depth for the fragment may equal the depth read back.
bool is_close(const Fragment& fragment, const PixelReport& report) {
    return std::abs(fragment.window_depth - report.window_depth) <=
           fragment.depth_error + code_width(report.precision, report.window_depth);
}

bool is_of_surface(const Fragment& fragment, const PixelReport& report) {
    return fragment.object == report.object && fragment.front_facing == report.front_facing;
}

bool is_compared(const Fragment& fragment) {
    return fragment.is_sent && fragment.depth.test && !fragment.culled && !fragment.stencil_fails;
}

/// Returns the last fragment drawn if it belongs to the surface read back. Otherwise, returns the fragment of that
/// surface that rounding may have let through and whose depth is closest to the one read back; end() if there is none.
std::vector<Fragment>::iterator read_back_one(std::vector<Fragment>& fragments, const PixelReport& report) {
    auto last = fragments.end();
    for (auto one = fragments.begin(); one != fragments.end(); ++one)
        if (one->drawn) last = one;
    if (last != fragments.end() && is_of_surface(*last, report)) return last;

    auto nearest = fragments.end();
    const auto off = [&](const Fragment& one) { return std::abs(one.window_depth - report.window_depth); };
    for (auto one = fragments.begin(); one != fragments.end(); ++one) {
        if (!is_of_surface(*one, report) || !is_compared(*one) || !is_close(*one, report)) continue;
        if (nearest == fragments.end() || off(*one) < off(*nearest)) nearest = one;
    }
    if (nearest == fragments.end()) return nearest;
    const bool is_explained = std::all_of(nearest + 1, fragments.end(), [&](const Fragment& later) {
        return !later.drawn || (is_compared(later) && is_close(later, report));
    });
    return is_explained ? nearest : fragments.end();
}

/// Sets whether a fragment passes, and whether rounding decided this: it did if the result contradicts the fragment's
/// codes or its earlier result.
void decide(Fragment& fragment, bool passes) {
    fragment.tie = fragment.stored == fragment.compared_with;
    const bool by_numbers = compare(fragment.depth.func, fragment.stored, fragment.compared_with);
    fragment.decided_by_rounding = passes != fragment.passes || passes != by_numbers;
    fragment.passes = passes;
}

/// Handles a pixel where no fragment wrote depth, so that all fragments were compared with the previous frame's value.
void compare_with_last_frame(std::vector<Fragment>& fragments, const PixelReport& report) {
    for (Fragment& fragment : fragments) {
        if (!is_compared(fragment)) continue;
        if (fragment.stored == fragment.compared_with && is_close(fragment, report)) fragment.stored = report.stored;
        fragment.compared_with = report.stored;
        decide(fragment, fragment.passes);
    }
}

}  // namespace

void reconcile(std::vector<Fragment>& fragments, const PixelReport& report, bool clears_depth) {
    const bool writes_depth = std::any_of(fragments.begin(), fragments.end(), [](const Fragment& fragment) {
        return fragment.passes && fragment.depth.test && fragment.depth.write;
    });
    if (!clears_depth && !report.written && !writes_depth) return compare_with_last_frame(fragments, report);
    if (!report.written) return;
    const auto seen = read_back_one(fragments, report);
    if (seen == fragments.end() || !is_compared(*seen)) return;
    const bool leaves_depth = seen->depth.write && std::none_of(seen + 1, fragments.end(), [](const Fragment& later) {
                                  return later.passes && !later.drawn;
                              });
    // If depth is not cleared, the fragments up to this one may have been compared with this surface's depth from the
    // previous frame.
    const std::uint32_t computed = seen->stored;
    if (leaves_depth && !clears_depth)
        for (auto one = fragments.begin(); one <= seen; ++one)
            if (is_compared(*one) && one->compared_with == computed) one->compared_with = report.stored;
    if (leaves_depth) seen->stored = report.stored;
    decide(*seen, true);
    seen->drawn = true;
    for (auto later = seen + 1; later != fragments.end(); ++later) {
        if (!is_compared(*later)) continue;
        if (leaves_depth) later->compared_with = report.stored;
        decide(*later, later->passes && !later->drawn);
        later->drawn = false;
    }
}

}  // namespace viewing
