// The faces that a drag of a connected part leaves alone, through splits, roll backs and gestures.
#include "mesh/staying_faces.h"

#include <gtest/gtest.h>

#include <vector>

namespace pectin {
namespace {

const std::vector<FaceId> kStaying{FaceId{1}, FaceId{4}};

TEST(StayingFaces, HandTheirMarkOnToTheirPieces) {
    StayingFaces staying;
    staying.begin(kStaying, 6);
    staying.fit(8);
    staying.record_piece(FaceId{4}, FaceId{6});
    staying.record_piece(FaceId{6}, FaceId{7});
    for (std::uint32_t f = 0; f < 8; ++f) {
        EXPECT_EQ(staying.contains(FaceId{f}), f == 1 || f == 4 || f >= 6) << f;
    }
}

// An unsplit frees the slots of faces, and later splits use them again.
TEST(StayingFaces, AreRestoredWhereSlotsWereUsedAgain) {
    StayingFaces staying;
    staying.begin(kStaying, 6);
    const std::vector<FaceId> edited{FaceId{1}, FaceId{2}, FaceId{3}};
    staying.record_piece(FaceId{0}, FaceId{1});
    staying.record_piece(FaceId{4}, FaceId{2});
    EXPECT_FALSE(staying.contains(FaceId{1}));
    EXPECT_TRUE(staying.contains(FaceId{2}));
    staying.restore(edited);
    EXPECT_TRUE(staying.contains(FaceId{1}));
    EXPECT_FALSE(staying.contains(FaceId{2}));
}

TEST(StayingFaces, LeaveNoMarksForTheNextGesture) {
    StayingFaces staying;
    staying.begin(kStaying, 6);
    staying.record_piece(FaceId{4}, FaceId{2});
    staying.end(std::vector<FaceId>{FaceId{2}});
    EXPECT_TRUE(staying.empty());
    staying.begin(std::vector<FaceId>{FaceId{0}}, 6);
    for (std::uint32_t f = 0; f < 6; ++f) EXPECT_EQ(staying.contains(FaceId{f}), f == 0) << f;
    staying.abandon();
    staying.begin(std::vector<FaceId>{FaceId{3}}, 6);
    for (std::uint32_t f = 0; f < 6; ++f) EXPECT_EQ(staying.contains(FaceId{f}), f == 3) << f;
}

// Nothing is stored then, so gestures that move everything cost nothing.
TEST(StayingFaces, AreNoneWithoutAnyAtTheBeginning) {
    StayingFaces staying;
    staying.begin({}, 6);
    staying.fit(100);
    staying.record_piece(FaceId{0}, FaceId{50});
    EXPECT_FALSE(staying.contains(FaceId{50}));
    EXPECT_EQ(staying.memory_bytes(), 0u);
}

}  // namespace
}  // namespace pectin
