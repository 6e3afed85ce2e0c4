// says: memory allocation of 140737488355328 bytes failed
fn main(){ let v:Vec<u8>=Vec::with_capacity(1<<47); println!("{}",v.capacity()); }
