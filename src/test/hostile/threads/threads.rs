// Answers each number by what threads compute, one of which sleeps all the time.
use std::io::{stdin, BufRead};
use std::thread;
use std::time::Duration;

fn work(seed: i64) -> i64 {
    (0..100_000).fold(seed, |value, _| (value * 1_103_515_245 + 12_345) % (1 << 31))
}

fn main() {
    thread::spawn(|| loop {
        thread::sleep(Duration::from_millis(3));
    });
    for line in stdin().lock().lines() {
        let seed: i64 = line.unwrap().parse().unwrap();
        let threads: Vec<_> = (0..4).map(|k| thread::spawn(move || work(seed + k))).collect();
        println!("{}", threads.into_iter().map(|each| each.join().unwrap()).sum::<i64>());
    }
}
