#include "grading/lesson_numbers.h"

#include <cmath>
#include <optional>

#include "frame/plan/plan.h"
#include "frame/problems.h"
#include "report/as_json.h"
#include "report/matrices_report.h"
#include "state/file/reader.h"
#include "text/numbers.h"
#include "topics/depth/measured/fighting_as_json.h"
#include "topics/depth/measured/pixel_as_json.h"
#include "topics/hidden/measured/order_report.h"
#include "topics/hidden/measured/visibility_report.h"
#include "topics/planes/measured/mirror_report.h"
#include "topics/why/measured/why_report.h"

namespace viewing {
namespace {

/// The lecture's letters, and the names that `matrices` prints for them.
struct Letter {
    const char *letter, *name;
};
constexpr Letter letters[] = {{"V", "view_from_world"},  {"C", "world_from_view"},   {"P", "clip_from_view"},
                              {"PV", "clip_from_world"}, {"S", "shadow_from_world"}, {"R", "mirror_from_world"}};

Error wants_arguments(const std::string& form) {
    return Error{"must be called as " + form};
}

}  // namespace

LessonNumbers::LessonNumbers(const Params& now, const Params& start, const Scene& scene, const Measurer& measurer,
                             glm::ivec2 size_px)
    : now_(now),
      start_(start),
      scene_(scene),
      renderer_(measurer.renderer()),
      size_px_(size_px),
      known_(measurer.known(now, scene)),
      derived_(derive(now, scene, renderer_ ? renderer_->viewport(size_px, now, scene) : Viewport{size_px})) {}

Surroundings LessonNumbers::surroundings() {
    return {[this](const std::string& name, std::span<const double> arguments) { return look_up(name, arguments); },
            nullptr, nullptr};
}

const Json& LessonNumbers::matrices() {
    if (matrices_.is_null()) {
        matrices_ = matrices_as_json(derived_, find_problems(now_, derived_, scene_, plan(now_, derived_)));
        for (const auto& [letter, name] : letters) matrices_[letter] = matrices_[name];
        if (!matrices_.contains("followed")) matrices_["followed"] = nullptr;
    }
    return matrices_;
}

Result<Json> LessonNumbers::measured(const std::string& name, std::span<const double> arguments) {
    if (name == "order") {
        if (!arguments.empty()) return wants_arguments("order()");
        return order_as_json(now_, scene_, size_px_);
    }
    if (name == "bsp_order") {
        if (!arguments.empty()) return wants_arguments("bsp_order()");
        return bsp_order_as_json(now_, scene_, size_px_);
    }
    if (name == "newell_step") {
        if (!arguments.empty()) return wants_arguments("newell_step()");
        return newell_step_as_json(now_, scene_, size_px_);
    }
    if (!renderer_) return Error{name + " is measured in pictures, which are not available here"};
    if (name == "pixel" || name == "why") {
        const auto is_place = [](double at, int end) { return at == std::floor(at) && at >= 0.0 && at < end; };
        if (arguments.size() != 2 || !is_place(arguments[0], size_px_.x) || !is_place(arguments[1], size_px_.y))
            return wants_arguments(name + "(x, y) with whole numbers below " + std::to_string(size_px_.x) + " and " +
                                   std::to_string(size_px_.y));
        const glm::ivec2 pixel(arguments[0], arguments[1]);
        if (name == "pixel") return pixel_as_json(*renderer_, now_, scene_, pixel, size_px_);
        const Result<std::vector<Why>> explained = explained_pixels(*renderer_, now_, scene_, {&pixel, 1}, size_px_);
        return explained ? Result<Json>(why_as_json(explained->front())) : Result<Json>(Error{explained.error()});
    }
    if (!arguments.empty()) return wants_arguments(name + "()");
    if (name == "fighting") return fighting_as_json(*renderer_, now_, scene_, size_px_, true);
    if (name == "mirror_ways") return mirror_as_json(*renderer_, now_, scene_, size_px_);
    if (const std::size_t count = scene_.triangle_count(); count > most_counted_polygons)
        return Error{"visibility_counts() takes scenes of at most " + grouped_number(most_counted_polygons) +
                     " polygons, but this one has " + grouped_number(static_cast<std::int64_t>(count))};
    Result<Json> counts = visibility_as_json(*renderer_, now_, scene_, visibility_size_px);
    return counts ? Result<Json>(without_times(*std::move(counts))) : counts;
}

Result<Json> LessonNumbers::look_up(const std::string& name, std::span<const double> arguments) {
    const auto state = [](Json& kept, const Params& params) -> const Json& {
        if (kept.is_null()) kept = params_as_document(params);
        return kept;
    };
    if (name == "start") return state(start_state_, start_);
    if (const Json& fields = state(state_, now_); fields.contains(name)) return fields[name];
    for (const char* const of_matrices :
         {"V", "C", "P", "PV", "S", "R", "shadow_sign", "facts", "followed", "problems"})
        if (name == of_matrices) return matrices()[name];
    if (name == "depth_step") {
        if (arguments.size() != 1 || !(arguments[0] > 0.0)) return wants_arguments("depth_step(z) with z > 0");
        return Json(depth_step(now_, arguments[0]));
    }
    std::string key = name;
    for (const double argument : arguments) key += " " + shortest_number(argument);
    if (const auto known = known_->find(key); known != known_->end()) return known->second;
    if (known_->size() == most_measured)
        return Error{name + " exceeds the limit of " + std::to_string(most_measured) +
                     " different measured values per state"};
    Result<Json> value = measured(name, arguments);
    if (value) (*known_)[key] = *value;
    return value;
}

}  // namespace viewing
