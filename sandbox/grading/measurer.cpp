#include "grading/measurer.h"

#include <algorithm>

namespace viewing {
namespace {

bool is_same(const Scene& a, const Scene& b) {
    return std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                      [](const SceneObject& one, const SceneObject& other) {
                          return one.mesh == other.mesh && one.description == other.description &&
                                 one.world_from_model == other.world_from_model;
                      });
}

}  // namespace

std::shared_ptr<Measurer::Values> Measurer::known(const Params& params, const Scene& scene) const {
    constexpr std::size_t most_states = 32;
    auto found = std::find_if(states_->begin(), states_->end(), [&](const State& state) {
        return state.params == params && is_same(state.scene, scene);
    });
    if (found == states_->end()) {
        if (states_->size() == most_states) states_->pop_back();
        states_->push_front({params, scene, std::make_shared<Values>()});
        found = states_->begin();
    }
    states_->splice(states_->begin(), *states_, found);
    return found->values;
}

}  // namespace viewing
