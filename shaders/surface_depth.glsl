// Part of surface.frag: the depth that the fragment writes instead of the rasterizer's.
#ifdef DEPTH_OF_PLANE
uniform vec3 depth_in_plane;  // window depth = dot(depth_in_plane, vec3(x, y, 1)), with x and y in pixels
#endif
#ifdef WRITE_DEPTH
uniform float depth_levels;      // 2^bits - 1; 0: the buffer's own precision
uniform vec2 logarithmic_range;  // near, far; 0: not logarithmic
uniform vec2 depth_offset;       // glPolygonOffset's factor, and units times the smallest step

float written_depth() {
#ifdef DEPTH_OF_PLANE
    float depth = dot(depth_in_plane, vec3(gl_FragCoord.xy, 1.0));
#else
    float depth = WINDOW_DEPTH;
#endif
    if (logarithmic_range.x > 0.0) {
        float distance = max(-view_zw.x / view_zw.y, 1e-30);
        depth = log(distance / logarithmic_range.x) / log(logarithmic_range.y / logarithmic_range.x);
    }
    depth += depth_offset.x * max(abs(dFdx(depth)), abs(dFdy(depth))) + depth_offset.y;
    if (depth_levels > 0.0) depth = floor(clamp(depth, 0.0, 1.0) * depth_levels + 0.5) / depth_levels;
    return depth;
}
#endif

