// Part of surface.frag: the gap to the neighboring surface, relative to the gap that the depth buffer resolves; see
// topics/depth/numbers/heat_map.h.
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

