//! The contact law of one node, and the search for nodes in contact.

use clubface_fem::contact::{NodeState, PenaltyContact, PenaltySprings, Penetration, SearchIntervals};
use clubface_math::Vec3;

/// Force along the normal of a node just below the face that arrives, or leaves, at a speed.
fn pressing(gap: f64, closing: f64) -> f64 {
    let (normal, velocity) = (Vec3::new(1.0, 0.0, 0.0), Vec3::new(-closing, 3.0, 0.0));
    let penetration = Penetration { mass: 1e-5, area: 1e-6, gap, normal, velocity };
    let mut contact = PenaltyContact::new(0.35, PenaltySprings::default());
    penetration.force(&mut contact, &mut NodeState::free(), 5e-7);
    contact.resultant.normal
}

#[test]
fn force_begins_at_zero_at_any_speed_and_never_pulls() {
    for gap in [-1e-12, -1e-9, -1e-6] {
        let spring = pressing(gap, 0.0);
        assert!(spring > 0.0);
        // Exact but for the rounding of a sum: the damper at most doubles what the spring gives, or takes it away.
        assert!((pressing(gap, 60.0) / spring - 2.0).abs() < 1e-12);
        assert!(pressing(gap, -60.0) == 0.0);
    }
    // Slowly, all of the damper acts: twice the closing speed, twice as much, but for the rounding of a hundredth of
    // the sum.
    let damper = |closing: f64| pressing(-1e-5, closing) - pressing(-1e-5, 0.0);
    assert!((damper(0.2) / damper(0.1) - 2.0).abs() < 1e-9);
}

#[test]
fn a_node_is_searched_before_it_can_have_arrived() {
    let mut intervals = SearchIntervals::new(2);
    intervals.skip_gap(0, 1e-3, 50.0 * 50.0, 1e-6);
    // 20 steps at 50 m/s: searched within a quarter of them, though this one is slow.
    intervals.skip_gap(1, 1e-3, 1.0, 1e-6);
    let searched =
        |intervals: &mut SearchIntervals, node| (0..).find(|_| intervals.due(node)).expect("searched");
    assert_eq!([searched(&mut intervals, 0), searched(&mut intervals, 1)], [5, 5]);
    intervals.skip_gap(0, f64::INFINITY, 0.0, 1e-6);
    assert_eq!(searched(&mut intervals, 0), 100);
    assert!(intervals.due(0), "in every step from then on");
    let mut intervals = SearchIntervals::new(1);
    intervals.skip_gap(0, 1e-3, 0.0, 1e-6);
    assert!(intervals.due(0), "what has not moved yet may move");
}
