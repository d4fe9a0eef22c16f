#pragma once

/// Code that gains from wide registers is compiled once for every instruction set, in a
/// file of its own, and chosen at run time. What differs between the versions carries the
/// name of its instruction set in its type, so that the linker never takes one version's
/// inline function for another's. Results are bitwise the same.
namespace delone::delaunay {

struct Portable {};
struct Avx2 {};

}  // namespace delone::delaunay
