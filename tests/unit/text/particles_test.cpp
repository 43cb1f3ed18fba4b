// Korean particles, chosen by the last sound before them. The expected forms are written by hand, as they are spoken.
#include "text/particles.h"

#include <gtest/gtest.h>

namespace viewing {
namespace {

TEST(Particles, FollowTheFinalLetterOfHangul) {
    EXPECT_EQ(with_particles("상자[은/는] 벽[을/를] 토러스[과/와] 공[이/가]"), "상자는 벽을 토러스와 공이");
    EXPECT_EQ(with_particles("평면[으로/로] 벽[으로/로] 거울[으로/로]"), "평면으로 벽으로 거울로");
}

TEST(Particles, FollowTheNameOfADigit) {
    EXPECT_EQ(
        with_particles("0[이/가] 1[이/가] 2[이/가] 3[이/가] 4[이/가] 5[이/가] 6[이/가] 7[이/가] 8[이/가] 9[이/가]"),
        "0이 1이 2가 3이 4가 5가 6이 7이 8이 9가");
    EXPECT_EQ(with_particles("0[으로/로] 1[으로/로] 2[으로/로] 3[으로/로] 6[으로/로] 7[으로/로] 8[으로/로]"),
              "0으로 1로 2로 3으로 6으로 7로 8로");
    EXPECT_EQ(with_particles("10[을/를] 65,536[을/를] 0.25[을/를] 16[과/와]"), "10을 65,536을 0.25를 16과");
}

TEST(Particles, FollowUnitsLettersAndWords) {
    EXPECT_EQ(with_particles("39.2%[은/는] 45°[은/는] 12 ms[은/는] 30 px[은/는] 5 MB[은/는] 8 m[은/는]"),
              "39.2%는 45°는 12 ms는 30 px은 5 MB는 8 m은");
    EXPECT_EQ(with_particles("A[이/가] L[이/가] M[이/가] N[이/가] R[이/가] S[이/가] V[이/가] z[이/가]"),
              "A가 L이 M이 N이 R이 S가 V가 z가");
    EXPECT_EQ(with_particles("near[을/를] stencil[을/를] stencil[으로/로] GL_EQUAL[으로/로] min[은/는] far[와/과]"),
              "near를 stencil을 stencil로 GL_EQUAL로 min은 far[와/과]");
}

TEST(Particles, SkipClosingMarks) {
    EXPECT_EQ(with_particles("(0, 1, 3)[은/는] \"상자\"[은/는] 평면(plane)[은/는]"),
              "(0, 1, 3)은 \"상자\"는 평면(plane)은");
    EXPECT_EQ(with_particles("[은/는]"), "는");
    EXPECT_EQ(with_particles("no marker [a/b]"), "no marker [a/b]");
}

}  // namespace
}  // namespace viewing
