// Whether the program was built with a sanitizer, which handles faults itself and checks for leaks at the end.
#pragma once

#if defined(__has_feature)
#define VIEWING_HAS_FEATURE(feature) __has_feature(feature)
#else
#define VIEWING_HAS_FEATURE(feature) 0
#endif

namespace viewing {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || VIEWING_HAS_FEATURE(address_sanitizer) || \
    VIEWING_HAS_FEATURE(thread_sanitizer)
inline constexpr bool is_sanitized = true;
#else
inline constexpr bool is_sanitized = false;
#endif

}  // namespace viewing
