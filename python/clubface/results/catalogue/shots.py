"""Sentences about recorded, measured and predicted shots."""

SENTENCES = {
    "monitor-any-other-file": "clubface monitor formats NAME shows the columns; any other file is read with --mapping.",
    "session-gap-not-sure": (
        "the gap between {longer} and {shorter} is not sure: {gap_carry:1} with a standard error of {error_carry:1}"
    ),
    "session-gap-of-a-single-shot": (
        "the gap between {longer} and {shorter} is not sure: {gap_carry:1} with a single shot, so that its error is "
        "not known"
    ),
    "session-median": (
        "medians, with ± the standard deviation from shot to shot, both without the mishits that are listed"
    ),
    "session-median-of-all": "medians, with ± the standard deviation from shot to shot",
    "session-partly-measured": "{quantity} was not measured in every shot: {counts}",
}
