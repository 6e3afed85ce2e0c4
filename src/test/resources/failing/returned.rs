// says: Error: ParseIntError { kind: InvalidDigit }
fn main()->Result<(),Box<dyn std::error::Error>>{ "dog".parse::<i32>()?; Ok(()) }
