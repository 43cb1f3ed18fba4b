#include "frame/pinned_pixel.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "frame/box_tree.h"
#include "topics/depth/numbers/fragments.h"

namespace viewing {
namespace {

bool is_inside(glm::ivec2 pixel, glm::ivec2 size_px) {
    return pixel.x >= 0 && pixel.y >= 0 && pixel.x < size_px.x && pixel.y < size_px.y;
}

glm::ivec2 pixel_of(const glm::dvec2& place_px) {
    return glm::ivec2(glm::floor(place_px));
}

PinnedPixel at_place(const glm::dvec2& place_px, glm::ivec2 size_px) {
    const glm::ivec2 pixel = pixel_of(place_px);
    if (!is_inside(pixel, size_px)) return {std::nullopt, message("The pinned pixel is outside the picture.")};
    return {pixel};
}

/// Returns the pixels of a grid over the visible part of the box, nearest to the box's middle first.
std::vector<glm::ivec2> candidates(const ScreenBox& box, glm::ivec2 size_px) {
    constexpr int most_on_a_side = 33;
    const glm::dvec2 middle = 0.5 * (box.min_px + box.max_px);
    const glm::dvec2 from = glm::max(box.min_px, glm::dvec2(0.0));
    const glm::dvec2 to = glm::min(box.max_px, glm::dvec2(size_px) - 1e-6);
    std::vector<glm::ivec2> pixels;
    if (from.x > to.x || from.y > to.y) return pixels;
    if (is_inside(pixel_of(middle), size_px)) pixels.push_back(pixel_of(middle));
    const glm::ivec2 counts = glm::clamp(glm::ivec2(to - from) + 1, 1, most_on_a_side);
    for (int row = 0; row < counts.y; ++row)
        for (int column = 0; column < counts.x; ++column) {
            const glm::dvec2 share = (glm::dvec2(column, row) + 0.5) / glm::dvec2(counts);
            pixels.push_back(pixel_of(from + share * (to - from)));
        }
    std::stable_sort(pixels.begin(), pixels.end(), [&middle](const glm::ivec2& a, const glm::ivec2& b) {
        return glm::distance(glm::dvec2(a) + 0.5, middle) < glm::distance(glm::dvec2(b) + 0.5, middle);
    });
    return pixels;
}

/// Returns whether the visible fragment, which is the last one drawn, belongs to the object.
bool is_seen_at(const FragmentFinder& finder, const FramePlan& plan, glm::ivec2 pixel, glm::ivec2 size_px,
                const std::string& object) {
    const std::vector<Fragment> fragments = finder.at(plan, pixel, size_px);
    const auto seen =
        std::find_if(fragments.rbegin(), fragments.rend(), [](const Fragment& fragment) { return fragment.drawn; });
    return seen != fragments.rend() && seen->object == object;
}

}  // namespace

std::optional<ScreenBox> projected_box(const SceneObject& object, const glm::dmat4& clip_from_world,
                                       glm::ivec2 size_px) {
    const Bounds bounds = vertex_tree(object.mesh)->bounds();
    const glm::dvec2 size(size_px);
    ScreenBox box{glm::dvec2(1e300), glm::dvec2(-1e300)};
    constexpr double least_w = 1e-6;
    int behind = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 model((corner & 1) != 0 ? bounds.max.x : bounds.min.x,
                               (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                               (corner & 4) != 0 ? bounds.max.z : bounds.min.z);
        const glm::dvec4 clip = clip_from_world * object.world_from_model * glm::dvec4(model, 1.0);
        if (clip.w < least_w) {
            ++behind;
            continue;
        }
        const glm::dvec2 place = glm::dvec2(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w) * size;
        box.min_px = glm::min(box.min_px, place);
        box.max_px = glm::max(box.max_px, place);
    }
    if (behind == 8) return std::nullopt;
    if (behind > 0) return ScreenBox{glm::dvec2(0.0), size};
    if (box.max_px.x < 0.0 || box.max_px.y < 0.0 || box.min_px.x >= size.x || box.min_px.y >= size.y)
        return std::nullopt;
    return box;
}

PinnedPixel pinned_pixel(const Params& params, const Derived& derived, const FramePlan& plan, const Scene& scene,
                         glm::ivec2 size_px) {
    const ViewParams& view = params.view;
    if (!view.pin) return view.pixel ? at_place(glm::dvec2(*view.pixel) + 0.5, size_px) : PinnedPixel{};
    const Pin& pin = *view.pin;
    if (pin.object.empty()) {
        // Points on the right and bottom edges belong to the last pixels.
        const glm::dvec2 place = pin.at.value_or(glm::dvec2(0.5)) * glm::dvec2(size_px);
        return at_place(glm::min(place, glm::dvec2(size_px) - 0.5), size_px);
    }
    const SceneObject* object = scene.find(pin.object);
    if (!object) return {std::nullopt, message("The scene has no object {name} to pin.", "name"_a = pin.object)};
    const std::optional<ScreenBox> box = projected_box(*object, derived.clip_from_world, size_px);
    if (box && pin.at) return at_place(box->min_px + *pin.at * (box->max_px - box->min_px), size_px);
    if (box) {
        const FragmentFinder finder(scene);
        FramePlan whole = plan;
        whole.limit = {};  // the step at which the frame stops does not move the pin
        for (const glm::ivec2& pixel : candidates(*box, size_px))
            if (is_seen_at(finder, whole, pixel, size_px, pin.object)) return {pixel};
    }
    return {std::nullopt, message("No part of the pinned object {name} is visible.", "name"_a = pin.object)};
}

}  // namespace viewing
