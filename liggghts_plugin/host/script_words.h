/* The words behind the style of a fix or compute, as the strict settings that dictionaries give
   (dualgrid/core/Settings.h): one form of error for both programs, with keyword, value, problem, cure and "did you
   mean". */

#ifndef FRAZIL_SCRIPT_WORDS_H
#define FRAZIL_SCRIPT_WORDS_H

#include <vector>

#include "Settings.h"

namespace frazil
{

struct Keyword {
    const char* name;
    int least = 1, most = 1; ///< values that follow; beyond the least they end at the next keyword
};

/// Values are kept as one text with blanks between them. InputError on an unknown word, a keyword given twice, and one
/// without enough values.
Settings scriptWords(int count, char** words, const std::vector<Keyword>& known);

/// A whole number from 1 to 2147483647, LIGGGHTS's largest.
int positiveInt(const Settings& words, const std::string& key);
int positiveInt(const Settings& words, const std::string& key, int byDefault);

} // namespace frazil

#endif
