/// The one exception for what a user can mend: it names the file, the key, the value and the cure.
#pragma once

#include <stdexcept>
#include <string>

namespace frazil
{

class InputError : public std::runtime_error
{
  public:
    /// what() reads "file: key value: problem. cure." An empty part is left out with its punctuation.
    InputError(const std::string& file, const std::string& key, const std::string& value, const std::string& problem,
               const std::string& cure);
};

} // namespace frazil
