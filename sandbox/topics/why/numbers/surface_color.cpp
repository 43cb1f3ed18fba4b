#include "topics/why/numbers/surface_color.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "frame/ground.h"
#include "frame/lighting.h"
#include "geometry/normals.h"
#include "geometry/shapes.h"
#include "topics/depth/numbers/pixel_triangle.h"
#include "topics/hidden/numbers/hidden_surfaces.h"

namespace viewing {
namespace {

glm::dvec3 srgb_of(const Color& color) {
    return glm::dvec3(color.r, color.g, color.b) / 255.0;
}

double smooth(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// A point of a surface as the fragment shader gets it: interpolated between the corners.
struct ShadedPoint {
    glm::dvec3 position_world{0.0};  ///< after the pass's S or R
    glm::dvec3 normal_world{0.0};    ///< any length
    glm::dvec3 face_world{0.0};      ///< normal of the triangle itself; 0: `normal_world` already points toward the eye
    glm::dvec3 albedo_linear{0.0};
};

glm::dvec3 placed(const glm::dmat4& world_from_space, const glm::dvec3& point) {
    const glm::dvec4 made = world_from_space * glm::dvec4(point, 1.0);
    return made.w == 0.0 ? glm::dvec3(made) : glm::dvec3(made) / made.w;
}

ShadedPoint interpolated(const std::array<glm::dvec3, 3>& positions, const std::array<glm::dvec3, 3>& normals,
                         const glm::dmat4& placed_from_space, const glm::dvec3& weights) {
    std::array<glm::dvec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) corners[i] = placed(placed_from_space, positions[i]);
    ShadedPoint made;
    for (std::size_t i = 0; i < 3; ++i) {
        made.position_world += weights[static_cast<int>(i)] * corners[i];
        made.normal_world += weights[static_cast<int>(i)] * normals[i];
    }
    made.normal_world = normal_matrix(glm::dmat3(placed_from_space)) * made.normal_world;
    made.face_world = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    return made;
}

/// Returns the surface point that a fragment shades: on an object's mesh, on a method's ordered triangles, or in a
/// method's picture.
ShadedPoint point_of(const FramePlan& plan, const Pass& pass, const Scene& scene, const Fragment& fragment,
                     glm::ivec2 pixel, glm::ivec2 size_px) {
    const auto first = 3 * static_cast<std::size_t>(fragment.triangle);
    std::array<glm::dvec3, 3> positions, normals;
    if (pass.subject == Subject::ordered) {
        const HiddenDrawing& drawing = *plan.drawing_of(pass);
        const std::vector<OrderedVertex>& vertices = drawing.triangles;
        glm::dvec3 albedo(0.0);
        for (std::size_t i = 0; i < 3; ++i) {
            positions[i] = drawing.origin_world + glm::dvec3(vertices[first + i].position_relative);
            normals[i] = vertices[first + i].normal_world;
            albedo += fragment.weights[static_cast<int>(i)] * glm::dvec3(vertices[first + i].color);
        }
        ShadedPoint made = interpolated(positions, normals, pass.world_from_scene, fragment.weights);
        made.albedo_linear = albedo;
        return made;
    }
    if (pass.subject == Subject::pixels) {
        const HiddenDrawing& picture = *plan.drawing_of(pass);
        const auto own = raster_pixel(glm::dvec2(pixel) + 0.5, size_px, picture.size_px, picture.share);
        if (!own) return {};
        const SurfacePixel& seen = picture.pixels[own->y * picture.size_px.x + own->x];
        const glm::dmat3 turn(pass.world_from_scene);
        const glm::dvec3 point = picture.origin_world + glm::dvec3(seen.position_relative);
        return {placed(pass.world_from_scene, point),
                normal_matrix(turn) * glm::dvec3(seen.normal_world) * (glm::determinant(turn) < 0.0 ? -1.0 : 1.0),
                glm::dvec3(0.0), glm::dvec3(seen.color)};
    }
    const SceneObject& object = scene.objects[fragment.object_index];
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = object.mesh->indices[first + i];
        positions[i] = object.mesh->positions[vertex];
        normals[i] = object.mesh->normals[vertex];
    }
    ShadedPoint made =
        interpolated(positions, normals, pass.world_from_scene * object.world_from_model, fragment.weights);
    made.albedo_linear = linear_from_srgb(object.description.color);
    return made;
}

/// Returns the patch's checkerboard at a point of its square, −1 … 1. `width`: the distance to the neighboring pixels.
glm::dvec3 patch_pattern(const FramePlan& plan, double extent, const glm::dvec2& position, const glm::dvec2& width) {
    const glm::dvec2 cell = position * extent, across = glm::max(width * extent, glm::dvec2(1e-6));
    const glm::dvec2 to_line = glm::abs(glm::fract(cell - 0.5) - 0.5);
    const glm::dvec2 off_line = (to_line - 0.008) / (across * 1.2);
    const double line = 1.0 - smooth(0.0, 1.0, std::min(off_line.x, off_line.y));
    const double far_away = std::clamp(std::max(across.x, across.y) * 2.0 - 0.4, 0.0, 1.0);
    const double steps = std::floor(cell.x) + std::floor(cell.y), dark = steps - 2.0 * std::floor(steps / 2.0);
    const glm::dvec3 light_tone(linear_from_srgb(plan.patch_light)), dark_tone(linear_from_srgb(plan.patch_dark));
    const glm::dvec3 square = glm::mix(light_tone, dark_tone, glm::mix(dark, 0.5, far_away));
    return glm::mix(square, glm::dvec3(linear_from_srgb(plan.patch_line)), line * (1.0 - far_away));
}

/// Returns the patch's point that a fragment shades. Its color depends on the neighbors in the same 2 × 2 pixel block.
ShadedPoint point_of_patch(const FramePlan& plan, const Pass& pass, const Fragment& fragment, glm::ivec2 pixel,
                           glm::ivec2 size_px) {
    static const Mesh quad = quad_mesh();
    const PlanePatch& patch = plan.patches[pass.plane];
    const glm::dmat4 placed_from_patch = pass.world_from_scene * patch.world_from_patch();
    const PixelView view(pass.clip_from_world * placed_from_patch, pass.view_from_world * placed_from_patch, pixel,
                         size_px);
    std::array<glm::dvec3, 3> corners;
    PixelTriangle seen;
    for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = quad.positions[quad.indices[3 * static_cast<std::size_t>(fragment.triangle) + i]];
        seen[i] = view.corner(corners[i]);
    }
    const auto at = [&](const glm::dvec3& weights) {
        const glm::dvec3 point = weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
        return glm::dvec2(point.x, point.z);
    };
    const glm::dvec2 here = at(fragment.weights);
    glm::dvec2 width(0.0);
    const glm::dvec2 neighbors = neighbors_px(pixel, size_px);
    for (const glm::dvec2& beside_px : {glm::dvec2(neighbors.x, 0.0), glm::dvec2(0.0, neighbors.y)})
        width += glm::abs(at(weights_beside(seen, beside_px)) - here);

    const glm::dvec3 position = fragment.weights.x * placed(placed_from_patch, corners[0]) +
                                fragment.weights.y * placed(placed_from_patch, corners[1]) +
                                fragment.weights.z * placed(placed_from_patch, corners[2]);
    glm::dvec3 normal = direction_of(normal_matrix(glm::dmat3(placed_from_patch))[1]);
    const glm::dvec3 to_eye = glm::dvec3(pass.eye_world) - pass.eye_world.w * glm::dvec3(placed_from_patch[3]);
    if (glm::dot(normal, to_eye) < 0.0) normal = -normal;
    return {position, normal, glm::dvec3(0.0), patch_pattern(plan, patch.extent, here, width)};
}

/// Adds ambient light and each light's contribution.
void light(SurfaceColor& made, const Pass& pass, const ShadedPoint& point, bool has_highlight) {
    const glm::dvec3 eye = glm::dvec3(pass.eye_world) - pass.eye_world.w * point.position_world;
    glm::dvec3 normal = direction_of(point.normal_world);
    if (point.face_world != glm::dvec3(0.0) &&
        glm::dot(normal, point.face_world) * glm::dot(point.face_world, eye) < 0.0)
        normal = -normal;
    made.albedo_linear = point.albedo_linear;
    made.ambient_linear = point.albedo_linear * (ambient_light + sky_light * glm::dot(normal, pass.sky_world));
    glm::dvec3 linear = made.ambient_linear;
    const std::size_t count = pass.shading == Shading::unlit ? 0 : pass.lights_world.size();
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec4& position = pass.lights_world[i];
        const glm::dvec3 to_light = direction_of(glm::dvec3(position) - position.w * point.position_world);
        LightShare share{.light = pass.lights[i], .cosine = glm::dot(normal, to_light)};
        share.adds_linear = point.albedo_linear * (diffuse_light * pass.light_strength * std::max(share.cosine, 0.0));
        if (has_highlight && share.cosine > 0.0) {
            const double shine = std::max(glm::dot(normal, direction_of(to_light + direction_of(eye))), 0.0);
            share.highlight = highlight_light * pass.light_strength * std::pow(shine, shininess);
            share.adds_linear += share.highlight;
        }
        linear += share.adds_linear;
        made.lights.push_back(share);
    }
    made.srgb = srgb_from_linear(linear);
}

}  // namespace

glm::dvec3 srgb_from_linear(const glm::dvec3& linear) {
    glm::dvec3 made;
    for (int i = 0; i < 3; ++i) {
        const double x = std::max(linear[i], 0.0);
        made[i] = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    }
    return glm::clamp(made, 0.0, 1.0);
}

SurfaceColor surface_color(const FramePlan& plan, const Scene& scene, const Fragment& fragment, glm::ivec2 pixel,
                           glm::ivec2 size_px) {
    const Pass& pass = plan.passes[fragment.pass];
    SurfaceColor made;
    made.alpha = pass.color.a;
    made.srgb = glm::dvec3(pass.color);
    if (pass.shading == Shading::flat || pass.shading == Shading::heat) return made;
    const bool is_patch = pass.subject == Subject::patch;
    const ShadedPoint point = is_patch ? point_of_patch(plan, pass, fragment, pixel, size_px)
                                       : point_of(plan, pass, scene, fragment, pixel, size_px);
    if (pass.shading == Shading::lit || pass.shading == Shading::unlit) {
        light(made, pass, point, !is_patch || pass.has_gloss);
        return made;
    }
    const glm::dvec3 normal = direction_of(point.normal_world);
    const double shade = 0.62 + 0.38 * std::abs(normal.y * 0.35 + normal.z * 0.65);
    if (pass.shading == Shading::caster_w) {
        const glm::dvec4 position(point.position_world, 1.0);
        const std::size_t kind = glm::dot(plan.caster_w, position) <= 0.0     ? 2
                                 : glm::dot(plan.caster_side, position) < 0.0 ? 1
                                                                              : 0;
        made.srgb = srgb_of(caster_colors[kind]) * shade;
        return made;
    }
    const double stripe = glm::fract((pixel.x + 0.5 + size_px.y - pixel.y - 0.5) / 12.0) < 0.5 ? 0.72 : 1.0;
    made.srgb = fragment.front_facing ? srgb_of(front_color) * shade : srgb_of(back_color) * stripe;
    return made;
}

}  // namespace viewing
