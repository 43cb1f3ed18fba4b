// The pictures in the window's views, each with its own View.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "app/shown_frame.h"
#include "render/renderer.h"
#include "text/per_enum.h"
#include "ui/views/views.h"

namespace viewing {

class ViewPictures {
public:
    explicit ViewPictures(Renderer& renderer) : renderer_(renderer) {}

    /// Sets a background color that replaces the theme's.
    void set_background(Color color) { background_ = color; }

    /// Draws all visible views. A view that cannot be drawn keeps its last picture.
    Status draw(const ShownFrame& shown, const Scene& scene, const Layout& layout);
    /// Draws only the camera's view, for scenes that are slow to draw; draw_lower() draws only one of the views below
    /// it.
    Status draw_camera(const ShownFrame& shown, const Scene& scene, const Layout& layout);
    /// Draws the camera's view at the size that it last had on screen, even though it is not visible now.
    Status draw_unseen_camera(const ShownFrame& shown, const Scene& scene);
    Status draw_lower(Slot slot, const ShownFrame& shown, const Scene& scene, const Layout& layout);

    const View& camera() const { return camera_; }
    /// Returns the View that this texture in Pictures belongs to; null for other textures.
    const View* view_of(ImTextureID texture) const;
    /// Returns the textures for the user interface, and the comparison of the ways to draw a mirror image; leaves
    /// everything else empty.
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
    PerEnum<Slot, View, 2> lower_;
    std::array<View, mirror_way_count> mirror_way_views_;
    std::shared_ptr<const MirrorWays> mirror_ways_;
    std::array<View, 3> after_pass_;  ///< color, depth and stencil
};

}  // namespace viewing
