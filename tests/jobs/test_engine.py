"""However often a job is interrupted, damaged or shared out, it ends with the results of an undisturbed run."""

import re

import pytest
from hypothesis import given, settings, strategies as st

from clubface.jobs import Job, Store, run
from clubface.jobs.workers import in_sequence
from job_parts import square

once = settings(max_examples=30)


class Interrupted:
    """What computes squares and is interrupted after so many of them."""

    def __init__(self, after):
        self.after, self.computed = after, []

    def __call__(self, part):
        if len(self.computed) == self.after:
            raise KeyboardInterrupt
        self.computed.append(part)
        return square(part)


@once
@given(st.integers(1, 12), st.lists(st.integers(0, 4), max_size=6))
def test_any_interruptions_and_resumptions_end_like_an_undisturbed_run(tmp_path_factory, count, stops):
    folder = tmp_path_factory.mktemp("job") / "out.unfinished"
    parts, computed, finished = range(count), [], set()
    for after in (*stops, 1000):
        compute = Interrupted(after)
        with Store(folder, {"count": count}) as store:
            assert set(store) == {str(part) for part in finished}  # nothing that was finished is lost
            if len(finished) + after < count:
                with pytest.raises(KeyboardInterrupt, match=rf"^{len(finished) + after} of {count} squares are done"):
                    run(Job("squares", parts, compute), store=store)
            else:
                results = run(Job("squares", parts, compute), store=store)
                assert list(results.items()) == [(part, square(part)) for part in parts]
        computed += compute.computed
        finished |= set(compute.computed)
    assert sorted(computed) == list(parts)  # and nothing is computed twice


@once
@given(st.data())
def test_damage_of_what_is_kept_costs_the_damaged_parts_and_nothing_else(tmp_path_factory, data):
    folder, parts = tmp_path_factory.mktemp("job") / "out.unfinished", range(8)
    with Store(folder, {}) as store:
        run(Job("squares", parts, square), store=store)
    values = folder / "values.jsonl"
    content = bytearray(values.read_bytes())
    if data.draw(st.booleans()):
        content[data.draw(st.integers(0, len(content) - 1))] ^= 1 << data.draw(st.integers(0, 7))
    else:
        content = content[: data.draw(st.integers(0, len(content)))]
    values.write_bytes(content)
    compute = Interrupted(1000)
    with Store(folder, {}) as store:
        assert run(Job("squares", parts, compute), store=store) == {part: square(part) for part in parts}
        assert store.resumed == tuple(str(part) for part in parts if part not in compute.computed)


@once
@given(st.integers(1, 5), st.integers(0, 20), st.randoms())
def test_shares_in_any_order_are_the_whole(tmp_path_factory, shares, count, random):
    folder = tmp_path_factory.mktemp("job") / "out.unfinished"
    order = list(range(shares))
    random.shuffle(order)
    for share in order:
        with Store(folder, {}) as store:
            run(Job("squares", range(share, count, shares), square), store=store)
    compute = Interrupted(0)
    with Store(folder, {}) as store:
        assert run(Job("squares", range(count), compute), store=store) == {part: square(part) for part in range(count)}


def test_progress_rises_to_the_whole_and_an_interruption_says_where_the_parts_are(tmp_path):
    folder, messages = tmp_path / "out.unfinished", []
    progress = lambda done, whole: messages.append((done, whole))  # noqa: E731
    message = (
        rf"^2 of 5 runs are done; they are in {re.escape(str(folder))}, and the same command continues from there$"
    )
    with Store(folder, {}) as store, pytest.raises(KeyboardInterrupt, match=message):
        run(Job("runs", range(5), Interrupted(2)), in_sequence, store=store, progress=progress)
    with pytest.raises(KeyboardInterrupt, match=r"^2 of 5 runs are done$"):
        run(Job("runs", range(5), Interrupted(2)))
    assert messages == [(1, 5), (2, 5)]
    with Store(folder, {}) as store:
        run(Job("runs", range(5), square), store=store, progress=progress)
    assert messages[2:] == [(2, 5), (3, 5), (4, 5), (5, 5)]
