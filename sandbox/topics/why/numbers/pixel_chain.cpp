#include "topics/why/numbers/pixel_chain.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "frame/depth_colors.h"
#include "frame/ground.h"

namespace viewing {
namespace {

glm::dvec3 channels_of(const Color& color) {
    return {color.r, color.g, color.b};
}

Color rounded_color(const glm::dvec3& channels) {
    const auto one = [](double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)); };
    return {one(channels.r), one(channels.g), one(channels.b)};
}

Color scaled(const Color& color, double factor) {
    return rounded_color(channels_of(color) * factor);
}

/// Blends a touch over the pixel, as GL does with 8 bits per channel, and updates the shares of everything below it.
void paint(PixelChain& chain, Touch& touch, const Pass& pass) {
    const double alpha = pass.blend == Blend::alpha ? touch.color.alpha : 1.0;
    touch.after = rounded_color(255.0 * touch.color.srgb * alpha + channels_of(chain.color) * (1.0 - alpha));
    chain.color = touch.after;
    for (Touch& earlier : chain.touches) earlier.share *= 1.0 - alpha;
    chain.background_share *= 1.0 - alpha;
    touch.share = alpha;
}

/// Returns the color of the depth picture, like shaders/show_depth.frag.
Color depth_color(const FramePlan& plan, const PixelChain& chain) {
    const DepthPrecision precision = precision_of(plan.depth_format);
    const double depth = precision.is_float ? static_cast<double>(std::bit_cast<float>(chain.stored))
                                            : chain.stored / precision.greatest_code();
    if (!chain.has_depth) return plan.unwritten;
    const GrayScale scale = gray_scale(plan);
    const double value =
        plan.depth_scale == DepthScale::linear ? distance_of_window_depth(plan.lens, plan.depth_mapping, depth) : depth;
    const double gray = std::clamp((value - scale.first) * scale.slope, 0.0, 1.0);
    if (plan.depth_colors == DepthColors::bands) {
        const double last = static_cast<double>(depth_bands.size()) - 1.0;
        return depth_bands[static_cast<std::size_t>(std::min(std::floor(gray * (last + 1.0)), last))];
    }
    return rounded_color(glm::dvec3(255.0 * gray));
}

/// Returns the color of the stencil picture, like shaders/show_stencil.frag.
Color stencil_color(int stencil) {
    const int region = stencil & stencil_region_bits, missing = stencil & stencil_light_bits;
    const int count = std::popcount(static_cast<unsigned>(missing));
    const std::size_t kind = missing == 0 ? (region == 0 ? 0 : 1) : (region == 0 ? 3 : 2);
    return scaled(stencil_colors[kind], std::pow(0.82, std::max(region - 1, 0) + 1.5 * std::max(count - 1, 0)));
}

PixelChain chain_of(const FramePlan& plan, const FragmentFinder& finder, glm::ivec2 pixel, glm::ivec2 size_px,
                    std::span<const std::size_t> as_rounded) {
    PixelChain chain;
    chain.pixel = pixel;
    chain.background = chain.color = plan.background;
    for (Fragment& fragment : finder.everything_at(plan, pixel, size_px, as_rounded)) {
        const Pass& pass = plan.passes[fragment.pass];
        Touch touch;
        touch.fragment = std::move(fragment);
        touch.paints = touch.fragment.drawn;
        if (touch.paints && pass.blend != Blend::add) {
            touch.color = surface_color(plan, finder.scene(), touch.fragment, pixel, size_px);
            paint(chain, touch, pass);
        }
        touch.after = chain.color;
        chain.stencil = touch.fragment.stencil_after;
        chain.stored = touch.fragment.depth_after;
        chain.has_depth = chain.has_depth || (touch.fragment.passes && pass.depth.test && pass.depth.write);
        chain.touches.push_back(std::move(touch));
    }
    return chain;
}

}  // namespace

const Touch* PixelChain::surface(const FramePlan& plan, std::span<const std::size_t> mirrors_met) const {
    const Touch* last = nullptr;
    for (const Touch& touch : touches) {
        const Pass& pass = plan.passes[touch.fragment.pass];
        const bool is_there =
            std::equal(pass.mirrors_met.begin(), pass.mirrors_met.end(), mirrors_met.begin(), mirrors_met.end());
        if (touch.paints && is_there && is_surface(pass)) last = &touch;
    }
    return last;
}

bool PixelChain::is_as_rounded() const {
    return std::any_of(touches.begin(), touches.end(),
                       [](const Touch& touch) { return touch.fragment.decided_by_rounding; });
}

std::size_t PixelChain::times_painted() const {
    return static_cast<std::size_t>(
        std::count_if(touches.begin(), touches.end(), [](const Touch& touch) { return touch.paints; }));
}

bool is_decided_by_rounding(const Fragment& fragment) {
    const CompareFunc func = fragment.depth.func;
    if (!fragment.depth.test || fragment.culled || fragment.cut_off || fragment.stencil_fails || !fragment.is_sent ||
        func == CompareFunc::always || func == CompareFunc::never)
        return false;
    const double apart = std::abs(static_cast<double>(fragment.stored) - fragment.compared_with);
    return apart <= 2.0 * fragment.within;
}

bool is_same_color(const Color& a, const Color& b) {
    return std::abs(a.r - b.r) <= 1 && std::abs(a.g - b.g) <= 1 && std::abs(a.b - b.b) <= 1;
}

PixelChain pixel_chain(const FramePlan& plan, const FragmentFinder& finder, glm::ivec2 pixel, glm::ivec2 size_px) {
    return chain_of(plan, finder, pixel, size_px, {});
}

PixelChain chain_as_rounded(const FramePlan& plan, const FragmentFinder& finder, glm::ivec2 pixel, glm::ivec2 size_px,
                            const Color& read_back) {
    PixelChain exact = pixel_chain(plan, finder, pixel, size_px);
    const auto explains = [&](const PixelChain& chain) {
        const std::optional<Color> color = predicted_color(plan, chain);
        return color && is_same_color(*color, read_back);
    };
    if (!predicted_color(plan, exact) || explains(exact)) return exact;
    // Tries reversing one outcome, then two, then three; later outcomes depend on earlier ones.
    std::vector<std::pair<std::vector<std::size_t>, PixelChain>> tried;
    tried.emplace_back(std::vector<std::size_t>{}, exact);
    constexpr std::size_t most_tried = 64, most_opposite = 3;
    for (std::size_t next = 0; next < tried.size() && tried.size() < most_tried; ++next) {
        const std::vector<std::size_t> opposite = tried[next].first;
        if (opposite.size() == most_opposite) break;
        const std::size_t count = tried[next].second.touches.size();
        for (std::size_t at = opposite.empty() ? 0 : opposite.back() + 1; at < count; ++at) {
            if (!is_decided_by_rounding(tried[next].second.touches[at].fragment)) continue;
            std::vector<std::size_t> more = opposite;
            more.push_back(at);
            PixelChain chain = chain_of(plan, finder, pixel, size_px, more);
            if (explains(chain)) return chain;
            tried.emplace_back(std::move(more), std::move(chain));
        }
    }
    return exact;
}

std::optional<Color> predicted_color(const FramePlan& plan, const PixelChain& chain) {
    switch (plan.shows) {
        case Shows::depth:
            return depth_color(plan, chain);
        case Shows::stencil:
            return stencil_color(chain.stencil);
        case Shows::overdraw:
            return overdraw_colors[std::min(chain.times_painted(), overdraw_colors.size() - 1)];
        case Shows::fighting:
        case Shows::difference:
            return std::nullopt;
        default:
            return chain.color;
    }
}

}  // namespace viewing
