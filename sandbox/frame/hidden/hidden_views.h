// What a picture asks of hidden-surface methods, and the answer: the method for the camera, the same for the eye behind
// the mirror, and the method that it is compared with. Read hidden_surfaces.h for one of them.
#pragma once

#include <optional>

#include "frame/hidden/hidden_budget.h"
#include "frame/hidden/hidden_drawing.h"
#include "frame/plan.h"
#include "visibility/difference.h"

namespace viewing {

struct HiddenQuestion {
    HiddenRequest camera;
    std::optional<HiddenRequest> mirrored{};  ///< where the mirror image is drawn by the method too
    std::optional<HiddenRequest> other{};     ///< in the difference view
    bool draws_camera = true;                 ///< false: GL draws the scene by itself, the order is wanted all the same
    bool operator==(const HiddenQuestion&) const = default;
};

/// None where GL draws everything by itself and nothing of a method is shown.
std::optional<HiddenQuestion> hidden_question(const Params& params, const Derived& derived, glm::ivec2 size_px);

struct HiddenAnswer {
    HiddenQuestion question;
    std::shared_ptr<const HiddenResult> camera{}, mirrored{}, other{};
    HiddenPictures pictures{};  ///< the difference is missing where GL has to draw one of the two
    std::int64_t different_pixels = -1, compared_pixels = -1;
    std::optional<WrongPair> painter_fails{};  ///< of the painter's algorithm; searched in a small picture

    /// A sentence when some method stopped at a budget or was cancelled; else empty.
    std::string problem() const;
};

/// Whether the scene is not too large for what is asked (hidden_budget.h).
Status check_hidden_budget(const Scene& scene, const HiddenQuestion& question);

HiddenAnswer answer_hidden_question(HiddenSurfaceSolver& solver, const HiddenQuestion& question,
                                    WorkProgress* progress = nullptr);

/// Fills the difference in from the two id pictures, which GL may have drawn. With exact curves on one side objects are
/// compared, else polygons.
void add_difference(HiddenAnswer& answer, const IdImage& camera, const IdImage& other);

/// A frame that shows the polygons of a request to be read back by number: only GL's own methods need it.
FramePlan plan_polygon_ids(Params params, const Derived& derived, const HiddenResult& result);

}  // namespace viewing
