// The pictures in the window's views: each topic's, drawn into a view of its own.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "app/shown_frame.h"
#include "render/renderer.h"
#include "ui/views/views.h"

namespace viewing {

class ViewPictures {
public:
    explicit ViewPictures(Renderer& renderer) : renderer_(renderer) {}

    /// What is behind everything, in the place of the theme's background.
    void set_background(Color color) { background_ = color; }

    /// What cannot be drawn keeps its last picture.
    Status draw(const ShownFrame& shown, const Scene& scene, const Layout& layout);
    /// The camera's view alone, or one of those below it: what can be done where the scene is slow to draw.
    Status draw_camera(const ShownFrame& shown, const Scene& scene, const Layout& layout);
    /// The same though nothing on screen shows it, at the size that it had there last.
    Status draw_unseen_camera(const ShownFrame& shown, const Scene& scene);
    Status draw_lower(Slot slot, const ShownFrame& shown, const Scene& scene, const Layout& layout);

    const View& camera() const { return camera_; }
    /// The view that a texture of Pictures belongs to; null for another one's.
    const View* view_of(ImTextureID texture) const;
    /// As the user interface shows them; what was found for them is left empty.
    Pictures textures() const;

private:
    Status render(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view);
    Status draw_beside(const ShownFrame& shown, const Scene& scene, const Layout& layout);
    Status draw_depth(const ShownFrame& shown, const Scene& scene, glm::ivec2 size_px, View& view);
    Status draw_after_pass(const ShownFrame& shown, const Scene& scene, glm::ivec2 size_px);
    Status draw_mirror_ways(const ShownFrame& shown, const Scene& scene);

    Renderer& renderer_;
    std::optional<Color> background_;
    View camera_, beside_;
    std::array<View, 2> lower_;  ///< of each Slot
    std::array<View, mirror_way_count> mirror_way_views_;
    std::shared_ptr<const MirrorWays> mirror_ways_;
    std::array<View, 3> after_pass_;  ///< colour, depth and stencil
};

}  // namespace viewing
