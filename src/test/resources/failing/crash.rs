// says: called `Result::unwrap()` on an `Err` value: ParseIntError { kind: InvalidDigit }
fn main(){ let x: Result<i32,_> = "dog".parse::<i32>(); x.unwrap(); }
