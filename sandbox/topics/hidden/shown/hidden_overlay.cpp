// Drawings over the pictures: polygon numbers, the linked polygon and its node, and the step's polygon, pixel, pair or
// ray.
#include "topics/hidden/shown/hidden_overlay.h"

#include <algorithm>
#include <array>
#include <string>

#include "frame/ground.h"
#include "text/catalogue.h"
#include "topics/hidden/numbers/hidden_method.h"
#include "topics/hidden/shown/raster_overlay.h"
#include "topics/hidden/shown/step_text.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"

namespace viewing {
namespace {

ImU32 im_color(const Color& color) {
    return IM_COL32(color.r, color.g, color.b, 255);
}

const Polygon* polygon_at(const HiddenResult& result, int fragment) {
    const auto& fragments = *result.fragments;
    return fragment >= 0 && fragment < std::ssize(fragments) ? &fragments[fragment] : nullptr;
}

void outline(Overlay& overlay, const Polygon& polygon, ImU32 color, float thickness) {
    for (std::size_t i = 0, last = polygon.vertices.size() - 1; i < polygon.vertices.size(); last = i++)
        overlay.line(polygon.vertices[last], polygon.vertices[i], color, thickness);
}

void outline_filled(Overlay& overlay, const Polygon& polygon, ImU32 color) {
    for (std::size_t corner = 2; corner < polygon.vertices.size(); ++corner)
        overlay.fill(
            {polygon.vertices[0], polygon.vertices[corner - 1], polygon.vertices[corner], polygon.vertices[corner]},
            with_alpha(color, 70));
    outline(overlay, polygon, color, 2.4F);
}

/// Whether a screen position is inside the projected polygon.
bool covers(const Overlay& overlay, const Polygon& polygon, ImVec2 place) {
    bool left = false, right = false;
    std::optional<ImVec2> before = overlay.project(polygon.vertices.back());
    for (const glm::dvec3& vertex : polygon.vertices) {
        const std::optional<ImVec2> here = overlay.project(vertex);
        if (!here || !before) return false;
        const float turn =
            (here->x - before->x) * (place.y - before->y) - (here->y - before->y) * (place.x - before->x);
        (turn < 0.0F ? left : right) = true;
        before = here;
    }
    return left != right;
}

struct NumberBox {
    ImVec2 min, max;

    bool overlaps(const NumberBox& other) const {
        return min.x < other.max.x && other.min.x < max.x && min.y < other.max.y && other.min.y < max.y;
    }
};

/// Returns the box for a polygon's number, which is at the polygon's center. Returns nullopt unless the center is
/// visible and the number fits into the polygon.
std::optional<NumberBox> number_box(const Overlay& overlay, const HiddenResult& result, const Polygon& polygon,
                                    ImVec2 size) {
    const std::optional<ImVec2> middle = overlay.project(centroid(polygon));
    if (!middle) return std::nullopt;
    if (!result.image.ids.empty()) {
        const auto pixel = RasterPlaces(overlay.rect(), result).pixel_at(*middle);
        if (!pixel || result.image.id(pixel->x, pixel->y) != polygon.source) return std::nullopt;
    }
    const NumberBox box{{middle->x - size.x * 0.5F, middle->y - size.y * 0.5F},
                        {middle->x + size.x * 0.5F, middle->y + size.y * 0.5F}};
    const bool fits = covers(overlay, polygon, box.min) && covers(overlay, polygon, box.max);
    return fits ? std::optional(box) : std::nullopt;
}

/// Labels each polygon with its number in the drawing order. If numbers overlap, only the number of the polygon drawn
/// last remains.
void numbers(Overlay& overlay, const HiddenResult& result) {
    constexpr int most = 3000;
    ImFont* font = widgets::CurrentContext().fonts.small_number;
    std::vector<NumberBox> taken;
    for (int place = result.drawn - 1; place >= std::max(0, result.drawn - most); --place) {
        const Polygon* polygon = polygon_at(result, result.order[place]);
        const std::string text = std::to_string(place + 1);
        const ImVec2 size =
            font ? font->CalcTextSizeA(font->FontSize, 1e30F, 0.0F, text.c_str()) : ImGui::CalcTextSize(text.c_str());
        const std::optional<NumberBox> box = number_box(overlay, result, *polygon, size);
        if (!box ||
            std::any_of(taken.begin(), taken.end(), [&](const NumberBox& other) { return box->overlaps(other); }))
            continue;
        taken.push_back(*box);
        widgets::PlateText(overlay.draw(), box->min, palette().text, text.c_str(), font);
    }
}

std::string depth_decimals(double depth) {
    return depth < 1e300 ? number_text(depth, 5) : "∞";
}

/// Draws the step's pair, pixel, ray, or polygon over the camera's picture.
void step_in_camera(Overlay& overlay, const HiddenResult& result) {
    if (result.traced) {
        const auto hits = static_cast<std::int64_t>(result.traced->hits.size());
        draw_pixel_of_step(overlay, result, result.traced->pixel,
                           hits == 0 ? tr("no hit") : say_count(hits, "{count} hit", "{count} hits, the nearest wins"));
        return;
    }
    if (result.step < 0) return;
    if (const NewellStep* const step = newell_step(result)) {
        if (const Polygon* q = polygon_at(result, step->q)) outline_filled(overlay, *q, palette().mirror);
        if (const Polygon* p = polygon_at(result, step->p)) outline_filled(overlay, *p, palette().light);
        if (const Polygon* p = polygon_at(result, step->p)) overlay.label(centroid(*p), "A", palette().light);
        if (const Polygon* q = polygon_at(result, step->q)) overlay.label(centroid(*q), "B", palette().mirror);
        return;
    }
    if (result.compare && result.compare->polygon >= 0) {
        const RasterStep& step = *result.compare;
        const std::string depth = depth_decimals(step.depth), stored = depth_decimals(step.stored_depth);
        draw_pixel_of_step(overlay, result, {step.x, step.y},
                           step.written
                               ? say("{depth} < {stored}: written", "depth"_a = depth, "stored"_a = stored)
                               : say("{depth} ≥ {stored}: not written", "depth"_a = depth, "stored"_a = stored));
        return;
    }
    const int last = result.drawn - 1;
    if (last < 0 || last >= std::ssize(result.order)) return;
    if (const Polygon* polygon = polygon_at(result, result.order[last]))
        outline(overlay, *polygon, palette().accent, 2.4F);
}

/// Outlines the polygons of a subtree; if there are too many, only some of them.
void subtree(Overlay& overlay, const BspTree& tree, int root, ImU32 color) {
    constexpr int most = 4000;
    std::vector<int> waiting;
    if (root >= 0) waiting.push_back(root);
    for (int drawn = 0; !waiting.empty() && drawn < most;) {
        const BspNode& node = tree.nodes[waiting.back()];
        waiting.pop_back();
        for (int i = 0; i < node.fragment_count; ++i, ++drawn)
            outline(overlay, tree.fragments[node.first_fragment + i], color, 1.4F);
        for (const int child : {node.front, node.back})
            if (child >= 0) waiting.push_back(child);
    }
}

/// Draws a square in a node's plane, the plane's normal, and the polygons on either side, with one color for each side.
void node_in_observer(Overlay& overlay, const HiddenResult& result, int index) {
    const BspTree& tree = *result.tree;
    if (index < 0 || index >= std::ssize(tree.nodes)) return;
    const BspNode& node = tree.nodes[index];
    const ImU32 front = im_color(front_color), back = im_color(back_color);
    subtree(overlay, tree, node.front, with_alpha(front, 200));
    subtree(overlay, tree, node.back, with_alpha(back, 200));
    if (node.fragment_count == 0) return;
    const Polygon& polygon = tree.fragments[node.first_fragment];
    const glm::dvec3 normal(node.plane), middle = centroid(polygon);
    const glm::dvec3 along = glm::normalize(
        glm::cross(normal, std::abs(normal.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0)));
    const glm::dvec3 across = glm::cross(normal, along);
    const double half = 0.35 * result.surface->diagonal;
    const std::array<glm::dvec3, 4> corners = {middle + half * (along + across), middle + half * (along - across),
                                               middle - half * (along + across), middle - half * (along - across)};
    overlay.fill(corners, with_alpha(palette().plane, 50));
    for (std::size_t i = 0; i < 4; ++i) overlay.line(corners[i], corners[(i + 1) % 4], palette().plane, 1.6F);
    const double arrow = 0.25 * half;
    overlay.arrow(middle, middle + arrow * normal, palette().plane);
    overlay.label(middle + arrow * normal, tr("front"), front);
    overlay.label(middle - arrow * normal, tr("back"), back);
    outline(overlay, polygon, palette().accent, 2.4F);
}

}  // namespace

std::optional<glm::ivec2> method_pixel_at(const HiddenStatus& hidden, const Overlay& overlay, ImVec2 place) {
    if (!hidden.answer || hidden.answer->camera->image.ids.empty()) return std::nullopt;
    return RasterPlaces(overlay.rect(), *hidden.answer->camera).pixel_at(place);
}

void choose_pixel(VisibilityParams& visibility, const HiddenResult& result, glm::ivec2 pixel) {
    if (hidden_method(visibility.method).casts_rays && visibility.step >= 0) {
        visibility.step = pixel.y * result.image.width + pixel.x + 1;
        visibility.pixel.reset();
    } else if (visibility.pixel == pixel) {
        visibility.pixel.reset();
    } else {
        visibility.pixel = pixel;
    }
}

int fragment_at(const HiddenStatus& hidden, const Overlay& overlay, ImVec2 pointed) {
    const std::optional<glm::ivec2> at = method_pixel_at(hidden, overlay, pointed);
    if (!at) return -1;
    const HiddenResult& result = *hidden.answer->camera;
    const int source = result.image.id(at->x, at->y);
    if (source == IdImage::background) return -1;
    const ImVec2 place = RasterPlaces(overlay.rect(), result).middle(*at);
    const bool has_order = !result.order.empty();  // ray casting has no order
    for (int turn = (has_order ? result.drawn : static_cast<int>(result.fragments->size())) - 1; turn >= 0; --turn) {
        const int fragment = has_order ? result.order[turn] : turn;
        const Polygon* polygon = polygon_at(result, fragment);
        if (polygon && polygon->source == source && covers(overlay, *polygon, place)) return fragment;
    }
    return -1;
}

void draw_hidden_overlay(const PolygonLink& link, const Session& session, const HiddenStatus& hidden,
                         Overlay& overlay) {
    if (hidden.fraction) {
        const std::string text = say("Running the method: {percent}", "percent"_a = progress_text(*hidden.fraction));
        widgets::PlateText(overlay.draw(), {overlay.rect().min.x + px(10.0F), overlay.rect().min.y + px(8.0F)},
                           palette().text, text.c_str());
    }
    if (!hidden.answer) return;
    const HiddenResult& result = *hidden.answer->camera;
    draw_raster_lines(overlay, result);
    if (session.params.visibility.numbers) numbers(overlay, result);
    draw_chosen_pixel(overlay, result);
    step_in_camera(overlay, result);
    if (result.step >= 0 && session.params.view.shows == Shows::color) {
        const std::string progress = progress_sentence(result, result.step);
        overlay.keep_labels_off(
            sentence_over_picture(overlay.draw(), overlay.rect(), palette().text, progress.c_str(), progress.c_str()));
    }
    draw_raster_depths(overlay, result);
    if (const Polygon* polygon = polygon_at(result, link.shown_fragment()))
        outline_filled(overlay, *polygon, palette().accent);
}

void draw_hidden_observer(const PolygonLink& link, const HiddenStatus& hidden, Overlay& overlay) {
    if (!hidden.answer) return;
    const HiddenResult& result = *hidden.answer->camera;
    if (result.tree)
        node_in_observer(overlay, result, link.shown_node() >= 0 ? link.shown_node() : current_node(result));
    if (result.traced) {
        const TracedRay& traced = *result.traced;
        const double reach = traced.hits.empty() ? 2.0 * result.surface->diagonal : traced.hits.back().t;
        overlay.line(traced.ray.origin, traced.ray.at(reach), palette().accent, 1.6F);
        for (const RayCastHit& hit : traced.hits)
            overlay.dot(traced.ray.at(hit.t), &hit == traced.hits.data() ? palette().accent : palette().quiet,
                        &hit == traced.hits.data() ? 5.0F : 3.5F);
    }
    if (const Polygon* polygon = polygon_at(result, link.shown_fragment()))
        outline_filled(overlay, *polygon, palette().accent);
}

}  // namespace viewing
