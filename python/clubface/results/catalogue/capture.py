"""Sentences about deliveries from motion capture."""

SENTENCES = {
    "capture-address": "address taken from frames {first_frame} to {last_frame}",
    "capture-address-of-file": "address taken from frames {first_frame} to {last_frame} of {file}",
    "capture-attitude-contradicted": (
        "the positions of the markers contradict the assumed attitude of the club, most of all in its {measured} "
        "(assumed: {assumed}): check them, or allow a larger deviation under [assumed]"
    ),
    "capture-ball-not-seen": "the ball is not seen after impact; the loss of the head's speed shows that they met",
    "capture-ball-place-alone": (
        "no impact can be read from the head's path, so everything depends on the given position of the ball: {reason}"
    ),
    "capture-ball-start": (
        "the ball starts {late_time:ms 2} after the face touches it, not the 0.2 ms of a real impact: a wrong club, "
        "mapping or calibration"
    ),
    "capture-ball-starts-late": (
        "the ball starts {late_time:ms 2} after the face touches it, {times:.1f} times the 0.2 ms of a real impact: "
        "the file may state a frame rate that is too low, which makes all speeds too low by the same factor; "
        "otherwise a wrong club, mapping or calibration"
    ),
    "capture-impact": "impact is where the head loses {lost:.0%} of its speed",
    "capture-impact-again": (
        "it loses speed in frame {again} as well as in frame {frame} of the recording: trim the recording to read that "
        "one"
    ),
    "capture-contradicts-ball": (
        "the clubhead loses speed {surprise:.1f} standard deviations from where ball, club and markers should be: "
        "check their positions, or give them a larger accuracy"
    ),
    "capture-ends-after-impact": (
        "the recording ends {later:n frame} after the impact, which is assumed to follow frame {frame}; record at "
        "least {fewest} more frames to see the loss of speed itself"
    ),
    "capture-ends-with-impact": (
        "the recording ends with the impact, which is assumed to follow frame {frame}; record at least {fewest} more "
        "frames to see the loss of speed itself"
    ),
    "capture-face-opens": (
        "the face opens through impact, with a closure rate of {closure}: the hand of the club may be wrong (--hand)"
    ),
    "capture-few-degrees-of-freedom": ("the marker noise is estimated from only {freedom:n degree} of freedom"),
    "capture-filled": (
        "{markers}: {frames:?frame/frames} {frames:ranges} not seen but filled by the capture program (a line or a "
        "spline): left out"
    ),
    "capture-filtered": (
        "the markers move more smoothly than noise allows (correlation of successive steps of their residuals "
        "{correlation:.2f}, -0.50 for white noise): the trajectories were filtered, or markers swing on their mounts. "
        "A filter that ran across the impact slows the clubhead before it, beyond the stated uncertainty, and nothing "
        "can undo that: export raw trajectories"
    ),
    "capture-flight-contradicts": (
        "the ball leaves with {seen}, but this delivery of {club} gives {expected}: a wrong club, mapping or "
        "calibration"
    ),
    "capture-head-lost": "the clubhead is lost from sight before it meets the ball",
    "capture-lie": "a lie of {lie} is impossible for a club: the axis that points up may be wrong",
    "capture-loft": (
        "the dynamic loft of {loft} is far from the {static_loft} of {club}: a wrong club, mapping or calibration"
    ),
    "capture-loft-uncertain": (
        "the dynamic loft is not known to 2 deg: too few markers, too near together, or gaps before impact"
    ),
    "capture-marker-moved": (
        "{marker} sits {marker_displacement} from its place in the mapping or calibration: has it moved?"
    ),
    "capture-marker-not-seen": "{marker} is never seen",
    "capture-marker-strays": "{marker} is out of place in {frames:?frame/frames} {frames:ranges}: left out there",
    "capture-markers-do-not-fit": (
        "the markers of the clubhead do not fit in {frames:?frame/frames} {frames:ranges}: left out"
    ),
    "capture-markers-exchanged": "{markers:and} swapped in {frames:?frame/frames} {frames:ranges}: corrected",
    "capture-markers-look-alike": ("the cluster looks the same with {markers:and} swapped: a swap would go unnoticed"),
    "capture-markers-not-calibrated": "{markers} not seen in the calibration: left out",
    "capture-not-plausible": (
        "not plausible: {values}. Do not use these figures: see which markers are hidden or out of place in which "
        "frames (capture markers, --plot), trim the recording to the swing, and check frames under [calibration], "
        "target and up under [laboratory], and the club"
    ),
    "capture-nothing-seen-after-impact": (
        "neither ball nor clubhead is seen after impact: that they met is inferred from where they were before"
    ),
    "capture-off-face": (
        "the impact lies {toe} towards the toe and {high} high, outside the face of {club} ({face_width:bare} x "
        "{face_height}): a wrong club, mapping or calibration"
    ),
    "capture-path": (
        "the club goes {path} to the right of the target: the axis that points to the target may be wrong (target "
        "under [laboratory], or --target)"
    ),
    "capture-path-extended": (
        "the last {missing} frames before impact do not show the clubhead's pose: extrapolated across them"
    ),
    "capture-path-misfit": (
        "the path differs from the estimator's by {misfit:.1f} times the expected variance: its uncertainty is too "
        "small (trajectories filtered across the impact do that: export them raw; otherwise give a larger roughness "
        "or the marker noise)"
    ),
    "capture-speed": "a clubhead of {speed}: the unit of length or the frame rate may be wrong",
    "capture-speed-uncertain": (
        "the speed is hardly known, {values}: too few frames before impact show the clubhead, or markers are out of "
        "place there; remove such markers from [cluster], or trim the recording"
    ),
    "launches-of-captured": "{quantities} of the launches taken from {captured}: the other table has none",
    "paired-by-order": "paired by order alone: the two tables have no common quantity to match shots by",
    "paired-by-values": "paired in order by {quantities}",
    "target-lines-differ": (
        "the azimuths of {measured} differ from those of {captured} by {azimuth:sides 2} (median): if that is more "
        "than noise, the target lines differ"
    ),
}
