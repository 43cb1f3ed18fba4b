// Assigns variants of exercises to students. The assignment is fixed forever, so that a sheet never changes and a
// lecturer can reconstruct it. All numbers are 64-bit, modulo 2⁶⁴. Source: Steele, Lea and Flood 2014, SplitMix64. For
// FNV, see text/hash.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "text/hash.h"

namespace viewing {

/// Applies SplitMix64's finalizer: a change of any bit of the argument changes about half of the result's bits.
std::uint64_t finalized(std::uint64_t bits);

/// Returns 0 … count − 1 in an order that depends only on the seed. This is a Fisher–Yates shuffle from the end, which
/// picks each position by SplitMix64 modulo the number of remaining positions.
std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed);

/// Returns a variant from 0 to `count` − 1 (`count` ≥ 1): the finalized FNV-1a hash of "course|student|exercise",
/// modulo `count`. Without the finalizer, FNV's low bits give many students the same sheet.
std::size_t variant_of(std::string_view course, std::string_view student, std::string_view exercise, std::size_t count);

}  // namespace viewing
