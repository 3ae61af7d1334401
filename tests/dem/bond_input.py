"""Wrong input to fix bond/parallel and compute fragment: each ends the run with the keyword, the value and the cure."""

from bond_dem import *

NEEDED = "young 5e8 stiffness_ratio 2.66 tensile_strength 1.2e6 shear_strength 0.8e6"
CASES = {
    "not a number": ("young abc stiffness_ratio 1 tensile_strength 1 shear_strength 1", "", ["young abc: is not a number"]),
    "no finite number": (NEEDED.replace("5e8", "inf"), "", ["young inf: is not a number"]),
    "not a number at all": (NEEDED.replace("2.66", "nan"), "", ["stiffness_ratio nan: is not a number"]),
    "negative": (NEEDED + " damping -1", "", ["damping -1: is negative", "0 or more"]),
    "two dampings": (NEEDED + " damping 0.1 0.2", "", ["damping 0.1 0.2: is neither one number nor four"]),
    "one of four negative": (NEEDED + " damping 0.1 0.2 -3 0", "", ["damping 0.1 0.2 -3 0: is negative", "0 or more"]),
    "no damping": (NEEDED + " damping much", "", ["damping much: much is not a number"]),
    "zero strength": (NEEDED.replace("1.2e6", "0"), "", ["tensile_strength 0: must be greater than zero"]),
    "friction angle": (NEEDED + " friction_angle 95", "", ["friction_angle 95: is no friction angle", "below 90"]),
    "unknown keyword": (NEEDED + " dampning 1", "", ['dampning: unknown keyword (did you mean "damping"?)', "Known: young"]),
    "missing keyword": ("young 5e8 stiffness_ratio 1 tensile_strength 1e6", "",
                        ['keyword "shear_strength" is missing', "Add shear_strength <value>"]),
    "missing value": (NEEDED + " weibull 5", "", ["weibull 5: needs 2 values"]),
    "value left out": ("young " + NEEDED.split(" ", 2)[2], "", ["young: needs 1 value"]),
    "no value": (NEEDED + " create_gap", "", ["create_gap: needs 1 value"]),
    "keyword twice": (NEEDED + " create_gap 0.1 create_gap 0.2", "", ["create_gap: stands twice"]),
    "bad seed": (NEEDED + " weibull 5 -3", "", ["weibull 5 -3: has no seed", "whole number"]),
    "no pair in reach": (NEEDED, "FAR", ["no pair", "0.5", "create_gap"]),
    "nobody near": (NEEDED, "VERY FAR", ["no pair", "neighbour distance"]),
    "time step": (NEEDED, "timestep 1e-5\n", ["time step of 1e-05", "critical", "cure: 'timestep"]),
    "gap beyond the skin": (NEEDED + " create_gap 0.9", "", ["create_gap", "skin", "neighbor"]),
    "events file": (NEEDED + " events nowhere/ev.csv", "", ["events nowhere/ev.csv: cannot be written"]),
}


def error_of(run):
    return next((line for line in run.output.splitlines() if "ERROR" in line), "")


def script(keywords, more):
    distance = {"FAR": D + 0.5 * R, "VERY FAR": 5 * D}.get(more, D)
    text = head(skin=0.001) + MODEL + spheres([[0, 0, 0], [distance, 0, 0]]) + "timestep 1e-7\n"
    text += f"fix bonds all bond/parallel {keywords}\nfix nve all nve/sphere\n"
    return text + (more if "\n" in more else "") + "run 1\n"


def main():
    check = Check()
    for name, (keywords, more, words) in CASES.items():
        for ranks in (1, 2):
            run = check.run(script(keywords, more), ranks=ranks, expect_failure=True)
            message = error_of(run)
            check.true(f"{name} on {ranks}", all(word in message for word in words), message)
    text = script(NEEDED, "").replace("run 1", "compute f all fragment bondz\nrun 1")
    message = check.run(text, expect_failure=True).output
    check.true("fragment of an unknown fix", "the ID 'bondz' (did you mean \"bonds\"?)" in message,
               message.strip().splitlines()[-1])
    for words, said in (("", "lacks the ID"), ("bonds bonds", "too many words")):
        message = check.run(script(NEEDED, "").replace("run 1", f"compute f all fragment {words}\nrun 1"),
                            expect_failure=True).output
        check.true(f"fragment with '{words}'", said in message and "Write compute ID group fragment BONDFIX" in message,
                   message.strip().splitlines()[-1])
    text = script(NEEDED, "").replace("timestep 1e-7", "timestep 8e-7")
    check.true("time step above 0.2 of critical warns", "WARNING" in (out := check.run(text).output) and "critical" in out,
               next((line for line in out.splitlines() if "critical" in line), ""))
    apart = head(processors="2 1 1") + MODEL + spheres([[-R, 0, 0], [R, 0, 0]]) + "timestep 1e-7\n" + bond()
    apart += "group one id 1\ngroup two id 2\nfix a one move linear -20 0 0\nfix b two move linear 20 0 0\nrun 5000\n"
    message = error_of(check.run(apart, ranks=2, expect_failure=True))
    check.true("partner beyond the ghosts", all(w in message for w in ("id 2", "ghost", "communicate", "cutoff")), message)
    fewer = head() + MODEL + spheres([[i * D, 0, 0] for i in range(4)]) + "timestep 1e-7\n" + bond()
    fewer += "run 1\ngroup gone id 2\ndelete_atoms group gone\nrun 1\n"
    message = error_of(check.run(fewer, expect_failure=True))
    check.true("ids renumbered by delete_atoms", "ids changed" in message and "compress no" in message, message)
    check.finish()


main()
