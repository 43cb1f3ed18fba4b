// Thumbnails of presets and lesson steps, made on demand and kept. Loading a preset and running its hidden-surface
// method happen in the background; one thumbnail per frame is drawn.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "frame/derive.h"
#include "gl/target.h"
#include "platform/background.h"
#include "render/renderer.h"
#include "state/scene.h"
#include "topics/hidden/numbers/hidden_views.h"
#include "ui/views/views.h"

namespace viewing {

class PresetPictures {
public:
    explicit PresetPictures(Renderer& renderer) : renderer_(renderer) {}

    /// A function that loads the state for a picture. It is called in the background.
    using Load = std::function<Result<LoadedState>()>;
    /// Returns a preset's picture, which has no texture while it is being made or if making it fails. `waits`: makes it
    /// before returning. Returns no picture for "".
    PresetPicture of(const std::string& name, bool waits);
    /// Returns the picture of any state, which `load` loads. Keeps the picture under `name`.
    PresetPicture of(const std::string& name, const Load& load, glm::ivec2 size_px, bool waits);

    /// Whether a picture is being made, in which case more frames are needed.
    bool is_busy() const { return preparing_.is_running(); }

private:
    /// Everything that a picture needs before it can be drawn.
    struct Prepared {
        std::string name;
        glm::ivec2 size_px{0};
        Params params;
        Scene scene;
        Derived derived;
        std::shared_ptr<HiddenAnswer> answer;  ///< null if GL's depth buffer does all the work
    };
    static Result<Prepared> prepare(const std::string& name, const Load& load, const Viewport& viewport);
    Status draw(Prepared& prepared);

    Renderer& renderer_;
    View view_;  ///< all pictures are drawn into this view, one after another
    std::map<std::string, gl::ColorTarget> pictures_;
    std::string wanted_;
    BackgroundTask<Prepared> preparing_;
};

}  // namespace viewing
