/// Strict settings: a tree of words that knows which keys were asked for.
///
/// A host fills it from its own input format; the parts of the coupling then take what they know. Whatever nobody asked
/// for is an error that lists the known keys, so a misspelt key never runs with a default in silence.
/// No MPI: every rank holds and checks the same tree, so all ranks throw the same error.
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "Vec3.h"

namespace frazil
{

class Settings
{
  public:
    /// How the user writes them, for the cures: `key value;` in a file, or `key value` among the words of a script.
    enum class Form { dictionary, script };

    /// `file` and `path` (the sub-dictionary's name, empty for the top) appear in every message.
    Settings(std::string file, std::string path, Form form = Form::dictionary);

    void set(const std::string& key, const std::string& value);
    /// The sub-dictionary `key`, for the host to fill.
    Settings& addSub(const std::string& key);
    /// The sub-dictionary `key`; an empty one when the user gave none, so that defaults apply.
    const Settings& sub(const std::string& key) const;
    bool has(const std::string& key) const;
    /// Names of all sub-dictionaries, for dictionaries with names of the user's choice (bodies).
    std::vector<std::string> subKeys() const;

    // Getters. Those without a default throw when the key is missing; all throw when the value does not parse.
    double number(const std::string& key) const;
    double number(const std::string& key, double byDefault) const;
    /// A number that must be greater than zero.
    double positive(const std::string& key) const;
    double positive(const std::string& key, double byDefault) const;
    double notNegative(const std::string& key, double byDefault) const;
    long integer(const std::string& key) const;
    long integer(const std::string& key, long byDefault) const;
    std::string word(const std::string& key, const std::vector<std::string>& allowed) const;
    std::string word(const std::string& key, const std::vector<std::string>& allowed,
                     const std::string& byDefault) const;
    /// Any text, e.g. a file name.
    std::string text(const std::string& key) const;
    std::string text(const std::string& key, const std::string& byDefault) const;
    /// on/off, yes/no, true/false.
    bool flag(const std::string& key, bool byDefault) const;
    /// Several words or numbers, with or without round brackets.
    std::vector<std::string> words(const std::string& key) const;
    std::vector<double> numbers(const std::string& key) const;
    /// Three numbers.
    Vec3 vec3(const std::string& key) const;
    Vec3 vec3(const std::string& key, const Vec3& byDefault) const;

    /// Throws on the first key that nobody asked for, here or in a sub-dictionary.
    void finish() const;

    /// The error for a value that parses but makes no sense; for the part of the code that knows the sense.
    [[noreturn]] void reject(const std::string& key, const std::string& problem, const std::string& cure) const;

  private:
    const std::string* find(const std::string& key) const;
    const std::string& require(const std::string& key) const;
    [[noreturn]] void unknown(const std::string& key) const;
    std::string pathOf(const std::string& key) const;
    void learn(const std::string& key) const;

    Form form_;
    std::string file_, path_;
    std::map<std::string, std::string> values_;
    mutable std::map<std::string, std::unique_ptr<Settings>> subs_;
    mutable std::vector<std::string> asked_;  ///< known keys, in the order in which they were asked for
    mutable std::set<std::string> emptySubs_; ///< asked for, but not given by the user
};

} // namespace frazil
