#include "grading/state_numbers.h"

#include "state/scene.h"

namespace viewing {
namespace {

/// Owns the data that a state's numbers refer to, for as long as they are in use.
struct Kept {
    Kept(const LoadedState& state, const Params& start, Scene scene, const Measurer& measurer)
        : now_(state.params), start_(start), scene_(std::move(scene)), numbers(now_, start_, scene_, measurer) {}

private:
    Params now_, start_;
    Scene scene_;

public:
    LessonNumbers numbers;
};

}  // namespace

Result<Surroundings> numbers_of(const LoadedState& now, const Params& start, const Measurer& measurer) {
    Result<Scene> scene =
        load_scene(now.params.scene, now.base, now.params.coplanar, {.origin = now.scene_origin, .reach = now.reach});
    if (!scene) return Error{scene.error()};
    const auto kept = std::make_shared<Kept>(now, start, *std::move(scene), measurer);
    return Surroundings{[kept](const std::string& name, std::span<const double> arguments) {
                            return kept->numbers.surroundings().look_up(name, arguments);
                        },
                        nullptr, nullptr};
}

NumbersAt numbers_at_start(const Measurer& measurer) {
    return [measurer](const LoadedState& start) { return numbers_of(start, start.params, measurer); };
}

}  // namespace viewing
