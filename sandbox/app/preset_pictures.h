// Small pictures of presets and of steps of lessons, made when they are wanted and kept. Reading a preset and finding
// what its hidden-surface method finds happens beside the window; of the drawing one picture a frame is done.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "frame/derive.h"
#include "frame/hidden/hidden_views.h"
#include "gl/target.h"
#include "platform/background.h"
#include "render/renderer.h"
#include "state/scene.h"
#include "ui/views/views.h"

namespace viewing {

class PresetPictures {
public:
    explicit PresetPictures(Renderer& renderer) : renderer_(renderer) {}

    /// Reads the state of a picture, beside the window.
    using Load = std::function<Result<LoadedState>()>;
    /// The picture of a preset, without a texture while it is being made, and where it cannot be. "" wants none.
    PresetPicture of(const std::string& name);
    /// The same of any state, kept under `name`.
    PresetPicture of(const std::string& name, const Load& load, glm::ivec2 size_px = {384, 216});

    /// Something is being made: further frames are wanted.
    bool is_busy() const { return preparing_.is_running(); }

private:
    /// Everything but the drawing.
    struct Prepared {
        std::string name;
        glm::ivec2 size_px{0};
        Params params;
        Scene scene;
        Derived derived;
        std::shared_ptr<HiddenAnswer> answer;  ///< null where GL's depth buffer draws
    };
    static Result<Prepared> prepare(const std::string& name, const Load& load, const Viewport& viewport);
    Status draw(Prepared& prepared);

    Renderer& renderer_;
    View view_;  ///< that they are drawn into, one after the other
    std::map<std::string, gl::ColorTarget> pictures_;
    std::string wanted_;
    BackgroundTask<Prepared> preparing_;
};

}  // namespace viewing
