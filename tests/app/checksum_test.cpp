// The checksum of files: a known answer, in pieces, and every flipped bit.
#include "app/io/checksum.h"

#include <gtest/gtest.h>

#include <string>

#include "app/io/text.h"

namespace pupflow::io {
namespace {

TEST(Checksum, IsTheOneThatXzUses) {
  EXPECT_EQ(checksum(std::string_view("123456789")), 0x995dc9bbdf1939faU);  // the catalogue's check
  EXPECT_EQ(checksum(std::string_view()), 0U);
}

TEST(Checksum, GoesOnFromWhatStandsBefore) {
  EXPECT_EQ(checksum(std::string_view("6789"), checksum(std::string_view("12345"))),
            checksum(std::string_view("123456789")));
}

TEST(Checksum, ChangesWithEveryBit) {
  std::string text = "a row of a journal, 0.25";
  const std::uint64_t before = checksum(text);
  for (char& byte : text) {
    for (int bit = 0; bit < 8; ++bit) {
      byte = static_cast<char>(byte ^ (1 << bit));
      EXPECT_NE(checksum(text), before);
      byte = static_cast<char>(byte ^ (1 << bit));
    }
  }
}

TEST(Checksum, IsReadOnlyAsItIsWritten) {
  EXPECT_EQ(hash_text(0x0123456789abcdefU), "0123456789abcdef");
  EXPECT_EQ(read_hash("0123456789abcdef"), 0x0123456789abcdefU);
  EXPECT_EQ(read_hash("0000000000000000"), 0U);
  for (const char* wrong : {"", "0", "0123456789abcde", "0123456789ABCDEF", "0123456789abcdef0",
                            "0123456789abcdeg", " 123456789abcdef", "-123456789abcdef"})
    EXPECT_FALSE(read_hash(wrong)) << wrong;
}

}  // namespace
}  // namespace pupflow::io
