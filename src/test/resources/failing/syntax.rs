// says: error[E0425]: cannot find value `y`
fn main(){ let _x = 1 + y; let _z: u8 = "a"; }
