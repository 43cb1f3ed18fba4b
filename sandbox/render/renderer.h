// Executes a frame plan with GL: the only place where passes become calls. Also reads pictures and pixels back.
#pragma once

#include <memory>

#include "frame/plan.h"
#include "gl/objects.h"
#include "gl/target.h"
#include "image/image.h"

namespace viewing {

/// The framebuffers of one view on screen; kept between frames so that nothing is reallocated while nothing changes.
class View {
public:
    /// The finished picture (resolved, or depth and stencil made visible).
    GLuint texture() const { return presents_ ? shown_.texture() : target_.color_texture(); }
    GLuint framebuffer() const { return presents_ ? shown_.framebuffer() : target_.single_framebuffer(); }
    glm::ivec2 size_px() const { return target_.size_px(); }
    const gl::Target& target() const { return target_; }

private:
    friend class Renderer;
    gl::Target target_;
    gl::ColorTarget shown_;
    bool presents_ = false;
};

class Renderer {
public:
    /// Needs a current context. Fewer capabilities than it has take the fallbacks; more are a programmer's mistake.
    /// The error is a driver that refuses a shader.
    static Result<Renderer> make(const gl::Capabilities& capabilities = gl::Capabilities::of_current_context());
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    const gl::Capabilities& capabilities() const;

    /// For derive(). The second one has what the driver makes of the format, which is measured once for each: 20 ms or
    /// so, then GL is in its default state. Nothing is measured of a format that GL does not have.
    Viewport viewport(glm::ivec2 size_px) const;
    Viewport viewport(glm::ivec2 size_px, DepthFormat measured) const;
    /// Measured where something depends on it (depends_on_stored_depth).
    Viewport viewport(glm::ivec2 size_px, const Params& params, const Scene& scene) const;

    /// Draws the plan into the view, which takes the given size.
    Status draw(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view);

    /// The picture of the view, top row first.
    Image read(const View& view) const;

    /// Draws the plan with identities for colours: red and green hold the number of the object from 1 on
    /// (from patch_identity on for the patches, 0 where nothing is), blue whether its front is seen. The mirror image
    /// is left out: the patch is what is there.
    Status draw_identities(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view);

    static constexpr int patch_identity = 255 * 256;

    /// The polygons that GL shows where the plan's hidden surfaces are drawn in order, by Polygon::source, and nothing
    /// else of the scene. Below 2^24 polygons; depths are left as they are in an empty picture.
    Result<IdImage> read_polygon_ids(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view);

private:
    struct Implementation;
    explicit Renderer(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace viewing
