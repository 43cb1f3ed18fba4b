// Executes a frame plan with GL: the only code that turns passes into calls. Also reads pictures and pixels back.
#pragma once

#include <memory>

#include "frame/plan/plan.h"
#include "gl/objects.h"
#include "gl/target.h"
#include "image/id_image.h"
#include "image/image.h"

namespace viewing {

/// The framebuffers of one view on screen, kept between frames so that they are reallocated only when something
/// changes.
class View {
public:
    /// Returns the finished picture: resolved color, or depth and stencil made visible.
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
    /// Makes a renderer for the current context. If a capability of the context is left out, its fallback is used;
    /// passing one that the context lacks is a programming error. Fails if the driver rejects a shader.
    static Result<Renderer> make(const gl::Capabilities& capabilities = gl::Capabilities::of_current_context());
    Renderer(Renderer&&) noexcept;
    Renderer& operator=(Renderer&&) noexcept;
    ~Renderer();

    const gl::Capabilities& capabilities() const;

    /// Return the viewport for derive(). The second overload includes the driver's actual precision for the format,
    /// measured once per format: that takes about 20 ms and leaves GL in its default state. A format that GL lacks is
    /// not measured.
    Viewport viewport(glm::ivec2 size_px) const;
    Viewport viewport(glm::ivec2 size_px, DepthFormat measured) const;
    /// Returns the viewport for the format in `params`; measures only if something depends on the precision
    /// (depends_on_stored_depth).
    Viewport viewport(glm::ivec2 size_px, const Params& params, const Scene& scene) const;

    /// Draws the plan into the view, after resizing the view to `size_px`.
    Status draw(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view);

    /// Returns the picture of the view, top row first.
    Image read(const View& view) const;

    /// Draws the plan with identities as colors: red and green contain the object's number, which counts from 1
    /// (patches count from patch_identity, and the background is 0); blue says whether the front is visible. Does not
    /// draw mirror images: the pixels get the identity of the mirror.
    Status draw_identities(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view);

    static constexpr int patch_identity = 255 * 256;

    /// Draws the plan's hidden surfaces in order, without anything else in the scene. Returns for each pixel the
    /// visible polygon, as its Polygon::source. There may be at most 2^24 − 1 polygons. The depths of the image are not
    /// set: all are infinite.
    Result<IdImage> read_polygon_ids(const FramePlan& plan, const Scene& scene, glm::ivec2 size_px, View& view);

private:
    struct Implementation;
    explicit Renderer(std::unique_ptr<Implementation> implementation);
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace viewing
