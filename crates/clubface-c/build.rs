//! Gives the shared library the name by which programs ask for it when they start: it ends in the number of the interface,
//! so that a program never starts with a library that it was not compiled for.

include!("src/abi.rs");

fn main() {
    println!("cargo::rerun-if-changed=src/abi.rs");
    match std::env::var("CARGO_CFG_TARGET_OS").as_deref() {
        Ok("macos") => {
            println!(
                "cargo::rustc-cdylib-link-arg=-Wl,-install_name,@rpath/libclubface.{CLUBFACE_ABI}.dylib"
            );
        }
        Ok("linux" | "android" | "freebsd" | "netbsd" | "openbsd") => {
            println!("cargo::rustc-cdylib-link-arg=-Wl,-soname,libclubface.so.{CLUBFACE_ABI}");
        }
        _ => {}
    }
}
