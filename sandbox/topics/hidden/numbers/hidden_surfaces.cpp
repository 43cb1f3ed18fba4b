// The list of the methods' entries, the entries of the methods that GL draws, and the solver. Read hidden_drawing.h
// next.
#include "topics/hidden/numbers/hidden_surfaces.h"

#include <algorithm>
#include <array>

#include "text/catalogue.h"
#include "topics/hidden/numbers/method_parts.h"

namespace viewing {

namespace hidden_methods {
const HiddenMethod depth_buffer{.name = marked("GL depth buffer"), .find = find_scene_order};
const HiddenMethod none{.name = marked("none"), .find = find_scene_order};
constexpr std::array all{VIEWING_METHODS(VIEWING_ADDRESS)};
}  // namespace hidden_methods

namespace {

/// Returns whether two requests differ only in step and followed pixel, and therefore share order, tree and counters.
bool have_one_order(HiddenRequest a, const HiddenRequest& b) {
    a.visibility.step = b.visibility.step;
    a.visibility.pixel = b.visibility.pixel;
    return a == b && !hidden_method(b.visibility.method).computes_pixels;
}

/// Finds how far into the order the requested step reaches.
void find_step(HiddenResult& result) {
    const int wanted = result.request.visibility.step;
    const std::vector<int>& steps = result.order_steps;
    result.step = wanted >= result.step_count ? -1 : wanted;
    const auto left = result.step < 0 ? steps.end() : std::upper_bound(steps.begin(), steps.end(), result.step);
    result.drawn = static_cast<int>(left - steps.begin());
}

}  // namespace

const HiddenMethod& hidden_method(VisibilityMethod method) {
    return *hidden_methods::all[static_cast<std::size_t>(method)];
}

std::span<const char* const> method_names() {
    static const std::vector<const char*> names = [] {
        std::vector<const char*> found;
        for (const HiddenMethod* const method : hidden_methods::all) found.push_back(method->name);
        return found;
    }();
    return names;
}

Message sentence_of_canceled() {
    return message("The method was canceled: the picture is not finished.");
}

HiddenSurfaceSolver::HiddenSurfaceSolver(const Scene& scene, const WorkProgress* progress)
    : data_{.surface = std::make_shared<const SceneSurface>(surface_of(scene, progress))} {}

std::shared_ptr<const HiddenResult> HiddenSurfaceSolver::solve(const HiddenRequest& request, WorkProgress* progress) {
    for (const auto& kept : latest_)
        if (kept->request == request) return kept;

    auto result = std::make_shared<HiddenResult>();
    const auto same_order = std::find_if(latest_.begin(), latest_.end(),
                                         [&](const auto& kept) { return have_one_order(kept->request, request); });
    const bool is_known = same_order != latest_.end();
    if (is_known) *result = **same_order;
    result->request = request;
    result->surface = surface();
    result->touches.clear();

    const HiddenMethod& method = hidden_method(request.visibility.method);
    if (!is_known) {
        result->facing = count_facing(surface()->polygons, request.viewpoint, winding_for(request), progress);
        method.find(data_, *result, progress);
    }
    find_step(*result);
    if (method.count) method.count(*result);
    if (method.draw) method.draw(data_, *result, progress);
    result->is_canceled = is_canceled(progress);
    if (result->is_canceled) {
        if (result->problem.empty()) result->problem = sentence_of_canceled();
        return result;
    }
    constexpr std::size_t kept_count = 4;  // camera and mirrored eye, for the two methods of a comparison
    if (latest_.size() == kept_count) latest_.erase(latest_.begin());
    latest_.push_back(result);
    return result;
}

}  // namespace viewing
