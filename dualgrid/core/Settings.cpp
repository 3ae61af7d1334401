#include "Settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "DidYouMean.h"
#include "InputError.h"

namespace frazil
{

namespace
{

/// The whole word as a finite number, in the C locale's format whatever the locale is.
template <class T> std::optional<T> parse(const std::string& word)
{
    const char* first = word.data();
    const char* const last = first + word.size();
    if (first != last && *first == '+' && last - first > 1 && first[1] != '-')
        ++first;
    T number{};
    const auto result = std::from_chars(first, last, number);
    if (result.ec != std::errc() || result.ptr != last)
        return std::nullopt;
    if (!std::isfinite(double(number)))
        return std::nullopt;
    return number;
}

std::vector<std::string> split(std::string text)
{
    const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    if (first == std::string::npos)
        return {};
    text = text.substr(first, last - first + 1);
    if (text.size() > 1 && text.front() == '(' && text.back() == ')')
        text = text.substr(1, text.size() - 2);
    std::vector<std::string> words;
    for (std::size_t begin = 0; (begin = text.find_first_not_of(" \t", begin)) != std::string::npos;) {
        const std::size_t end = std::min(text.find_first_of(" \t", begin), text.size());
        words.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return words;
}

} // namespace

Settings::Settings(std::string file, std::string path, Form form)
    : form_(form), file_(std::move(file)), path_(std::move(path))
{
}

void Settings::set(const std::string& key, const std::string& value)
{
    values_[key] = value;
}

Settings& Settings::addSub(const std::string& key)
{
    auto& child = subs_[key];
    if (!child)
        child = std::make_unique<Settings>(file_, pathOf(key), form_);
    emptySubs_.erase(key);
    return *child;
}

const Settings& Settings::sub(const std::string& key) const
{
    learn(key);
    if (values_.count(key)) {
        throw InputError(file_, pathOf(key), values_.at(key), "must be a sub-dictionary", "Write " + key + " { ... }");
    }
    auto& child = subs_[key];
    if (!child) {
        child = std::make_unique<Settings>(file_, pathOf(key), form_);
        emptySubs_.insert(key);
    }
    return *child;
}

bool Settings::has(const std::string& key) const
{
    learn(key);
    return values_.count(key) || (subs_.count(key) && !emptySubs_.count(key));
}

std::vector<std::string> Settings::subKeys() const
{
    std::vector<std::string> keys;
    for (const auto& [key, child] : subs_) {
        if (!emptySubs_.count(key))
            keys.push_back(key);
    }
    return keys;
}

double Settings::number(const std::string& key) const
{
    const std::string& value = require(key);
    if (const auto number = parse<double>(value))
        return *number;
    throw InputError(file_, pathOf(key), value, "is not a number", "Write it like 0.005 or 5e-3, in SI units");
}

double Settings::number(const std::string& key, double byDefault) const
{
    return find(key) ? number(key) : byDefault;
}

double Settings::positive(const std::string& key) const
{
    const double value = number(key);
    if (value <= 0)
        reject(key, "must be greater than zero", "");
    return value;
}

double Settings::positive(const std::string& key, double byDefault) const
{
    return find(key) ? positive(key) : byDefault;
}

double Settings::notNegative(const std::string& key, double byDefault) const
{
    const double value = number(key, byDefault);
    if (value < 0)
        reject(key, "must not be negative", "Give 0 or more");
    return value;
}

long Settings::integer(const std::string& key) const
{
    const std::string& value = require(key);
    if (const auto number = parse<long>(value))
        return *number;
    throw InputError(file_, pathOf(key), value, "is not a whole number", "Write it without point or exponent");
}

long Settings::integer(const std::string& key, long byDefault) const
{
    return find(key) ? integer(key) : byDefault;
}

std::string Settings::word(const std::string& key, const std::vector<std::string>& allowed) const
{
    const std::string& value = require(key);
    if (std::find(allowed.begin(), allowed.end(), value) != allowed.end())
        return value;
    throw InputError(file_, pathOf(key), value, "is not one of the choices" + didYouMean(value, allowed),
                     "Choose from: " + joined(allowed));
}

std::string Settings::word(const std::string& key, const std::vector<std::string>& allowed,
                           const std::string& byDefault) const
{
    return find(key) ? word(key, allowed) : byDefault;
}

std::string Settings::text(const std::string& key) const
{
    return require(key);
}

std::string Settings::text(const std::string& key, const std::string& byDefault) const
{
    return find(key) ? text(key) : byDefault;
}

bool Settings::flag(const std::string& key, bool byDefault) const
{
    const std::string* value = find(key);
    if (!value)
        return byDefault;
    if (*value == "on" || *value == "yes" || *value == "true")
        return true;
    if (*value == "off" || *value == "no" || *value == "false")
        return false;
    throw InputError(file_, pathOf(key), *value, "is neither on nor off", "Choose from: on, off, yes, no, true, false");
}

std::vector<std::string> Settings::words(const std::string& key) const
{
    return split(require(key));
}

std::vector<double> Settings::numbers(const std::string& key) const
{
    std::vector<double> list;
    for (const std::string& word : words(key)) {
        const auto number = parse<double>(word);
        if (!number)
            throw InputError(file_, pathOf(key), require(key), word + " is not a number",
                             "Write it like 0.005 or 5e-3, in SI units");
        list.push_back(*number);
    }
    return list;
}

Vec3 Settings::vec3(const std::string& key) const
{
    const std::string& value = require(key);
    const auto list = words(key);
    if (list.size() == 3) {
        const auto x = parse<double>(list[0]), y = parse<double>(list[1]), z = parse<double>(list[2]);
        if (x && y && z)
            return {*x, *y, *z};
    }
    throw InputError(file_, pathOf(key), value, "is not a vector",
                     form_ == Form::dictionary ? "Write three numbers: (x y z)" : "Write three numbers: X Y Z");
}

Vec3 Settings::vec3(const std::string& key, const Vec3& byDefault) const
{
    return find(key) ? vec3(key) : byDefault;
}

void Settings::finish() const
{
    const auto known = [&](const std::string& key) {
        return std::find(asked_.begin(), asked_.end(), key) != asked_.end();
    };
    for (const auto& entry : values_) {
        if (!known(entry.first))
            unknown(entry.first);
    }
    for (const auto& [key, child] : subs_) {
        if (!known(key))
            unknown(key);
        child->finish();
    }
}

void Settings::reject(const std::string& key, const std::string& problem, const std::string& cure) const
{
    const auto value = values_.find(key);
    throw InputError(file_, pathOf(key), value == values_.end() ? "" : value->second, problem, cure);
}

const std::string* Settings::find(const std::string& key) const
{
    learn(key);
    if (subs_.count(key) && !emptySubs_.count(key)) {
        throw InputError(file_, pathOf(key), "", "must be a single value, not a sub-dictionary",
                         "Write " + key + " <value>;");
    }
    const auto value = values_.find(key);
    return value == values_.end() ? nullptr : &value->second;
}

const std::string& Settings::require(const std::string& key) const
{
    if (const std::string* value = find(key))
        return *value;
    const bool line = form_ == Form::dictionary;
    throw InputError(file_, path_, "", (line ? "key \"" : "keyword \"") + key + "\" is missing",
                     (line ? "Add a line: " : "Add ") + key + (line ? " <value>;" : " <value>"));
}

void Settings::unknown(const std::string& key) const
{
    const std::string cure = asked_.empty() ? "No key is known here" : "Known keys: " + joined(asked_);
    throw InputError(file_, path_, "", "unknown key \"" + key + "\"" + didYouMean(key, asked_), cure);
}

std::string Settings::pathOf(const std::string& key) const
{
    return path_.empty() ? key : path_ + "." + key;
}

void Settings::learn(const std::string& key) const
{
    if (std::find(asked_.begin(), asked_.end(), key) == asked_.end())
        asked_.push_back(key);
}

} // namespace frazil
