//! The build script of the examples: `cargo test` compiles them without optimisation
//! (`profile.test.package.examples`), as a check only; what they compute it takes from
//! `tests/every_example`. So there each is a program that runs nothing, and takes a third of the time.

fn main() {
    println!("cargo::rerun-if-env-changed=OPT_LEVEL");
    println!("cargo::rustc-check-cfg=cfg(only_checked)");
    if std::env::var("OPT_LEVEL").is_ok_and(|level| level == "0") {
        println!("cargo::rustc-cfg=only_checked");
    }
}
