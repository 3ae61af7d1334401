#include "InputError.h"

namespace frazil
{

namespace
{

std::string paragraph(const std::string& file, const std::string& key, const std::string& value,
                      const std::string& problem, const std::string& cure)
{
    std::string text = file;
    if (!key.empty())
        text += (text.empty() ? "" : ": ") + key + (value.empty() ? "" : " " + value);
    text += (text.empty() ? "" : ": ") + problem;
    if (!cure.empty())
        text += (text.back() == '.' ? " " : ". ") + cure;
    if (text.back() != '.')
        text += '.';
    return text;
}

} // namespace

InputError::InputError(const std::string& file, const std::string& key, const std::string& value,
                       const std::string& problem, const std::string& cure)
    : std::runtime_error(paragraph(file, key, value, problem, cure))
{
}

} // namespace frazil
