/// key=value arguments of the toy programs.
#pragma once

#include <cstdlib>
#include <map>
#include <string>

class ToyArguments
{
  public:
    ToyArguments(int argc, char** argv)
    {
        for (int i = 1; i < argc; ++i) {
            const std::string word = argv[i];
            const std::size_t equals = word.find('=');
            values_[word.substr(0, equals)] = word.substr(equals + 1);
        }
    }
    double number(const std::string& key, double otherwise) const
    {
        const auto found = values_.find(key);
        return found == values_.end() ? otherwise : std::atof(found->second.c_str());
    }
    std::string word(const std::string& key) const
    {
        const auto found = values_.find(key);
        return found == values_.end() ? "" : found->second;
    }

  private:
    std::map<std::string, std::string> values_;
};
