/// Words for messages: a list in one line, and the known word that a user may have meant.
#pragma once

#include <string>
#include <vector>

namespace frazil
{

std::string joined(const std::vector<std::string>& words, const std::string& between = ", ");

/// ` (did you mean "x"?)` if one of the words is within a third of the letters, else nothing. Distance: Levenshtein 1966.
std::string didYouMean(const std::string& word, const std::vector<std::string>& known);

} // namespace frazil
