// Transforms every surface of the scene: objects, their shadows, their mirror images and the plane's patch. The
// matrices arrive complete: the CPU has already multiplied in S and R, in double precision. Shading uses positions
// relative to the eye, along the world's axes: far from the world's origin, float32 is too coarse to compute slopes.
layout(location = 0) in vec3 position_model;
layout(location = 1) in vec3 normal_model;
#ifdef PER_VERTEX
layout(location = 2) in vec3 vertex_color;  // linear
layout(location = 3) in vec2 vertex_ids;    // of the object and of the polygon, from 1
AT(3) out vec3 vertex_albedo;
AT(4) flat out vec2 ids;
#endif

// SEPARATE: several fragment stages share this stage, so it has the same outputs whichever of them they read.
#ifdef SEPARATE
out gl_PerVertex {
    vec4 gl_Position;
#ifdef CLIP_DISTANCE
    float gl_ClipDistance[CLIP_PLANES];
#endif
};
#elif defined(CLIP_DISTANCE)
out float gl_ClipDistance[CLIP_PLANES];
#endif

// Passes that rely on stencil or equal depth must cover exactly the same pixels, whichever program they use.
invariant gl_Position;

uniform mat4 clip_from_model;
uniform mat4 relative_from_model;
uniform mat3 world_from_normal;

AT(0) out vec3 position_relative;
#ifndef IS_PATCH
AT(1) out vec3 normal_world;
#endif
#if defined(IS_PATCH) || defined(SEPARATE)
AT(2) out vec2 position_patch;
#endif

// For passes that clip: CLIP_DISTANCE, or CLIP_BY_DISCARD if GL has no clip distances.
#ifdef CLIP_BY_DISCARD
AT(6) out float clip_distance[CLIP_PLANES];
#endif
#if defined(CLIP_DISTANCE) || defined(CLIP_BY_DISCARD)
uniform vec4 clip_plane_model[CLIP_PLANES];  // kept where dot(plane, position) >= 0
#endif

#if defined(WRITE_DEPTH) || defined(LOGARITHM_PER_VERTEX)
uniform vec4 view_z_of_model;  // the third and fourth rows of view_from_model
uniform vec4 view_w_of_model;
#endif
#ifdef WRITE_DEPTH
AT(5) out vec2 view_zw;
#endif

// GL interpolates the vertices' logarithms over the triangle, so the depth is correct only at the vertices.
#ifdef LOGARITHM_PER_VERTEX
uniform vec2 vertex_near_far;

float logarithmic_depth(float distance) {
    return log(max(distance, 1e-30) / vertex_near_far.x) / log(vertex_near_far.y / vertex_near_far.x);
}
#endif

void main() {
    vec4 position = vec4(position_model, 1.0);
    gl_Position = clip_from_model * position;
    vec4 placed = relative_from_model * position;
    position_relative = placed.w == 0.0 ? placed.xyz : placed.xyz / placed.w;
#ifndef IS_PATCH
    normal_world = world_from_normal * normal_model;
#endif
#if defined(IS_PATCH) || defined(SEPARATE)
    position_patch = position_model.xz;
#endif
#ifdef PER_VERTEX
    vertex_albedo = vertex_color;
    ids = vertex_ids;
#endif
#ifdef FORCE_SIGN
    // Test the w that S yields, before the camera is applied. After the negation, GL does not split a triangle in which
    // this sign changes.
    if (placed.w < 0.0) gl_Position = -gl_Position;
#endif
#ifdef CLIP_DISTANCE
    for (int plane = 0; plane < CLIP_PLANES; ++plane) gl_ClipDistance[plane] = dot(clip_plane_model[plane], position);
#endif
#ifdef CLIP_BY_DISCARD
    for (int plane = 0; plane < CLIP_PLANES; ++plane) clip_distance[plane] = dot(clip_plane_model[plane], position);
#endif
#ifdef LOGARITHM_PER_VERTEX
    float distance = -dot(view_z_of_model, position) / dot(view_w_of_model, position);
    gl_Position.z = (2.0 * logarithmic_depth(distance) - 1.0) * gl_Position.w;
#endif
#ifdef WRITE_DEPTH
    view_zw = vec2(dot(view_z_of_model, position), dot(view_w_of_model, position));
#endif
}
