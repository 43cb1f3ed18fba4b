// Everything that happens at one pixel, in drawing order: the fragments that each pass sends, the tests that they pass,
// and the pixel's color after each fragment. The final color is predicted from the chain, not read back. Read why.h
// next, which turns the chain into sentences.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "topics/why/numbers/surface_color.h"

namespace viewing {

/// One fragment and its effect on the pixel.
struct Touch {
    Fragment fragment;
    SurfaceColor color;   ///< set if `paints`
    bool paints = false;  ///< passes all tests and writes color
    Color after;          ///< the pixel's color after it
    double share = 0.0;   ///< of the final color, 0 … 1: the rest has been painted over
};

struct PixelChain {
    glm::ivec2 pixel{0};  ///< (0, 0) is top left
    Color background;
    double background_share = 1.0;  ///< of the final color
    std::vector<Touch> touches;     ///< in drawing order
    int stencil = 0;                ///< at the end
    bool has_depth = false;         ///< something wrote depth
    std::uint32_t stored = 0;       ///< the code at the end
    Color color;                    ///< the scene's color at the end

    /// Returns whether rounding decides a depth comparison, as in a chain that chain_as_rounded() found.
    bool is_as_rounded() const;

    /// Returns how many touches write color, as the overdraw picture counts them.
    std::size_t times_painted() const;

    /// Returns the last touch that paints a surface of the real world or, with `mirrors_met`, of what those mirrors
    /// show; null for the background.
    const Touch* surface(const FramePlan& plan, std::span<const std::size_t> mirrors_met = {}) const;
};

/// Replays the frame at a pixel without multisampling. `plan` must belong to the finder's scene.
PixelChain pixel_chain(const FramePlan& plan, const FragmentFinder& finder, glm::ivec2 pixel, glm::ivec2 size_px);

/// Replays the frame as GL may have rounded it: depth comparisons of values that differ by less than GL's error may
/// have the opposite outcome. Returns the first such chain that predicts `read_back`; without one, the chain of exact
/// depths.
PixelChain chain_as_rounded(const FramePlan& plan, const FragmentFinder& finder, glm::ivec2 pixel, glm::ivec2 size_px,
                            const Color& read_back);

/// Returns whether GL's error may reverse the outcome of a fragment's depth comparison.
bool is_decided_by_rounding(const Fragment& fragment);

/// Returns whether two colors differ by at most one level per channel, which rounding in blending explains.
bool is_same_color(const Color& a, const Color& b);

/// Returns the chain's pixel as view.shows displays it: its own color, or the color of its depth, stencil or count.
/// None for heat maps and differences, whose colors are not computed.
std::optional<Color> predicted_color(const FramePlan& plan, const PixelChain& chain);

}  // namespace viewing
