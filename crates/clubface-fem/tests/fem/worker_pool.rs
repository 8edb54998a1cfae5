//! Threads that go through stages together.

use clubface_fem::environment::{Environment, SingleThread};
use clubface_fem::solve::{Stage, WorkerPool};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// With a pool of three workers.
fn three<T: Send>(lead: impl FnOnce(&WorkerPool<'_>) -> T + Send) -> T {
    let threads = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("threads");
    threads.install(|| WorkerPool::with(&*Environment::native().executor, lead))
}

#[test]
fn every_task_of_a_stage_is_done_once_before_the_next() {
    let stages = |pool: &WorkerPool<'_>, stages: usize| {
        let workers = pool.workers();
        for turn in 0..stages {
            // Stages of all sizes, each gone when the next begins.
            let schedule = [(0..turn % 5).collect(), vec![], (5..5 + turn % 7).collect::<Vec<_>>()];
            let counts: Vec<AtomicUsize> = (0..12).map(|_| AtomicUsize::new(0)).collect();
            let task = |task: usize, _: usize| {
                counts[task].fetch_add(1, Ordering::Relaxed);
            };
            let schedule = if workers == 1 { vec![schedule.concat()] } else { schedule.to_vec() };
            pool.run(&Stage { task: &task, schedule: &schedule });
            for (task, count) in counts.iter().enumerate() {
                let expected = usize::from(task < turn % 5 || (5..5 + turn % 7).contains(&task));
                assert_eq!(count.load(Ordering::Relaxed), expected, "task {task} of stage {turn}");
            }
        }
    };
    three(|pool| stages(pool, 2000));
    WorkerPool::with(&SingleThread, |pool| stages(pool, 20));
}

#[test]
fn calls_within_get_the_same_pool_and_calls_afterwards_another() {
    three(|outer| {
        assert_eq!(WorkerPool::size(&SingleThread), 3, "the pool that is there");
        WorkerPool::with(&SingleThread, |inner| assert!(std::ptr::eq(outer, inner)));
    });
    assert_eq!(WorkerPool::size(&SingleThread), 1);
    assert!(catch_unwind(|| WorkerPool::with(&SingleThread, |_| panic!("planted"))).is_err());
    assert_eq!(WorkerPool::size(&SingleThread), 1, "whatever has happened");
}

#[test]
fn no_task_is_left_when_another_panics() {
    three(|pool| {
        let [begun, ended] = [AtomicUsize::new(0), AtomicUsize::new(0)];
        let task = |task: usize, _: usize| {
            if task == 0 {
                // Another worker is at its task, unless the machine has no time for any.
                let start = Instant::now();
                while begun.load(Ordering::Relaxed) == 0 && start.elapsed() < Duration::from_secs(5) {
                    std::hint::spin_loop();
                }
                panic!("planted");
            }
            begun.fetch_add(1, Ordering::Relaxed);
            std::thread::sleep(Duration::from_millis(200));
            ended.fetch_add(1, Ordering::Relaxed);
        };
        let stage = Stage { task: &task, schedule: &[vec![0, 1], vec![2, 3], vec![4, 5]] };
        assert!(catch_unwind(AssertUnwindSafe(|| pool.run(&stage))).is_err());
        assert_eq!(begun.load(Ordering::Relaxed), ended.load(Ordering::Relaxed));
    });
}

#[test]
fn no_stage_begins_within_a_stage() {
    three(|pool| {
        let empty = Stage { task: &|_, _| (), schedule: &[vec![0]] };
        let task = |_, _| {
            assert!(catch_unwind(AssertUnwindSafe(|| pool.run(&empty))).is_err());
        };
        pool.run(&Stage { task: &task, schedule: &[vec![0]] });
        pool.run(&empty);
    });
}
