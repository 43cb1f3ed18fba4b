// Which variant of an exercise a student has: fixed for ever, so that a sheet that was handed out stays the same and a
// lecturer can tell what it was. All 64-bit, modulo 2⁶⁴.
// Source: Steele, Lea and Flood 2014, SplitMix64; text/hash.h for the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "text/hash.h"

namespace viewing {

/// SplitMix64's finaliser: each bit of the argument changes about half of the bits.
std::uint64_t finalised(std::uint64_t bits);

/// The numbers 0 … count − 1 in an order that the seed alone says: Fisher and Yates from the end on, with SplitMix64
/// modulo the places that are left.
std::vector<std::size_t> shuffled(std::size_t count, std::uint64_t seed);

/// From 0 on, below `count` (1 and more): the finalised FNV-1a of "course|student|exercise", modulo `count`. Without
/// the finaliser FNV's low bits give many students one and the same sheet.
std::size_t variant_of(std::string_view course, std::string_view student, std::string_view exercise, std::size_t count);

}  // namespace viewing
