// The rows about lights: what each light adds to a surface, or what blocks the light and how the shadow passes draw
// the shadow. Part of why.h.
#include <algorithm>

#include "frame/say.h"
#include "topics/why/numbers/why.h"

namespace viewing {
namespace {

Message light_title(std::size_t light, std::size_t count) {
    return count == 1 ? message("Light source") : message("Light {light}", "light"_a = light + 1);
}

Message name_of_light(const WhyQuestion& question, std::size_t light) {
    return light_name(light, question.derived.lights_world.size());
}

/// Says what a light adds to a surface that no shadow darkens, or why it adds nothing.
Message lit_sentence(const WhyQuestion& question, const Touch& surface, std::size_t light) {
    const Message name = name_of_light(question, light);
    const auto share = std::find_if(surface.color.lights.begin(), surface.color.lights.end(),
                                    [&](const LightShare& one) { return one.light == light; });
    if (share == surface.color.lights.end())
        return message("{light} shines on the other side of the surface and adds nothing.", "light"_a = name);
    if (share->cosine <= 0.0)
        return message("n·ℓ = {cosine}: the surface faces away from {light}, which adds nothing.", "light"_a = name,
                       "cosine"_a = number_text(share->cosine, 2));
    const double added = share->adds_linear.r + share->adds_linear.g + share->adds_linear.b;
    double all = surface.color.ambient_linear.r + surface.color.ambient_linear.g + surface.color.ambient_linear.b;
    for (const LightShare& one : surface.color.lights) all += one.adds_linear.r + one.adds_linear.g + one.adds_linear.b;
    return message("n·ℓ = {cosine}: {share} of the surface's light.", "cosine"_a = number_text(share->cosine, 2),
                   "share"_a = percent(all > 0.0 ? added / all : 0.0, 0));
}

/// Says, for one light, which point of which caster the matrix S maps to the pixel, and how the shadow passes darken
/// the pixel.
std::vector<Message> shadow_sentences(const WhyQuestion& question, const ShadowAtPixel& shadow, std::size_t plane,
                                      std::size_t light) {
    const Touch& first = *shadow.first;
    const CastShadow& cast = question.derived.planes[plane].shadows[light];
    const glm::dvec3& p = first.fragment.point_scene;
    const glm::dvec4 s = cast.shadowed_world_from_world * glm::dvec4(p, 1.0);
    const Message caster = surface_name(question, first.fragment.object_index), name = name_of_light(question, light);
    Message said;
    switch (place_of(question.derived.planes[plane], cast, p)) {
        case CasterPlace::behind_plane:
            said = message(
                "{caster} lies behind the plane at p = {p} and darkens this pixel all the same: a false shadow.",
                "caster"_a = caster, "p"_a = point_text(p));
            break;
        case CasterPlace::beyond_light:
            said =
                message("{caster} lies beyond {light} at p = {p} and darkens this pixel all the same: an anti-shadow.",
                        "caster"_a = caster, "light"_a = name, "p"_a = point_text(p));
            break;
        case CasterPlace::between:
            said = message("{light} does not arrive: {caster} blocks it at p = {p}.", "light"_a = name,
                           "caster"_a = caster, "p"_a = point_text(p));
    }
    std::vector<Message> all{said};
    if (s.w != 0.0)
        all.push_back(
            message("S p ÷ w = {s}, w = {w}.", "s"_a = point_text(glm::dvec3(s) / s.w), "w"_a = number_text(s.w, 2)));
    const bool is_missing_light = !question.plan.passes[first.fragment.pass].color_write;
    all.push_back(is_missing_light ? message("The stencil marks the pixel, and the plane is drawn without this light.")
                                   : message_count(shadow.passing, "The shadow is blended here once.",
                                                   "The shadow is blended here {count} times."));
    return all;
}

/// Says why a pixel shows no shadow although a caster blocks the light.
Message no_shadow_sentence(const WhyQuestion& question, const Message& caster, const ShadowAtPixel& shadow,
                           std::size_t plane, std::size_t light) {
    const Message name = name_of_light(question, light);
    if (shadow.rejected)
        return message("{caster} blocks {light}, but its shadow fails the depth test here: {test}.",
                       "caster"_a = caster, "light"_a = name,
                       "test"_a = test_phrase(question, shadow.rejected->fragment));
    if (!question.params.shadow.enabled)
        return message("{caster} blocks {light}, but no shadows are drawn.", "caster"_a = caster, "light"_a = name);
    if (!question.derived.planes[plane].receives_shadow)
        return message("{caster} blocks {light}, but this plane receives no shadow.", "caster"_a = caster,
                       "light"_a = name);
    return message("{caster} blocks {light}, but no pass draws its shadow here.", "caster"_a = caster,
                   "light"_a = name);
}

/// Returns the eye, reflected in each of the pass's mirrors.
glm::dvec4 eye_behind(const WhyQuestion& question, const Pass& pass) {
    glm::dvec4 eye = question.derived.eye_world;
    for (const std::size_t mirror : pass.mirrors_met)
        eye = mirror_matrix(question.derived.planes[mirror].unit_plane) * eye;
    return eye;
}

/// A light's row, and the caster that blocks the light.
struct LightRow {
    std::vector<Message> sentences;
    std::optional<Color> after = {};
    std::optional<glm::dvec3> caster_world = {};
    Message caster = {};
};

/// Says what a light adds to a patch, how a caster darkens the patch, or why the caster does not.
LightRow row_of_patch(const Why& made, const WhyQuestion& question, const Touch& surface, std::size_t light) {
    const Pass& pass = question.plan.passes[surface.fragment.pass];
    const ShadowAtPixel shadow = shadow_at(question.plan, made.chain, pass.plane, light, pass.mirrors_met);
    if (shadow.first)
        return {shadow_sentences(question, shadow, pass.plane, light),
                shadow.last->paints ? std::optional(shadow.last->after) : std::nullopt,
                shadow.first->fragment.point_scene, surface_name(question, shadow.first->fragment.object_index)};
    const DerivedPlane& receiver = question.derived.planes[pass.plane];
    const bool reaches = receiver.shadows[light].reaches(glm::dot(receiver.unit_plane, eye_behind(question, pass)));
    const std::optional<Blocker> in_way =
        blocker(question.finder, surface.fragment.point_scene, question.derived.lights_world[light]);
    if (!in_way || !reaches) return {{lit_sentence(question, surface, light)}};
    const Message caster = surface_name(question, in_way->object_index);
    return {
        {no_shadow_sentence(question, caster, shadow, pass.plane, light)}, std::nullopt, in_way->point_world, caster};
}

/// Says what a light adds to an object, on which no planar shadow falls.
LightRow row_of_object(const WhyQuestion& question, const Touch& surface, std::size_t light) {
    LightRow row{{lit_sentence(question, surface, light)}};
    const std::optional<Blocker> in_way =
        blocker(question.finder, surface.fragment.point_scene, question.derived.lights_world[light]);
    const bool faces = std::any_of(surface.color.lights.begin(), surface.color.lights.end(),
                                   [&](const LightShare& one) { return one.light == light && one.cosine > 0.0; });
    if (!in_way || !faces) return row;
    row.caster_world = in_way->point_world;
    row.caster = surface_name(question, in_way->object_index);
    if (question.params.shadow.enabled)
        row.sentences = {listed(
            {row.sentences.front(),
             message("{caster} blocks the light, but planar shadows fall on planes only.", "caster"_a = row.caster)},
            " ")};
    return row;
}

/// Returns a light's position; for a parallel light, a point outside the scene, in the light's direction from `point`.
glm::dvec3 place_of_light(const WhyQuestion& question, const glm::dvec4& light_world, const glm::dvec3& point) {
    if (light_world.w != 0.0) return glm::dvec3(light_world) / light_world.w;
    return point + glm::normalize(glm::dvec3(light_world)) * glm::length(question.finder.scene().bounds_world.size());
}

/// Adds a row for each light of a surface that is part of the color: in the real world or in a mirror.
void add_lights(Why& made, const WhyQuestion& question, const Touch& surface) {
    const Pass& pass = question.plan.passes[surface.fragment.pass];
    if (pass.shading != Shading::lit && pass.shading != Shading::unlit) return;
    const glm::dvec3& point = surface.fragment.point_scene;
    const std::vector<glm::dvec4>& lights_world = question.derived.lights_world;
    for (std::size_t light = 0; light < lights_world.size(); ++light) {
        LightRow row = surface.fragment.object_index < 0 ? row_of_patch(made, question, surface, light)
                                                         : row_of_object(question, surface, light);
        const Message title = light_title(light, lights_world.size());
        row.sentences.front() = begun(row.sentences.front());
        made.rows.push_back(
            {.kind = WhyRow::Kind::light,
             .title = pass.mirrors_met.empty() ? title : message("{light}, in the mirror", "light"_a = title),
             .sentences = row.sentences,
             .after = row.after});
        const std::size_t at = made.rows.size() - 1;
        const glm::dvec3 from = place_of_light(question, lights_world[light], point);
        made.lines.push_back({WhyLine::Kind::light, from, row.caster_world.value_or(point), {}, at});
        if (row.caster_world)
            made.lines.push_back({WhyLine::Kind::cut_light, *row.caster_world, point, row.caster, at});
    }
}

}  // namespace

void add_light_rows(Why& made, const WhyQuestion& question) {
    if (const Touch* surface = made.chain.surface(question.plan); surface && surface->share > least_share)
        add_lights(made, question, *surface);
    for (const Touch* image : images_of(made, question.plan)) add_lights(made, question, *image);
}

}  // namespace viewing
