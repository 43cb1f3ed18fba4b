// Converts orders to vertices, and ID images to surface points.
#include "topics/hidden/numbers/hidden_drawing.h"

#include <cmath>

#include "frame/ground.h"
#include "topics/hidden/methods/difference.h"

namespace viewing {
namespace {

/// Returns the eye's position, even for an orthographic camera; 0 if the view matrix has no inverse.
glm::dvec3 origin_of(const Viewpoint& viewpoint) {
    const glm::dmat3 turned(viewpoint.view_from_world);
    if (glm::determinant(turned) == 0.0) return glm::dvec3(0.0);
    return glm::inverse(turned) * -glm::dvec3(viewpoint.view_from_world[3]);
}

void add_ordered_triangles(HiddenDrawing& drawing, const HiddenResult& result, const WorkProgress* progress) {
    const SceneSurface& surface = *result.surface;
    std::vector<OrderedVertex>& vertices = drawing.triangles;
    vertices.reserve(static_cast<std::size_t>(result.drawn) * 3);
    for (int place = 0; place < result.drawn; ++place) {
        drawing.is_cut = is_cut_short(static_cast<std::size_t>(place), progress);
        if (drawing.is_cut) return;
        const Polygon& polygon = (*result.fragments)[result.order[static_cast<std::size_t>(place)]];
        const ObjectDescription& object = surface.scene.objects[polygon.object].description;
        if (drawing.runs.empty() || drawing.runs.back().is_decal != object.decal)
            drawing.runs.push_back({static_cast<int>(vertices.size()), 0, object.decal});
        drawing.runs.back().vertex_count += static_cast<int>(3 * (polygon.vertices.size() - 2));
        const auto vertex = [&](std::size_t corner) {
            const glm::dvec3& point = polygon.vertices[corner];
            return OrderedVertex{point - drawing.origin_world, normal_at(surface, polygon.source, point),
                                 linear_from_srgb(object.color), static_cast<float>(polygon.object + 1),
                                 static_cast<float>(polygon.source + 1)};
        };
        for (std::size_t corner = 2; corner < polygon.vertices.size(); ++corner)
            for (const std::size_t at : {std::size_t{0}, corner - 1, corner}) vertices.push_back(vertex(at));
    }
}

/// Converts a pixel and its depth to a point, and the point to the inputs of shading.
class Pixels {
public:
    Pixels(const HiddenResult& result, const glm::dvec3& origin_world)
        : result_(result),
          origin_world_(origin_world),
          world_from_clip_(glm::inverse(result.request.viewpoint.clip_from_world())),
          eye_(result.request.viewpoint.eye_world()),
          mirrors_(glm::determinant(glm::dmat3(result.request.viewpoint.view_from_world)) < 0.0) {
        faces_.resize(static_cast<std::size_t>(result.surface->source_count()));
        for (const Polygon& polygon : result.surface->polygons) faces_[polygon.source] = glm::dvec3(polygon.plane);
    }

    SurfacePixel at(int x, int y) const {
        const IdImage& image = result_.image;
        const int source = image.id(x, y);
        if (source == IdImage::background) return {{0.0F, 0.0F, 0.0F, 2.0F}, {}, {}};
        const double depth = image.depths[image.index(x, y)];
        const glm::dvec4 clip((x + 0.5) / image.width * 2.0 - 1.0, 1.0 - (y + 0.5) / image.height * 2.0,
                              depth * 2.0 - 1.0, 1.0);
        const glm::dvec4 homogeneous = world_from_clip_ * clip;
        const glm::dvec3 point = glm::dvec3(homogeneous) / homogeneous.w;

        const SceneSurface& surface = *result_.surface;
        glm::dvec3 normal = glm::normalize(normal_at(surface, source, point));
        const glm::dvec3 face_normal = surface.curved_of(source) ? normal : faces_[source];
        const bool seen_from_front = glm::dot(face_normal, glm::dvec3(eye_) - eye_.w * point) > 0.0;
        if ((glm::dot(normal, face_normal) > 0.0) != seen_from_front) normal = -normal;
        const int object = surface.object_of(source);
        const Color& color = surface.scene.objects[object].description.color;
        return {glm::vec4(point - origin_world_, depth), glm::vec4(normal, is_front(seen_from_front) ? 1.0F : 0.0F),
                glm::vec4(linear_from_srgb(color), static_cast<float>(object + 1))};
    }

private:
    /// Returns whether a face is a front face. GL decides by the winding on the screen, which a mirrored view reverses.
    bool is_front(bool seen_from_front) const {
        const bool is_counter_clockwise = seen_from_front != mirrors_;
        return is_counter_clockwise == (result_.request.cull.front_face == FrontFace::ccw);
    }

    const HiddenResult& result_;
    const glm::dvec3 origin_world_;
    const glm::dmat4 world_from_clip_;
    const glm::dvec4 eye_;
    const bool mirrors_;
    std::vector<glm::dvec3> faces_;  ///< unit normals of the triangles, by source
};

}  // namespace

HiddenDrawing hidden_drawing(const HiddenResult& result, const WorkProgress* progress) {
    HiddenDrawing made;
    made.origin_world = origin_of(result.request.viewpoint);
    if (!draws_pixels(result.request.visibility)) {
        add_ordered_triangles(made, result, progress);
        return made;
    }
    made.size_px = {result.image.width, result.image.height};
    made.share = result.request.share;
    made.overdraw = result.written_per_pixel;
    made.pixels.reserve(result.image.ids.size());
    const Pixels pixels(result, made.origin_world);
    for (int y = 0; y < result.image.height; ++y)
        for (int x = 0; x < result.image.width; ++x) made.pixels.push_back(pixels.at(x, y));
    return made;
}

IdDifference difference_from_drawn(const IdImage& reference, const IdImage& image, const HiddenResult& result) {
    if (draws_pixels(result.request.visibility)) return difference(reference, image);
    const glm::dmat4 clip_from_world =
        part_from_view(result.request.share) * result.request.viewpoint.clip_from_world();
    return difference(reference, image, *result.fragments, clip_from_world);
}

DifferenceDrawing difference_drawing(std::span<const std::uint8_t> differs, glm::ivec2 size_px) {
    constexpr glm::u8vec4 red(difference_color.r, difference_color.g, difference_color.b, 255), veil(0, 0, 0, 110);
    DifferenceDrawing made{size_px, {}, static_cast<std::int64_t>(differs.size()), 0};
    made.pixels.reserve(differs.size());
    for (const std::uint8_t is_different : differs) {
        made.pixels.push_back(is_different != 0 ? red : veil);
        made.different += is_different != 0 ? 1 : 0;
    }
    return made;
}

DifferenceDrawing difference_drawing(const IdDifference& found, glm::ivec2 size_px) {
    DifferenceDrawing made = difference_drawing(found.differs, size_px);
    made.compared = found.compared;
    return made;
}

}  // namespace viewing
