// Part of surface.frag: the light that a surface reflects. Light is added in linear space and converted to sRGB here, so
// that no sRGB target is needed.
#ifdef LIGHTS
uniform vec4 lights_relative[LIGHTS];  // w = 1 point light, w = 0 parallel light
uniform float light_strength;          // of each light
#endif
uniform vec3 sky_world;                 // unit: direction of the strongest ambient light
uniform vec3 patch_tones[PATCH_TONES];  // linear: light square, dark square, line
uniform float patch_extent;
uniform vec3 patch_normal;  // unit, toward the eye

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

