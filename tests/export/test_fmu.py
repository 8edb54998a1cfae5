"""Units for co-simulation, as a master of FMI 2.0 and 3.0 uses them: through FMPy."""

import zipfile
from typing import Any

import numpy as np
import pytest

import clubface
from clubface.errors import ClubfaceError
from clubface.export.fmu import write_fmu
from command_line import process

fmpy = pytest.importorskip("fmpy")
DELIVERY = {"speed": "105 mph", "attack": "3 deg", "loft": "13 deg", "toe": "10 mm", "closure": "2000 deg/s"}
VERSIONS = ("2.0", "3.0")


@pytest.fixture(scope="module", params=VERSIONS)
def unit(request, tmp_path_factory):
    path = tmp_path_factory.mktemp("fmu") / "driver_impact.fmu"
    return write_fmu(path, "driver", model="volumetric", version=request.param)


class Master:
    """One instance of a unit, its variables by name."""

    def __init__(self, unit, messages=None):
        from fmpy import fmi2, fmi3

        described = fmpy.read_model_description(unit)
        self.two = described.fmiVersion.startswith("2")
        self.references = {each.name: each.valueReference for each in described.modelVariables}
        slave: Any = fmi2.FMU2Slave if self.two else fmi3.FMU3Slave
        self.unit: Any = slave(
            guid=described.guid,
            unzipDirectory=fmpy.extract(unit),
            modelIdentifier=described.coSimulation.modelIdentifier,
            instanceName="impact",
        )
        self.unit.instantiate(loggingOn=True)

    def set(self, values):
        references = [self.references[name] for name in values]
        (self.unit.setReal if self.two else self.unit.setFloat64)(references, [*values.values()])

    def get(self, *names):
        references = [self.references[name] for name in names]
        return np.array((self.unit.getReal if self.two else self.unit.getFloat64)(references))

    def phase(self):
        reference = [self.references["phase"]]
        return (self.unit.getInteger if self.two else self.unit.getInt32)(reference)[0]

    def begin(self):
        if self.two:
            self.unit.setupExperiment(startTime=0.0)
            self.unit.enterInitializationMode()
        else:
            self.unit.enterInitializationMode(startTime=0.0)
        self.unit.exitInitializationMode()

    def step(self, time, duration):
        self.unit.doStep(currentCommunicationPoint=time, communicationStepSize=duration)

    def end(self):
        self.unit.terminate()
        self.unit.freeInstance()


def quaternion(rotation):
    w = np.sqrt(1.0 + np.trace(rotation)) / 2.0
    skew = (rotation - rotation.T) / (4.0 * w)
    return np.array([w, skew[2, 1], skew[0, 2], skew[1, 0]])


def head_of(rotation, position, velocity, spin):
    values = np.concatenate([quaternion(rotation), position, velocity, spin])
    names = ["head_qw", "head_qx", "head_qy", "head_qz", *(f"head_{a}{b}" for a in ("", "v", "w") for b in "xyz")]
    return dict(zip(names, values.tolist(), strict=True))


def swing(master, club, step):
    """A master with a rigid head of its own, which it moves by the force and torque of each step."""
    rotation, position, velocity, spin = (np.array(each) for each in clubface.Delivery(**DELIVERY).pose(club))
    position, time = position - 3e-6 * velocity, 0.0
    inertia, impulse = np.array(club.inertia), np.zeros(3)
    while master.phase() < 2:
        master.set(head_of(rotation, position, velocity, spin))
        master.step(time, step)
        loads = master.get(*(f"{kind}_{axis}" for kind in ("force", "torque") for axis in "xyz"))
        whole = rotation @ inertia @ rotation.T
        change = step * loads[:3] / club.mass
        turned = spin + step * np.linalg.solve(whole, loads[3:] - np.cross(spin, whole @ spin))
        angle = step * (spin + turned) / 2.0
        rate = np.linalg.norm(angle)
        axis = np.array([[0, -angle[2], angle[1]], [angle[2], 0, -angle[0]], [-angle[1], angle[0], 0]]) / rate
        rotation = (np.eye(3) + np.sin(rate) * axis + (1 - np.cos(rate)) * axis @ axis) @ rotation
        position, velocity, spin = position + step * (velocity + change / 2.0), velocity + change, turned
        impulse, time = impulse + step * loads[:3], time + step
    return impulse


def test_a_unit_obeys_the_rules_of_the_standard(unit):
    from fmpy.validation import validate_fmu

    assert validate_fmu(str(unit)) == []


def test_a_whole_impact_through_a_unit_is_the_impact(unit):
    club = clubface.club("driver")
    launch = clubface.impact(club, **DELIVERY, model="volumetric", accuracy=1e-9)
    errors = []
    for step in (2e-5, 1e-5):
        master = Master(unit)
        master.begin()
        impulse = swing(master, club, step)
        speed, backspin, time = master.get("launched_ball_speed", "launched_backspin", "launched_contact_time")
        velocity = master.get("ball_vx", "ball_vy", "ball_vz")
        master.end()
        errors.append(abs(speed / launch.ball_speed - 1.0))
        # Momentum is what the master's head lost.
        assert impulse == pytest.approx(-clubface.ball("modern").mass * velocity, rel=1e-9, abs=1e-9)
        assert backspin == pytest.approx(launch.backspin, rel=1e-3)
        assert time == pytest.approx(launch.contact_time, rel=1e-3)
    # The step's accuracy: the master's head lags by half of what a mean force moves it.
    assert errors[0] < 1e-4
    assert errors[1] < errors[0]


def test_an_importer_runs_it_with_a_head_that_moves_as_prescribed(unit):
    if "aarch64-linux" in str(zipfile.ZipFile(unit).namelist()):
        pytest.skip("FMPy's simulate_fmu does not look for libraries under the name that FMI 3.0 has for Linux on Arm")
    rotation, position, velocity, spin = clubface.Delivery(speed="100 mph", loft="11 deg").pose("driver")
    start = head_of(np.array(rotation), position - 1e-5 * velocity, velocity, np.zeros(3))
    times = np.array([0.0, 1e-3])
    names = [name for name in start if name in ("head_x", "head_y", "head_z")]
    moving = np.array(
        [(time, *(start[name] + time * start[name.replace("_", "_v")] for name in names)) for time in times],
        dtype=[("time", float), *((name, float) for name in names)],
    )
    fixed = {name: value for name, value in start.items() if name not in names} | {"head_gives_way": False}
    result = fmpy.simulate_fmu(
        str(unit), start_values=fixed, input=moving, stop_time=1e-3, output_interval=5e-6,
        output=["launched_ball_speed", "phase", "force_x"],
    )  # fmt: skip
    struck = clubface.StruckBall(club="driver", head_gives_way=False)
    struck.advance((rotation, position - 1e-5 * velocity, velocity, spin), 1e-3)
    assert result["phase"][-1] == 2
    assert result["force_x"].min() < -5000.0
    # Inputs are held over a step of 5 us, in which the head moves on as its velocity says.
    assert result["launched_ball_speed"][-1] == pytest.approx(struck.launch["ball_speed"], rel=1e-4)


def test_parameters_of_a_unit_are_those_of_club_and_model(unit):
    master = Master(unit)
    master.set({"friction": 0.05, "club_mass": 0.25})
    master.begin()
    swing(master, clubface.club("driver").replace(mass=0.25), 1e-5)
    changed = clubface.impact(
        clubface.club("driver").replace(mass=0.25), **DELIVERY, model="volumetric", parameters={"friction": 0.05}
    )
    assert master.get("launched_backspin")[0] == pytest.approx(changed.backspin, rel=1e-3)
    master.end()


def test_a_unit_names_what_is_wrong(unit, capfd):
    from fmpy.fmi1 import FMICallException

    master = Master(unit)
    master.set({"club_mass": -1.0})
    with pytest.raises(FMICallException):
        master.begin()
    master.unit.reset()
    master.begin()
    with pytest.raises(FMICallException):
        master.set({"club_mass": 0.2})
    master.set({"head_qw": 0.0})
    with pytest.raises(FMICallException):
        master.step(0.0, 1e-5)
    master.unit.freeInstance()


@pytest.mark.parametrize("mistake", [
    {"model": "response"}, {"model": "fem"}, {"model": "volumetrik"}, {"club": "drivr"}, {"version": "1.0"},
    {"path": "impact.zip"}, {"path": "7-iron.fmu"}, {"parameters": {"friction": [0.1, 0.2]}},
])  # fmt: skip
def test_mistakes_are_named(tmp_path, mistake):
    given = {"path": "impact.fmu", "club": "driver", "model": "volumetric"} | mistake
    with pytest.raises(ClubfaceError):
        write_fmu(tmp_path / given.pop("path"), given.pop("club"), **given)
    assert not [*tmp_path.iterdir()]


def test_the_command_writes_the_same_unit(tmp_path):
    done = process("export", "fmu", "driver", "--model", "area", "--set", "friction=0.1", "-o", str(tmp_path / "a.fmu"))
    assert done.returncode == 0
    written = write_fmu(tmp_path / "b.fmu", "driver", model="area", parameters={"friction": 0.1})
    one, other = (zipfile.ZipFile(path).read("resources/impact.json") for path in (tmp_path / "a.fmu", written))
    assert one == other
