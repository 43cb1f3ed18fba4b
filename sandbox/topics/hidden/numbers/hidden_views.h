// The question that a picture asks of the hidden-surface methods, and the answer: one method's results for the camera
// and for the eye behind the mirror, and the results of a second method to compare with. See hidden_surfaces.h for a
// single method.
#pragma once

#include <optional>

#include "frame/plan/plan.h"
#include "topics/hidden/methods/difference.h"
#include "topics/hidden/numbers/hidden_budget.h"
#include "topics/hidden/numbers/hidden_drawing.h"

namespace viewing {

struct HiddenQuestion {
    HiddenRequest camera;
    std::optional<HiddenRequest> mirrored{};  ///< set if the method draws the mirror image, too
    std::optional<HiddenRequest> other{};     ///< for the difference view
    bool draws_camera = true;                 ///< false: GL draws the scene by itself, but the order is needed
    bool operator==(const HiddenQuestion&) const = default;
};

/// Returns the question that a state asks; none if GL draws everything by itself and nothing about a method is shown.
std::optional<HiddenQuestion> hidden_question(const Params& params, const Derived& derived, glm::ivec2 size_px);

struct HiddenAnswer {
    HiddenQuestion question;
    std::shared_ptr<const HiddenResult> camera{}, mirrored{}, other{};
    HiddenPictures pictures{};  ///< the difference is missing if GL has to draw one of the two pictures
    std::int64_t different_pixels = -1, compared_pixels = -1;
    std::optional<WrongPair> painter_fails{};  ///< the worst error of the painter's algorithm, in a small picture

    /// Returns a sentence if a method stopped at a budget or was canceled; otherwise empty.
    Message problem() const;
};

/// Says that the scene is too large for the question (hidden_budget.h); empty if it is not.
Message beyond_hidden_budget(const Scene& scene, const HiddenQuestion& question);

HiddenAnswer answer_hidden_question(HiddenSurfaceSolver& solver, const HiddenQuestion& question,
                                    WorkProgress* progress = nullptr);

/// Adds the difference of the two ID images, which GL may have drawn. Compares objects if one of the images has exact
/// curves, otherwise polygons.
void add_difference(HiddenAnswer& answer, const IdImage& camera, const IdImage& other);

/// Plans a frame that draws the IDs of a result's polygons, to be read back. It is needed if GL draws these polygons.
FramePlan plan_polygon_ids(Params params, const Derived& derived, const HiddenResult& result);

}  // namespace viewing
