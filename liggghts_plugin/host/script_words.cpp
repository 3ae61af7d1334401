#include "script_words.h"

#include <algorithm>

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

/// The values of a keyword, which stand from `first` on.
std::vector<std::string> valuesOf(const Keyword& keyword, int first, int count, char** words,
                                  const std::vector<Keyword>& known)
{
    std::vector<std::string> values;
    for (int n = first; n < count && int(values.size()) < keyword.most; ++n) {
        if (int(values.size()) >= keyword.least && find(known, words[n]))
            break;
        values.push_back(words[n]);
    }
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

} // namespace frazil
