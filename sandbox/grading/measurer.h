// What lessons and exercises measure in the pictures and orders of states. Questions of one exercise, and the answers
// of many students, ask for the same values of the same states; a measurement takes up to a second.
#pragma once

#include <list>
#include <map>
#include <memory>
#include <string>

#include "render/renderer.h"
#include "state/file/document.h"
#include "state/scene.h"

namespace viewing {

/// Keeps measured values for the most recently used states. Copies share them.
class Measurer {
public:
    /// Measured values, by the name of the measurement and its arguments.
    using Values = std::map<std::string, Json>;

    /// Without a renderer, nothing can be measured in pictures. A renderer must outlive the measurer.
    Measurer(Renderer* renderer) : renderer_(renderer) {}

    Renderer* renderer() const { return renderer_; }

    /// Returns the values that are known about a state. It is the same state if its parameters and meshes are.
    std::shared_ptr<Values> known(const Params& params, const Scene& scene) const;

private:
    struct State {
        Params params;
        Scene scene;
        std::shared_ptr<Values> values;
    };
    Renderer* renderer_;
    std::shared_ptr<std::list<State>> states_ = std::make_shared<std::list<State>>();  ///< the latest first
};

}  // namespace viewing
