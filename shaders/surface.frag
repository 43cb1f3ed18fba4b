// Colors a fragment: lit, ambient only, one flat color, front and back in different colors, by depth fighting, by the w
// of a shadow caster, or with an ID to read back.
//
// SHADING, IS_PATCH and all constants shared with C++ (render/shader_constants.cpp) are defined before this source, and
// its parts (render/programs.cpp) precede it. Several small programs, one per way of drawing, compile faster than one
// that can do everything.
uniform float alpha;
uniform vec3 front_color;  // sRGB
uniform vec3 back_color;
uniform vec4 caster_w;                     // dot(caster_w, p) is the w that S gives p
uniform vec4 caster_side;                  // dot(caster_side, p) is positive on the light's side of the plane
uniform vec3 caster_tones[CASTER_COLORS];  // sRGB: casts a shadow, behind the plane, beyond the light

layout(location = 0) out vec4 color;

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
    gl_FragDepth = written_depth();
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
