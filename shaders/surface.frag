// Colors a fragment: lit, ambient only, one flat color, front and back in different colors, by depth fighting, by the w
// of a shadow caster, or with an ID to read back. Light is added in linear space and converted to sRGB here, so that no
// sRGB target is needed.
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

// SHADING, IS_PATCH and all constants shared with C++ (render/shader_constants.cpp) are defined before this source.
// Several small programs, one per way of drawing, compile faster than one that can do everything.

#ifdef LIGHTS
uniform vec4 lights_relative[LIGHTS];  // w = 1 point light, w = 0 parallel light
uniform float light_strength;       // of each light
#endif
uniform vec4 eye_relative;     // w = 0: parallel view rays, from this direction
uniform vec3 sky_world;     // unit: direction of the strongest ambient light
uniform vec4 base_color;    // linear; flat shading: sRGB
uniform float alpha;
uniform vec3 patch_tones[PATCH_TONES];  // linear: light square, dark square, line
uniform float patch_extent;
uniform vec3 patch_normal;  // unit, toward the eye
uniform vec3 front_color;  // sRGB
uniform vec3 back_color;
uniform vec4 caster_w;          // dot(caster_w, p) is the w that S gives p
uniform vec4 caster_side;       // dot(caster_side, p) is positive on the light's side of the plane
uniform vec3 caster_tones[CASTER_COLORS];  // sRGB: casts a shadow, behind the plane, beyond the light

// The gap to the neighboring surface, relative to the gap that the depth buffer resolves; see frame/depth/heat_map.h.
#if SHADING == SHADING_HEAT
uniform mat4 heat_view_from_relative;
uniform vec2 heat_near_far;
// Logarithms of the gap that the depth buffer resolves, at eye distances from near to far in equal logarithmic steps.
uniform vec4 heat_onsets[HEAT_ENTRIES / 4];
uniform vec3 heat_tones[HEAT_COLORS];       // sRGB: first half for ratios from 0 to just below 1, rest for 1, 2, 4 …
uniform vec4 heat_gap;                       // xyz: unit normal in view space; w: gap along it, negative: none

vec3 heat_color() {
    vec3 position_view = (heat_view_from_relative * vec4(position_relative, 1.0)).xyz;
    float distance = max(-position_view.z, heat_near_far.x);
    vec3 sight = eye_relative.w == 0.0 ? vec3(0.0, 0.0, -1.0) : position_view / distance;
    float gap = heat_gap.w / max(abs(dot(heat_gap.xyz, sight)), 1e-6);  // in eye distance

    float last = float(HEAT_ENTRIES - 1);
    float place = log(distance / heat_near_far.x) / log(heat_near_far.y / heat_near_far.x) * last;
    int entry = clamp(int(place), 0, HEAT_ENTRIES - 2), next = entry + 1;
    float onset = mix(heat_onsets[entry / 4][entry % 4], heat_onsets[next / 4][next % 4],
                      clamp(place - float(entry), 0.0, 1.0));
    float ratio = gap / exp(onset);

    const int middle = HEAT_COLORS / 2;
    const float steps = float(middle - 1);
    float stop = ratio < 1.0 ? steps * ratio : float(middle) + min(log2(ratio), steps);
    int first = min(int(stop), ratio < 1.0 ? middle - 2 : HEAT_COLORS - 2);
    return mix(heat_tones[first], heat_tones[first + 1], stop - float(first));
}
#endif

#ifdef CLIP_BY_DISCARD
AT(6) in float clip_distance[CLIP_PLANES];
#endif

#ifdef DEPTH_OF_PLANE
uniform vec3 depth_in_plane;  // window depth = dot(depth_in_plane, vec3(x, y, 1)), with x and y in pixels
#endif
#ifdef WRITE_DEPTH
#ifndef FROM_PICTURE
AT(5) in vec2 view_zw;
#endif
uniform float depth_levels;      // 2^bits - 1; 0: the buffer's own precision
uniform vec2 logarithmic_range;  // near, far; 0: not logarithmic
uniform vec2 depth_offset;       // glPolygonOffset's factor, and units times the smallest step
#endif

layout(location = 0) out vec4 color;

// MASK_TEST and MASK_WRITE: a mask replaces the stencil. It is tested with discard and written along with the color.
#if defined(MASK_TEST) || defined(MASK_WRITE)
uniform sampler2D mask_texture;  // value / 255, before the pass
uniform int mask_reference;

int mask_before() {
    return int(texelFetch(mask_texture, ivec2(gl_FragCoord.xy), 0).r * 255.0 + 0.5);
}
#endif
#ifdef MASK_TEST
uniform int mask_func;  // a CompareFunc
uniform int mask_read_bits;

// Comparisons are encoded as bit sets of less, equal and greater, as in GL.
bool passes_mask() {
    int value = mask_before() & mask_read_bits, reference = mask_reference & mask_read_bits;
    int relation = reference < value ? COMPARE_LESS : reference == value ? COMPARE_EQUAL : COMPARE_GREATER;
    return (mask_func & relation) != 0;
}
#endif
#ifdef MASK_WRITE
uniform int mask_op;  // a StencilOp
uniform int mask_write_bits;
layout(location = 1) out vec4 mask;

int mask_after() {
    int before = mask_before(), after = mask_reference;  // replace
    if (mask_op == STENCIL_INCREMENT) after = min(before + 1, 255);
    if (mask_op == STENCIL_DECREMENT) after = max(before - 1, 0);
    if (mask_op == STENCIL_INVERT) after = 255 - before;
    if (mask_op == STENCIL_ZERO) after = 0;
    return (before & (255 - mask_write_bits)) | (after & mask_write_bits);
}
#endif

// Converts linear light to sRGB. Replaces 1.055 x^(1/2.4) - 0.055 with a polynomial in the fourth root of x, since pow
// is slow to compile and to run in a software renderer. The error is at most a hundredth of a level.
vec3 srgb_from_linear(vec3 linear) {
    vec3 root = sqrt(sqrt(max(linear, vec3(0.0))));
    vec3 curve = (((0.0813307 * root - 0.3355051) * root + 1.1226862) * root + 0.1961336) * root - 0.0646112;
    return mix(linear * 12.92, curve, greaterThan(linear, vec3(0.0031308)));
}

#if SHADING == SHADING_LIT || SHADING == SHADING_UNLIT
#ifdef IS_PATCH
// Returns the color of a checkerboard: two alternating tones with thin lines between them. Where squares become smaller
// than pixels, the tones blend into their mean, and the lines fade out.
vec3 patch_color() {
    vec2 cell = position_patch * patch_extent;
    vec2 width = max(fwidth(cell), vec2(1e-6));
    vec2 to_line = abs(fract(cell - 0.5) - 0.5);
    vec2 off_line = (to_line - 0.008) / (width * 1.2);
    float line = 1.0 - smoothstep(0.0, 1.0, min(off_line.x, off_line.y));
    float far_away = clamp(max(width.x, width.y) * 2.0 - 0.4, 0.0, 1.0);
    float dark = mod(floor(cell.x) + floor(cell.y), 2.0);
    vec3 square = mix(patch_tones[0], patch_tones[1], mix(dark, 0.5, far_away));
    return mix(square, patch_tones[2], line * (1.0 - far_away));
}
#endif

float pow48(float x) {
    float cube = x * x * x, power6 = cube * cube, power12 = power6 * power6, power24 = power12 * power12;
    return power24 * power24;
}

vec3 lit_color(vec3 surface_albedo) {
    vec3 eye = eye_relative.xyz - eye_relative.w * position_relative;
    // The normal points toward the eye. Its sign comes from the geometry, since it must not depend on winding or
    // culling.
#if defined(IS_PATCH)
    vec3 normal = patch_normal;
#else
    vec3 normal = normalize(normal_world);
#ifndef FROM_PICTURE  // a picture's normals already point toward the eye
    vec3 face = cross(dFdx(position_relative), dFdy(position_relative));
    normal *= dot(normal, face) * dot(face, eye) < 0.0 ? -1.0 : 1.0;
#endif
#endif

    float ambient = AMBIENT_LIGHT + SKY_LIGHT * dot(normal, sky_world);
#if SHADING == SHADING_UNLIT
    return surface_albedo * ambient;
#else
    vec3 lit = surface_albedo * ambient;
    for (int light = 0; light < LIGHTS; ++light) {
        vec4 position = lights_relative[light];
        vec3 to_light = normalize(position.xyz - position.w * position_relative);
        float diffuse = max(dot(normal, to_light), 0.0);
        lit += surface_albedo * (DIFFUSE_LIGHT * light_strength * diffuse);
#if !defined(IS_PATCH) || defined(HAS_GLOSS)
        float shine = pow48(max(dot(normal, normalize(to_light + normalize(eye))), 0.0));
        lit += diffuse > 0.0 ? HIGHLIGHT_LIGHT * light_strength * shine : 0.0;
#endif
    }
    return lit;
#endif
}
#endif

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

// Splits a number below 2^24 into three bytes.
vec4 bytes_of(float number) {
    return vec4(mod(number, 256.0), mod(floor(number / 256.0), 256.0), floor(number / 65536.0), 255.0) / 255.0;
}

void main() {
#ifdef FROM_PICTURE
    fetch_surface();
#endif
#if SHADING == SHADING_FLAT && defined(FROM_PICTURE)
    color = base_color * texelFetch(surface_counts, texel_of(surface_counts), 0).r;
#elif SHADING == SHADING_FLAT
    color = base_color;
#elif SHADING == SHADING_IDENTITY && defined(FROM_PICTURE)
    float object = texelFetch(surface_colors, texel_of(surface_colors), 0).w;
    color = vec4(bytes_of(object).rg, FRONT_FACING ? 1.0 : 0.0, 1.0);
#elif SHADING == SHADING_IDENTITY && defined(PER_VERTEX)
    color = vec4(bytes_of(ids.x).rg, FRONT_FACING ? 1.0 : 0.0, 1.0);
#elif SHADING == SHADING_IDENTITY
    color = vec4(base_color.rg, FRONT_FACING ? 1.0 : 0.0, 1.0);
#elif SHADING == SHADING_POLYGON_IDENTITY
    color = bytes_of(ids.y);
#elif SHADING == SHADING_FACING
    vec3 normal = normalize(normal_world);
    float shade = 0.62 + 0.38 * abs(normal.y * 0.35 + normal.z * 0.65);
    float stripe = step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / 12.0));
    color = vec4(FRONT_FACING ? front_color * shade : back_color * mix(0.72, 1.0, stripe), alpha);
#elif SHADING == SHADING_HEAT
    vec3 normal = normalize(normal_world);
    float shade = 0.30 + 0.16 * abs(normal.y * 0.35 + normal.z * 0.65);
    color = vec4(heat_gap.w < 0.0 ? vec3(shade) : heat_color(), alpha);
#elif SHADING == SHADING_CASTER_W
    vec4 point = vec4(position_relative, 1.0);
    vec3 normal = normalize(normal_world);
    float shade = 0.62 + 0.38 * abs(normal.y * 0.35 + normal.z * 0.65);
    int kind = dot(caster_w, point) <= 0.0 ? 2 : dot(caster_side, point) < 0.0 ? 1 : 0;
    color = vec4(caster_tones[kind] * shade, alpha);
#elif defined(IS_PATCH)
    color = vec4(srgb_from_linear(lit_color(patch_color())), alpha);
#else
    color = vec4(srgb_from_linear(lit_color(ALBEDO)), alpha);
#endif
#ifdef WRITE_DEPTH
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
    gl_FragDepth = depth;
#endif
#ifdef MASK_WRITE
    mask = vec4(float(mask_after()) / 255.0, 0.0, 0.0, 1.0);
#endif
    // Discard last, because the derivatives above need all four fragments of a quad.
#ifdef MASK_TEST
    if (!passes_mask()) discard;
#endif
#ifdef CLIP_BY_DISCARD
    for (int plane = 0; plane < CLIP_PLANES; ++plane)
        if (clip_distance[plane] < 0.0) discard;
#endif
}
