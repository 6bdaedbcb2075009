//! Empty: Cargo.toml names the API descriptions that tools/setup downloads.
