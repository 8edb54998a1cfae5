"""Sentences about studies."""

SENTENCES = {
    "study-chunks-not-listed": "{left:n chunk} missing or damaged; {chunks} of them not listed",
    "study-complete": "the study is complete in {store}",
    "study-left": "{chunks:n chunk} of the whole study left for other runs; parts in {store}",
    "study-parts-mended": "{parts:n damaged part} recomputed: {shown}",
    "study-processors": "computed on {processors}, which agree to rounding, not in the last digits",
    "study-range": "{quantity} ranges from {least_text} to {most_text}.",
    "study-store": "parts in {store}",
    "study-tasks": "The study has {tasks:n task}, which differ in {inputs:and}.",
    "tasks-without-result": "{tasks:n task} without a result; the first is {first}",
}
