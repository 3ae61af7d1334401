"""frazilDem runs stock scripts as liggghts does: the same thermo output, digit for digit, on one and two ranks.

packing: insertion, growth by fix adapt, primitive walls, a `clear` and a second box (after which our styles must still
be known). chute: a mesh wall read from STL, gravity, continuous insertion through a face, wear, dumps.
"""
import re
import sys
import tempfile
import unittest
from pathlib import Path

import dem_script
import mpirun
import surfaces

WEAR = "fix m5 all property/global k_finnie peratomtypepair 1 1.0\n"


def head(boundary, low, high):
    return dem_script.head(dem_script.box(low, high), boundary, restitution=0.3, more=WEAR) + "timestep 1e-5\n"


THERMO = """
compute spin all erotate/sphere
thermo_style custom step atoms ke c_spin vol
thermo_modify lost ignore norm no format float %.16g
"""

PACKING = head("m m m", (-0.05, -0.05, 0), (0.05, 0.05, 0.1)) + """
fix xlo all wall/gran model hertz tangential history primitive type 1 xplane -0.05
fix xhi all wall/gran model hertz tangential history primitive type 1 xplane 0.05
fix ylo all wall/gran model hertz tangential history primitive type 1 yplane -0.05
fix yhi all wall/gran model hertz tangential history primitive type 1 yplane 0.05
fix zlo all wall/gran model hertz tangential history primitive type 1 zplane 0
fix zhi all wall/gran model hertz tangential history primitive type 1 zplane 0.1
fix small all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.005
fix large all particletemplate/sphere 15485867 atom_type 1 density constant 2500 radius constant 0.007
fix mix all particledistribution/discrete 32452843 2 small 0.3 large 0.7
fix fill all insert/pack seed 32452867 distributiontemplate mix maxattempt 200 insert_every once overlapcheck yes &
    all_in yes vel constant 0 0 0 region box volumefraction_region 0.25
fix move all nve/sphere
""" + THERMO + """
thermo 200
run 1
unfix fill
compute r all property/atom radius
variable grown atom 2.0*c_r*1.004
fix grow all adapt 20 atom diameter v_grown
run 1200
unfix grow
run 400
clear
""" + head("f f f", (0, 0, 0), (1, 1, 1)) + """
create_atoms 1 single 0.5 0.5 0.5 units box
set group all density 1000 diameter 0.02
fix move all nve/sphere
fix g all gravity 9.81 vector 0 0 -1
thermo_style custom step atoms ke
thermo_modify format float %.16g
run 100
"""

CHUTE = head("f f f", (-0.25, -0.1, -0.25), (0.1, 0.1, 0.15)) + """
fix g all gravity 9.81 vector 0 0 -1
fix chute all mesh/surface/stress file chute.stl type 1 wear finnie
fix face all mesh/surface/planar file face.stl type 1
fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes chute
fix small all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 0.002
fix large all particletemplate/sphere 15485867 atom_type 1 density constant 2500 radius constant 0.003
fix mix all particledistribution/discrete 32452843 2 small 0.3 large 0.7
fix stream all insert/stream seed 32452867 distributiontemplate mix nparticles 600 massrate 0.3 insert_every 1500 &
    overlapcheck yes all_in no vel constant 0 0 -1 insertion_face face
fix move all nve/sphere
""" + THERMO + """
thermo 500
dump particles all custom 2000 particles.*.txt id x y z fx fy fz omegax omegay omegaz
dump mesh all mesh/stl 4000 mesh.*.stl chute
run 8000
"""


CHUTE_STL = surfaces.quads(((-0.2, -0.05, -0.1), (0.08, -0.05, 0.02), (0.08, 0.05, 0.02), (-0.2, 0.05, -0.1)),
                ((-0.2, 0.05, -0.1), (0.08, 0.05, 0.02), (0.08, 0.05, 0.1), (-0.2, 0.05, 0.0)))
FACE_STL = surfaces.quads(((0.02, -0.03, 0.12), (0.07, -0.03, 0.12), (0.07, 0.03, 0.12), (0.02, 0.03, 0.12)))

BONDED = """
create_atoms 1 single 0.5 0.5 0.5 units box
create_atoms 1 single 0.52 0.5 0.5 units box
create_atoms 1 single 0.54 0.5 0.5 units box
set group all density 1000 diameter 0.02
fix bonds all bond/parallel young 1e6 stiffness_ratio 2 tensile_strength 1e5 shear_strength 1e5
fix move all nve/sphere
thermo_style custom step atoms f_bonds[1] f_bonds[2]
thermo_modify format float %g
run 100
"""


class Stock(unittest.TestCase):
    def outcome(self, program, ranks, script):
        """Thermo lines (step and values) and the files that the run wrote."""
        with tempfile.TemporaryDirectory() as folder:
            here = Path(folder)
            (here / "in.test").write_text(script)
            surfaces.write_stl(here / "chute.stl", CHUTE_STL)
            surfaces.write_stl(here / "face.stl", FACE_STL)
            run = mpirun.run(["-np", ranks, program, "-in", "in.test"], cwd=folder)
            self.assertEqual(run.code, 0, run)
            thermo = re.findall(r"^ +\d+ +\d+ [-+.\deE ]+$", run.text, re.MULTILINE)
            self.assertGreater(len(thermo), 8, run)
            files = {file.name: file.read_text() for pattern in ("particles.*", "mesh.*") for file in here.glob(pattern)}
            return thermo, files

    def same(self, script):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                stock, stock_files = self.outcome("liggghts", ranks, script)
                ours, our_files = self.outcome(f"{BIN}/frazilDem", ranks, script)
                self.assertEqual(ours, stock)
                self.assertEqual(our_files, stock_files)
                print(f"{len(stock)} thermo lines and {len(stock_files)} files are equal, last:{stock[-1]}")

    def test_packing(self):
        self.same(PACKING)

    def test_chute(self):
        self.same(CHUTE)

    def test_our_styles_work_after_clear(self):
        """A pair that bonds hold together, in the box that follows `clear`: both bonds are made, and none breaks."""
        script = PACKING[:PACKING.index("create_atoms 1 single 0.5 0.5 0.5")] + BONDED
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "in.test").write_text(script)
            run = mpirun.run(["-np", 1, f"{BIN}/frazilDem", "-in", "in.test"], cwd=folder)
        self.assertEqual(run.code, 0, run)
        self.assertRegex(run.text, r"(?m)^ +\d+ +3 2 0 *$")


if __name__ == "__main__":
    BIN = sys.argv.pop(1)
    unittest.main(verbosity=2)
