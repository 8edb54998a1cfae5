"""Shares of a study: together they are the whole, and their numbers come from where the person says."""

import pytest
from hypothesis import given, strategies as st

from clubface import studies
from clubface.errors import InputError
from clubface.jobs.workers import shard_of
from study_files import shots, sums

SLURM = {"SLURM_ARRAY_TASK_ID": "12", "SLURM_ARRAY_TASK_MIN": "10", "SLURM_ARRAY_TASK_COUNT": "40"}


@given(st.integers(1, 50), st.integers(0, 500))
def test_every_chunk_falls_to_one_share(count, chunk):
    assert sum(chunk in shard_of(f"{number}/{count}").of_all(501) for number in range(1, count + 1)) == 1


def test_shares_joined_are_the_whole(tmp_path, in_this_process):
    pytest.importorskip("pyarrow")
    whole, shared = shots(tmp_path), shots(tmp_path, name="shared.toml")
    studies.run(whole, workers=1)
    left = [studies.run(shared, workers=1, shard=f"{number}/3").missing for number in (2, 1, 3)]
    assert left == [3, 1, 0]
    assert sums(shared) == sums(whole)


@pytest.mark.parametrize(
    ("text", "environment", "result"),
    [
        ("3/40", {}, (3, 40)),
        ("3/40", SLURM, (3, 40)),
        ("slurm", SLURM, (3, 40)),
        ("slurm/50", SLURM, (3, 50)),
        ("slurm", {**SLURM, "SLURM_ARRAY_TASK_STEP": "2"}, (2, 40)),
        ("kubernetes/40", {"JOB_COMPLETION_INDEX": "0"}, (1, 40)),
        ("kubernetes/40", {"JOB_COMPLETION_INDEX": "39"}, (40, 40)),
    ],
)
def test_a_share_is_typed_or_taken_from_the_scheduler(text, environment, result):
    assert shard_of(text, environment) == result


@pytest.mark.parametrize(
    ("text", "environment", "words"),
    [
        ("0/40", {}, "1 to the number of shards"),
        ("41/40", {}, "1 to the number of shards"),
        ("3", {}, "such as 3/40"),
        (3, {}, "shard is 3; it must be text"),
        ("3/-4", {}, "such as 3/40"),
        ("kubernetes", {"JOB_COMPLETION_INDEX": "0"}, "such as 3/40"),
        ("kubernetes/40", {}, "JOB_COMPLETION_INDEX is missing"),
        ("kubernetes/40", {"JOB_COMPLETION_INDEX": "40"}, "41/40 here"),
        ("slurm", {}, "SLURM_ARRAY_TASK_MIN is missing"),
        ("slurm", {**SLURM, "SLURM_ARRAY_TASK_ID": "x"}, "SLURM_ARRAY_TASK_ID is 'x'"),
    ],
)
def test_a_share_that_does_not_exist_is_reported(text, environment, words):
    with pytest.raises(InputError, match=words):
        shard_of(text, environment)
