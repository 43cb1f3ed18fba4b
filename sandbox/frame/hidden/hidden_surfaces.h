// A hidden-surface method run on a scene for a camera, with everything that is shown of it: order, tree, steps,
// counters and picture. Read hidden_surfaces.cpp, then hidden_drawing.h.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/derive.h"
#include "frame/hidden/scene_surface.h"
#include "visibility/bsp.h"
#include "visibility/culling.h"
#include "visibility/newell.h"
#include "visibility/painter.h"
#include "visibility/software_zbuffer.h"

namespace viewing {

/// What a method needs to know: equal requests have equal results.
struct HiddenRequest {
    VisibilityParams visibility;
    CullParams cull;
    Viewpoint viewpoint;
    glm::ivec2 size_px{1};  ///< of the picture that is found: the view's, or a raster's
    glm::dvec2 share{1.0};  ///< of the view's width and height that the picture fills, around its middle
    bool operator==(const HiddenRequest&) const = default;
};

/// The part of the view around its middle, in clip space, so that it fills the picture: HiddenRequest::share.
glm::dmat4 part_from_view(const glm::dvec2& share);

/// The pixel of the picture that a place of the view lies in, both from the top left one on; none beside the picture.
/// `place_px`: in the view's pixels.
std::optional<glm::ivec2> raster_pixel(const glm::dvec2& place_px, glm::ivec2 view_px, glm::ivec2 size_px,
                                       const glm::dvec2& share);

/// The camera's request, and that of the eye behind the mirror, whose picture is the mirror image.
HiddenRequest hidden_request(const Params& params, const Derived& derived, glm::ivec2 size_px);
HiddenRequest mirrored_request(const Params& params, const Derived& derived, glm::ivec2 size_px);

/// What a method did, at the step that was asked for. −1: a number that this method does not have.
struct HiddenCounters {
    std::int64_t polygons = 0;  ///< given to the method
    std::int64_t culled = 0;    ///< left out before, because of their facing
    std::int64_t comparisons = -1, swaps = -1, splits = -1;
    std::int64_t fragments = -1;   ///< polygons after cutting
    std::int64_t tree_depth = -1;  ///< 1 for a root alone
    std::int64_t pixels_tested = -1, pixels_written = -1, pixels_covered = -1;
    std::int64_t rays = -1, intersection_tests = -1;

    /// How often a covered pixel was written, in the mean; 0 for an empty picture.
    double overdraw() const {
        return pixels_covered > 0 ? static_cast<double>(pixels_written) / static_cast<double>(pixels_covered) : 0.0;
    }
};

/// A ray of ray casting and all that it meets.
struct TracedRay {
    glm::ivec2 pixel{0};
    Ray ray;
    std::vector<RayCastHit> hits;
};

/// A fragment of the pixel that is followed, and the step that tests it.
struct PixelTouch {
    int step = 0;
    RasterStep fragment;
};

/// Shared with whatever made them: the scene's surface, a tree, an order.
using Polygons = std::shared_ptr<const std::vector<Polygon>>;

/// Immutable once made; parts that do not depend on the step are shared with other results.
struct HiddenResult {
    HiddenRequest request;
    std::shared_ptr<const SceneSurface> surface;
    Polygons fragments;      ///< what is drawn
    std::vector<int> order;  ///< indices into fragments in drawing order, of all steps
    int drawn = 0;           ///< how many of `order` the step has reached

    std::shared_ptr<const PainterOrder> painter;
    std::shared_ptr<const NewellOrder> newell;
    std::shared_ptr<const BspTree> tree;
    std::shared_ptr<const BspWalk> walk;
    int built_nodes = 0, visited_nodes = 0;  ///< of tree and walk
    std::optional<RasterStep> compare;       ///< of the software depth buffer: the last one
    std::optional<TracedRay> traced;  ///< of ray casting: the last one at a step, else that of the followed pixel
    std::vector<PixelTouch> touches;  ///< of the followed pixel: of all steps, in their order

    int step = -1, step_count = 0;  ///< −1: all
    std::vector<int> group_ends;    ///< the last step of each group, see step_groups.h; empty: no groups
    CullCounts facing;              ///< of all the scene's polygons, whether or not they are culled
    HiddenCounters counters;
    IdImage image;                                 ///< polygon numbers; what is drawn at this step
    std::vector<std::uint32_t> written_per_pixel;  ///< overdraw; as image
    double time_ms = 0.0;                          ///< of the method alone, all steps, without painting_ms
    double painting_ms = 0.0;                      ///< of painting in the order that the method has found
    double build_ms = 0.0;                         ///< of what is made once for all cameras: tree, hierarchy
    std::string problem;                           ///< a sentence when it stopped at a budget or was cancelled
    bool is_cancelled = false;
};

/// What is said of a method that was cancelled and has nothing better to say.
std::string sentence_of_cancelled();

/// Whether rays meet curved shapes themselves; their triangles are taken while culling tells sides apart.
bool uses_exact_curves(const HiddenRequest& request);

/// Whether the picture is made of pixels that were found in software, not of polygons that GL draws in order.
bool draws_pixels(const VisibilityParams& visibility);

/// Runs methods on one scene; what does not depend on the camera, and the latest order, are kept between calls. Not for
/// several threads at once.
class HiddenSurfaceSolver {
public:
    /// Cancelled, it has the first of the scene's polygons: good for an answer to who cancelled it, for nobody after.
    explicit HiddenSurfaceSolver(const Scene& scene, const WorkProgress* progress = nullptr);

    /// `depth_buffer` and `none` give the scene's own order and no picture: that is GL's to draw. Cancelled: a result
    /// with a sentence.
    std::shared_ptr<const HiddenResult> solve(const HiddenRequest& request, WorkProgress* progress = nullptr);

    const std::shared_ptr<const SceneSurface>& surface() const { return surface_; }

private:
    struct Trees {
        std::shared_ptr<const BspTree> tree;
        BspSplitter splitter = BspSplitter::first;
        double epsilon = 0.0, build_ms = 0.0;
    };
    struct Rays {
        std::shared_ptr<const RayScene> scene;
        HiddenRequest made_for;
        double build_ms = 0.0;
    };

    void find_order(HiddenResult& result, WorkProgress* progress);
    void find_bsp(HiddenResult& result, WorkProgress* progress);
    void cast(HiddenResult& result, WorkProgress* progress);
    Polygons polygons_for(HiddenResult& result, const WorkProgress* progress) const;

    std::shared_ptr<const SceneSurface> surface_;
    Trees trees_;
    Rays rays_;
    std::vector<std::shared_ptr<const HiddenResult>> latest_;  ///< of the camera and the mirrored eye, for two methods
};

}  // namespace viewing
