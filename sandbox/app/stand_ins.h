// What is drawn while a large scene moves by hand: the same objects with coarser meshes, made beside the window. At
// rest, and in every picture that is written, the scene itself is drawn.
#pragma once

#include <string>

#include "platform/background.h"
#include "state/scene.h"

namespace viewing {

/// The scene with a coarser mesh for each that has more than 150,000 triangles.
Scene with_stand_ins(const Scene& scene);

class StandIns {
public:
    /// Begins to make them when the scene is another one and has meshes that are large.
    void follow(const Scene& scene, int version);

    /// `is_slow`: frames take long. A scene that was slow once while it was held is drawn coarsely whenever it is held:
    /// that is what comes back then. Null: draw the scene itself.
    const Scene* choose(bool is_held, bool is_slow);

    /// "40,112 of 1,000,000 triangles", in a sentence.
    const std::string& sentence() const { return sentence_; }

private:
    BackgroundTask<Scene> task_;
    int version_ = -1;  ///< of the scene that they stand for
    std::optional<Scene> scene_;
    std::size_t triangles_ = 0;  ///< of the scene that they stand for
    std::string sentence_;
    bool was_slow_ = false;
};

}  // namespace viewing
