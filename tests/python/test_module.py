"""The Python module: test_module.py PYTHONPATH_OF_THE_BUILD RGIMP [unittest's options]."""

import copy
import json
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

BUILT, RGIMP = sys.argv.pop(1), sys.argv.pop(1)
sys.path.insert(0, BUILT)

import h5py  # noqa: E402
import numpy as np  # noqa: E402

import rgimp  # noqa: E402

BLOCK = Path(__file__).resolve().parents[1] / "support/breaking_block.toml"
STEPS = 300


def block(**changes):
    case = rgimp.read_case(BLOCK)
    for name, value in changes.items():
        setattr(case, name, value)
    return case


def resting_block():
    """Steps without end: nothing moves, nothing fails."""
    return rgimp.read_case(BLOCK, [f"platen[{i}].speed=0" for i in (0, 1)])


def small_case():
    """A block of 200 particles, built in code."""
    rock = rgimp.Material(density=2600.0, youngs_modulus=17e9, poisson_ratio=0.14)
    return rgimp.Case(grid=rgimp.GridSettings(cell_size=1e-3),
                      bodies=[rgimp.Body(size=[5e-3, 10e-3], material="rock")],
                      materials={"rock": rock},
                      platens=[rgimp.Platen(side=rgimp.Side.top, speed=0.1),
                               rgimp.Platen(side=rgimp.Side.bottom)],
                      time=rgimp.TimeSettings(steps=1000))


class Cases(unittest.TestCase):
    def test_a_case_survives_its_text(self):
        case = block()
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "case.toml"
            path.write_text(rgimp.write_case(case))
            self.assertEqual(rgimp.write_case(rgimp.read_case(path)), rgimp.write_case(case))

    def test_overrides_are_those_of_the_command(self):
        case = rgimp.read_case(BLOCK, ["time.steps=7", "damping.local=0.5"])
        self.assertEqual((case.time.steps, case.local_damping), (7, 0.5))

    def test_parts_can_be_set_in_place(self):
        case = small_case()
        case.grid.cell_size = 0.5e-3
        case.bodies[0].center = [1e-3, 0]
        case.flaws.append(rgimp.Flaw(shape=rgimp.FlawShape.circle, length=2e-3, center=[1e-3, 0]))
        case.materials["rock"].failure = rgimp.Failure(tensile_strength=2e6)
        case.materials["rock"].failure.cohesion = 6e6
        text = rgimp.write_case(case)
        for line in ("cell_size = 0.0005", "cohesion = 6000000.0", 'shape = "circle"'):
            self.assertIn(line, text)

    def test_an_object_outlives_its_list(self):
        case = small_case()
        body = case.bodies[0]
        case.bodies = []
        case.bodies += [rgimp.Body() for _ in range(100)]
        self.assertEqual(body.material, "rock")

    def test_a_copy_is_independent(self):
        case = small_case()
        other = copy.deepcopy(case)
        other.bodies[0].material = "clay"
        other.time.steps = 1
        self.assertEqual((case.bodies[0].material, case.time.steps), ("rock", 1000))

    def test_vectors_cannot_be_changed_by_component(self):
        with self.assertRaises(ValueError):
            small_case().bodies[0].center[0] = 1.0

    def test_wrong_values_are_refused_by_name(self):
        case = small_case()
        with self.assertRaises(AttributeError):
            case.grid.cellsize = 1.0
        with self.assertRaises(AttributeError):
            rgimp.Body(centre=[0, 0])
        with self.assertRaisesRegex(ValueError, "two or three components, not 1"):
            rgimp.Body(center=[0.0])
        case.bodies.append(rgimp.Flaw())
        with self.assertRaisesRegex(TypeError, "expected a Body, not <.*Flaw"):
            rgimp.check_case(case)
        case = small_case()
        case.materials[3] = case.materials["rock"]
        with self.assertRaisesRegex(TypeError, "name of a material is a str, not 3"):
            rgimp.check_case(case)

    def test_errors_are_those_of_the_library(self):
        case = small_case()
        case.bodies[0].material = "clay"
        with self.assertRaisesRegex(rgimp.CaseError, "clay"):
            rgimp.Simulation(case)
        with self.assertRaisesRegex(rgimp.FileError, "nowhere"):
            rgimp.read_case("nowhere.toml")
        self.assertTrue(issubclass(rgimp.FileError, rgimp.Error))


class Steps(unittest.TestCase):
    def test_same_bits_as_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([RGIMP, "run", BLOCK, "-o", f"{folder}/run", "--steps", str(STEPS),
                            "--quiet"], check=True)
            summary = json.loads(Path(f"{folder}/run/summary.json").read_text())
        simulation = rgimp.Simulation(block())
        simulation.run_until(STEPS)
        self.assertEqual(f"{simulation.state_hash():016x}", summary["state_hash"])
        self.assertEqual(simulation.steps_done(), STEPS)

    def test_the_table_is_the_columns_in_order_of_id(self):
        simulation = rgimp.Simulation(block())
        simulation.run_until(STEPS)
        table, columns = simulation.particles(), simulation.columns()
        lanes = np.flatnonzero(columns.id != columns.no_id)
        lanes = lanes[np.argsort(columns.id[lanes])]
        np.testing.assert_array_equal(columns.id[lanes], table.id)
        np.testing.assert_array_equal(columns.stress[1][lanes], table.stress[:, 1])
        np.testing.assert_array_equal(columns.position[0][lanes], table.position[:, 0])
        self.assertEqual(len(columns.position), 2)
        self.assertEqual(len(table), simulation.facts().particles)
        self.assertEqual(table.failed.dtype, np.uint8)
        self.assertGreater(np.count_nonzero(table.stress), len(table))

    def test_columns_are_views_that_cannot_be_written(self):
        columns = rgimp.Simulation(small_case()).columns()
        self.assertFalse(columns.mass.flags.owndata)
        with self.assertRaises(ValueError):
            columns.mass[0] = 1.0

    def test_arrays_outlive_their_simulation_and_their_table(self):
        mass = rgimp.Simulation(small_case()).columns().mass[::2]
        stress = rgimp.Simulation(small_case()).particles().stress[1:]
        self.assertAlmostEqual(np.sum(mass) * 2, 2600 * 5e-3 * 10e-3, delta=0.03)
        self.assertEqual(np.count_nonzero(stress), 0)

    def test_steps_wait_for_nobody_who_looks_at_columns(self):
        simulation = rgimp.Simulation(small_case())
        part = simulation.columns().mass[3:]
        with self.assertRaisesRegex(BufferError, "delete or copy"):
            simulation.step()
        del part
        simulation.step()
        self.assertEqual(simulation.steps_done(), 1)

    def test_observers_are_called_and_can_read(self):
        simulation = rgimp.Simulation(small_case())
        seen = []
        simulation.every(50, lambda sim: seen.append((sim.steps_done(),
                                                      float(np.sum(sim.columns().mass)))))
        simulation.run_until(200)
        self.assertEqual([step for step, _ in seen], [50, 100, 150, 200])
        self.assertGreater(seen[0][1], 0.0)

    def test_observers_must_not_step_nor_keep_columns(self):
        simulation = rgimp.Simulation(small_case())
        simulation.every(1, lambda sim: sim.step())
        with self.assertRaisesRegex(RuntimeError, "observers may only read"):
            simulation.run_until(2)
        kept = []
        simulation = rgimp.Simulation(small_case())
        simulation.every(1, lambda sim: kept.append(sim.columns()))
        with self.assertRaises(BufferError):
            simulation.run_until(2)
        self.assertEqual(simulation.steps_done(), 1)

    def test_what_an_observer_raises_ends_the_steps(self):
        simulation = rgimp.Simulation(small_case())
        simulation.every(10, lambda sim: 1 / 0)
        with self.assertRaises(ZeroDivisionError):
            simulation.run_until(100)
        self.assertEqual(simulation.steps_done(), 10)

    def test_physics_errors_carry_their_report(self):
        case = small_case()
        case.platens[0].speed = 1e5
        simulation = rgimp.Simulation(case)
        with self.assertRaises(rgimp.PhysicsError) as stopped:
            simulation.run_until(1000)
        self.assertGreater(stopped.exception.report.step, 0)
        self.assertIn(str(stopped.exception.report.step), str(stopped.exception))

    def test_checkpoints_go_on_to_the_same_bits(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "state.rgimp"
            first = rgimp.Simulation(small_case())
            first.run_until(50)
            first.save(path, "half")
            first.run_until(100)
            second = rgimp.Simulation(small_case())
            self.assertEqual(second.restore(path), "half")
            second.run_until(100)
        self.assertEqual(first.state_hash(), second.state_hash())


def pulled(position, time):
    return [1e5 if position[1] > 0.0 else -1e5, -2e5]


def seam(particle):
    weak = abs(particle.position[1]) < 1e-3 and particle.stress[1, 1] < -1e5
    return rgimp.FailureMode.shear if weak else rgimp.FailureMode.intact


class OwnFunctions(unittest.TestCase):
    def test_a_constant_acceleration_is_the_case_s(self):
        case = small_case()
        own = rgimp.Simulation(case)
        own.set_acceleration(lambda position, time: (0.0, -50.0))
        own.run_until(40)
        case.body_acceleration = [0.0, -50.0]
        expected = rgimp.Simulation(case)
        expected.run_until(40)
        self.assertEqual(own.state_hash(), expected.state_hash())
        own.set_acceleration(None)
        own.run_until(50)
        expected.run_until(50)
        self.assertNotEqual(own.state_hash(), expected.state_hash())

    def test_an_initial_state_is_what_the_particles_have(self):
        simulation = rgimp.Simulation(small_case())
        stress = np.array([[1e5, 2e4, 0.0], [2e4, -3e5, 0.0], [0.0, 0.0, 4e4]])
        simulation.set_initial_state(lambda position: rgimp.InitialState(
            velocity=[position[1], -position[0]], stress=stress))
        particles = simulation.particles()
        np.testing.assert_array_equal(particles.velocity[:, 0], particles.position[:, 1])
        np.testing.assert_array_equal(particles.velocity[:, 1], -particles.position[:, 0])
        np.testing.assert_array_equal(particles.stress[:, :4],
                                      np.tile([1e5, -3e5, 4e4, 2e4], (len(particles), 1)))
        with self.assertRaisesRegex(rgimp.CaseError, "not symmetric"):
            simulation.set_initial_state(lambda position: rgimp.InitialState(
                stress=np.triu(stress)))

    def test_own_functions_give_the_same_bits_on_any_number_of_threads(self):
        hashes = set()
        for threads in (1, 2):
            case = small_case()
            case.tuning.threads = threads
            simulation = rgimp.Simulation(case)
            simulation.set_acceleration(pulled)
            simulation.set_criterion(seam)
            simulation.run_until(120)
            history = simulation.history()
            self.assertGreater(history.failed_shear, 5)
            self.assertEqual(history.failed_tension, 0)
            failed = simulation.particles().failed == int(rgimp.FailureMode.shear)
            self.assertLess(np.abs(simulation.particles().position[failed, 1]).max(), 1.1e-3)
            hashes.add(simulation.state_hash())
        self.assertEqual(len(hashes), 1)

    def test_a_checkpoint_needs_the_functions_that_acted_on_it(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "state.rgimp"
            simulation = rgimp.Simulation(small_case())
            simulation.set_criterion(seam)
            simulation.run_until(5)
            simulation.save(path)
            other = rgimp.Simulation(small_case())
            with self.assertRaisesRegex(rgimp.CaseError, "call set_criterion"):
                other.restore(path)
            other.set_criterion(seam)
            other.restore(path)
            self.assertEqual(other.state_hash(), simulation.state_hash())

    def test_what_a_function_raises_leaves_the_step_half_done(self):
        simulation = rgimp.Simulation(small_case())
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "state.rgimp"
            simulation.save(path)
            simulation.set_criterion(lambda particle: 1 / 0)
            with self.assertRaises(ZeroDivisionError):
                simulation.run_until(10)
            with self.assertRaisesRegex(rgimp.Error, "half done"):
                simulation.step()
            simulation.set_criterion(None)
            simulation.restore(path)
            simulation.run_until(10)

    def test_wrong_values_and_looking_at_the_simulation_are_refused(self):
        for setter, function, error, text in (
                ("set_acceleration", lambda x, t: "up", TypeError, "two or three numbers, not 'up'"),
                ("set_acceleration", lambda x, t: [1.0], ValueError, "not 1"),
                ("set_acceleration", lambda x: [0.0, 0.0], TypeError, "argument"),
                ("set_criterion", lambda particle: None, TypeError, "a FailureMode, not None"),
                ("set_initial_state", lambda x: [0.0], TypeError, "an InitialState, not"),
                ("set_acceleration", lambda x, t: [simulation.time(), 0], RuntimeError,
                 "cannot look at it")):
            with self.subTest(setter=setter, text=text):
                simulation = rgimp.Simulation(small_case())
                with self.assertRaisesRegex(error, text):
                    getattr(simulation, setter)(function)
                    simulation.step()


class Threads(unittest.TestCase):
    def test_others_go_on_but_not_with_the_same_simulation(self):
        simulation = rgimp.Simulation(block())
        started, proceed = threading.Event(), threading.Event()

        def hold(_):
            started.set()
            proceed.wait(30)

        simulation.every(1, hold)
        stepping = threading.Thread(target=simulation.step)
        stepping.start()
        self.assertTrue(started.wait(30))
        try:
            with self.assertRaisesRegex(RuntimeError, "another thread"):
                simulation.history()
            with self.assertRaisesRegex(RuntimeError, "stepping"):
                simulation.step()
        finally:
            proceed.set()
            stepping.join()
        self.assertEqual(simulation.history().step, 1)

    def test_ctrl_c_ends_the_steps(self):
        code = (f"import sys; sys.path.insert(0, {BUILT!r}); import rgimp\n"
                f"case = rgimp.read_case({str(BLOCK)!r}, ['platen[0].speed=0', 'platen[1].speed=0'])\n"
                "simulation = rgimp.Simulation(case)\n"
                "print('stepping', flush=True)\n"
                "try:\n    simulation.run_until(10**12)\n"
                "except KeyboardInterrupt:\n    print(simulation.steps_done() > 0)\n")
        child = subprocess.Popen(["/usr/bin/python3", "-c", code], stdout=subprocess.PIPE,
                                 text=True)
        self.assertEqual(child.stdout.readline(), "stepping\n")
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        self.assertEqual(child.communicate(timeout=60)[0], "True\n")


class Runs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_a_run_leaves_what_the_command_reads(self):
        case = block()
        case.time.steps = STEPS
        progress = []
        end = rgimp.run_case(rgimp.Simulation(case), self.folder / "run",
                             on_progress=progress.append)
        self.assertEqual(end, rgimp.RunEnd.finished)
        settings, particles = rgimp.read_results(self.folder / "run")
        self.assertEqual(settings.time.steps, STEPS)
        cracks = rgimp.trace_cracks(self.folder / "run")
        printed = subprocess.run([RGIMP, "cracks", self.folder / "run", "--json", "-"], check=True,
                                 capture_output=True, text=True)
        self.assertEqual(cracks, json.loads(printed.stdout))
        self.assertEqual(len(particles), rgimp.Simulation(case).facts().particles)
        self.check_grid(settings, particles)
        with self.assertRaises(rgimp.CaseError):
            rgimp.run_case(rgimp.Simulation(case), self.folder / "run")
        self.assertEqual(rgimp.run_case(rgimp.Simulation(case), self.folder / "run",
                                        rgimp.ExistingOutput.resume), rgimp.RunEnd.was_finished)

    def check_grid(self, settings, particles):
        """Fields of the particles that were read are those in the file that is written of them."""
        fields = rgimp.grid_fields(settings, particles, STEPS)
        self.assertEqual(fields.stress.shape, (*fields.nodes[::-1], 6))
        mean = (fields.mass * fields.damage).sum() / fields.mass.sum()
        self.assertAlmostEqual(mean, particles.damage.mean(), delta=1e-12)
        written = rgimp.write_grids(self.folder / "run", STEPS)
        with h5py.File(written.files[0]) as file:
            for name in ("mass", "velocity", "stress", "damage"):
                there = file["VTKHDF/PointData"][name][:1]
                self.assertTrue(np.array_equal(there, getattr(fields, name)), name)
        with self.assertRaisesRegex(rgimp.CaseError, "no snapshot of step 1 "):
            rgimp.write_grids(self.folder / "run", 1)

    def test_what_a_callback_raises_ends_the_run_with_a_checkpoint(self):
        def refuse(_):
            raise ZeroDivisionError

        case = resting_block()
        case.time.steps = 10**9
        with self.assertRaises(ZeroDivisionError):
            rgimp.run_case(rgimp.Simulation(case), self.folder / "run", on_progress=refuse)
        self.assertTrue(list((self.folder / "run").glob("checkpoint*.rgimp")))

    def test_a_sweep_runs_every_combination(self):
        sweep = rgimp.read_sweep(BLOCK, ["damping.local=0|0.5", f"time.steps={STEPS}"])
        outcomes = rgimp.run_sweep(sweep, self.folder / "sweep", jobs=2)
        self.assertEqual([one.values for one in sweep.cases], [["0"], ["0.5"]])
        self.assertEqual([outcome.status for outcome in outcomes],
                         [rgimp.SweepStatus.finished] * 2)
        self.assertGreater(outcomes[0].figures.peak_axial_stress, 0.0)
        self.assertTrue((self.folder / "sweep/sweep.csv").is_file())


if __name__ == "__main__":
    unittest.main()
