"""What is told while one waits: how much is done never falls, the whole stays the same, and the last says all."""

import pytest

import clubface
from clubface import studies
from clubface.capture.synthetic.laboratory import synthesize
from clubface.validation.tour import tour
from study_files import squares

pytestmark = pytest.mark.usefixtures("in_this_process")


@pytest.fixture
def progress():
    """A progress that keeps what it is told, and the checks on it."""

    class Wording(list):
        def __call__(self, done, whole):
            self.append((done, whole))

        def check(self, whole):
            done = [each for each, _ in self]
            assert {each for _, each in self} == {whole}
            assert done == sorted(done)
            assert done[-1] == whole
            assert done[0] <= 1 or len(done) == 1
            self.clear()

    return Wording()


def test_of_a_study(progress, tmp_path):
    """20 chunks of 10 tasks; a summary reads each twice, once to find the ends of the classes."""
    path = squares(tmp_path)
    studies.run(path, progress=progress)
    progress.check(20)
    studies.status(path, check=True, progress=progress)
    progress.check(20)
    studies.join(path, tmp_path / "all.parquet", progress=progress)
    progress.check(20)
    studies.summary(path, progress=progress)
    assert len(progress) == 40
    progress.check(40)


def test_of_a_study_that_is_half_done(progress, tmp_path):
    path = squares(tmp_path)
    studies.run(path, shard="1/2")
    studies.run(path, progress=progress)
    progress.check(20)


@pytest.mark.filterwarnings("ignore::clubface.errors.RangeWarning")
def test_of_other_long_work(progress, tmp_path):
    pytest.importorskip("ezc3d")
    tour(["standard", "slip"], progress=progress)
    progress.check(progress[0][1])
    synthesize(tmp_path, 2, progress=progress)
    progress.check(2)
    clubface.dispersion("tour-driver", count=40_000, progress=progress)
    progress.check(progress[0][1])
