//! Tasks by worker.

use clubface_fem::solve::balanced;

#[test]
fn workers_have_every_task_once_and_about_the_same_cost() {
    let costs = [1, 4, 4, 4, 4, 1];
    assert_eq!(balanced(&[0, 1, 2, 3, 4, 5], |task| costs[task], 2), [[0, 1, 2], [3, 4, 5]]);
    assert_eq!(balanced(&[7, 8], |task| if task == 7 { 9 } else { 1 }, 3), [vec![], vec![7], vec![8]]);
    assert_eq!(balanced(&[], |_| 1, 2), vec![vec![0; 0]; 2]);
}
