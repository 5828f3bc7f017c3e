//! The lines of `benches/record/peers.txt` at 1e-9, by criterion, grouped by problem.
//!
//! A bench is not timed before the error that it claims is shown to be reached. The
//! record itself is measured by the binary of this crate, in rounds.

use benches::{RECORD, path};
use criterion::{Criterion, SamplingMode, criterion_group, criterion_main};
use kit::parse;
use peers::contest::contestants;
use peers::problem::PROBLEMS;
use peers::record::claims;
use std::fs;
use std::time::Duration;

const CLAIMED: f64 = 1e-9;

fn races(c: &mut Criterion) {
    let text = fs::read_to_string(path(RECORD)).expect("there is a record");
    let record = parse(&text).expect("a record is a report");
    let claims = claims(&record).expect("the runs can be read");
    for problem in &PROBLEMS {
        let mut group = c.benchmark_group(problem.key);
        group
            .sampling_mode(SamplingMode::Flat)
            .sample_size(10)
            .warm_up_time(Duration::from_millis(300))
            .measurement_time(Duration::from_secs(1));
        let all = contestants(problem).expect("they can be set up");
        for claim in &claims {
            if claim.key != problem.key || claim.error != CLAIMED {
                continue;
            }
            let same = all.iter().find(|c| c.name() == claim.name && c.form == claim.form);
            let contestant = same.expect("who is in the record can race");
            let run = || (contestant.run)(claim.setting).expect("a run");
            let error = problem.error(&run()).expect("an attitude");
            assert!(error <= CLAIMED, "{error:e} is delivered by {claim:?}");
            group.bench_function(&claim.name, |b| b.iter(run));
        }
        group.finish();
    }
}

criterion_group!(benches, races);
criterion_main!(benches);
