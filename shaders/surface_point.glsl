// Part of surface.frag: the surface point that the fragment shows, from the rasterizer.
//
// FROM_PICTURE: the surface point and its depth come from textures, one texel per pixel, as a software method computed
// them.
#ifdef FROM_PICTURE
in vec2 position_texture;
uniform highp sampler2D surface_positions;  // xyz: relative to the drawing's origin; w: standard window depth, or 2 if nothing is seen
uniform highp sampler2D surface_normals;    // xyz: toward the eye; w: 1 for a front face, 0 for a back face
uniform highp sampler2D surface_colors;     // xyz: linear color; w: object ID, from 1
uniform highp sampler2D surface_counts;     // how often the pixel was drawn
uniform vec2 picture_share;                 // fraction of the view that the picture fills, centered
uniform mat4 relative_from_model;
uniform mat3 world_from_normal;
uniform vec4 clip_plane_model[CLIP_PLANES];
uniform vec4 view_z_of_model;
uniform vec4 view_w_of_model;
uniform bool reverses_depth;
vec3 position_relative = vec3(0.0), normal_world = vec3(0.0), albedo = vec3(0.0);
float found_depth = 0.0;
vec2 view_zw = vec2(-1.0, 1.0);
bool is_front = false;
#else
AT(0) in vec3 position_relative;
#ifdef IS_PATCH
AT(2) in vec2 position_patch;
#else
AT(1) in vec3 normal_world;
#endif
#endif

// PER_VERTEX: color and IDs come with the vertices.
#ifdef PER_VERTEX
AT(3) in vec3 vertex_albedo;
AT(4) flat in vec2 ids;
#endif

#if defined(WRITE_DEPTH) && !defined(FROM_PICTURE)
AT(5) in vec2 view_zw;
#endif
#ifdef CLIP_BY_DISCARD
AT(6) in float clip_distance[CLIP_PLANES];
#endif

uniform vec4 eye_relative;  // w = 0: parallel view rays, from this direction
uniform vec4 base_color;    // linear; flat shading: sRGB

#ifdef FROM_PICTURE
vec2 position_picture() {
    return (position_texture - 0.5) / picture_share + 0.5;
}

ivec2 texel_of(highp sampler2D picture) {  // the first row is the top one
    ivec2 size = textureSize(picture, 0);
    vec2 position = position_picture();
    return clamp(ivec2(vec2(position.x, 1.0 - position.y) * vec2(size)), ivec2(0), size - 1);
}

void fetch_surface() {
    vec2 from_middle = abs(position_picture() - 0.5);
    if (max(from_middle.x, from_middle.y) > 0.5) discard;
    ivec2 texel = texel_of(surface_positions);
    vec4 position = texelFetch(surface_positions, texel, 0);
    vec4 normal = texelFetch(surface_normals, texel, 0);
    vec4 scene = vec4(position.xyz, 1.0);
    if (position.w > 1.5) discard;
    for (int plane = 0; plane < CLIP_PLANES; ++plane)
        if (dot(clip_plane_model[plane], scene) < 0.0) discard;
    position_relative = (relative_from_model * scene).xyz;
    normal_world = world_from_normal * normal.xyz;
    albedo = texelFetch(surface_colors, texel, 0).rgb;
    is_front = normal.w > 0.5;
    found_depth = reverses_depth ? 1.0 - position.w : position.w;
    view_zw = vec2(dot(view_z_of_model, scene), dot(view_w_of_model, scene));
}
#define FRONT_FACING is_front
#define WINDOW_DEPTH found_depth
#else
#define FRONT_FACING gl_FrontFacing
#define WINDOW_DEPTH gl_FragCoord.z
#endif

#if defined(FROM_PICTURE)
#define ALBEDO albedo
#elif defined(PER_VERTEX)
#define ALBEDO vertex_albedo
#else
#define ALBEDO base_color.rgb
#endif

