"""frazilDem runs stock scripts as liggghts does: the same thermo output, digit for digit, on one and two ranks.

packing: insertion, growth by fix adapt, primitive walls, a `clear` and a second box (after which our styles must still
be known). chute: a mesh wall read from STL, gravity, continuous insertion through a face, wear, dumps.
"""
import re
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "mpi"))
import mpirun  # noqa: E402

MATERIAL = """
fix m1 all property/global youngsModulus peratomtype 5.e6
fix m2 all property/global poissonsRatio peratomtype 0.45
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.3
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
fix m5 all property/global k_finnie peratomtypepair 1 1.0
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-5
"""

HEAD = """
atom_style granular
atom_modify map array
newton off
communicate single vel yes
units si
"""

THERMO = """
compute spin all erotate/sphere
thermo_style custom step atoms ke c_spin vol
thermo_modify lost ignore norm no format float %.16g
"""

PACKING = HEAD + """
boundary m m m
region box block -0.05 0.05 -0.05 0.05 0 0.1 units box
create_box 1 box
neighbor 0.002 bin
neigh_modify delay 0
""" + MATERIAL + """
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
atom_style granular
atom_modify map array
newton off
communicate single vel yes
units si
boundary f f f
region box block 0 1 0 1 0 1 units box
create_box 1 box
neighbor 0.002 bin
neigh_modify delay 0
""" + MATERIAL + """
create_atoms 1 single 0.5 0.5 0.5 units box
set group all density 1000 diameter 0.02
fix move all nve/sphere
fix g all gravity 9.81 vector 0 0 -1
thermo_style custom step atoms ke
thermo_modify format float %.16g
run 100
"""

CHUTE = HEAD + """
boundary f f f
region box block -0.25 0.1 -0.1 0.1 -0.25 0.15 units box
create_box 1 box
neighbor 0.002 bin
neigh_modify delay 0
""" + MATERIAL + """
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


def stl(*quads):
    """Two triangles for each quad of four corners."""
    lines = ["solid s"]
    for a, b, c, d in quads:
        for triangle in ((a, b, c), (a, c, d)):
            lines += ["facet normal 0 0 1", "outer loop"]
            lines += ["vertex %g %g %g" % corner for corner in triangle]
            lines += ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid s", ""])


CHUTE_STL = stl(((-0.2, -0.05, -0.1), (0.08, -0.05, 0.02), (0.08, 0.05, 0.02), (-0.2, 0.05, -0.1)),
                ((-0.2, 0.05, -0.1), (0.08, 0.05, 0.02), (0.08, 0.05, 0.1), (-0.2, 0.05, 0.0)))
FACE_STL = stl(((0.02, -0.03, 0.12), (0.07, -0.03, 0.12), (0.07, 0.03, 0.12), (0.02, 0.03, 0.12)))


class Stock(unittest.TestCase):
    def outcome(self, program, ranks, script):
        """Thermo lines (step and values) and the files that the run wrote."""
        with tempfile.TemporaryDirectory() as folder:
            here = Path(folder)
            (here / "in.test").write_text(script)
            (here / "chute.stl").write_text(CHUTE_STL)
            (here / "face.stl").write_text(FACE_STL)
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

    def test_our_styles_are_known_after_clear(self):
        script = PACKING.replace("thermo_style custom step atoms ke\n",
                                 "fix bonds all bond/parallel young 1e6 stiffness_ratio 2 tensile_strength 1e5 "
                                 "shear_strength 1e5\nthermo_style custom step atoms ke\n")
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "in.test").write_text(script)
            run = mpirun.run(["-np", 1, f"{BIN}/frazilDem", "-in", "in.test"], cwd=folder)
        self.assertNotIn("Invalid fix style", run.text)


if __name__ == "__main__":
    BIN = sys.argv.pop(1)
    unittest.main(verbosity=2)
