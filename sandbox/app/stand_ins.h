// Coarser meshes, made in the background, to draw instead of a large scene during a drag. At rest, and in every picture
// that is written to a file, the full scene is drawn.
#pragma once

#include <string>

#include "platform/background.h"
#include "state/scene.h"

namespace viewing {

/// Returns the scene with a coarser mesh for each mesh of more than 150,000 triangles.
Scene with_stand_ins(const Scene& scene);

class StandIns {
public:
    /// Starts to make stand-ins if the scene has changed and has large meshes.
    void follow(const Scene& scene, int version);

    /// Returns the scene to draw during a drag; null if the full scene must be drawn. `is_slow` says whether frames
    /// take a long time. Once a scene has been slow during a drag, it is drawn coarsely during every later drag.
    const Scene* choose(bool is_held, bool is_slow);

    /// Returns a sentence that contains the counts: "40,112 of 1,000,000 triangles".
    const std::string& sentence() const { return sentence_; }

private:
    BackgroundTask<Scene> task_;
    int version_ = -1;  ///< of the scene that the stand-ins replace
    std::optional<Scene> scene_;
    std::size_t triangles_ = 0;  ///< of the scene that the stand-ins replace
    std::string sentence_;
    bool was_slow_ = false;
};

}  // namespace viewing
