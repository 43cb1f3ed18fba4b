// Runs a hidden-surface method on a scene for a camera, and keeps everything that the views show about it: order, tree,
// steps, counters and picture. Read hidden_method.h next, then hidden_drawing.h.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/derive.h"
#include "topics/hidden/methods/bsp.h"
#include "topics/hidden/methods/culling.h"
#include "topics/hidden/methods/newell.h"
#include "topics/hidden/methods/painter.h"
#include "topics/hidden/methods/software_zbuffer.h"
#include "topics/hidden/numbers/scene_surface.h"

namespace viewing {

/// The input of a method: equal requests give equal results.
struct HiddenRequest {
    VisibilityParams visibility;
    CullParams cull;
    Viewpoint viewpoint;
    glm::ivec2 size_px{1};  ///< of the picture to compute: the view's size, or a raster's
    glm::dvec2 share{1.0};  ///< fraction of the view's width and height that the centered picture fills
    bool operator==(const HiddenRequest&) const = default;
};

/// Returns the clip-space matrix that enlarges the central part of the view, HiddenRequest::share, to fill the picture.
glm::dmat4 part_from_view(const glm::dvec2& share);

/// Returns the pixel of the picture at a position in the view, both counted from the top left; none outside the
/// picture. `place_px`: in the view's pixels.
std::optional<glm::ivec2> raster_pixel(const glm::dvec2& place_px, glm::ivec2 view_px, glm::ivec2 size_px,
                                       const glm::dvec2& share);

/// Return the requests for the camera and for the eye behind the mirror, whose picture is the mirror image.
HiddenRequest hidden_request(const Params& params, const Derived& derived, glm::ivec2 size_px);
HiddenRequest mirrored_request(const Params& params, const Derived& derived, glm::ivec2 size_px);

/// Counts of a method's operations. Operations that its steps show are counted up to the requested step. −1: this
/// method does not count them.
struct HiddenCounters {
    std::int64_t polygons = 0;  ///< given to the method
    std::int64_t culled = 0;    ///< left out beforehand by culling
    std::int64_t comparisons = -1, swaps = -1, splits = -1;
    std::int64_t fragments = -1;   ///< polygons after cutting
    std::int64_t tree_depth = -1;  ///< 1 for a tree with only a root
    std::int64_t pixels_tested = -1, pixels_written = -1, pixels_covered = -1;
    std::int64_t rays = -1, intersection_tests = -1;

    /// Returns how often a covered pixel was written, on average; 0 for an empty picture.
    double overdraw() const {
        return pixels_covered > 0 ? static_cast<double>(pixels_written) / static_cast<double>(pixels_covered) : 0.0;
    }
};

/// A ray of ray casting and all its hits.
struct TracedRay {
    glm::ivec2 pixel{0};
    Ray ray;
    std::vector<RayCastHit> hits;
};

/// A fragment in the followed pixel, and the step that tests it.
struct PixelTouch {
    int step = 0;
    RasterStep fragment;
};

/// Polygons, shared with their owner: the scene's surface, a tree or an order.
using Polygons = std::shared_ptr<const std::vector<Polygon>>;

/// Immutable once made; shares the parts that do not depend on the step with other results.
struct HiddenResult {
    HiddenRequest request;
    std::shared_ptr<const SceneSurface> surface;
    Polygons fragments;            ///< to draw
    std::vector<int> order;        ///< indices into fragments in drawing order, for all steps
    std::vector<int> order_steps;  ///< for each entry of `order`, the step that completes its polygon
    int drawn = 0;                 ///< number of entries of `order` that the step has reached

    std::shared_ptr<const PainterOrder> painter;
    std::shared_ptr<const NewellOrder> newell;
    std::shared_ptr<const BspTree> tree;
    std::shared_ptr<const BspWalk> walk;
    int built_nodes = 0, visited_nodes = 0;  ///< nodes that the step has reached, in building and in traversal
    std::optional<RasterStep> compare;       ///< software depth buffer: the last comparison
    std::optional<TracedRay> traced;         ///< ray casting: the ray of the step, or else the followed pixel's
    std::vector<PixelTouch> touches;         ///< fragments in the followed pixel, over all steps, in order

    int step = -1, step_count = 0;  ///< −1: all
    std::vector<int> group_ends;    ///< the last step of each group (step_groups.h); empty: no groups
    CullCounts facing;              ///< of all polygons of the scene, culled or not
    HiddenCounters counters;
    IdImage image;                                 ///< IDs of the polygons drawn at this step
    std::vector<std::uint32_t> written_per_pixel;  ///< overdraw; laid out like image
    double time_ms = 0.0;                          ///< of the method alone, for all steps, without painting_ms
    double painting_ms = -1.0;                     ///< of painting in the method's order; −1: paints in no order
    double build_ms = -1.0;                        ///< of data made once for all cameras: tree, hierarchy; −1: none
    Message problem;                               ///< a sentence if the method stopped at a budget or was canceled
    bool is_canceled = false;
};

/// Returns the sentence for a canceled method that has no sentence of its own.
Message sentence_of_canceled();

/// Returns whether rays intersect the exact curved shapes. Because culling distinguishes front and back faces, rays
/// intersect the shapes' triangles instead while it is on.
bool uses_exact_curves(const HiddenRequest& request);

/// Returns whether software computes the picture's pixels, instead of GL drawing polygons in order.
bool draws_pixels(const VisibilityParams& visibility);

/// What methods keep between calls, since it does not depend on the camera.
struct HiddenData {
    struct Tree {
        std::shared_ptr<const BspTree> tree;
        BspSplitter splitter = BspSplitter::first;
        double epsilon = 0.0, build_ms = 0.0;
    };
    struct Rays {
        std::shared_ptr<const RayScene> scene;
        HiddenRequest made_for;
        double build_ms = 0.0;
    };
    std::shared_ptr<const SceneSurface> surface;
    Tree tree{};
    Rays rays{};
};

/// Runs methods on one scene. Between calls, keeps the data that does not depend on the camera, and the latest orders.
/// Not safe to use from several threads at the same time.
class HiddenSurfaceSolver {
public:
    /// If canceled, the solver has only the first polygons of the scene: enough to answer the caller who canceled.
    explicit HiddenSurfaceSolver(const Scene& scene, const WorkProgress* progress = nullptr);

    /// Solves a request. `depth_buffer` and `none` give the scene's own order but no picture, since GL draws the
    /// picture. If canceled, the result has a problem sentence.
    std::shared_ptr<const HiddenResult> solve(const HiddenRequest& request, WorkProgress* progress = nullptr);

    const std::shared_ptr<const SceneSurface>& surface() const { return data_.surface; }

private:
    HiddenData data_;
    std::vector<std::shared_ptr<const HiddenResult>> latest_;  ///< camera and mirrored eye, for two methods
};

}  // namespace viewing
