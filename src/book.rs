//! The chapters of the book as documentation tests: a Rust block in a chapter compiles and runs, unless it is code
//! included from an example (`rust,ignore`, compiled there).

macro_rules! chapters {
    ($($name:ident: $file:literal,)*) => {
        $(#[doc = include_str!(concat!("../book/src/", $file))]
        mod $name {})*
    };
}

chapters! {
    introduction: "introduction.md",
}
