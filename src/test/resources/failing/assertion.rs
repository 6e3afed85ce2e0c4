// says: assertion `left == right` failed: one is two
fn main(){ assert_eq!(1,2,"one is two"); }
