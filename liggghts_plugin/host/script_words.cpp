#include "script_words.h"

#include <algorithm>
#include <limits>

#include "DidYouMean.h"
#include "InputError.h"

namespace frazil
{

namespace
{

std::vector<std::string> namesOf(const std::vector<Keyword>& known)
{
    std::vector<std::string> names;
    for (const Keyword& keyword : known)
        names.push_back(keyword.name);
    return names;
}

const Keyword* find(const std::vector<Keyword>& known, const std::string& word)
{
    const auto at = std::find_if(known.begin(), known.end(), [&](const Keyword& k) { return word == k.name; });
    return at == known.end() ? nullptr : &*at;
}

/// Beyond the values that a keyword must have: does this word begin the next keyword, well spelt or not?
bool beginsKeyword(const std::string& word, const std::vector<Keyword>& known)
{
    return find(known, word) || !didYouMean(word, namesOf(known)).empty();
}

/// A value may look like a keyword (`bonds bonds`); in `young stiffness_ratio 2` it is one, because 2 is none.
void dropSwallowed(std::vector<std::string>& values, const char* behind, const std::vector<Keyword>& known)
{
    if (!behind || find(known, behind))
        return;
    const auto isKeyword = [&](const std::string& value) { return find(known, value) != nullptr; };
    values.erase(std::find_if(values.begin(), values.end(), isKeyword), values.end());
}

/// The values of a keyword, which stand from `first` on.
std::vector<std::string> valuesOf(const Keyword& keyword, int first, int count, char** words,
                                  const std::vector<Keyword>& known)
{
    std::vector<std::string> values;
    for (int n = first; n < count && int(values.size()) < keyword.most; ++n) {
        if (int(values.size()) >= keyword.least && beginsKeyword(words[n], known))
            break;
        values.push_back(words[n]);
    }
    const int behind = first + int(values.size());
    dropSwallowed(values, behind < count ? words[behind] : nullptr, known);
    if (int(values.size()) < keyword.least)
        throw InputError("", keyword.name, joined(values, " "),
                         "needs " + std::to_string(keyword.least) + (keyword.least > 1 ? " values" : " value"),
                         "Add what is missing behind it");
    return values;
}

} // namespace

Settings scriptWords(int count, char** words, const std::vector<Keyword>& known)
{
    Settings settings("", "", Settings::Form::script);
    for (int n = 0; n < count;) {
        const std::string word = words[n];
        const Keyword* keyword = find(known, word);
        if (!keyword)
            throw InputError("", word, "", "unknown keyword" + didYouMean(word, namesOf(known)),
                             "Known: " + joined(namesOf(known)));
        if (settings.has(word))
            throw InputError("", word, "", "stands twice", "Give it once");
        const std::vector<std::string> values = valuesOf(*keyword, n + 1, count, words, known);
        settings.set(word, joined(values, " "));
        n += 1 + int(values.size());
    }
    return settings;
}

int positiveInt(const Settings& words, const std::string& key)
{
    const long value = words.integer(key);
    if (value <= 0)
        words.reject(key, "must be above zero", "Give a whole number from 1 on");
    if (value > std::numeric_limits<int>::max())
        words.reject(key, "is too large", "Give a whole number up to 2147483647");
    return static_cast<int>(value);
}

int positiveInt(const Settings& words, const std::string& key, int byDefault)
{
    return words.has(key) ? positiveInt(words, key) : byDefault;
}

} // namespace frazil
