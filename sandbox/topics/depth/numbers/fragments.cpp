// Repeats the plan's passes for one pixel: the surfaces that cover it, their depths, and the outcome of the tests.
#include "topics/depth/numbers/fragments.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <set>
#include <span>

#include "frame/object_reach.h"
#include "frame/plan/draw_calls.h"
#include "geometry/shapes.h"
#include "state/compare_func.h"
#include "topics/depth/numbers/depth_data.h"
#include "topics/depth/numbers/fragment_depth.h"
#include "topics/depth/numbers/pixel_triangle.h"
#include "topics/hidden/numbers/hidden_surfaces.h"

namespace viewing {
namespace {

/// A surface on the pixel's ray, before any test.
struct Met {
    int object;         ///< index in the scene; −1: the patch
    std::size_t place;  ///< index of the triangle in its mesh, or in a sorting method's order
    PixelTriangle triangle;
    PixelHit hit;
    glm::dvec3 point_scene;  ///< world space
    DepthOffset offset;
    std::optional<ProjectedTriangle> projected;  ///< set if the camera's lens alone does not determine the depth
};

/// Finds everything that one pass draws over one pixel.
class Meeting {
public:
    /// `clip_from_world`, `pixel` and `size_px` belong to the view or, if the pass shows a software method's picture,
    /// to that picture.
    Meeting(const FramePlan& plan, const Pass& pass, const glm::dmat4& clip_from_world, glm::ivec2 pixel,
            glm::ivec2 size_px)
        : plan_(plan),
          pass_(pass),
          clip_from_world_(clip_from_world),
          pixel_(pixel),
          size_px_(size_px),
          is_projected_(!plan.has_distances || pass.is_mirror_image || pass.subject == Subject::backdrop ||
                        pass.world_from_scene != glm::dmat4(1.0)) {}

    /// `drawn`: how many of the mesh's triangles to draw.
    void mesh(int object, const Mesh& mesh, int drawn, const BoxTree& triangles, const glm::dmat4& world_from_model,
              const DepthOffset& offset) {
        const PixelView view = view_of(world_from_model);
        const auto before = static_cast<std::ptrdiff_t>(found.size());
        const auto meet = [&](std::uint32_t place) {
            if (place >= static_cast<std::uint32_t>(drawn)) return;
            std::array<glm::dvec3, 3> corners;
            for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.positions[mesh.indices[3 * std::size_t{place} + k]];
            triangle(object, place, view, corners, world_from_model, offset);
        };
        const glm::dvec4 w_of_model = glm::transpose(pass_.world_from_scene * world_from_model)[3];
        const auto may_meet = [&](const Bounds& box) {
            return view.may_meet(box) || (pass_.forces_sign && crosses(w_of_model, box));
        };
        triangles.each(may_meet, meet);
        std::sort(found.begin() + before, found.end(), [](const Met& a, const Met& b) { return a.place < b.place; });
    }

    void ordered(const HiddenDrawing& drawing) {
        const std::vector<OrderedVertex>& vertices = drawing.triangles;
        const glm::dmat4 in_place = glm::translate(glm::dmat4(1.0), drawing.origin_world);
        const PixelView view = view_of(in_place);
        for (std::size_t i = 0; i + 2 < vertices.size(); i += 3) {
            triangle(
                static_cast<int>(vertices[i].object) - 1, i / 3, view,
                {vertices[i].position_relative, vertices[i + 1].position_relative, vertices[i + 2].position_relative},
                in_place, {});
        }
    }

    std::vector<Met> found;

private:
    /// Returns whether the plane w = 0, given in the box's space, cuts the box: a triangle in the box may then have
    /// corners on both sides. If the sign of w is forced, such a triangle covers pixels that none of its points project
    /// to.
    static bool crosses(const glm::dvec4& plane, const Bounds& box) {
        const double middle = glm::dot(plane, glm::dvec4(box.center(), 1.0));
        return std::abs(middle) <= glm::dot(glm::abs(glm::dvec3(plane)), box.size() * 0.5);
    }

    PixelView view_of(const glm::dmat4& world_from_model) const {
        const glm::dmat4 placed_from_model = pass_.world_from_scene * world_from_model;
        return {clip_from_world_ * placed_from_model, pass_.view_from_world * placed_from_model, pixel_, size_px_};
    }

    /// Returns a corner as the pass's matrices transform it. If the pass forces the sign of w and w is negative,
    /// negates the corner in `seen`, too.
    ProjectedCorner projected(PixelCorner& seen, const glm::dvec3& corner, const glm::dmat4& world_from_space) const {
        const glm::dvec4 placed = pass_.world_from_scene * world_from_space * glm::dvec4(corner, 1.0);
        const glm::dvec4 clip = clip_from_world_ * placed, view = pass_.view_from_world * placed;
        ProjectedCorner made{clip.z, clip.w, view.z, view.w};
        if (plan_.has_logarithm_per_vertex())
            made.z =
                clip.w *
                (2.0 * window_depth(plan_.lens, DepthMapping::logarithmic, std::max(-view.z / view.w, 1e-30)) - 1.0);
        if (pass_.forces_sign && placed.w < 0.0) {
            seen.offset_px = -seen.offset_px;
            seen.w = -seen.w;
            made.z = -made.z;
            made.w = -made.w;
        }
        return made;
    }

    void triangle(int object, std::size_t place, const PixelView& view, const std::array<glm::dvec3, 3>& corners,
                  const glm::dmat4& world_from_space, const DepthOffset& offset) {
        PixelTriangle seen{view.corner(corners[0]), view.corner(corners[1]), view.corner(corners[2])};
        std::optional<ProjectedTriangle> projection;
        if (is_projected_) {
            projection.emplace();
            for (std::size_t i = 0; i < 3; ++i) (*projection)[i] = projected(seen[i], corners[i], world_from_space);
        }
        std::optional<PixelHit> met = hit(seen);
        if (!met) return;
        if (projection ? !is_in_clip_range(plan_, *projection, met->weights) : !is_in_depth_range(plan_, seen, *met))
            return;
        if (projection) met->distance = projected_distance(*projection, met->weights);
        const glm::dvec3 point =
            met->weights.x * corners[0] + met->weights.y * corners[1] + met->weights.z * corners[2];
        found.push_back(
            {object, place, seen, *met, glm::dvec3(world_from_space * glm::dvec4(point, 1.0)), offset, projection});
    }

    const FramePlan& plan_;
    const Pass& pass_;
    const glm::dmat4 clip_from_world_;
    const glm::ivec2 pixel_, size_px_;
    const bool is_projected_;
};

/// Returns the picture of a software method that a pass shows pixel by pixel; null if GL draws.
const HiddenDrawing* picture_of(const FramePlan& plan, const Pass& pass) {
    return pass.subject == Subject::pixels ? plan.drawing_of(pass).get() : nullptr;
}

std::optional<glm::ivec2> pixel_of_picture(const HiddenDrawing* picture, glm::ivec2 pixel, glm::ivec2 size_px) {
    return picture ? raster_pixel(glm::dvec2(pixel) + 0.5, size_px, picture->size_px, picture->share) : std::nullopt;
}

/// Returns the index of the object that a method's coarser picture shows at a pixel, −1 for the background. None if GL
/// draws, or if the picture has the same size as the view.
std::optional<int> object_in_picture(const FramePlan& plan, const Pass& pass, glm::ivec2 pixel, glm::ivec2 size_px) {
    const HiddenDrawing* picture = picture_of(plan, pass);
    if (!picture || picture->size_px == size_px) return std::nullopt;
    const std::optional<glm::ivec2> own = pixel_of_picture(picture, pixel, size_px);
    if (!own) return -1;
    const SurfacePixel& seen = picture->pixels[own->y * picture->size_px.x + own->x];
    return static_cast<int>(seen.color.w) - 1;
}

/// Returns an empty Meeting for one pass and one pixel. If the pass shows a software method's picture, the Meeting is
/// for the picture's pixel at that place.
Meeting meeting_of(const FramePlan& plan, const Pass& pass, glm::ivec2 pixel, glm::ivec2 size_px) {
    const HiddenDrawing* picture = picture_of(plan, pass);
    const std::optional<glm::ivec2> own = pixel_of_picture(picture, pixel, size_px);
    if (!own) return {plan, pass, pass.clip_from_world, pixel, size_px};
    return {plan, pass, part_from_view(picture->share) * pass.clip_from_world, *own, picture->size_px};
}

/// The depth and stencil values of one pixel. Tests the surfaces that are sent to it.
class PixelBuffers {
public:
    PixelBuffers(const FramePlan& plan, glm::ivec2 pixel, glm::ivec2 size_px)
        : plan_(plan),
          size_px_(size_px),
          precision_(precision_of(plan.depth_format)),
          neighbors_px_(neighbors_px(pixel, size_px)),
          depth_(code_of(plan.clear_depth_value, precision_)) {}

    void clear_stencil() { stencil_ = 0; }

    /// Tests a surface and writes the values that the pass writes. A surface that GL never gets does not pass.
    /// With `flips`, the depth comparison has the opposite outcome.
    Fragment send(const Pass& pass, const Met& met, bool gl_gets_it, bool flips) {
        Fragment made;
        made.object_index = met.object;
        made.triangle = static_cast<int>(met.place);
        made.eye_z = -met.hit.distance;
        made.window_depth =
            met.projected ? projected_depth_of(plan_, met.triangle, *met.projected, met.hit, met.offset, neighbors_px_)
                          : depth_of(plan_, met.triangle, met.hit, met.offset, neighbors_px_);
        made.depth_error = depth_error(plan_, met.triangle, met.hit, met.offset, neighbors_px_, size_px_);
        made.stored = code_of(made.window_depth, precision_);
        made.within = stored_within(made.window_depth, made.depth_error, precision_);
        made.is_sent = gl_gets_it;
        made.front_facing = is_front(pass.cull, met.hit.is_counter_clockwise);
        made.culled = is_culled(pass.cull, made.front_facing);
        made.step = depth_step(plan_.lens, plan_.depth_mapping, precision_, met.hit.distance);
        made.depth = pass.depth;
        made.compared_with = depth_;
        made.tie = pass.depth.test && !made.culled && made.stored == depth_;
        const std::uint32_t reference = reference_of(pass, met);
        // The reference is the left operand of the stencil comparison.
        const auto read_bits = static_cast<std::uint32_t>(pass.stencil.read_bits);
        const bool by_stencil =
            !pass.stencil.test || compare(pass.stencil.func, reference & read_bits, stencil_ & read_bits);
        made.stencil_fails = !by_stencil;
        const bool by_depth = (!pass.depth.test || compare(pass.depth.func, made.stored, depth_)) != flips;
        made.decided_by_rounding = flips;
        made.passes = gl_gets_it && !made.culled && by_stencil && by_depth;
        made.drawn = made.passes && pass.color_write;
        made.weights = met.hit.weights;
        made.point_scene = met.point_scene;
        made.stencil_before = static_cast<int>(stencil_);
        if (made.passes && pass.depth.test && pass.depth.write) depth_ = made.stored;
        if (made.passes && pass.stencil.test) stencil_ = stencil_after(pass.stencil, reference);
        made.stencil_after = static_cast<int>(stencil_);
        made.depth_after = depth_;
        return made;
    }

private:
    std::uint32_t stencil_after(const StencilState& state, std::uint32_t reference) const {
        std::uint32_t value = stencil_;
        switch (state.on_pass) {
            case StencilOp::keep:
                break;
            case StencilOp::replace:
                value = reference;
                break;
            case StencilOp::increment:
                value = std::min(stencil_ + 1, 255U);
                break;
            case StencilOp::decrement:
                value = stencil_ > 0 ? stencil_ - 1 : 0;
                break;
            case StencilOp::invert:
                value = ~stencil_;
                break;
            case StencilOp::zero:
                value = 0;
                break;
        }
        const auto written = static_cast<std::uint32_t>(state.write_bits);
        return (stencil_ & ~written) | (value & written);
    }

    std::uint32_t reference_of(const Pass& pass, const Met& met) const {
        const bool is_own = pass.marks_objects && met.object >= 0;
        return static_cast<std::uint32_t>(is_own ? plan_.mark_of(static_cast<std::size_t>(met.object))
                                                 : pass.stencil.reference);
    }

    const FramePlan& plan_;
    const glm::ivec2 size_px_;
    const DepthPrecision precision_;
    const glm::dvec2 neighbors_px_;
    std::uint32_t depth_, stencil_ = 0;
};

bool shows_surfaces(const Pass& pass) {
    return !pass.is_mirror_image && is_surface(pass);
}

bool is_mask(const Pass& pass) {
    return pass.subject == Subject::patch && !shows_surfaces(pass);
}

/// Returns whether the pass clears the stencil everywhere, before marks of another kind are set.
bool clears_marks(const Pass& pass) {
    return pass.subject == Subject::backdrop && pass.stencil.on_pass == StencilOp::zero;
}

bool is_cut_off(const Pass& pass, const glm::dvec3& point_scene) {
    return std::any_of(pass.clip_planes.begin(), pass.clip_planes.end(),
                       [&](const ClipPlane& plane) { return glm::dot(plane, glm::dvec4(point_scene, 1.0)) < 0.0; });
}

/// A pass and the surfaces that it sends to the pixel.
struct Batch {
    std::size_t number;
    const Pass* pass;
    std::vector<Met> found;
    std::optional<std::size_t> only;  ///< the surface that GL gets, if a method finds one surface per pixel
};

/// Returns the nearest surface that is not culled and, if `object` is given, belongs to it.
std::optional<std::size_t> only_one_sent(const Pass& pass, const std::vector<Met>& found, std::optional<int> object) {
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (is_culled(pass.cull, is_front(pass.cull, found[i].hit.is_counter_clockwise))) continue;
        if (object && found[i].object != *object) continue;
        if (!nearest || found[i].hit.distance < found[*nearest].hit.distance) nearest = i;
    }
    return nearest;
}

/// Sends the surfaces of one frame, starting with a cleared stencil.
std::vector<Fragment> send_all(const std::vector<Batch>& batches, PixelBuffers& buffers, bool lists_all,
                               std::span<const std::size_t> as_rounded) {
    std::vector<Fragment> fragments;
    buffers.clear_stencil();
    for (const Batch& batch : batches) {
        if (clears_marks(*batch.pass)) buffers.clear_stencil();
        for (std::size_t i = 0; i < batch.found.size(); ++i) {
            const bool cut_off = is_cut_off(*batch.pass, batch.found[i].point_scene);
            if (cut_off && !lists_all) continue;
            const bool is_sent = !cut_off && (batch.pass->subject != Subject::pixels || batch.only == i);
            const bool flips = std::find(as_rounded.begin(), as_rounded.end(), fragments.size()) != as_rounded.end();
            Fragment fragment = buffers.send(*batch.pass, batch.found[i], is_sent, flips);
            fragment.pass = batch.number;
            fragment.cut_off = cut_off;
            if (lists_all || !is_mask(*batch.pass)) fragments.push_back(std::move(fragment));
        }
    }
    return fragments;
}

}  // namespace

PassRole role_of(const Pass& pass) {
    if (pass.subject == Subject::backdrop) return PassRole::backdrop;
    // The overdraw count also draws surfaces in a flat color: additive blending sets these passes apart.
    const bool is_flat = pass.shading == Shading::flat && pass.blend != Blend::add;
    if (pass.subject == Subject::patch) return is_flat ? PassRole::mask : PassRole::patch;
    return is_flat ? PassRole::shadow : PassRole::objects;
}

bool is_surface(const Pass& pass) {
    return role_of(pass) == PassRole::objects || role_of(pass) == PassRole::patch;
}

FragmentFinder::FragmentFinder(const Scene& scene) : scene_(scene) {
    for (const SceneObject& object : scene_.objects) trees_.push_back(triangle_tree(object.mesh));
}

std::vector<Fragment> FragmentFinder::at(const FramePlan& plan, glm::ivec2 pixel, glm::ivec2 size_px) const {
    return replayed(plan, pixel, size_px, Scope::surfaces, {});
}

std::vector<Fragment> FragmentFinder::everything_at(const FramePlan& plan, glm::ivec2 pixel, glm::ivec2 size_px,
                                                    std::span<const std::size_t> as_rounded) const {
    return replayed(plan, pixel, size_px, Scope::everything, as_rounded);
}

std::vector<Fragment> FragmentFinder::replayed(const FramePlan& plan, glm::ivec2 pixel, glm::ivec2 size_px, Scope scope,
                                               std::span<const std::size_t> as_rounded) const {
    const bool lists_all = scope == Scope::everything;
    static const Mesh quad = quad_mesh();
    static const BoxTree quad_tree = BoxTree::of_triangles(quad);
    std::vector<Batch> batches;
    std::set<std::size_t> patches;  // several passes may draw a patch, lit or in shadow, but only one draws this pixel
    int next_call = 0;
    for (std::size_t number = 0; number < plan.passes.size(); ++number) {
        if (plan.limit.pass >= 0 && static_cast<int>(number) > plan.limit.pass) break;
        const Pass& pass = plan.passes[number];
        int call = next_call;
        next_call += call_count(pass, scene_);
        if (pass.subject == Subject::difference) continue;
        if (clears_marks(pass)) {
            batches.push_back({number, &pass, {}, std::nullopt});
            continue;
        }
        if (!lists_all && !is_mask(pass) && !shows_surfaces(pass)) continue;
        Meeting meeting = meeting_of(plan, pass, pixel, size_px);
        const auto meet = [&](int object, const Mesh& mesh, const BoxTree& triangles,
                              const glm::dmat4& world_from_model, const DepthOffset& offset) {
            const int drawn = triangles_drawn(plan.limit, call++, static_cast<int>(mesh.triangle_count()));
            meeting.mesh(object, mesh, drawn, triangles, world_from_model, offset);
        };
        if (pass.subject == Subject::backdrop) {
            meet(no_object, quad, quad_tree, glm::dmat4(1.0), {});
        } else if (pass.subject == Subject::patch) {
            if (!lists_all && !is_mask(pass) && !patches.insert(pass.plane).second) continue;
            meet(-1 - static_cast<int>(pass.plane), quad, quad_tree, plan.patches[pass.plane].world_from_patch(), {});
        } else if (pass.subject == Subject::ordered) {
            meeting.ordered(*plan.drawing_of(pass));
        } else {
            for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
                const SceneObject& object = scene_.objects[i];
                if (!is_chosen(pass.chosen, object)) continue;
                const DepthOffset own = object.description.decal ? plan.decal_offset : DepthOffset{};
                meet(static_cast<int>(i), *object.mesh, *trees_[i], object.world_from_model, pass.offset.value_or(own));
            }
        }
        const auto only = only_one_sent(pass, meeting.found, object_in_picture(plan, pass, pixel, size_px));
        batches.push_back({number, &pass, std::move(meeting.found), only});
    }

    PixelBuffers buffers(plan, pixel, size_px);
    if (!plan.clears_depth()) send_all(batches, buffers, lists_all, {});
    std::vector<Fragment> fragments = send_all(batches, buffers, lists_all, as_rounded);
    for (Fragment& fragment : fragments) fragment.object = name_of(fragment.object_index);
    return fragments;
}

std::string FragmentFinder::name_of(int object) const {
    if (object == no_object) return "";
    return object < 0 ? plane_name(static_cast<std::size_t>(-1 - object)) : scene_.objects[object].description.name;
}

std::optional<DrawLimit> limit_after(const Fragment& fragment, const std::vector<DrawCall>& calls) {
    const auto call = std::find_if(calls.begin(), calls.end(), [&](const DrawCall& drawn) {
        return drawn.pass == fragment.pass && drawn.object == std::max(fragment.object_index, -1);
    });
    if (call == calls.end()) return std::nullopt;
    return DrawLimit{static_cast<int>(call - calls.begin()), fragment.triangle + 1};
}

}  // namespace viewing
