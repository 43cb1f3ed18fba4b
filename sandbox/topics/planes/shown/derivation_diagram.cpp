#include "topics/planes/shown/derivation_diagram.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "text/catalogue.h"
#include "topics/planes/shown/derivation_text.h"
#include "ui/parts/look.h"
#include "ui/parts/slide_figure.h"
#include "ui/parts/view_parts.h"

namespace viewing {
namespace {

/// Returns some unit vector in the plane with this normal.
glm::dvec3 along_plane(const glm::dvec3& normal) {
    const glm::dvec3 axis = std::abs(normal.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    return glm::normalize(axis - normal * glm::dot(axis, normal));
}

/// The figure's axes, and the light's direction and position in the figure.
struct ShadowPlaces {
    glm::dvec3 up, across;
    glm::dvec3 towards_light;  ///< unit vector from p; zero if there is no ray
    glm::dvec3 source;         ///< start of the ray: l, or a point far away toward the light
    bool has_light = false;    ///< l is a point within reach
};

ShadowPlaces shadow_places(const ShadowDerivation& found, double farthest_world) {
    const glm::dvec3 n(found.unit_plane);
    ShadowPlaces places{};
    const double side = found.ray == ShadowRay::light_in_plane ? found.point_height : found.light_height;
    places.up = side < 0.0 ? -n : n;
    glm::dvec3 towards = found.parallel_light ? found.light_world : found.light_world - found.point_world;
    const double length = glm::length(towards);
    if (length > 1e-9) places.towards_light = towards / length;
    const glm::dvec3 flat = places.towards_light - n * glm::dot(n, places.towards_light);
    places.across = glm::length(flat) > 1e-6 ? -glm::normalize(flat) : along_plane(n);
    places.has_light = !found.parallel_light && length < 100.0 * farthest_world;
    places.source =
        places.has_light ? found.light_world : found.point_world + places.towards_light * 100.0 * farthest_world;
    return places;
}

/// Returns the points to fit into the figure. They include the ray at least as far as it runs for l_w = 1, but no
/// farther than `farthest_world`.
std::array<glm::dvec3, 4> shown_points(const ShadowDerivation& found, const ShadowPlaces& places,
                                       double farthest_world) {
    const glm::dvec3& p = found.point_world;
    const double as_point = glm::length(glm::dvec3(found.light) - p);
    const double reach = std::min(std::max(as_point, 1.5 * found.point_to_shadow), farthest_world);
    const double to_source = std::min(glm::length(places.source - p), reach);
    glm::dvec3 s = found.shadow_world.value_or(found.point_foot_world);
    if (glm::length(s - p) > farthest_world) s = p + glm::normalize(s - p) * farthest_world;
    return {p, found.point_foot_world, p + places.towards_light * to_source, s};
}

/// Draws l above its foot, and the two similar triangles at l, whose heights have the ratio t.
void draw_light_side(Figure& figure, const ShadowDerivation& found, const ShadowPlaces& places, const glm::dvec3& s) {
    const ImU32 light = palette().light;
    const glm::dvec3 &l = found.light_world, &foot = found.light_foot_world, &p = found.point_world;
    const glm::dvec3 level = foot + glm::dvec3(found.unit_plane) * found.point_height;  // above foot, as high as p
    figure.triangle(l, foot, s, light, 26);
    figure.triangle(l, level, p, light, 34);
    figure.dashed(l, foot, light);
    figure.dashed(level, p, palette().quiet);
    figure.right_angle(foot, places.across, places.up);
    const bool has_heights = !widgets::IsCovered("label:heights");
    if (has_heights) figure.dimension(l, foot, "n·ℓ + d", found.light_height, palette().plane);
    figure.mark_target("label:heights", l, foot);
    if (figure.has_room() && has_heights)
        figure.measure(l, level, "n·ℓ − n·p", found.n_dot_l - found.n_dot_p, palette().quiet);
    figure.measure(l, p, "|p − ℓ|", found.light_to_point, light);
}

void draw_point_side(Figure& figure, const ShadowDerivation& found, const ShadowPlaces& places) {
    const glm::dvec3 &p = found.point_world, &foot = found.point_foot_world;
    if (found.shadow_world) {
        figure.triangle(p, foot, *found.shadow_world, palette().point, 30);
        figure.measure(p, *found.shadow_world, "|s − p|", found.point_to_shadow, palette().light);
    }
    figure.dashed(p, foot, palette().point);
    const double upwards = glm::dot(p - foot, places.up) < 0.0 ? -1.0 : 1.0;
    figure.right_angle(foot, places.across, places.up * upwards);
    if (!widgets::IsCovered("label:heights")) figure.measure(p, foot, "n·p + d", found.point_height, palette().plane);
    figure.mark_target("label:heights", p, foot);
}

}  // namespace

void draw_shadow_diagram(const Rect& rect, const ShadowDerivation& found, double farthest_world) {
    const ShadowPlaces places = shadow_places(found, farthest_world);
    CrossSection section(rect, found.point_foot_world, places.across, places.up);
    const std::array<glm::dvec3, 4> shown = shown_points(found, places, farthest_world);
    const float left = std::min(Figure::has_room(rect) ? px(150.0F) : px(56.0F), rect.width() * 0.3F);
    const float right = std::min(px(40.0F), rect.width() * 0.2F), above = std::min(px(26.0F), rect.height() * 0.2F);
    section.fit(shown, {left, right, above, above});

    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRect(rect.min, rect.max, true);
    section.draw_plane(draw, glm::dot(places.up, glm::dvec3(found.unit_plane)) > 0.0);
    {
        Figure figure(section);
        const glm::dvec3& p = found.point_world;
        const bool has_ray = places.towards_light != glm::dvec3(0.0);
        if (found.shadow_world) figure.name(*found.shadow_world, "s", palette().light);
        figure.name(p, "p", palette().point);
        if (places.has_light) figure.name(found.light_world, "ℓ", palette().light);
        if (places.has_light && found.shadow_world) draw_light_side(figure, found, places, *found.shadow_world);
        draw_point_side(figure, found, places);
        if (has_ray) figure.line(places.source, p, palette().light, 2.0F);
        if (found.shadow_world) figure.line(p, *found.shadow_world, palette().light, 2.0F);
        if (found.ray == ShadowRay::parallel)
            figure.line(p, p - places.towards_light * 100.0 * farthest_world, palette().light, 2.0F);
        figure.dot(found.point_foot_world, palette().plane, 3.0F);
        if (places.has_light) {
            figure.dot(found.light_foot_world, palette().plane, 3.0F);
            figure.dot(found.light_world, palette().light, 5.5F);
        }
        if (found.shadow_world) figure.dot(*found.shadow_world, palette().light);
        figure.dot(p, palette().point, 5.0F);
    }
    draw->PopClipRect();
}

void draw_mirror_diagram(const Rect& rect, const MirrorDerivation& found) {
    const glm::dvec3 n(found.unit_plane), across = along_plane(n);
    const bool is_wall = std::abs(n.y) < 0.5;
    CrossSection section(rect, found.foot_world, across, n, is_wall);
    const double k = std::max(std::abs(found.k), 1e-3);
    const std::array<glm::dvec3, 2> shown = {found.foot_world + n * k, found.foot_world - n * k};
    const float margin = std::min(px(34.0F), std::min(rect.width(), rect.height()) * 0.25F);
    section.fit(shown, {margin, margin, margin, margin});

    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRect(rect.min, rect.max, true);
    section.draw_plane(draw, true);
    {
        Figure figure(section);
        const glm::dvec3 &q = found.point_world, &foot = found.foot_world, &image = found.mirrored_world;
        figure.name(q, "q", palette().point);
        const bool has_image = !is_image_covered();
        figure.mark_target("label:mirrored", image, image);
        if (has_image) figure.name(image, "q′", palette().mirror);
        figure.name(foot, tr("foot"), palette().plane);
        figure.line(q, foot, palette().point, 2.0F);
        if (has_image) figure.dashed(foot, image, palette().mirror);
        figure.right_angle(foot, across, n * (found.k < 0.0 ? -1.0 : 1.0));
        figure.measure(q, foot, "k", found.k, palette().point);
        if (has_image) figure.measure(foot, image, "k", found.k, palette().mirror);
        figure.dot(foot, palette().plane, 3.5F);
        if (has_image) figure.dot(image, palette().mirror, 5.0F);
        figure.dot(q, palette().point, 5.0F);
    }
    draw->PopClipRect();
}

}  // namespace viewing
