/* The tables of styles are private members of Modify and Input: private_member.h. */

#include "register_styles.h"

#include <map>
#include <string>

#include "compute_fragment.h"
#include "fix_body_rigid.h"
#include "fix_bond_parallel.h"
#include "fix_couple_foam.h"
#include "fix_results.h"
#include "input.h"
#include "modify.h"
#include "private_member.h"

using namespace LAMMPS_NS;

namespace
{

typedef Fix* (*FixCreator)(LAMMPS*, int, char**);
typedef Compute* (*ComputeCreator)(LAMMPS*, int, int, char**);
typedef void (*CommandCreator)(LAMMPS*, int, char**);

struct FixMap {
    typedef std::map<std::string, FixCreator>* Modify::*Member;
    friend Member memberOf(FixMap);
};
struct ComputeMap {
    typedef std::map<std::string, ComputeCreator>* Modify::*Member;
    friend Member memberOf(ComputeMap);
};
struct CommandMap {
    typedef std::map<std::string, CommandCreator>* Input::*Member;
    friend Member memberOf(CommandMap);
};

template struct PrivateMember<FixMap, &Modify::fix_map>;
template struct PrivateMember<ComputeMap, &Modify::compute_map>;
template struct PrivateMember<CommandMap, &Input::command_map>;

template <class T> Fix* newFix(LAMMPS* lmp, int narg, char** arg)
{
    return new T(lmp, narg, arg);
}

template <class T> Compute* newCompute(LAMMPS* lmp, int iarg, int narg, char** arg)
{
    return new T(lmp, iarg, narg, arg);
}

/* The list of our styles, one line each. */
void addStyles(LAMMPS* lmp)
{
    std::map<std::string, FixCreator>& fixes = *(lmp->modify->*memberOf(FixMap()));
    std::map<std::string, ComputeCreator>& computes = *(lmp->modify->*memberOf(ComputeMap()));

    fixes["body/rigid"] = &newFix<FixBodyRigid>;
    fixes["bond/parallel"] = &newFix<FixBondParallel>;
    fixes["couple/foam"] = &newFix<FixCoupleFoam>;
    fixes["results"] = &newFix<FixResults>;
    computes["fragment"] = &newCompute<ComputeFragment>;
}

/* No fix or compute can be created before the simulation box, and `clear` deletes the box together with
   the tables. So the commands that create a box are the ones to renew the tables. */
enum BoxCommand { CREATE_BOX, READ_DATA, READ_RESTART, BOX_COMMANDS };
const char* const boxCommandName[BOX_COMMANDS] = {"create_box", "read_data", "read_restart"};
CommandCreator stockCommand[BOX_COMMANDS];

template <int command> void addStylesThenRun(LAMMPS* lmp, int narg, char** arg)
{
    addStyles(lmp);
    stockCommand[command](lmp, narg, arg);
}

template <int command> void wrap(std::map<std::string, CommandCreator>& commands)
{
    CommandCreator& entry = commands[boxCommandName[command]];
    stockCommand[command] = entry;
    entry = &addStylesThenRun<command>;
}

} // namespace

void frazil::registerStyles(LAMMPS* lmp)
{
    std::map<std::string, CommandCreator>& commands = *(lmp->input->*memberOf(CommandMap()));
    wrap<CREATE_BOX>(commands);
    wrap<READ_DATA>(commands);
    wrap<READ_RESTART>(commands);
}
