// The derivations in the world: the slides' figures, drawn into the scene.
#include <algorithm>
#include <cmath>
#include <optional>

#include "text/catalogue.h"
#include "topics/planes/numbers/derivation.h"
#include "topics/planes/shown/derivation_views.h"
#include "ui/parts/look.h"
#include "ui/parts/topics.h"
#include "ui/parts/view_parts.h"

namespace viewing {
namespace {

/// Whether the view is large enough for more than names and numbers.
bool is_large(const Overlay& overlay) {
    return overlay.rect().width() >= px(560.0F);
}

/// Labels the middle of a line with "symbol = number" or, in a small view, with the number alone.
void measure(Overlay& overlay, const glm::dvec3& from, const glm::dvec3& to, const char* symbol, double value,
             ImU32 color) {
    const std::string number = number_text(value, 2);
    const std::string text = is_large(overlay) ? std::string(symbol) + " = " + number : number;
    overlay.label((from + to) * 0.5, text.c_str(), color);
}

/// Labels a height above the plane. Lessons call these labels "label:heights".
void height(Overlay& overlay, const glm::dvec3& from, const glm::dvec3& to, const char* symbol, double value,
            ImU32 color) {
    overlay.mark_target("label:heights", from, to);
    if (!widgets::IsCovered("label:heights")) measure(overlay, from, to, symbol, value, color);
}

void triangle(Overlay& overlay, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, ImU32 color) {
    overlay.fill({a, b, c, c}, with_alpha(color, 36));
}

/// Draws the shadow's figure without the light itself, which already has a handle and a label.
void shadow_overlay(Overlay& overlay, const Derived& derived, const ShadowDerivation& found) {
    const widgets::Palette& colors = palette();
    const glm::dvec3 &p = found.point_world, &foot = found.point_foot_world;
    const double far = 20.0 * derived.chosen_plane().patch.extent;
    const bool has_light = !found.parallel_light && found.light_to_point < far;
    const glm::dvec3 towards = found.parallel_light ? found.light_world : found.light_world - p;
    const double length = glm::length(towards);
    const glm::dvec3 source = has_light || length == 0.0 ? p + towards : p + towards / length * far;

    if (found.shadow_world) {
        const glm::dvec3& s = *found.shadow_world;
        if (has_light) {
            triangle(overlay, found.light_world, found.light_foot_world, s, colors.light);
            overlay.line(found.light_foot_world, s, colors.plane);
        }
        triangle(overlay, p, foot, s, colors.point);
        overlay.line(foot, s, colors.plane);
        overlay.line(p, s, colors.light, 2.0F);
        measure(overlay, p, s, "|s − p|", found.point_to_shadow, colors.light);
        overlay.dot(s, colors.light);
        overlay.label(s, "s", colors.light);
    }
    overlay.line(source, p, colors.light, 2.0F);
    if (has_light) {
        overlay.dashed(found.light_world, found.light_foot_world, colors.light);
        overlay.dot(found.light_foot_world, colors.plane, 3.0F);
        height(overlay, found.light_world, found.light_foot_world, "n·ℓ + d", found.light_height, colors.plane);
        measure(overlay, found.light_world, p, "|p − ℓ|", found.light_to_point, colors.light);
    }
    overlay.dashed(p, foot, colors.point);
    overlay.dot(foot, colors.plane, 3.0F);
    height(overlay, p, foot, "n·p + d", found.point_height, colors.plane);
}

/// Returns the position to which a matrix maps a point, unless that position is `correct` or at infinity.
std::optional<glm::dvec3> sent_elsewhere(const glm::dmat4& matrix, const glm::dvec3& point, const glm::dvec3& correct) {
    const glm::dvec4 sent = matrix * glm::dvec4(point, 1.0);
    if (std::abs(sent.w) < 1e-9) return std::nullopt;
    const glm::dvec3 place = glm::dvec3(sent) / sent.w;
    const double difference = glm::length(place - correct);
    return difference > 1e-6 * (1.0 + glm::length(correct)) ? std::optional(place) : std::nullopt;
}

void mirror_overlay(Overlay& overlay, const DerivedPlane& plane, const MirrorDerivation& found) {
    const widgets::Palette& colors = palette();
    overlay.dashed(found.point_world, found.foot_world, colors.point);
    overlay.dot(found.foot_world, colors.plane, 3.0F);
    measure(overlay, found.point_world, found.foot_world, "k", found.k, colors.plane);
    overlay.mark_target("label:mirrored", found.mirrored_world, found.mirrored_world);
    if (is_image_covered()) return;
    if (const auto image = sent_elsewhere(plane.mirrored_world_from_world, found.point_world, found.mirrored_world)) {
        overlay.dashed(found.foot_world, *image, colors.mirror);
        overlay.dot(*image, colors.mirror);
        overlay.label(*image, "q′", colors.mirror);
        overlay.ring(found.mirrored_world, colors.mirror, 6.0F);
        overlay.label(found.mirrored_world, tr("where q′ belongs"), colors.mirror);
        return;
    }
    overlay.dashed(found.foot_world, found.mirrored_world, colors.mirror);
    overlay.dot(found.mirrored_world, colors.mirror);
    overlay.label(found.mirrored_world, is_large(overlay) ? "q′ = q − 2 k n" : "q′", colors.mirror);
    overlay.label((found.foot_world + found.mirrored_world) * 0.5, "k", colors.mirror);
}

}  // namespace

void draw_derivation_overlay(Overlay& overlay, const Params& params, const Derived& derived) {
    const bool shadow = is_shown(params, Topic::shadow_derivation);
    const bool mirror = is_shown(params, Topic::mirror_derivation);
    if (!shadow && !mirror) return draw_followed(overlay, params, derived);
    const glm::dvec3 point = derivation_point(derived);
    const glm::dvec4& plane = derived.chosen_plane().unit_plane;
    if (shadow) shadow_overlay(overlay, derived, derive_shadow(plane, derived.chosen_light(), point));
    if (mirror) mirror_overlay(overlay, derived.chosen_plane(), derive_mirror(plane, point));
    overlay.dot(point, palette().point, 5.0F);
    overlay.label(point, shadow ? "p" : "q", palette().point);
}

}  // namespace viewing
