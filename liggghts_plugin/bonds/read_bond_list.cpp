#include "read_bond_list.h"

#include <fstream>
#include <map>
#include <sstream>

namespace
{

/// Two positive whole numbers and nothing else?
bool parse(const std::string& line, int& id1, int& id2)
{
    std::istringstream words(line);
    std::string more;
    return words >> id1 >> id2 && !(words >> more) && id1 > 0 && id2 > 0;
}

} // namespace

std::string frazil::readBondList(const std::string& path, BondList& pairs)
{
    std::ifstream file(path);
    if (!file)
        return "list " + path + ": the file cannot be read; cure: check the path, it starts at the folder of the run";
    std::map<std::pair<int, int>, int> lines;
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
        const std::string at = "list " + path + ", line " + std::to_string(number) + ": ";
        line = line.substr(0, line.find('#'));
        if (line.find_first_not_of(" \t\r") == std::string::npos)
            continue;
        int id1 = 0, id2 = 0;
        if (!parse(line, id1, id2))
            return at + "'" + line + "' is no pair of ids; cure: two whole numbers above 0 in each line";
        if (id1 == id2)
            return at + "sphere " + std::to_string(id1) + " with itself; cure: two different ids";
        if (id1 > id2)
            std::swap(id1, id2);
        const auto first = lines.emplace(std::make_pair(id1, id2), number);
        if (!first.second)
            return at + "the pair " + std::to_string(id1) + " " + std::to_string(id2) + " is there already, in line " +
                   std::to_string(first.first->second) + "; cure: each pair once";
        pairs.push_back({id1, id2, number});
    }
    return pairs.empty() ? "list " + path + ": no pair in it; cure: lines 'id1 id2'" : "";
}
