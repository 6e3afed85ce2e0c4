// says: has overflowed its stack
#[allow(unconditional_recursion)]
fn f(n:u64)->u64{ if n==u64::MAX {0} else {f(n+1)+std::hint::black_box(n)} }
fn main(){ println!("{}",f(0)); }
