#pragma once
/// Checks what every refusal must be: exit status 2, one sentence on standard error, nothing else, and nothing left
/// behind.
#include <string>
#include <vector>

#include "program.hpp"

namespace perinox::cli {

/// `sentence` with the folder filled in.
inline std::string in_folder(std::string sentence, const Folder& folder) {
  const std::size_t at = sentence.find("{dir}");
  return at == std::string::npos ? sentence : sentence.replace(at, 5, folder.path().string());
}

inline void expect_refusal(const Folder& folder, const std::vector<std::string>& arguments,
                           const std::string& sentence) {
  const std::vector<std::string> before = folder.names();
  const Outcome outcome = folder.perinox(arguments);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.error, in_folder(sentence, folder) + "\n");
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(folder.names(), before) << "something was left in the folder";
}

}  // namespace perinox::cli
