/// A choice by name among types: the one list that makes the variant, the words of the input and the error that lists them.
///
/// Each type tells its own `static constexpr const char* name`, and where it has one its `source`. What is in the variant
/// can be chosen, and nothing else can: a name cannot stand in the documentation of the error and run another law.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "Settings.h"

namespace frazil
{

template <class Variant> struct Catalogue;

template <class... Items> struct Catalogue<std::variant<Items...>> {
    static std::vector<std::string> names() { return {Items::name...}; }

    /// The item that `key` names; the first one where the user says nothing. InputError on any other word.
    static std::variant<Items...> choose(const Settings& settings, const std::string& key)
    {
        const std::string name = settings.word(key, names(), names().front());
        std::variant<Items...> chosen;
        ((name == Items::name ? void(chosen = Items{}) : void()), ...);
        return chosen;
    }
};

} // namespace frazil
